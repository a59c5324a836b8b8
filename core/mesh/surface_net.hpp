#pragma once
// A closed quad mesh of the surface where a sampled field is 0.

#include <cstdint>
#include <vector>

#include "core/mesh/quad_mesh.hpp"

namespace core {

/// Field values at the corners of a regular grid, negative inside, x fastest.
struct FieldGrid {
    Vec3 origin;
    double cell = 1.0;
    int nx = 0, ny = 0, nz = 0;
    std::vector<float> value;

    [[nodiscard]] std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(nx) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] Vec3 place(int x, int y, int z) const { return origin + Vec3{x * cell, y * cell, z * cell}; }
};

/// Makes the surface a manifold where a cell holds two sheets: corners that keep them apart become barely inside, so
/// that gaps narrower than two cells may close. Each pass is linear in the grid; few are needed.
void join_double_sheets(FieldGrid& grid);

/// One vertex in each cell that the surface crosses, at the mean of its crossings; one quad, anti-clockwise seen from
/// outside, for each edge that it crosses (S. Gibson, Constrained elastic surface nets, 1998). The outermost layers of
/// the grid must be outside; then every edge of the mesh has an even number of quads. It has two, and the mesh is a
/// manifold, after join_double_sheets. Linear time.
[[nodiscard]] QuadMesh surface_net(const FieldGrid& grid);

/// Every edge has exactly two quads, which pass it in opposite directions, and the quads around every vertex form one
/// fan. Linear time, but for sorting.
[[nodiscard]] bool is_closed_manifold(const QuadMesh& mesh);

}  // namespace core
