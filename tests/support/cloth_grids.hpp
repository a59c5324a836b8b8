#pragma once
// Grids of quads bent into known surfaces, for tests of cloth.

#include <cmath>
#include <cstdint>

#include "core/garment/cloth.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace support {

/// wide x high quads; place(u, v) for u, v in 0 … 1. Anti-clockwise where u runs right and v up.
template <typename Place>
core::QuadMesh bent_grid(int wide, int high, const Place& place) {
    core::QuadMesh mesh;
    for (int j = 0; j <= high; ++j)
        for (int i = 0; i <= wide; ++i)
            mesh.vertices.push_back(place(static_cast<double>(i) / wide, static_cast<double>(j) / high));
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (wide + 1) + i); };
    for (int j = 0; j < high; ++j)
        for (int i = 0; i < wide; ++i) mesh.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return mesh;
}

/// Of a cylinder about the y axis, seen from outside; its arc is 0.8 of a turn.
inline core::QuadMesh cylinder_panel(int wide, int high, double radius, double height) {
    return bent_grid(wide, high, [=](double u, double v) {
        const double angle = 0.8 * 6.283185307179586 * (u - 0.5);
        return core::Vec3{radius * std::sin(angle), height * v, radius * std::cos(angle)};
    });
}

/// Of a cone about the y axis, half a turn; `below` and `above` are radii.
inline core::QuadMesh cone_panel(int wide, int high, double below, double above, double height) {
    return bent_grid(wide, high, [=](double u, double v) {
        const double angle = 3.141592653589793 * (u - 0.5), radius = below + (above - below) * v;
        return core::Vec3{radius * std::sin(angle), height * v, radius * std::cos(angle)};
    });
}

/// One piece, nothing of it drawn but its border.
inline core::Cloth one_piece(core::QuadMesh mesh, const char* name = "piece") {
    core::Cloth cloth;
    cloth.pieces.push_back({name, 0, 0, mesh.quads.size(), {}, 0.0});
    cloth.drawn.assign(mesh.vertices.size(), false);
    cloth.mesh = std::move(mesh);
    for (const auto& [a, b] : core::edges_of(cloth).hems) cloth.drawn[a] = cloth.drawn[b] = true;
    return cloth;
}

}  // namespace support
