#include "core/garment/fitting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

#include "core/mesh/crossings.hpp"

namespace core {
namespace {

constexpr double kSmallQuad_cm = 2.5;  // longest diagonal
constexpr double kSkin_cm = 0.2;       // so deep the nearest way out is always right
constexpr double kBodyReach_cm = 40.0;
constexpr int kPartingRounds = 30;
constexpr int kIdleRounds = 6;  // without fewer crossings: what is left stays
constexpr double kPartingStep_cm = 0.12;

struct Link {
    std::uint32_t a, b;
    double rest;
};

/// Edges, each once, and quads' diagonals.
std::vector<Link> links_of(const QuadMesh& mesh, bool diagonals) {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    pairs.reserve(6 * mesh.quads.size());
    for (const Quad& q : mesh.quads) {
        for (std::size_t k = 0; k < 4; ++k)
            pairs.push_back({std::min(q[k], q[(k + 1) % 4]), std::max(q[k], q[(k + 1) % 4])});
        if (!diagonals) continue;
        pairs.push_back({std::min(q[0], q[2]), std::max(q[0], q[2])});
        pairs.push_back({std::min(q[1], q[3]), std::max(q[1], q[3])});
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<Link> links;
    for (const auto& [a, b] : pairs) links.push_back({a, b, length(mesh.vertices[b] - mesh.vertices[a])});
    return links;
}

std::vector<Vec3> outward_directions(const QuadMesh& mesh) {
    std::vector<Vec3> normals(mesh.vertices.size());
    for (const Quad& q : mesh.quads) {
        const Vec3 n = cross(mesh.vertices[q[2]] - mesh.vertices[q[0]], mesh.vertices[q[3]] - mesh.vertices[q[1]]);
        for (const std::uint32_t v : q) normals[v] = normals[v] + n;
    }
    for (Vec3& n : normals) n = normalised(n);
    return normals;
}

class Fitter {
  public:
    Fitter(Cloth& cloth, const Obstacle& obstacle, const FittingOptions& options)
        : cloth_(cloth),
          mesh_(cloth.mesh),
          obstacle_(obstacle),
          options_(options),
          edges_(links_of(cloth.mesh, false)),
          springs_(links_of(cloth.mesh, true)),
          outward_(outward_directions(cloth.mesh)),
          parts_(cloth.mesh.vertices.size(), 0) {
        for (const ClothPiece& piece : cloth.pieces)
            for (std::size_t q = piece.first; q < piece.first + piece.count; ++q)
                for (const std::uint32_t v : mesh_.quads[q]) parts_[v] |= piece.parts;
    }

    FittingReport run() {
        FittingReport report;
        report.deepest_before_cm = std::max(0.0, -closest());
        for (int round = 0; round < options_.rounds; ++round) {
            fair();
            push_out(options_.clearance_cm);
        }
        // no more fairing: only out, until nothing is nearer than asked; places inside quads cost some rounds
        for (int round = 0; round < 40 && closest() < options_.clearance_cm * 0.98; ++round)
            push_out(options_.clearance_cm * 1.02);
        part_crossings();
        part_from_itself(report);
        report.closest_cm = closest();
        report.deepest_after_cm = std::max(0.0, -report.closest_cm);
        double sum = 0.0;
        for (const Link& e : edges_) {
            const double stretch =
                std::abs(length(mesh_.vertices[e.b] - mesh_.vertices[e.a]) / std::max(e.rest, 1e-9) - 1.0);
            sum += stretch;
            report.largest_stretch = std::max(report.largest_stretch, stretch);
        }
        report.mean_stretch = edges_.empty() ? 0.0 : sum / static_cast<double>(edges_.size());
        return report;
    }

  private:
    /// How far a point must move to be `clearance` away, and which way: down the field if the nearest part of the body
    /// is one of the cloth's own, back towards these if not; where parts are not known, along the cloth's outward
    /// direction where the field leads elsewhere.
    [[nodiscard]] Vec3 way_out(Vec3 p, Vec3 outward, PartSet own, double clearance) const {
        const double d = obstacle_.distance(p);
        if (d >= clearance) return {};
        const FieldSample s = obstacle_.sample(p);
        if (d > -kSkin_cm) return s.gradient * (clearance - d);
        if (own != 0 && !obstacle_.parts().empty())
            if (const std::optional<Vec3> back = way_back(p, own, clearance); back) return *back;
        if (dot(s.gradient, outward) > 0.1) return s.gradient * (clearance - d);
        const double most = 3.0 * (clearance - d);  // farther out it would leave by another part of the body
        for (double step = 0.3; step < most; step += 0.3)
            if (obstacle_.distance(p + outward * step) >= clearance) return outward * step;
        return s.gradient * (clearance - d);
    }

    /// The move out of a part that the cloth is not associated with: straight towards the nearest place of its own
    /// parts, as far as the gap between the two, or to that place. Nothing when the part is its own.
    [[nodiscard]] std::optional<Vec3> way_back(Vec3 p, PartSet own, double clearance) const {
        const PartSurface& parts = obstacle_.parts();
        const std::optional<PartPlace> near = parts.nearest(p, ~PartSet{0}, kBodyReach_cm);
        if (!near || (own & part_bit(near->part)) != 0) return std::nullopt;
        const std::optional<PartPlace> home = parts.nearest(p, own, kBodyReach_cm);
        if (!home) return std::nullopt;
        const Vec3 way = home->place + home->outward * clearance - p;
        const double far = length(way);
        for (double at = 0.3; at < far; at += 0.3)
            if (obstacle_.distance(p + way * (at / far)) >= clearance) return way * (at / far);
        return way;
    }

    void push_out(double clearance) {
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v)
            mesh_.vertices[v] = mesh_.vertices[v] + way_out(mesh_.vertices[v], outward_[v], parts_[v], clearance);
        // each vertex takes the largest of the moves that places beside it ask for: a sum would throw it far off
        std::vector<Vec3> move(mesh_.vertices.size());
        for_places([&](Vec3 p, std::initializer_list<std::uint32_t> around) {
            if (obstacle_.distance(p) >= clearance) return;
            Vec3 outward;
            PartSet own = 0;
            for (const std::uint32_t v : around) outward = outward + outward_[v], own |= parts_[v];
            const Vec3 m = way_out(p, normalised(outward), own, clearance);
            for (const std::uint32_t v : around)
                if (dot(m, m) > dot(move[v], move[v])) move[v] = m;
        });
        for (std::size_t v = 0; v < move.size(); ++v) mesh_.vertices[v] = mesh_.vertices[v] + move[v];
    }

    /// Calls use(place, vertices beside it) for places between the vertices: the middles of edges and of quads, nine
    /// places in a quad that is large enough for the body to bulge through.
    template <typename Use>
    void for_places(const Use& use) const {
        const auto& at = mesh_.vertices;
        for (const Link& e : edges_) use((at[e.a] + at[e.b]) * 0.5, {e.a, e.b});
        for (const Quad& q : mesh_.quads) {
            const Vec3 a = at[q[0]], b = at[q[1]], c = at[q[2]], d = at[q[3]];
            const double size = std::max(length(c - a), length(d - b));
            const int parts = size < kSmallQuad_cm ? 2 : 4;
            for (int i = 1; i < parts; ++i)
                for (int j = 1; j < parts; ++j) {
                    const double u = static_cast<double>(i) / parts, v = static_cast<double>(j) / parts;
                    use((a * (1 - u) + b * u) * (1 - v) + (d * (1 - u) + c * u) * v, {q[0], q[1], q[2], q[3]});
                }
        }
    }

    /// The last doubt: quads that still pass through a surface, where the field between its samples is not fine enough
    /// for sharp edges. Their vertices go out a little along with the cloth's outward direction.
    void part_crossings() {
        for (int round = 0; round < 25; ++round) {
            std::vector<bool> through(mesh_.vertices.size(), false);
            bool any = false;
            for (const QuadMesh& surface : obstacle_.surfaces())
                for (const auto& [quad, other] : mesh_crossings(mesh_, surface)) {
                    any = true;
                    for (const std::uint32_t v : mesh_.quads[quad]) through[v] = true;
                }
            if (!any) return;
            for (std::size_t v = 0; v < through.size(); ++v)
                if (through[v])
                    mesh_.vertices[v] = mesh_.vertices[v] +
                                        normalised(outward_[v] + obstacle_.sample(mesh_.vertices[v]).gradient) * 0.15;
        }
    }

    /// Parts cloth that passes through cloth of its layer, in small moves; each is followed by a move off the body.
    void part_from_itself(FittingReport& report) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> crossings = self_crossings(mesh_);
        report.self_crossings_before = report.self_crossings = crossings.size();
        std::vector<Vec3> best = mesh_.vertices;
        for (int round = 0, idle = 0; round < kPartingRounds && idle < kIdleRounds && !crossings.empty(); ++round) {
            std::vector<Vec3> move(mesh_.vertices.size());
            for (const auto& [a, b] : crossings) add_parting(a, b, move);
            for (std::size_t v = 0; v < move.size(); ++v) {
                const double size = length(move[v]);
                if (size > 0.0) mesh_.vertices[v] = mesh_.vertices[v] + move[v] * (kPartingStep_cm / size);
            }
            push_out(options_.clearance_cm);
            part_crossings();
            crossings = self_crossings(mesh_);
            ++idle;
            if (crossings.size() >= report.self_crossings) continue;
            idle = 0;
            report.self_crossings = crossings.size();
            best = mesh_.vertices;
        }
        mesh_.vertices = std::move(best);
    }

