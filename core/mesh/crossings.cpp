#include "core/mesh/crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace core {
namespace {

struct Box {
    Vec3 low, high;
};

Box box_of(const QuadMesh& mesh, const Quad& quad) {
    Box box{mesh.vertices[quad[0]], mesh.vertices[quad[0]]};
    for (const std::uint32_t v : quad) {
        const Vec3 p = mesh.vertices[v];
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
    return box;
}

bool overlap(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
}

/// Quads by the cells of a grid that their boxes touch.
class QuadGrid {
  public:
    explicit QuadGrid(const QuadMesh& mesh) {
        double sum = 0.0;
        for (const Quad& q : mesh.quads) {
            boxes_.push_back(box_of(mesh, q));
            const Vec3 size = boxes_.back().high - boxes_.back().low;
            sum += std::max({size.x, size.y, size.z});
        }
        cell_ = mesh.quads.empty() ? 1.0 : std::max(1.5 * sum / static_cast<double>(mesh.quads.size()), 1e-9);
        for (std::uint32_t i = 0; i < boxes_.size(); ++i)
            for_cells(boxes_[i], [&](std::uint64_t key) { cells_[key].push_back(i); });
    }

    /// Calls visit(i) for each quad i whose box overlaps, in ascending order.
    template <typename Visit>
    void near(const Box& box, const Visit& visit) {
        found_.clear();
        for_cells(box, [&](std::uint64_t key) {
            const auto cell = cells_.find(key);
            if (cell != cells_.end()) found_.insert(found_.end(), cell->second.begin(), cell->second.end());
        });
        std::sort(found_.begin(), found_.end());
        found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
        for (const std::uint32_t i : found_)
            if (overlap(box, boxes_[i])) visit(i);
    }

  private:
    template <typename Use>
    void for_cells(const Box& box, const Use& use) const {
        const auto at = [&](double v) { return static_cast<std::int64_t>(std::floor(v / cell_)); };
        for (std::int64_t z = at(box.low.z); z <= at(box.high.z); ++z)
            for (std::int64_t y = at(box.low.y); y <= at(box.high.y); ++y)
                for (std::int64_t x = at(box.low.x); x <= at(box.high.x); ++x)
                    use((static_cast<std::uint64_t>(x) & 0x1FFFFF) | (static_cast<std::uint64_t>(y) & 0x1FFFFF) << 21 |
                        (static_cast<std::uint64_t>(z) & 0x1FFFFF) << 42);
    }

    double cell_ = 1.0;
    std::vector<Box> boxes_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
    std::vector<std::uint32_t> found_;
};

/// Six times the signed volume of a tetrahedron.
double volume(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    return dot(cross(b - a, c - a), d - a);
}

bool edge_through(Vec3 p, Vec3 q, const std::array<Vec3, 3>& t) {
    if ((volume(t[0], t[1], t[2], p) < 0.0) == (volume(t[0], t[1], t[2], q) < 0.0)) return false;
    const double u = volume(p, q, t[0], t[1]), v = volume(p, q, t[1], t[2]), w = volume(p, q, t[2], t[0]);
    return (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
}

std::array<std::array<Vec3, 3>, 2> triangles(const QuadMesh& mesh, const Quad& q) {
    const auto& v = mesh.vertices;
    return {{{v[q[0]], v[q[1]], v[q[2]]}, {v[q[0]], v[q[2]], v[q[3]]}}};
}

bool quads_cross(const QuadMesh& a, const Quad& p, const QuadMesh& b, const Quad& q) {
    for (const auto& s : triangles(a, p))
        for (const auto& t : triangles(b, q))
            for (std::size_t k = 0; k < 3; ++k)
                if (edge_through(s[k], s[(k + 1) % 3], t) || edge_through(t[k], t[(k + 1) % 3], s)) return true;
    return false;
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> mesh_crossings(const QuadMesh& a, const QuadMesh& b) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    QuadGrid grid(b);
    for (std::uint32_t i = 0; i < a.quads.size(); ++i)
        grid.near(box_of(a, a.quads[i]), [&](std::uint32_t j) {
            if (quads_cross(a, a.quads[i], b, b.quads[j])) out.emplace_back(i, j);
        });
    return out;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> self_crossings(const QuadMesh& mesh) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    QuadGrid grid(mesh);
    for (std::uint32_t i = 0; i < mesh.quads.size(); ++i)
        grid.near(box_of(mesh, mesh.quads[i]), [&](std::uint32_t j) {
            if (j <= i) return;
            for (const std::uint32_t v : mesh.quads[i])
                if (std::find(mesh.quads[j].begin(), mesh.quads[j].end(), v) != mesh.quads[j].end()) return;
            if (quads_cross(mesh, mesh.quads[i], mesh, mesh.quads[j])) out.emplace_back(i, j);
        });
    return out;
}

}  // namespace core
