#pragma once
// A surface of quadrilaterals: what cloth and mannequins are made of.

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/point.hpp"

namespace core {

using Quad = std::array<std::uint32_t, 4>;  ///< indices of its corners, anti-clockwise seen from outside

/// Where the four corners of a quad lie on a picture, or on the flat cloth: to the right and up, in the mesh's unit.
using QuadTexture = std::array<Point, 4>;

struct QuadMesh {
    std::vector<Vec3> vertices;
    std::vector<Quad> quads;
};

}  // namespace core
