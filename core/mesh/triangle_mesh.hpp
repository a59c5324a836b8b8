#pragma once
// A triangle mesh as it comes from a file or from the starter collection: a soup is welcome, no topology is promised.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/point.hpp"

namespace core {

struct Rgb {
    std::uint8_t r = 216, g = 207, b = 191;  ///< the design's clay when a file names no colour
    friend bool operator==(const Rgb&, const Rgb&) = default;
};

struct TriangleMesh {
    std::vector<Vec3> vertices;                           ///< any unit, any side up
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into vertices; either winding
    std::vector<Rgb> colours;                             ///< one per vertex, or empty: all clay

    [[nodiscard]] bool empty() const { return triangles.empty(); }
};

}  // namespace core
