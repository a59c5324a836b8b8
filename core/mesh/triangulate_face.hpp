#pragma once
// Cuts one polygon of a mesh file, of any number of corners, into triangles.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/point.hpp"

namespace core {

/// Triangles over the corner numbers 0 … corners.size()-1, appended to `out`: corners.size()-2 of them, none for fewer
/// than three corners. Concave faces are cut by ear clipping in the plane that fits them best (Newell's normal), so
/// that no triangle covers what the face does not. A face that crosses itself, has no area or has more than 1000
/// corners becomes a fan as far as no ear is found. Quadratic to cubic in the corners up to that number.
void triangulate_face(std::span<const Vec3> corners, std::vector<std::array<std::uint32_t, 3>>& out);

}  // namespace core
