#pragma once
// A turn in space as three angles: about x, then y, then z, all anti-clockwise seen from their axis' end, radians.

#include "core/geometry/point.hpp"

namespace core {

[[nodiscard]] Vec3 turned(Vec3 p, Vec3 turn);

/// The turn that takes x, y and z to these. They must be perpendicular, of unit length and right-handed. Where the
/// second angle is a right one, the third is 0.
[[nodiscard]] Vec3 turn_of_axes(Vec3 x, Vec3 y, Vec3 z);

/// `turn`, and then about a unit axis by `angle`.
[[nodiscard]] Vec3 turned_further(Vec3 turn, Vec3 axis, double angle);

}  // namespace core
