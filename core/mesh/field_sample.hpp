#pragma once
// What a distance field says at a place.

#include "core/geometry/point.hpp"

namespace core {

struct FieldSample {
    double distance = 0.0;  ///< negative inside
    Vec3 gradient;          ///< where it grows, of length 1 or nearly so; zero where nothing is known
};

}  // namespace core
