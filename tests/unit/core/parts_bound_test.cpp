#include "core/fusion/parts_bound.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <vector>

#include "core/fusion/fused_match.hpp"
#include "support/shapes.hpp"

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

core::ComparableShape shape_of(const core::Polygon& contour) {
    const auto readings = core::read_outline(contour);
    REQUIRE(readings);
    return core::comparable(*readings);
}

/// Stars of uneven tips, each number another, some of them alike.
core::Polygon uneven_star(unsigned number) {
    std::mt19937 random(number);
    core::Polygon ring = support::star(4 + static_cast<int>(number % 4), 30, 12);
    for (core::Point& p : ring) p = p * (0.7 + 0.6 * static_cast<double>(random() % 1000) / 1000.0);
    return ring;
}

std::vector<core::ComparableShape> shapes() {
    std::vector<core::ComparableShape> out;
    for (const core::Polygon& ring : {support::horse(), support::hand(), support::cross(8, 3), support::star(5, 9, 4),
                                      support::disc(60, 10), support::rectangle(9, 2), support::comb(4, 6)}) {
        out.push_back(shape_of(ring));
    }
    for (unsigned n = 0; n < 10; ++n) out.push_back(shape_of(uneven_star(n)));
    return out;
}

}  // namespace

TEST_CASE("the bound of the parts never exceeds their distance", "[fusion]") {
    core::Matcher matcher;
    const std::vector<core::ComparableShape> all = shapes();
    int told = 0, pairs = 0;
    for (const core::ComparableShape& a : all) {
        const core::PartsBound bound(a.parts);
        for (const core::ComparableShape& b : all) {
            const double distance = matcher.distance(a.parts, b.parts);
            const core::Ways open = bound.open_ways(b.parts, 1.001 * distance + 1e-3);
            CHECK(matcher.distance(a.parts, b.parts, kInfinity, open) == distance);
            ++pairs;
            if (bound.open_ways(b.parts, 0.2 * distance).none()) ++told;
        }
    }
#if defined(__SSE2__)
    CHECK(told > pairs / 2);
#else
    CHECK(told == 0);
#endif
}

TEST_CASE("the bound of the parts is the same for a mirror image", "[fusion]") {
    for (unsigned n = 0; n < 4; ++n) {
        const core::PartsBound bound(shape_of(uneven_star(n)).parts);
        core::ComparableShape other = shape_of(support::horse());
        for (const double distance : {5.0, 10.0, 15.0, 20.0, 30.0, 45.0}) {
            const core::Ways open = bound.open_ways(other.parts, distance);
            std::swap(other.parts.forwards, other.parts.backwards);
            const core::Ways turned = bound.open_ways(other.parts, distance);
            CHECK(turned.along == open.against);
            CHECK(turned.against == open.along);
        }
    }
}

TEST_CASE("the bound of the parts tells nothing where nothing can be told", "[fusion]") {
    const core::ComparableShape horse = shape_of(support::horse()), disc = shape_of(support::disc(60, 10));
    const core::PartsBound bound(horse.parts);
    CHECK(bound.open_ways(horse.parts, 1e-6).along);
    const core::Ways open = bound.open_ways(disc.parts, kInfinity);
    CHECK(open.along);
    CHECK(open.against);
}

TEST_CASE("a bound changes no fused distance below the limit", "[fusion]") {
    core::FusedMatcher matcher;
    const std::vector<core::ComparableShape> all = shapes();
    for (const core::ComparableShape& a : all) {
        const core::PartsBound bound(a.parts);
        for (const core::ComparableShape& b : all) {
            const double contour = matcher.contour().distance(a.contour, b.contour);
            const double distance = matcher.distance(a, b);
            for (const double share : {0.3, 0.9, 0.999}) {
                CHECK(matcher.distance_from(contour, a, bound, b, share * distance) >= share * distance);
            }
            const double beyond = 1.01 * distance + 1e-6;
            CHECK(matcher.distance_from(contour, a, bound, b, beyond) == distance);
        }
    }
}
