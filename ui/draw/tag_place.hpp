#pragma once

#include <vector>

#include "core/geometry/point.hpp"

namespace ui {

/// Where a part's number stands: on the mean of its points, or beside it where that lies outside, as between two legs:
/// then in the middle of the part's widest span at that height. The ring must not be empty. Linear.
[[nodiscard]] core::Point tag_place(const core::Polygon& ring);

/// Moves places that lie closer to each other than `apart` away from each other, as little as that takes, so that no
/// number covers another; two in one point go left and right. Where they are too many they stay as far apart as they
/// came. The number of places squared, at most 60 times.
void spread_tags(std::vector<core::Point>& places, double apart);

}  // namespace ui
