#include "core/geometry/segment.hpp"

#include <algorithm>

namespace core {

double nearest_on_segment(Vec3 p0, Vec3 p1, Vec3 point) {
    const Vec3 along = p1 - p0;
    const double square = dot(along, along);
    return square > 0.0 ? std::clamp(dot(point - p0, along) / square, 0.0, 1.0) : 0.0;
}

NearestOnSegments nearest_on_segments(Vec3 p0, Vec3 p1, Vec3 q0, Vec3 q1) {
    const Vec3 u = p1 - p0, v = q1 - q0, w = p0 - q0;
    const double a = dot(u, u), b = dot(u, v), c = dot(v, v), d = dot(u, w), e = dot(v, w);
    const double determinant = a * c - b * b;
    NearestOnSegments best;
    best.s = determinant > 1e-12 * a * c ? std::clamp((b * e - c * d) / determinant, 0.0, 1.0) : 0.0;
    best.t = nearest_on_segment(q0, q1, p0 + u * best.s);
    best.s = nearest_on_segment(p0, p1, q0 + v * best.t);
    best.distance = length(p0 + u * best.s - q0 - v * best.t);
    return best;
}

}  // namespace core
