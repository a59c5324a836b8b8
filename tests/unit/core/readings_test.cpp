#include "core/parts/readings.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/match/reading_match.hpp"

namespace {

/// A star with `arms` arms, its first arm stretched, so that no symmetry hides a mistake.
core::Polygon star(int arms) {
    core::Polygon ring;
    for (int i = 0; i < 2 * arms; ++i) {
        const double angle = 3.14159265358979 * i / arms, radius = i % 2 != 0 ? 12.0 : i == 0 ? 60.0 : 40.0;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

}  // namespace

TEST_CASE("a shape has as many readings as are compared, the first of them the thesis's own", "[readings]") {
    const auto readings = core::describe_readings(star(5));
    REQUIRE(readings);
    REQUIRE(readings->size() == core::kReadingCount);
    CHECK(readings->front() == *core::describe(star(5)));
    CHECK((*readings)[1].samples.size() > readings->front().samples.size());
}

TEST_CASE("an outline without area has no reading", "[readings]") {
    CHECK_FALSE(core::describe_readings({{0, 0}, {1, 0}, {2, 0}}));
}

TEST_CASE("the distance over readings is the mean of theirs, symmetric, 0 to itself", "[readings]") {
    const core::MatchableReadings a = core::matchable_readings(*core::describe_readings(star(5)));
    const core::MatchableReadings b = core::matchable_readings(*core::describe_readings(star(4)));
    core::Matcher matcher;
    double sum = 0.0;
    for (std::size_t k = 0; k < core::kReadingCount; ++k) sum += matcher.distance(a[k], b[k]);
    CHECK(core::distance(matcher, a, b) == Approx(sum / core::kReadingCount));
    CHECK(core::distance(matcher, a, b) == core::distance(matcher, b, a));
    CHECK(core::distance(matcher, a, a) == 0.0);
    CHECK(core::match(matcher, a, b).distance == core::distance(matcher, a, b));
    CHECK(core::match(matcher, a, b).first.distance == matcher.distance(a[0], b[0]));
}

TEST_CASE("giving up early never turns a farther shape into a nearer one", "[readings]") {
    const core::MatchableReadings a = core::matchable_readings(*core::describe_readings(star(5)));
    const core::MatchableReadings b = core::matchable_readings(*core::describe_readings(star(3)));
    core::Matcher matcher;
    const double whole = core::distance(matcher, a, b);
    REQUIRE(whole > 0.0);
    for (const double share : {0.01, 0.3, 0.6, 0.99}) {
        CHECK(core::distance(matcher, a, b, share * whole) >= share * whole);
    }
    CHECK(core::distance(matcher, a, b, 1.01 * whole) == whole);
}
