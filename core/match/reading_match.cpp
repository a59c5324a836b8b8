#include "core/match/reading_match.hpp"

namespace core {

MatchableReadings matchable_readings(const ShapeReadings& readings, const ShapeParameters& parameters) {
    MatchableReadings out;
    out.reserve(readings.size());
    for (const ShapeDescriptor& reading : readings) out.push_back(matchable(reading, parameters));
    return out;
}

double distance(Matcher& matcher, const MatchableReadings& a, const MatchableReadings& b, double give_up_at) {
    const double count = static_cast<double>(a.size());
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        sum += matcher.distance(a[k], b[k]);
        if (sum / count >= give_up_at) break;  // distances are not negative
    }
    return sum / count;
}

ReadingMatch match(Matcher& matcher, const MatchableReadings& a, const MatchableReadings& b) {
    return {distance(matcher, a, b), matcher.match(a.front(), b.front())};
}

}  // namespace core
