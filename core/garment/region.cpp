#include "core/garment/region.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>

#include "core/geometry/segment.hpp"
#include "core/mesh/mesh_welder.hpp"

namespace core {
namespace {

Unexpected bad(std::string what) {
    return unexpected(ErrorCode::BadOutline, std::move(what));
}

std::string side_name(std::size_t side) {
    return "Side " + std::to_string(side + 1);
}

/// The longest edge of the bounding box.
double size_of(const std::vector<Vec3>& points) {
    Vec3 low = points[0], high = points[0];
    for (const Vec3& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

Result<std::vector<Vec3>> ring_of_sides(const RegionOutline& outline) {
    if (outline.sides.size() < kFewestSides || outline.sides.size() > kMostSides)
        return bad("The region has " + std::to_string(outline.sides.size()) +
                   " sides; 2 to 8 can be filled: mark or "
                   "unmark corners.");
    std::vector<Vec3> ring;
    for (std::size_t i = 0; i < outline.sides.size(); ++i) {
        const std::vector<Vec3>& side = outline.sides[i];
        if (side.size() < 2) return bad(side_name(i) + " has fewer than 2 points: draw it longer or leave it out.");
        for (std::size_t k = 0; k < side.size(); ++k) {
            if (!is_usable(side[k]))
                return bad(side_name(i) + " has a coordinate that is no finite number, at point " +
                           std::to_string(k + 1) + ".");
            if (k + 1 < side.size()) ring.push_back(side[k]);
        }
    }
    return ring;
}

Result<void> check_joins(const RegionOutline& outline, double size) {
    for (std::size_t i = 0; i < outline.sides.size(); ++i) {
        const std::size_t next = (i + 1) % outline.sides.size();
        if (!(length(outline.sides[i].back() - outline.sides[next].front()) <= kJoinTolerance * size))
            return bad("The region is not closed: side " + std::to_string(i + 1) + " does not end where side " +
                       std::to_string(next + 1) + " starts.");
    }
    return {};
}

/// Of which side, from 1 on, each edge of the ring is.
std::vector<std::size_t> side_of_edges(const RegionOutline& outline) {
    std::vector<std::size_t> sides;
    for (std::size_t i = 0; i < outline.sides.size(); ++i)
        sides.insert(sides.end(), outline.sides[i].size() - 1, i + 1);
    return sides;
}

/// Sweeps along x. Neighbouring edges are left out: they share a point.
Result<void> check_crossings(const std::vector<Vec3>& ring, const std::vector<std::size_t>& side, double tolerance) {
    const std::size_t n = ring.size();
    const auto end = [&](std::size_t i) { return ring[(i + 1) % n]; };
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto low_x = [&](std::size_t i) { return std::min(ring[i].x, end(i).x); };
    const auto high_x = [&](std::size_t i) { return std::max(ring[i].x, end(i).x); };
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return low_x(i) != low_x(j) ? low_x(i) < low_x(j) : i < j; });
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a + 1; b < n && low_x(order[b]) <= high_x(order[a]) + tolerance; ++b) {
            const std::size_t i = order[a], j = order[b];
            if ((i + 1) % n == j || (j + 1) % n == i) continue;
            if (std::min(ring[j].y, end(j).y) > std::max(ring[i].y, end(i).y) + tolerance ||
                std::min(ring[i].y, end(i).y) > std::max(ring[j].y, end(j).y) + tolerance)
                continue;
            if (nearest_on_segments(ring[i], end(i), ring[j], end(j)).distance > tolerance) continue;
            return bad("The outline meets itself: side " + std::to_string(std::min(side[i], side[j])) + " and side " +
                       std::to_string(std::max(side[i], side[j])) + " touch or cross; draw them apart.");
        }
    return {};
}

/// The unit normal of the plane all points lie in; zero when there is none.
Vec3 plane_normal(const std::vector<Vec3>& ring) {
    Vec3 area;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) area = area + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    const Vec3 normal = normalised(area);
    const double tolerance = 1e-9 * size_of(ring);
    for (const Vec3& p : ring)
        if (std::abs(dot(p - ring[0], normal)) > tolerance) return {};
    return normal;
}

