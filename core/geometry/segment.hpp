#pragma once
// Straight segments in space: the nearest points of two.

#include "core/geometry/point.hpp"

namespace core {

struct NearestOnSegments {
    double s = 0.0, t = 0.0;  ///< 0 … 1 along the first and the second segment
    double distance = 0.0;
};

/// Where the segments p0 p1 and q0 q1 come nearest; for parallel ones one of the many places. A segment may be a point.
/// Constant time. After C. Ericson, Real-Time Collision Detection, 5.1.9.
[[nodiscard]] NearestOnSegments nearest_on_segments(Vec3 p0, Vec3 p1, Vec3 q0, Vec3 q1);

/// 0 … 1 along the segment p0 p1 where it comes nearest to `point`; 0 for a segment that is a point.
[[nodiscard]] double nearest_on_segment(Vec3 p0, Vec3 p1, Vec3 point);

}  // namespace core
