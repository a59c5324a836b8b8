#pragma once
// The whole-contour descriptor of one silhouette: a second reading of a shape that knows nothing of its parts.
//
// Two views of the same outline, both of whole numbers, so that a stored descriptor is the fresh one to the last bit:
//
// - frames: at 80 points round the outline, where the rest of the outline lies as seen from there, in a frame along the
//   tangent. The rest is cut into 8 stretches, short ones near the point and long ones far from it; each gives how high
//   above the tangent it lies on average (the height functions of Wang, Bai, You, Liu and Latecki, "Shape matching and
//   classification using height functions", 2012) and how far ahead. Each number is divided by the greatest of its
//   stretch anywhere on the shape, so that no stretch outweighs another (their local normalisation).
// - cover: how much of each cell of a polar grid about the centroid the shape covers, blurred along the rings.
//
//     const core::Result<core::ContourDescriptor> d = core::describe_contour(*core::largest_contour(mask));
//     matcher.distance(core::matchable(*d), other);                          // core/contour/contour_match.hpp

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/result.hpp"
#include "core/geometry/point.hpp"

namespace core {

inline constexpr std::size_t kFramePoints = 80;
inline constexpr std::size_t kFrameStretches = 8;
inline constexpr std::size_t kFrameChannels = 2 * kFrameStretches;  ///< heights, then distances ahead
inline constexpr int kGreatestHeight = 34;                          ///< what 1 of a height is stored as …
inline constexpr int kGreatestAhead = 51;                           ///< … and of a distance ahead, which weighs more

inline constexpr std::size_t kPolarRings = 12;
inline constexpr std::size_t kPolarSectors = 32;

struct ContourDescriptor {
    /// One row a channel, one column a point, anti-clockwise. Within ±kGreatestHeight and ±kGreatestAhead.
    std::array<std::array<std::int8_t, kFramePoints>, kFrameChannels> frames{};
    /// One row a ring from the centre outwards, one column a sector, anti-clockwise. A cell is worth its area.
    std::array<std::array<std::uint8_t, kPolarSectors>, kPolarRings> cover{};
    /// How much the heights vary round the outline, in [0, 1]: near 0 for a disc, about 0.4 for a horse.
    float complexity = 0.0F;

    friend bool operator==(const ContourDescriptor&, const ContourDescriptor&) = default;
};

/// What describe_contour gives for the mirror image. mirrored(mirrored(d)) == d.
[[nodiscard]] ContourDescriptor mirrored(const ContourDescriptor& descriptor);

/// The ring runs anti-clockwise, y up, in any unit, as largest_contour gives it. The result does not depend on the
/// first point, nor on where the shape lies when it was moved by whole units; turning, scaling and mirroring change it
/// by rounding and pixel noise, up to a cyclic shift of points and sectors; a mirrored ring gives the mirrored
/// descriptor exactly. BadOutline for a ring that encloses no area (or runs clockwise), or with a coordinate that is
/// not finite. Linear in points, plus about 0.5 ms.
[[nodiscard]] Result<ContourDescriptor> describe_contour(const Polygon& contour);

}  // namespace core
