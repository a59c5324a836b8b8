#include "core/geometry/polygon.hpp"

#include <catch2/catch.hpp>

using core::Point;
using core::Polygon;

TEST_CASE("a ring that runs anti-clockwise has positive area", "[polygon]") {
    const Polygon square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    CHECK(core::signed_area(square) == Approx(4.0));
    CHECK(core::signed_area({square.rbegin(), square.rend()}) == Approx(-4.0));
    CHECK(core::perimeter(square) == Approx(8.0));
}

TEST_CASE("the hull leaves out inner and collinear points and runs anti-clockwise", "[polygon]") {
    const Polygon hull = core::convex_hull({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 0}});
    CHECK(hull == Polygon{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    CHECK(core::convex_hull({{1, 1}, {1, 1}}).size() == 1);
    CHECK(core::convex_hull({{0, 0}, {1, 1}, {2, 2}}).size() == 2);
}

TEST_CASE("the least rectangle of a turned rectangle is that rectangle", "[polygon]") {
    const double c = std::cos(0.4), s = std::sin(0.4);
    Polygon turned;
    for (const Point p : {Point{0, 0}, Point{5, 0}, Point{5, 2}, Point{0, 2}}) {
        turned.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
    }
    const core::OrientedRectangle r = core::least_rectangle(core::convex_hull(turned));
    CHECK(r.area() == Approx(10.0));
    CHECK(std::max(r.along, r.across) == Approx(5.0));
}

TEST_CASE("resampling spaces points evenly by arc length", "[polygon]") {
    const Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    const Polygon eight = core::resample_ring(square, 8);
    REQUIRE(eight.size() == 8);
    CHECK(eight[1] == Point{2, 0});
    CHECK(eight[7].y == Approx(2.0));
    const core::Polyline chain = core::resample_chain({{0, 0}, {1, 0}, {4, 0}}, 5);
    CHECK(chain[2].x == Approx(2.0));
    CHECK(chain.back() == Point{4, 0});
    CHECK(core::resample_ring({{3, 3}}, 4) == Polygon(4, Point{3, 3}));
}
