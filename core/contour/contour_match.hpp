#pragma once
// The distance of two whole contours.
//
// What is minimised, exactly. The points of A are paired with points of B in cyclic order, each with one or none. The
// best alignment costs the least sum of
//
//     for each pair, the gaps between what each channel runs through near the one point and near the other, from a
//     quarter of a step before it to a quarter after (0 where the two ranges meet), over all channels
//   + kLeftOut for each point of A or B without a partner
//
// over all 80 ways to turn B against A and both directions of B, where a pair strays no more than kStray points from
// the turn chosen. Ranges, because where on an outline the points fall is chance: with values alone, half a step
// between the points of two equal outlines costs as much as half of what tells two classes apart.
// The cover differs by the sum of absolute differences over all cells, the least over all turns by whole sectors and
// both directions. The distance is
//
//     kAlignmentWeight * alignment / (kPlainness + complexity of A + complexity of B) + kCoverWeight * cover difference
//
// It is >= 0 and at most 6.4; 0 for equal descriptors and for mirrored ones; d(A, B) = d(B, A) = d(mirrored A, B) to
// the last bit. Both sums are whole numbers, so every machine gives the same. No metric. The scale: 0.9 is the
// median over pairs of shapes of different classes of Kimia-216; same classes have a median of 0.3.
//
// After Wang et al. 2012 (see contour_descriptor.hpp): their cost of leaving out and shape complexity. We try all turns
// where they try some, compare ranges (Birchfield and Tomasi, "A pixel dissimilarity measure that is insensitive to
// image sampling", 1998, do so with pixels), and add the cover.

#include <cstdint>
#include <limits>

#include "core/contour/contour_descriptor.hpp"

namespace core {

/// A descriptor laid out for matching.
struct MatchableContour {
    ContourDescriptor descriptor;
    /// How long a row of points is, the first ones being there once more at its end: whole vectors.
    static constexpr std::size_t kRow = 96;
    static constexpr int kZero = 64;  ///< what 0 is stored as
    using Channels = std::array<std::array<std::uint8_t, kRow>, kFrameChannels>;
    using Points = std::array<std::array<std::uint8_t, kFrameChannels>, kFramePoints>;
    /// What each channel runs through from a quarter of a step before a point to a quarter after it: lowest and
    /// highest. One row a channel, each at a whole vector …
    alignas(64) Channels low{};
    alignas(64) Channels high{};
    /// … and one row a point.
    Points low_at{}, high_at{};
    /// Sums over all points of bounded functions of the frames, at their lowest and highest: see lower_bound.
    std::array<std::int32_t, kFrameChannels> low_sums{}, high_sums{};
    std::array<std::int32_t, kPolarRings> ring_sums{};  ///< of the cover
};
[[nodiscard]] MatchableContour matchable(const ContourDescriptor& descriptor);

/// Never above ContourMatcher::distance of the same two, in the same arithmetic, and symmetric as it is: from sums over
/// all points and rings that no turning changes. About 0.15 of the distance; 30 ns.
[[nodiscard]] double lower_bound(const MatchableContour& a, const MatchableContour& b);

/// Working memory that is kept from one pair of shapes to the next; one per thread. Nothing is allocated.
class ContourMatcher {
  public:
    /// As soon as the distance cannot come below `give_up_at`, some value not below `give_up_at` comes back.
    [[nodiscard]] double distance(const MatchableContour& a, const MatchableContour& b,
                                  double give_up_at = std::numeric_limits<double>::infinity());

    /// How many pairs of shapes no bound has spared their alignment so far.
    [[nodiscard]] std::size_t aligned_pairs() const { return aligned_pairs_; }

    /// B's points twice and a little more, so that every turn is a run in it.
    static constexpr std::size_t kRow = 2 * kFramePoints + 32;
    /// A's points x B's: what pairing them spares against leaving both out.
    using Spared = std::array<std::array<std::uint8_t, kRow>, kFramePoints>;
    /// A sum for every turn; those past a whole turn mean nothing.
    using TurnBounds = std::array<std::int16_t, MatchableContour::kRow>;
    /// A's points are worked on in rounds: long before the last of them those so far say whether the alignment can
    /// still be good enough.
    static constexpr std::size_t kRounds = 5;

  private:
    /// Sixteen turns that are aligned at once.
    struct Block {
        int bound = 0;  ///< none of them costs less
        std::size_t direction = 0, block = 0;
    };
    void bound_turns(std::size_t direction, const MatchableContour::Points& low, const MatchableContour::Points& high,
                     const MatchableContour& b, int limit);

    // Of both directions of A:
    MatchableContour::Points mirrored_low_{}, mirrored_high_{};
    alignas(64) std::array<Spared, 2> spared_{};
    std::array<std::array<TurnBounds, kRounds + 1>, 2> until_{};  // what the points before a round cost at least
    std::array<Block, 2 * kFramePoints / 16> blocks_{};
    std::size_t block_count_ = 0;
    std::size_t aligned_pairs_ = 0;
};

}  // namespace core
