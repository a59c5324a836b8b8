#pragma once
// Distance and correspondence of two shapes over several readings of each (core/parts/readings.hpp).

#include <limits>

#include "core/match/match.hpp"
#include "core/parts/readings.hpp"

namespace core {

/// One MatchableShape a reading.
using MatchableReadings = std::vector<MatchableShape>;

[[nodiscard]] MatchableReadings matchable_readings(const ShapeReadings& readings,
                                                   const ShapeParameters& parameters = {});

/// Mean over the readings of Matcher::distance, in the order of the readings; both shapes have equally many, at least
/// one. As soon as it cannot come below `give_up_at`, some value not below `give_up_at` comes back.
[[nodiscard]] double distance(Matcher& matcher, const MatchableReadings& a, const MatchableReadings& b,
                              double give_up_at = std::numeric_limits<double>::infinity());

/// The correspondence of the first reading, with the distance over all of them.
struct ReadingMatch {
    double distance = 0.0;  ///< mean over the readings
    Match first;
};
[[nodiscard]] ReadingMatch match(Matcher& matcher, const MatchableReadings& a, const MatchableReadings& b);

}  // namespace core
