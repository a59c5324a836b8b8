#pragma once
// The measure tape: girths as a tape lies, by the hull of a cut, and lengths along a drawn line.

#include "core/garment/desk/desk_tool.hpp"
#include "core/mesh/plane_section.hpp"

namespace core {

/// Around the piece of the cut that is nearest to the plane's origin. Nothing drawn and 0 cm when the plane misses.
[[nodiscard]] TapeReading girth_of(const QuadMesh& mesh, const CutPlane& plane);

[[nodiscard]] TapeReading length_of(SpaceLine line);

}  // namespace core
