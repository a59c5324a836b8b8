#pragma once
// Where surfaces pass through each other.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/mesh/quad_mesh.hpp"

namespace core {

/// Pairs of quads, one of each mesh, of which an edge of one goes through the other; quads count as two triangles cut
/// from their first to their third corner. Touching in a plane does not count. Near linear for quads of like size.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> mesh_crossings(const QuadMesh& a, const QuadMesh& b);

/// The same within one mesh, each pair once, for quads without a common vertex.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> self_crossings(const QuadMesh& mesh);

}  // namespace core
