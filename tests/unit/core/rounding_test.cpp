#include "core/parts/rounding.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/match/match.hpp"
#include "core/parts/describe.hpp"
#include "support/shapes.hpp"

using core::ShapeDescriptor;

namespace {

/// Outlines as large as those of the 256-pixel silhouettes, on no grid.
std::vector<ShapeDescriptor> described() {
    std::vector<ShapeDescriptor> all;
    const std::vector<core::Polygon> outlines{support::horse(), support::hand(), support::star(5, 10, 4),
                                              support::cross(9, 3), support::disc(60, 8)};
    for (const core::Polygon& outline : outlines) {
        const core::Polygon large = support::turned(support::scaled(outline, 8.7), 0.3);
        all.push_back(*core::describe(large));
    }
    return all;
}

}  // namespace

TEST_CASE("what describe makes is measured, anything else is not", "[rounding]") {
    for (const ShapeDescriptor& shape : described()) CHECK(core::is_measured(shape));
    ShapeDescriptor changed = described().front();
    SECTION("a feature") {
        changed.parts[1].features[3] += 0.001F;
    }
    SECTION("the whole") {
        changed.whole.salient = true;
    }
    SECTION("a sample") {
        changed.samples[4].x += 1e-6;
    }
    SECTION("an arc that names no sample") {
        changed.parts[0].end_sample = static_cast<int>(changed.samples.size());
    }
    SECTION("no area") {
        std::reverse(changed.samples.begin(), changed.samples.end());
    }
    CHECK_FALSE(core::is_measured(changed));
    CHECK_FALSE(core::rounded(changed));
    CHECK_FALSE(core::is_measured({}));
}

TEST_CASE("a rounded descriptor is measured, and rounding it again changes nothing", "[rounding]") {
    for (const ShapeDescriptor& shape : described()) {
        const auto once = core::rounded(shape);
        REQUIRE(once);
        CHECK(core::is_measured(*once));
        CHECK(core::rounded(*once) == *once);
        CHECK(once->terminal_count == shape.terminal_count);
        CHECK(once->stop_points == shape.stop_points);
        for (std::size_t i = 0; i < shape.samples.size(); ++i) {
            CHECK(core::distance(once->samples[i], shape.samples[i]) < 0.1);
        }
    }
}

TEST_CASE("rounding moves a shape by next to nothing", "[rounding]") {
    const std::vector<ShapeDescriptor> shapes = described();
    core::Matcher matcher;
    for (std::size_t i = 0; i + 1 < shapes.size(); ++i) {
        const auto matchable = core::matchable(shapes[i]);
        const double to_next = matcher.distance(matchable, core::matchable(shapes[i + 1]));
        CHECK(matcher.distance(matchable, core::matchable(*core::rounded(shapes[i]))) < 0.05 * to_next);
    }
}
