#include "core/garment/permanence_patch.hpp"

#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "core/garment/frontal_factor.hpp"
#include "core/mesh/flow_loops.hpp"

namespace core {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Rows = FrontalFactor::Rows;  // a place each

/// From here on towards -1/4 the system's condition costs digits, which one step of refinement brings back.
constexpr double kRefineBelow = -0.24;

/// What one quad adds for its corners i and j, as opposite(i - j) numbers: quads share each inner edge between two, so
/// each takes half of it. The edge part is exact for inner vertices, whose edges all have two quads.
struct QuadWeights {
    double same, beside, across;
};
QuadWeights weights(double alpha) {
    const double mixed = -4.0 * alpha, straight = 1.0 + 4.0 * alpha;
    return {mixed + straight, -mixed - 0.5 * straight, mixed};
}

}  // namespace

struct PermanencePatch::System {
    int fixed = 0;
    double lowest_alpha = kCoonsAlpha;
    double alpha = 0.0;
    std::vector<Quad> quads;
    Matrix inner;     // inner x inner, lower triangle
    Matrix coupling;  // inner x fixed
    /// Where each quad's corner pair goes: an index into the values of `inner` or, from inner.nonZeros() on, of
    /// `coupling`; kNowhere for what is fixed or in the upper triangle.
    std::vector<std::array<std::uint32_t, 16>> slots;
    FrontalFactor factor;
    Rows boundary, right, answer;

    static constexpr std::uint32_t kNowhere = ~0U;

    void lay_out(std::uint32_t vertex_count) {
        using Triplet = Eigen::Triplet<double>;
        std::vector<Triplet> within, across;
        for (const Quad& quad : quads)
            for (const std::uint32_t row : quad)
                for (const std::uint32_t column : quad) {
                    const int i = static_cast<int>(row) - fixed, j = static_cast<int>(column) - fixed;
                    if (i >= 0 && j >= 0 && i >= j) within.emplace_back(i, j, 0.0);
                    if (i >= 0 && j < 0) across.emplace_back(i, j + fixed, 0.0);
                }
        const auto count = static_cast<int>(vertex_count) - fixed;
        inner.resize(count, count);
        inner.setFromTriplets(within.begin(), within.end());
        coupling.resize(count, fixed);
        coupling.setFromTriplets(across.begin(), across.end());
        find_slots();
        factor.analyse(inner);
    }

    static std::uint32_t slot(const Matrix& matrix, int row, int column) {
        const int* rows = matrix.innerIndexPtr();
        const int* begin = rows + matrix.outerIndexPtr()[column];
        const int* end = rows + matrix.outerIndexPtr()[column + 1];
        return static_cast<std::uint32_t>(std::lower_bound(begin, end, row) - rows);
    }

    void find_slots() {
        slots.resize(quads.size());
        for (std::size_t q = 0; q < quads.size(); ++q)
            for (std::size_t k = 0; k < 16; ++k) {
                const int i = static_cast<int>(quads[q][k / 4]) - fixed, j = static_cast<int>(quads[q][k % 4]) - fixed;
                std::uint32_t& at = slots[q][k];
                at = kNowhere;
                if (i >= 0 && j >= 0 && i >= j) at = slot(inner, i, j);
                if (i >= 0 && j < 0) at = static_cast<std::uint32_t>(inner.nonZeros()) + slot(coupling, i, j + fixed);
            }
    }

    void factorise() {
        const QuadWeights w = weights(alpha);
        const std::array<double, 4> by_step{w.same, w.beside, w.across, w.beside};
        const auto inner_count = static_cast<std::uint32_t>(inner.nonZeros());
        std::fill_n(inner.valuePtr(), inner.nonZeros(), 0.0);
        std::fill_n(coupling.valuePtr(), coupling.nonZeros(), 0.0);
        for (const auto& quad : slots)
            for (std::size_t k = 0; k < 16; ++k) {
                if (quad[k] == kNowhere) continue;
                double& value =
                    quad[k] < inner_count ? inner.valuePtr()[quad[k]] : coupling.valuePtr()[quad[k] - inner_count];
                value += by_step[(k / 4 + 4 - k % 4) % 4];
            }
        [[maybe_unused]] const bool definite = factor.factorise(inner);
        assert(definite);
    }

    /// answer += inverse of `inner` times right.
    void back_substitute() {
        factor.solve(right);
        answer += right;
    }

    void solve() {
        right.noalias() = -(coupling * boundary);
        answer.setZero(inner.rows(), 3);
        back_substitute();
        if (alpha > kRefineBelow) return;
        right.noalias() = -(coupling * boundary) - inner.selfadjointView<Eigen::Lower>() * answer;
        back_substitute();
    }
};

PermanencePatch::PermanencePatch(std::span<const Quad> quads, std::uint32_t vertex_count, std::uint32_t fixed,
                                 double alpha)
    : system_(std::make_unique<System>()) {
    system_->fixed = static_cast<int>(fixed);
    system_->quads.assign(quads.begin(), quads.end());
    if (count_closed_flow_loops(quads) > 0) system_->lowest_alpha = kClosedFlowAlpha;
    if (vertex_count > fixed) system_->lay_out(vertex_count);
    set_alpha(alpha);
}
PermanencePatch::PermanencePatch(PermanencePatch&&) noexcept = default;
PermanencePatch& PermanencePatch::operator=(PermanencePatch&&) noexcept = default;
PermanencePatch::~PermanencePatch() = default;

void PermanencePatch::set_alpha(double alpha) {
    system_->alpha = alpha < 0.0 ? std::max(alpha, system_->lowest_alpha) : kHarmonicAlpha;
    if (system_->inner.rows() > 0) system_->factorise();
}

double PermanencePatch::alpha() const {
    return system_->alpha;
}

void PermanencePatch::solve(std::vector<Vec3>& vertices) {
    System& s = *system_;
    const auto count = static_cast<std::size_t>(s.inner.rows()), fixed = static_cast<std::size_t>(s.fixed);
    if (count == 0) return;
    assert(vertices.size() == fixed + count);
    const auto row = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
    s.boundary.resize(s.fixed, 3);
    for (std::size_t i = 0; i < fixed; ++i) s.boundary.row(row(i)) << vertices[i].x, vertices[i].y, vertices[i].z;
    s.solve();
    for (std::size_t i = 0; i < count; ++i)
        vertices[fixed + i] = {s.answer(row(i), 0), s.answer(row(i), 1), s.answer(row(i), 2)};
}

}  // namespace core
