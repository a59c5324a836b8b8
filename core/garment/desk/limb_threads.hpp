#pragma once
// What tells an opening from a piece of cloth: a thread through a limb passes the one, never the other.

#include <vector>

#include "core/garment/obstacle.hpp"
#include "core/geometry/space_line.hpp"

namespace core {

/// Lines through the inside of a body, from far beyond a hand or foot through the limb, the trunk and the head and far
/// up: cloth lies outside of the body, so that none passes through it, while the border of a sleeve's, a leg's, a hem's
/// or a neck's opening has one or more through it. Empty where the parts of the body are not known.
[[nodiscard]] std::vector<SpaceLine> limb_threads(const PartSurface& parts);

/// How often a thread passes the cone over a line from one fixed place: summed over the lines of a closed border, each
/// in the border's direction, it is the linking number of the two, how often the thread passes through the border.
[[nodiscard]] int passes_cone(const SpaceLine& thread, const SpaceLine& line);

}  // namespace core
