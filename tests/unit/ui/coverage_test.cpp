#include "ui/draw/coverage.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "core/geometry/polygon.hpp"

TEST_CASE("coverage adds up to the area of the polygon", "[coverage]") {
    core::Polygon star;
    for (int i = 0; i < 10; ++i) {
        const double r = i % 2 == 0 ? 40.3 : 15.7, a = i * 0.6283;
        star.push_back({50.2 + r * std::cos(a), 48.9 + r * std::sin(a)});
    }
    for (const bool turned : {false, true}) {
        if (turned) star = {star.rbegin(), star.rend()};
        const ui::CoverageImage fill = ui::fill_polygon(star, 100, 100);
        const double sum = std::accumulate(fill.coverage.pixels.begin(), fill.coverage.pixels.end(), 0.0) / 255;
        CHECK(sum == Approx(std::abs(core::signed_area(star))).epsilon(0.005));
    }
}

TEST_CASE("half a pixel covered is half", "[coverage]") {
    const ui::CoverageImage fill = ui::fill_polygon({{1.5, 1}, {4, 1}, {4, 3}, {1.5, 3}}, 10, 10);
    CHECK(fill.x == 1);
    CHECK(fill.y == 1);
    CHECK(fill.coverage.at(0, 0) == 128);
    CHECK(fill.coverage.at(1, 0) == 255);
    CHECK(fill.coverage.width == 3);
}

TEST_CASE("polygons over the edge of the page are cut there", "[coverage]") {
    const ui::CoverageImage fill = ui::fill_polygon({{-50, -50}, {60, -50}, {60, 60}, {-50, 60}}, 10, 8);
    REQUIRE(fill.coverage.width == 10);
    REQUIRE(fill.coverage.height == 8);
    for (const std::uint8_t v : fill.coverage.pixels) CHECK(v == 255);
    CHECK(ui::fill_polygon({{20, 20}, {30, 20}, {30, 30}}, 10, 10).coverage.pixels.empty());
    CHECK(ui::fill_polygon({{1, 1}, {5, 5}}, 10, 10).coverage.pixels.empty());
    CHECK(ui::fill_polygon({}, 10, 10).coverage.pixels.empty());
}
