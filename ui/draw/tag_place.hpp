#pragma once

#include "core/geometry/point.hpp"

namespace ui {

/// Where a part's number stands: on the mean of its points, or beside it where that lies outside, as between two legs:
/// then in the middle of the part's widest span at that height. The ring must not be empty. Linear.
[[nodiscard]] core::Point tag_place(const core::Polygon& ring);

}  // namespace ui
