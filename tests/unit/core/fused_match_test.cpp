#include "core/fusion/fused_match.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "support/shapes.hpp"

namespace {

core::ComparableShape shape_of(const core::Polygon& contour) {
    const auto readings = core::read_outline(contour);
    REQUIRE(readings);
    return core::comparable(*readings);
}

std::vector<core::Polygon> outlines() {
    return {support::horse(), support::hand(), support::cross(8, 3), support::star(5, 9, 4), support::disc(60, 10)};
}

}  // namespace

TEST_CASE("the fused distance is the weighted sum of both readings", "[fusion]") {
    core::FusedMatcher matcher;
    const core::ComparableShape horse = shape_of(support::horse()), hand = shape_of(support::hand());
    const double parts = matcher.parts().distance(horse.parts, hand.parts);
    const double contour = matcher.contour().distance(horse.contour, hand.contour);
    CHECK(matcher.distance(horse, hand) ==
          Approx(contour + core::kPartsWeight * parts / core::kPartsScale * std::min(1.0, contour / 0.3)));
    CHECK(matcher.distance_from(contour, horse, hand) == matcher.distance(horse, hand));
}

TEST_CASE("the fused distance is symmetric, finite, and nothing for equal shapes", "[fusion]") {
    core::FusedMatcher matcher;
    for (const core::Polygon& first : outlines()) {
        const core::ComparableShape a = shape_of(first);
        CHECK(matcher.distance(a, a) == Approx(0.0).margin(1e-6));
        for (const core::Polygon& second : outlines()) {
            const core::ComparableShape b = shape_of(second);
            CHECK(std::isfinite(matcher.distance(a, b)));
            CHECK(matcher.distance(a, b) == matcher.distance(b, a));
        }
    }
}

TEST_CASE("giving up never hides a nearer shape", "[fusion]") {
    core::FusedMatcher matcher;
    for (const core::Polygon& first : outlines()) {
        for (const core::Polygon& second : outlines()) {
            const core::ComparableShape a = shape_of(first), b = shape_of(second);
            const double distance = matcher.distance(a, b);
            for (const double share : {0.1, 0.5, 0.9, 0.999}) {
                CHECK(matcher.distance(a, b, share * distance) >= share * distance);
            }
            CHECK(matcher.distance(a, b, distance * 1.01 + 1e-6) == distance);
        }
    }
}

TEST_CASE("an outline without area has no readings", "[fusion]") {
    CHECK_FALSE(core::read_outline({{0, 0}, {4, 0}, {8, 0}}));
}
