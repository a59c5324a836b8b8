#pragma once
// Cornerity of contour points, and the corners among them (thesis 5.5, after [53]).

#include <vector>

#include "core/geometry/point.hpp"

namespace core {

/// Distance of each contour point to the centroid of itself and the points half a window before and after, in the
/// contour's units; 0 on straight stretches. Cyclic: turning the list turns the answer. Linear time.
[[nodiscard]] std::vector<double> cornerity(const Polygon& contour, int window);

/// Indices, ascending, of the corners: points of greatest cornerity within half a window on either side (the
/// non-maximum suppression that plateaus need) that exceed more than `extent * window` of the points in their window.
/// A circle, where all are equal, has none.
[[nodiscard]] std::vector<int> corners(const std::vector<double>& cornerity, int window, double extent);

}  // namespace core
