#pragma once
// Ways along the lines of a network.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/garment/desk/desk_tool.hpp"

namespace core {

/// The shortest way from one vertex to another along lines that may be taken; empty when there is none.
[[nodiscard]] std::vector<LineUse> way_along(const Network& network, int layer, int from, int to,
                                             const std::function<bool(const NetworkLine&)>& may_take);

/// The shortest ring through all pieces of a line and, between its two ends, other lines of its layer. Nothing for a
/// line that is closed or whose ends no other lines join.
[[nodiscard]] std::optional<std::vector<LineUse>> ring_with_line(const Network& network, int layer,
                                                                 const std::string& name);

/// Where two lines cross as they are seen along the way out of the body, within 1.5 cm of each other along it, and not
/// where both end.
struct LineCrossing {
    int line = 0, other = 0;  ///< may be the same
    Vec3 at, to;              ///< on the one and on the other
};
/// The first crossing of any piece of this name with any line of its layer that is not near to one of `refused`;
/// nothing for none. Quadratic in the points of the piece and of what lies near it.
[[nodiscard]] std::optional<LineCrossing> first_crossing(const Network& network, int layer, const std::string& name,
                                                         const Obstacle& body, const std::vector<Vec3>& refused = {});

/// The stretch of a line between the places nearest to two others, in its direction.
[[nodiscard]] SpaceLine stretch_between(const SpaceLine& line, Vec3 from, Vec3 to);

/// The region whose corner a tap means: the one under the pen if the vertex or line is on its ring, or else the first
/// that passes it; null for none.
[[nodiscard]] const NetworkRegion* region_at_corner(const Network& network, int layer, const Pick& vertex,
                                                    const Pick& line, const Pick& region);

}  // namespace core
