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
            const core::LeastOutlines least = bound.least_outlines(b.parts);
            CHECK(matcher.distance(a.parts, b.parts, kInfinity, least) == distance);
            CHECK(matcher.distance(a.parts, b.parts, 1.001 * distance + 1e-3, least) == distance);
            ++pairs;
            if (core::configuration_distance(0.0F, std::min(least.along, least.against)) > 0.2 * distance) ++told;
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
        const core::LeastOutlines least = bound.least_outlines(other.parts);
        std::swap(other.parts.forwards, other.parts.backwards);
        other.parts.paired = core::paired_heights(other.parts.forwards.outline);
        const core::LeastOutlines turned = bound.least_outlines(other.parts);
        CHECK(turned.along == least.against);
        CHECK(turned.against == least.along);
    }
}

TEST_CASE("a shape may have its own outline, and none is told to differ more than outlines without parts", "[fusion]") {
    const core::ComparableShape horse = shape_of(support::horse());
    CHECK(core::PartsBound(horse.parts).least_outlines(horse.parts).along == 0.0F);
    for (const core::ComparableShape& other : shapes()) {
        const core::LeastOutlines least = core::PartsBound(horse.parts).least_outlines(other.parts);
        CHECK(std::max(least.along, least.against) <= core::kUnaligned);
    }
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
