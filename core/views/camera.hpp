#pragma once
// A parallel camera on the unit sphere, looking at the origin (thesis 7.1.1).
//
// Models are looked at in their normalised frame: the centre of the bounding box at the origin, the farthest vertex at
// distance 1. So every silhouette lies in the square [-1, 1] x [-1, 1] of the image plane, x to the right and y up.

#include "core/geometry/point.hpp"

namespace core {

struct Camera {
    Vec3 direction{0.0, 0.0, 1.0};  ///< unit, from the origin towards the camera
    Vec3 up{0.0, 1.0, 0.0};         ///< unit, perpendicular to direction

    [[nodiscard]] Vec3 right() const { return cross(up, direction); }
    /// Where a point of the normalised frame appears.
    [[nodiscard]] Point project(Vec3 p) const { return {dot(right(), p), dot(up, p)}; }
    /// Larger is nearer to the camera.
    [[nodiscard]] double nearness(Vec3 p) const { return dot(direction, p); }
};

}  // namespace core
