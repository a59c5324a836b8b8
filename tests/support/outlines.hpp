#pragma once
// Outlines of regions with given numbers of edges a side.

#include <cmath>
#include <numbers>
#include <vector>

#include "core/garment/region.hpp"

namespace support {

/// On the unit circle in the plane z = 0, anti-clockwise, every side with the same angle.
inline core::RegionOutline circle_outline(const std::vector<int>& side_edges) {
    core::RegionOutline outline;
    const std::size_t n = side_edges.size();
    const auto at = [n](std::size_t side, double share) {
        const double angle = 2.0 * std::numbers::pi * (static_cast<double>(side % n) + share) / static_cast<double>(n);
        return core::Vec3{std::cos(angle), std::sin(angle), 0.0};
    };
    for (std::size_t i = 0; i < n; ++i) {
        auto& points = outline.sides.emplace_back();
        for (int k = 0; k < side_edges[i]; ++k) points.push_back(at(i, static_cast<double>(k) / side_edges[i]));
        points.push_back(at(i + 1, 0.0));
    }
    return outline;
}

/// A quad of a mesh in the plane z = 0 that is not strictly convex and anti-clockwise, or -1.
inline int folded_quad(const core::QuadMesh& mesh) {
    for (std::size_t i = 0; i < mesh.quads.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) {
            const core::Quad& q = mesh.quads[i];
            const core::Vec3 here = mesh.vertices[q[k]];
            if (core::cross(mesh.vertices[q[(k + 1) % 4]] - here, mesh.vertices[q[(k + 3) % 4]] - here).z <= 0.0)
                return static_cast<int>(i);
        }
    return -1;
}

}  // namespace support
