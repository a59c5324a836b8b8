#pragma once
// Grids of the plane whose step is a power of two and which pass through the origin: where points go that are stored.
// Points on such a grid are exact in double precision, and rounding them to the same or a finer grid changes nothing.

#include <cstdint>
#include <vector>

#include "core/geometry/point.hpp"

namespace core {

inline constexpr int kFinestGrid = -60;  ///< exponents of two of the smallest and the largest step
inline constexpr int kCoarsestGrid = 20;
inline constexpr std::int64_t kFarthestGridLine = std::int64_t{1} << 40;  ///< so that every grid point is a double

/// The grid line nearest to `value`, counted from the origin, halves away from it.
[[nodiscard]] double grid_line(double value, int exponent);

/// Where that line lies: a point moves by at most half a step.
[[nodiscard]] Point on_grid(Point p, int exponent);

/// The finest grid (its step is 2 to the power of the result) on which the points' box has at most `most_steps` steps a
/// side and all lines are within kFarthestGridLine; kCoarsestGrid where there is none, kFinestGrid without points.
/// Coordinates must be finite. Rounding is monotonic, so what fits once fits again after rounding. Linear time.
[[nodiscard]] int finest_grid(const std::vector<Point>& points, std::int64_t most_steps);

}  // namespace core
