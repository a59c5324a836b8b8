#pragma once
// Measures of closed rings (Polygon) and open chains (Polyline).

#include "core/geometry/point.hpp"

namespace core {

/// Signed area in square units: positive when the ring runs anti-clockwise (y up). 0 for fewer than three points.
[[nodiscard]] double signed_area(const Polygon& ring);

/// Length round the ring, the closing edge included. 0 for fewer than two points.
[[nodiscard]] double perimeter(const Polygon& ring);

/// Length of the open chain.
[[nodiscard]] double chain_length(const Polyline& chain);

/// Mean of the points. The ring must not be empty.
[[nodiscard]] Point centroid_of_points(const std::vector<Point>& points);

/// Convex hull, anti-clockwise, collinear points left out (Andrew's monotone chain). n log n.
/// Fewer than three distinct points, or all on one line, give the one or two extreme points.
[[nodiscard]] Polygon convex_hull(std::vector<Point> points);

/// A rectangle in any direction: side lengths along the unit vectors `axis` and its anti-clockwise normal.
struct OrientedRectangle {
    Point axis{1.0, 0.0};
    double along = 0.0;   ///< extent along axis
    double across = 0.0;  ///< extent across axis
    [[nodiscard]] double area() const { return along * across; }
};

/// The enclosing rectangle of least area, by rotating calipers over the hull edges. `hull` as convex_hull gives it.
/// One point gives a rectangle of size 0, two points one of width 0. Linear in hull edges times hull points.
[[nodiscard]] OrientedRectangle least_rectangle(const Polygon& hull);

/// `count` points evenly spaced by arc length round the ring, the first at ring[0].
/// The ring needs at least one point and count >= 1; a ring without length repeats its first point.
[[nodiscard]] Polygon resample_ring(const Polygon& ring, int count);

/// `count` points evenly spaced by arc length along the chain, both ends included. count >= 2.
[[nodiscard]] Polyline resample_chain(const Polyline& chain, int count);

}  // namespace core
