#pragma once
// Flow lines of a quad mesh: the bands of quads joined at opposite edges.

#include <span>

#include "core/mesh/quad_mesh.hpp"

namespace core {

/// How many bands close up without coming to an edge that only one quad has. Linear time.
[[nodiscard]] int count_closed_flow_loops(std::span<const Quad> quads);

}  // namespace core
