#pragma once
// A body that is quickly made: an upright, rounded post.

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/mesh/distance_grid.hpp"

namespace support {

/// Around the y axis, from y = 0 to `height`, of radius `radius`, with rounded ends.
inline core::TriangleMesh post(double radius, double height) {
    constexpr int kAround = 32, kRings = 24;
    core::TriangleMesh mesh;
    const auto ring = [&](double y, double r) {
        for (int k = 0; k < kAround; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kAround;
            mesh.vertices.push_back({r * std::sin(angle), y, r * std::cos(angle)});
        }
    };
    mesh.vertices.push_back({0, 0, 0});
    for (int i = 1; i <= kRings; ++i) {
        const double t = static_cast<double>(i) / (kRings + 1), y = height * t;
        const double end = std::min(y, height - y);
        ring(y, end < radius ? std::sqrt(radius * radius - (radius - end) * (radius - end)) : radius);
    }
    mesh.vertices.push_back({0, height, 0});
    const auto at = [](int i, int k) { return static_cast<std::uint32_t>(1 + i * kAround + k % kAround); };
    const auto top = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    for (int k = 0; k < kAround; ++k) {
        mesh.triangles.push_back({0, at(0, k + 1), at(0, k)});
        for (int i = 0; i + 1 < kRings; ++i) {
            mesh.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
            mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
        }
        mesh.triangles.push_back({at(kRings - 1, k), at(kRings - 1, k + 1), top});
    }
    return mesh;
}

}  // namespace support
