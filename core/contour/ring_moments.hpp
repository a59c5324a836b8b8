#pragma once
// Area, centroid and second moments of what a ring encloses, by sums over its edges (Green's theorem).

#include "core/geometry/point.hpp"

namespace core {

struct RingMoments {
    double area = 0.0;  ///< signed: positive for an anti-clockwise ring
    Point centroid;
    // Second moments about the centroid over the area: mean of squares of the distances, in square units.
    double xx = 0.0, xy = 0.0, yy = 0.0;

    /// Direction of the axis along which the shape is longest, in (-pi/2, pi/2]; 0 for a round one.
    [[nodiscard]] double long_axis_rad() const;
    /// Spread along the long axis and across it, >= 0.
    struct Spread {
        double along = 0.0, across = 0.0;
    };
    [[nodiscard]] Spread spread() const;
};

/// A ring without area gives an area of 0, and nothing else of use. Linear.
[[nodiscard]] RingMoments ring_moments(const Polygon& ring);

}  // namespace core
