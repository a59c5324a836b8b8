#pragma once
// How far two surfaces of cloth lie apart.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/geometry/space_line.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace support {

/// From a place to the nearest of a mesh's triangles, two for each quad.
inline double distance_to(const core::QuadMesh& mesh, core::Vec3 p) {
    double least = 1e9;
    for (const core::Quad& q : mesh.quads)
        for (const auto& t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
            const core::Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
            if (core::length(a - p) > least + 12.0) continue;  // no quad is as long
            const core::Vec3 n = core::cross(b - a, c - a);
            const double d = core::dot(p - a, n) / std::max(1e-12, core::length(n));
            const core::Vec3 on = p - core::normalised(n) * d;
            const bool inside = core::dot(core::cross(b - a, on - a), n) >= 0 &&
                                core::dot(core::cross(c - b, on - b), n) >= 0 &&
                                core::dot(core::cross(a - c, on - c), n) >= 0;
            if (inside) {
                least = std::min(least, std::abs(d));
                continue;
            }
            for (const auto& [u, v] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
                least = std::min(least, core::nearest_on_line({u, v}, p).distance);
        }
    return least;
}

struct ClothDistance {
    double median = 0.0, most_of = 0.0, largest = 0.0;  ///< most_of: 95 of 100 places are no farther
};

/// From every third vertex of each to the other, the worse of the two ways.
inline ClothDistance distance_between(const core::QuadMesh& a, const core::QuadMesh& b) {
    ClothDistance out;
    for (const auto& [from, to] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
        std::vector<double> away;
        for (std::size_t v = 0; v < from->vertices.size(); v += 3) away.push_back(distance_to(*to, from->vertices[v]));
        if (away.empty()) continue;
        std::sort(away.begin(), away.end());
        out.median = std::max(out.median, away[away.size() / 2]);
        out.most_of = std::max(out.most_of, away[away.size() * 95 / 100]);
        out.largest = std::max(out.largest, away.back());
    }
    return out;
}

}  // namespace support
