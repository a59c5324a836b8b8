#pragma once
// The axis of least inertia of a region, and the copy scaled along it that the triangulation reads (thesis 5.1).

#include "core/geometry/point.hpp"

namespace core {

/// The region's mean and the unit direction along which it extends most (the axis of least inertia).
struct InertiaAxis {
    Point centre;
    Point direction{1.0, 0.0};
};

/// From the second moments of the area inside the ring. A ring without area, and one as round as a disc, where the axis
/// is undefined, give the direction (1, 0).
[[nodiscard]] InertiaAxis axis_of_least_inertia(const Polygon& ring);

/// The ring stretched by `factor` along the axis, about its centre. For the triangulation alone: near-circular arcs, on
/// which Delaunay is a matter of rounding, then triangulate in one way.
[[nodiscard]] Polygon stretched_along(const Polygon& ring, const InertiaAxis& axis, double factor);

}  // namespace core