    /// Facing sheets draw back against their outward directions; of sheets that look the same way, the one that is
    /// farther from the body moves out and the other in.
    void add_parting(std::uint32_t a, std::uint32_t b, std::vector<Vec3>& move) const {
        const auto middle = [&](std::uint32_t q) {
            Vec3 sum;
            for (const std::uint32_t v : mesh_.quads[q]) sum = sum + mesh_.vertices[v] * 0.25;
            return sum;
        };
        const auto normal = [&](std::uint32_t q) {
            const Quad& k = mesh_.quads[q];
            return normalised(
                cross(mesh_.vertices[k[2]] - mesh_.vertices[k[0]], mesh_.vertices[k[3]] - mesh_.vertices[k[1]]));
        };
        const Vec3 na = normal(a), nb = normal(b);
        double way_a = -1.0, way_b = -1.0;
        if (dot(na, nb) > 0.0) (obstacle_.distance(middle(a)) >= obstacle_.distance(middle(b)) ? way_a : way_b) = 1.0;
        for (const std::uint32_t v : mesh_.quads[a]) move[v] = move[v] + na * way_a;
        for (const std::uint32_t v : mesh_.quads[b]) move[v] = move[v] + nb * way_b;
    }

    void fair() {
        if (options_.fairing == Fairing::Optimised) {
            even_out();
        } else {
            keep_lengths();
        }
    }

