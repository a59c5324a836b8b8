#pragma once
// The line in the middle of a mirrored garment, where a designer left it out.

#include <string>

#include "core/garment/drawing.hpp"
#include "core/garment/network.hpp"

namespace core {

/// What such lines are called, with a number.
inline constexpr const char* kMiddleLine = "middle";

/// Whether two places in the plane x = 0 lie on one side of the body: both before it or both behind it; a place below
/// or above it, as between the legs, goes with either.
[[nodiscard]] bool is_one_side(const Obstacle& body, Vec3 a, Vec3 b);

/// From one place in the plane x = 0 to another, in that plane: straight, and where that would come nearer to the body
/// than its ends are (half a centimetre at least), around it.
[[nodiscard]] SketchStroke middle_stroke(const Obstacle& body, Vec3 from, Vec3 to);

/// Whether the line of this name lies in the middle, on the same side of the body as `shape` and beside all of it.
[[nodiscard]] bool runs_along(const Network& network, int layer, const std::string& name, const SpaceLine& shape,
                              const Obstacle& body);

}  // namespace core
