#pragma once
// The ring of visual parts: terminals in anti-clockwise order, and the wings that group them (thesis 5.3.2).

#include "core/parts/depth.hpp"
#include "core/parts/descriptor.hpp"

namespace core {

/// Terminals first, anti-clockwise from the one whose arc starts at the lowest sample; then the wings, ascending by
/// (first_terminal, terminal_count). A wing is a subtree that groups no more than parameters.wing_salient_limit salient
/// terminals, and differs by parameters.wing_step from every part with the same terminals; none contains the root. A
/// shape without terminals gives nothing.
[[nodiscard]] std::vector<Part> parts_of(const Skeleton& skeleton, const PartTree& tree,
                                         const ShapeParameters& parameters);

}  // namespace core
