#pragma once

#include "core/mesh/triangle_mesh.hpp"

namespace core {

/// The mesh without the vertices that no triangle uses; the others keep their order. Indices must be in range. Linear
/// time.
[[nodiscard]] TriangleMesh without_unused_vertices(const TriangleMesh& mesh);

}  // namespace core
