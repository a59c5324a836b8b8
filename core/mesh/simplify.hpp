#pragma once
// Makes a mesh small enough to be stored and drawn on a card.

#include <cstddef>

#include "core/base/result.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

/// A mesh of at most `most_triangles` triangles that looks like `mesh`. A mesh that is small enough comes back
/// unchanged. Vertices in one cell of a grid become one, at the place nearest to the planes of its faces; the grid is
/// the finest that leaves few enough faces. Soups, holes, duplicate and flipped faces are welcome, and colours stay
/// crisp: a corner keeps the colour it had. Parts thinner than a cell become flat, but what has area seldom goes
/// altogether. The result does not depend on anything but the input. BadArgument below 4 triangles, BadMesh for an
/// index out of range or a coordinate that is not finite, EmptyMesh when no face is left. About twelve passes of linear
/// time. After P. Lindstrom, Out-of-core simplification of large polygonal models, 2000, section 3.
[[nodiscard]] Result<TriangleMesh> simplified_mesh(const TriangleMesh& mesh, std::size_t most_triangles);

}  // namespace core
