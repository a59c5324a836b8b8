#pragma once
// The cut line around a piece: its sew line moved outward by the allowances.

#include <vector>

#include "core/geometry/point.hpp"

namespace core {

/// `ring` anti-clockwise, `away`[i] the distance for its edge from point i to the next, 0 or more. Corners are mitred,
/// cut off where they would reach farther than three times the distance; small loops that moving makes at hollow places
/// are taken out. Quadratic in the points.
[[nodiscard]] Polygon moved_outward(const Polygon& ring, const std::vector<double>& away);

}  // namespace core