    /// Towards the mean of edge neighbours.
    void even_out() {
        std::vector<Vec3> sum(mesh_.vertices.size());
        std::vector<double> count(mesh_.vertices.size(), 0.0);
        for (const Link& e : edges_) {
            sum[e.a] = sum[e.a] + mesh_.vertices[e.b], sum[e.b] = sum[e.b] + mesh_.vertices[e.a];
            count[e.a] += 1.0, count[e.b] += 1.0;
        }
        for (std::size_t v = 0; v < sum.size(); ++v) {
            if (cloth_.drawn[v] || count[v] == 0.0) continue;
            const Vec3 to = sum[v] * (1.0 / count[v]) - mesh_.vertices[v];
            // the drawn form is kept: only what a push has bent is taken back, most where the body is near
            const double near =
                std::clamp(1.0 - (obstacle_.distance(mesh_.vertices[v]) - options_.clearance_cm) / 2.0, 0.0, 1.0);
            mesh_.vertices[v] = mesh_.vertices[v] + to * (options_.strength * near);
        }
    }

    /// Sweeps of distance constraints with a little compliance; drawn vertices stay.
    void keep_lengths() {
        constexpr double kCompliance = 0.05;
        std::vector<double> multiplier(springs_.size(), 0.0);
        for (int sweep = 0; sweep < 4; ++sweep)
            for (std::size_t i = 0; i < springs_.size(); ++i) {
                const Link& s = springs_[i];
                const Vec3 along = mesh_.vertices[s.b] - mesh_.vertices[s.a];
                const double now = length(along), wa = cloth_.drawn[s.a] ? 0.0 : 1.0,
                             wb = cloth_.drawn[s.b] ? 0.0 : 1.0;
                if (now < 1e-9 || wa + wb == 0.0) continue;
                const double change = -(now - s.rest + kCompliance * multiplier[i]) / (wa + wb + kCompliance);
                multiplier[i] += change;
                const Vec3 move = along * (options_.strength * change / now);
                mesh_.vertices[s.a] = mesh_.vertices[s.a] - move * wa;
                mesh_.vertices[s.b] = mesh_.vertices[s.b] + move * wb;
            }
    }

    [[nodiscard]] double closest() const {
        double least = std::numeric_limits<double>::max();
        for (const Vec3& v : mesh_.vertices) least = std::min(least, obstacle_.distance(v));
        for_places(
            [&](Vec3 p, std::initializer_list<std::uint32_t>) { least = std::min(least, obstacle_.distance(p)); });
        return least;
    }

    Cloth& cloth_;
    QuadMesh& mesh_;
    const Obstacle& obstacle_;
    FittingOptions options_;
    std::vector<Link> edges_, springs_;
    std::vector<Vec3> outward_;
    std::vector<PartSet> parts_;  // of each vertex, those of its pieces
};

}  // namespace

FittingReport fit_cloth(Cloth& cloth, const Obstacle& obstacle, const FittingOptions& options) {
    if (cloth.mesh.vertices.empty()) return {};
    return Fitter(cloth, obstacle, options).run();
}

std::string fitting_warning(const FittingReport& report) {
    std::string what;
    if (report.deepest_after_cm > 0.0) {
        std::array<char, 96> text{};
        std::snprintf(text.data(), text.size(), "stays up to %.2f cm inside what is below it", report.deepest_after_cm);
        what = text.data();
    }
    if (report.self_crossings > 0) {
        if (!what.empty()) what += " and ";
        what += "passes through itself at " + std::to_string(report.self_crossings) +
                (report.self_crossings == 1 ? " place" : " places");
    }
    return what.empty() ? what : "The cloth " + what + ": draw it looser there.";
}

}  // namespace core
