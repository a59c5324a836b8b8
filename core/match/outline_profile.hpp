#pragma once
// How two outlines differ once parts have been matched: the thesis's future work (8.2), the distance recomputed from
// the correspondence that was found.
//
// Matched parts say which stretch of one outline answers to which of the other, and so does what lies between them.
// Along this alignment the outlines are compared by height functions: seen from a point, with the tangent laid flat,
// how high the rest of the outline stands. After <Wang, Bai, You, Liu, Latecki: Shape matching and classification using
// height functions, 2012>; we differ in the alignment, which comes from the parts and needs no dynamic program, and in
// the number format: eight bits, so that a comparison is a few hundred integer operations.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "core/geometry/point.hpp"

namespace core {

/// A place on an outline in 1/65536 of its perimeter, counted in the ring's direction; it wraps round by itself.
using OutlinePlace = std::uint16_t;

inline constexpr std::size_t kOutlineGrid = 256;  ///< points an outline is seen from: places >> 8
inline constexpr std::size_t kOutlineSlack = 3;   ///< grid points that outlines may be moved against each other by
inline constexpr std::size_t kHeightBins = 16;    ///< stretches of the outline, one after the other from the point on

/// Heights of the stretches over the tangent, from every point of the grid. Each bin is divided by its greatest height
/// on this outline, so that size does not count, and weighted by one over the root of how far it lies from the point.
struct OutlineProfile {
    /// 128: level with the point. The first points are there once more at the end, so that no slack runs over it.
    alignas(16) std::array<std::array<std::uint8_t, kHeightBins>, kOutlineGrid + 2 * kOutlineSlack> heights{};
    float complexity = 0.0F;  ///< mean over the bins of the standard deviation of heights, in [0, 1]
    friend bool operator==(const OutlineProfile&, const OutlineProfile&) = default;
};

/// Profile of a ring in its own direction from its first point. An outline on one line has no heights. About 20 us.
[[nodiscard]] OutlineProfile outline_profile(const Polygon& ring);

/// Profile of the mirror image, read in the opposite direction from the same first point.
[[nodiscard]] OutlineProfile mirrored(const OutlineProfile& profile);

/// The heights of a profile with two neighbouring bins added up, as far as a byte holds the sum: of two profiles they
/// differ no more than the heights do.
using PairedHeights = std::array<std::array<std::uint8_t, kHeightBins / 2>, kOutlineGrid>;
[[nodiscard]] PairedHeights paired_heights(const OutlineProfile& profile);

/// Places that answer to each other. The first is where the alignment starts.
struct OutlineAnchor {
    OutlinePlace a = 0, b = 0;
};

/// Difference of two outlines along the alignment that runs through the anchors in order, once round, evenly in
/// between: the mean weighted difference of heights at 64 places, each compared with up to three grid points of slack
/// along both outlines against each other, over 0.3 plus both complexities, so that ragged outlines do not count as
/// different from everything. 0 for equal outlines aligned as they are, about 0.3 for shapes of different classes,
/// below 4 always; kUnaligned without an anchor. Swapping a and b changes nothing. As soon as it cannot come below
/// `give_up_at`, give_up_at comes back. About 0.2 us.
[[nodiscard]] float outline_difference(const OutlineProfile& a, const OutlineProfile& b,
                                       std::span<const OutlineAnchor> anchors,
                                       float give_up_at = std::numeric_limits<float>::infinity());

/// Outlines that differ less are those of the same shape, or nearly.
inline constexpr float kNearlyEqual = 0.1F;

/// outline_difference along the anchors; for outlines that are nearly equal along them also with one turned against the
/// other as a whole, by about the mean of what the anchors say, and the less of the two: what parts of the same shape
/// end at varies more than the shape. What is not below `give_up_at` may be any such value.
[[nodiscard]] float aligned_difference(const OutlineProfile& a, const OutlineProfile& b,
                                       std::span<const OutlineAnchor> anchors,
                                       float give_up_at = std::numeric_limits<float>::infinity());

/// What counts for outlines of which no parts are matched.
inline constexpr float kUnaligned = 0.6F;

}  // namespace core
