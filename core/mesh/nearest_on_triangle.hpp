#pragma once
// The place of a triangle that is nearest to a point.

#include "core/geometry/point.hpp"

namespace core {

/// `feature`: 0 … 2 its corners, 3 … 5 the edges from these on, 6 its inside.
/// After C. Ericson, Real-Time Collision Detection, 5.1.5.
struct NearestOnTriangle {
    Vec3 point;
    int feature = 6;
};
[[nodiscard]] inline NearestOnTriangle nearest_on_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return {a, 0};
    const Vec3 bp = p - b;
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return {b, 1};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + ab * (d1 / (d1 - d3)), 3};
    const Vec3 cp = p - c;
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return {c, 2};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + ac * (d2 / (d2 - d6)), 5};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return {b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))), 4};
    const double scale = 1.0 / (va + vb + vc);
    return {a + ab * (vb * scale) + ac * (vc * scale), 6};
}

}  // namespace core
