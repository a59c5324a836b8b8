#include "core/geometry/point_grid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using core::Point;

TEST_CASE("a point moves by at most half a step, and only once", "[point_grid]") {
    for (const int exponent : {-20, -3, 0, 5}) {
        const double step = std::ldexp(1.0, exponent);
        for (const Point p : {Point{0.3, -7.77}, Point{1e3, 12.5}, Point{-0.01, 99.0}}) {
            const Point q = core::on_grid(p, exponent);
            CHECK(std::abs(q.x - p.x) <= step / 2);
            CHECK(std::abs(q.y - p.y) <= step / 2);
            CHECK(core::on_grid(q, exponent) == q);
            CHECK(core::on_grid(q, exponent - 1) == q);
        }
    }
}

TEST_CASE("the finest grid is the last that has few enough steps", "[point_grid]") {
    const std::vector<Point> points{{0, 0}, {100, 3}, {40, 77}};
    CHECK(core::finest_grid(points, 100) == 0);
    CHECK(core::finest_grid(points, 99) == 1);
    CHECK(core::finest_grid(points, 200) == -1);
    CHECK(core::finest_grid(points, 2047) == -4);
    CHECK(core::finest_grid({}, 10) == core::kFinestGrid);
}

TEST_CASE("far away the grid is as fine as doubles are", "[point_grid]") {
    CHECK(core::finest_grid({{1.0, 1.0}}, 10) == -40);
    CHECK(core::finest_grid({{1e300, 0}, {-1e300, 0}}, 10) == core::kCoarsestGrid);
}
