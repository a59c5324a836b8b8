#pragma once
// A lower bound of Matcher::distance from the outlines alone, so that most shapes that are far by their parts are known
// to be far before a single part is compared.
//
// Why it holds. The distance is never below kOutlineWeight times the outline difference along some alignment
// (core/match/match.hpp), and that is a sum over 64 places (core/match/outline_profile.hpp). Whatever the alignment,
// the grid points i of A and j of B compared at one place have i + j that grows by 512 / 64 = 8 from place to place,
// one more or less by rounding; the slack moves i and j against each other and keeps i + j. So with
//
//     least(r) = the least difference of heights over all i, j with i + j = r (mod 256)
//     sum(s)   = 2 * sum over k of min(least(s + 8k - 1), least(s + 8k), least(s + 8k + 1)),   k = 0 … 31
//
// no alignment costs less than the least of sum(0) … sum(7). It is about half of what the best alignment costs, where
// bounds from ranges of several grid points reach a quarter or less. The heights of two neighbouring bins are added up
// first, which halves the work and never makes a difference greater; they mostly differ towards the same side.

#include <array>
#include <cstdint>

#include "core/match/match.hpp"

namespace core {

/// One shape against many. Immutable after construction; may be used from several threads.
class PartsBound {
  public:
    /// 12 kB.
    explicit PartsBound(const MatchableShape& shape);

    /// What Matcher::distance may take for granted about the shape and `other`: for each way round no more than the
    /// difference of the outlines along any alignment. About 5 us; nought where the processor has no SSE2, for there it
    /// would take longer than the distance itself.
    [[nodiscard]] LeastOutlines least_outlines(const MatchableShape& other) const;

  private:
    /// Points from last to first, twice over, so that all with the same i + j are a run.
    using Turning = std::array<PairedHeights::value_type, 2 * kOutlineGrid>;
    alignas(64) Turning forwards_;
    alignas(64) Turning backwards_;
    OutlineProfile level_;  ///< flat, as complex as the shape: to ask what a sum of differences is worth
};

}  // namespace core
