#pragma once
// The outline as a fixed number of samples that include the corners (thesis 5.1).

#include <cstdint>
#include <vector>

#include "core/geometry/point.hpp"

namespace core {

/// Samples of an outline lie on the finest grid (point_grid.hpp) with at most so many steps a side of their box. In a
/// silhouette of 256 pixels a sample moves by a twentieth of a pixel at most.
inline constexpr std::int64_t kOutlineSteps = 2047;

/// `count` samples of the contour in its own direction. Each stretch between two consecutive corners gets the share of
/// samples that its length has of the perimeter, rounded down but at least one (its first corner); what is left
/// over goes one by one to the stretches with the greatest cumulative cornerity. Within a stretch the samples are
/// evenly spaced by arc length. Without corners the ring is sampled evenly from its first point. `cornerity` has one
/// value a contour point. There must be fewer corners than samples; surplus corners of least cornerity are ignored.
[[nodiscard]] Polygon sample_outline(const Polygon& contour, const std::vector<double>& cornerity,
                                     const std::vector<int>& corners, int count);

/// Drops samples until no two edges of the ring cross or touch, so that it can be triangulated; a ring that is simple
/// already comes back unchanged. Thin tails need this when samples of both sides interleave. Quadratic in the samples.
[[nodiscard]] Polygon without_crossings(Polygon ring);

}  // namespace core