bool has_fold(const QuadMesh& mesh, Vec3 normal) {
    for (const Quad& q : mesh.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec3 here = mesh.vertices[q[k]];
            const Vec3 turn = cross(mesh.vertices[q[(k + 1) % 4]] - here, mesh.vertices[q[(k + 3) % 4]] - here);
            if (dot(turn, normal) < 0.0) return true;
        }
    return false;
}

/// Four sides, opposite ones with as many edges: a Coons patch there is the sum of what the sides do, however high they
/// arch, and swings nowhere.
bool is_grid(const RegionTopology& topology) {
    return topology.counts.irregular() == 0 &&
           std::count(topology.is_corner.begin(), topology.is_corner.end(), true) == 4;
}

/// Whether inner vertices leave the ring's bounding box, or inner edges are much longer than the ring's.
bool swings_out(const QuadMesh& mesh, const std::vector<Vec3>& ring) {
    Vec3 low = ring[0], high = ring[0];
    double longest = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec3 p = ring[i];
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        longest = std::max(longest, length(ring[(i + 1) % ring.size()] - p));
    }
    const double slack = 0.05 * size_of(ring);
    for (std::size_t v = ring.size(); v < mesh.vertices.size(); ++v) {
        const Vec3 p = mesh.vertices[v];
        if (p.x < low.x - slack || p.y < low.y - slack || p.z < low.z - slack || p.x > high.x + slack ||
            p.y > high.y + slack || p.z > high.z + slack)
            return true;
    }
    for (const Quad& q : mesh.quads)
        for (std::size_t k = 0; k < 4; ++k)
            if (length(mesh.vertices[q[(k + 1) % 4]] - mesh.vertices[q[k]]) > 4.0 * longest) return true;
    return false;
}

}  // namespace

Result<std::vector<Vec3>> outline_ring(const RegionOutline& outline) {
    Result<std::vector<Vec3>> ring = ring_of_sides(outline);
    if (!ring) return ring;
    const double size = size_of(*ring);
    if (const Result<void> joined = check_joins(outline, size); !joined) return unexpected(joined.error());
    const std::vector<std::size_t> side = side_of_edges(outline);
    for (std::size_t i = 0; i < ring->size(); ++i)
        if (!(length((*ring)[(i + 1) % ring->size()] - (*ring)[i]) > 1e-9 * size))
            return bad("Side " + std::to_string(side[i]) +
                       " has an edge without length: two of its points are at one "
                       "place.");
    if (const Result<void> apart = check_crossings(*ring, side, 1e-9 * size); !apart) return unexpected(apart.error());
    return ring;
}

Result<RegionTopology> outline_topology(const RegionOutline& outline) {
    std::vector<int> edges;
    for (const auto& side : outline.sides) edges.push_back(static_cast<int>(side.size()) - 1);
    return fill_topology(edges);
}

FilledRegion fill_ring(RegionTopology topology, const std::vector<Vec3>& ring, double alpha) {
    FilledRegion filled{std::move(topology), {ring, {}}, 0.0};
    filled.mesh.quads = filled.topology.quads;
    filled.mesh.vertices.resize(filled.topology.vertices);
    PermanencePatch patch(filled.mesh.quads, filled.topology.vertices, filled.topology.boundary, alpha);
    patch.solve(filled.mesh.vertices);
    filled.alpha = patch.alpha();
    const Vec3 normal = plane_normal(ring);
    const bool grid = is_grid(filled.topology);
    const auto good = [&](const QuadMesh& mesh) {
        return (grid || !swings_out(mesh, ring)) && (normal == Vec3{} || !has_fold(mesh, normal));
    };
    if (filled.alpha == kHarmonicAlpha || good(filled.mesh)) return filled;
    QuadMesh flatter = filled.mesh;
    for (const double share : {0.998, 0.99, 0.95, 0.8, 0.5, 0.25, 0.0}) {
        patch.set_alpha(filled.alpha * share);
        patch.solve(flatter.vertices);
        if (!good(flatter)) continue;
        filled.mesh = std::move(flatter);
        filled.alpha = patch.alpha();
        break;
    }
    return filled;
}

Result<FilledRegion> fill_region(const RegionOutline& outline, double alpha) {
    const Result<std::vector<Vec3>> ring = outline_ring(outline);
    if (!ring) return unexpected(ring.error());
    Result<RegionTopology> topology = outline_topology(outline);
    if (!topology) return unexpected(topology.error());
    return fill_ring(std::move(*topology), *ring, alpha);
}

}  // namespace core
