#pragma once
// How much of each cell of a polar grid a shape covers.

#include <array>

#include "core/contour/contour_descriptor.hpp"
#include "core/contour/ring_moments.hpp"

namespace core {

/// Sectors count from the long axis of the shape, rings of equal width from the centroid out to 2.5 units, a unit being
/// the geometric mean of the radii of two discs: of equal area, and of equal second moment. What lies beyond is left
/// out. Blurred along each ring by a Gaussian, so that a part may turn a little. 255 is a whole cell of the last ring.
/// The coverage is exact along four rays a sector. The ring must enclose an area, `moments` are its own; linear.
[[nodiscard]] std::array<std::array<std::uint8_t, kPolarSectors>, kPolarRings> polar_cover(const Polygon& ring,
                                                                                           const RingMoments& moments);

}  // namespace core
