#include "core/mesh/plane_section.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

#include "core/geometry/polygon.hpp"

namespace core {
namespace {

struct Crossing {
    std::uint64_t edge;  // both its vertices
    Point place;
};

/// Two crossings in a row for every triangle cut. A vertex in the plane counts as above it.
std::vector<Crossing> crossings(const QuadMesh& mesh, const CutPlane& plane) {
    const Vec3 normal = cross(plane.right, plane.up);
    std::vector<double> height;
    height.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) height.push_back(dot(v - plane.origin, normal));
    std::vector<Crossing> out;
    const auto cut = [&](std::uint32_t a, std::uint32_t b) {
        if ((height[a] < 0.0) == (height[b] < 0.0)) return;
        if (a > b) std::swap(a, b);
        const double t = height[a] / (height[a] - height[b]);
        const Vec3 p = mesh.vertices[a] * (1.0 - t) + mesh.vertices[b] * t - plane.origin;
        out.push_back({std::uint64_t{a} << 32 | b, {dot(p, plane.right), dot(p, plane.up)}});
    };
    for (const Quad& q : mesh.quads) {
        const bool side = height[q[0]] < 0.0;
        if (side == (height[q[1]] < 0.0) && side == (height[q[2]] < 0.0) && side == (height[q[3]] < 0.0)) continue;
        for (const auto& t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}})
            for (std::size_t k = 0; k < 3; ++k) cut(t[k], t[(k + 1) % 3]);
    }
    return out;
}

bool holds_origin(const Polygon& hull) {
    for (std::size_t i = 0; i < hull.size(); ++i)
        if (cross(hull[i], hull[(i + 1) % hull.size()]) < 0.0) return false;
    return hull.size() > 2;
}

double circumference(const Polygon& hull) {
    double sum = 0.0;
    for (std::size_t i = 0; i < hull.size(); ++i) sum += distance(hull[i], hull[(i + 1) % hull.size()]);
    return sum;
}

}  // namespace

std::vector<std::vector<Point>> plane_section(const QuadMesh& mesh, const CutPlane& plane) {
    const std::vector<Crossing> cuts = crossings(mesh, plane);
    std::vector<std::size_t> order(cuts.size()), parent(cuts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    const auto unite = [&](std::size_t i, std::size_t j) {
        i = find(i), j = find(j);
        parent[std::max(i, j)] = std::min(i, j);
    };
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) unite(i, i + 1);
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return cuts[i].edge != cuts[j].edge ? cuts[i].edge < cuts[j].edge : i < j;
    });
    for (std::size_t k = 0; k + 1 < order.size(); ++k)
        if (cuts[order[k]].edge == cuts[order[k + 1]].edge) unite(order[k], order[k + 1]);
    std::vector<std::vector<Point>> pieces;
    std::vector<std::size_t> piece_of(cuts.size());
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (find(i) == i) {
            piece_of[i] = pieces.size();
            pieces.emplace_back();
        }
        pieces[piece_of[find(i)]].push_back(cuts[i].place);
    }
    return pieces;
}

double hull_length(std::vector<Point> points) {
    return circumference(convex_hull(std::move(points)));
}

double tape_length(const QuadMesh& mesh, const CutPlane& plane) {
    double nearest = std::numeric_limits<double>::max(), best = 0.0;
    for (std::vector<Point>& piece : plane_section(mesh, plane)) {
        const Polygon hull = convex_hull(std::move(piece));
        double distance_to = std::numeric_limits<double>::max();
        for (const Point& p : hull) distance_to = std::min(distance_to, length(p));
        if (holds_origin(hull)) distance_to = 0.0;
        if (distance_to >= nearest) continue;
        nearest = distance_to;
        best = circumference(hull);
    }
    return best;
}

}  // namespace core
