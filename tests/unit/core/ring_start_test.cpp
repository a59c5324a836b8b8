#include "core/geometry/ring_start.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/geometry/polygon.hpp"
#include "support/shapes.hpp"

using core::Point;
using core::Polygon;

namespace {

/// The nearer of both ends of the ellipse to a point.
double from_an_end(const Polygon& ring, Point p) {
    const double share = core::ellipse_end(ring), other = share < 0.5 ? share + 0.5 : share - 0.5;
    return std::min(distance(core::at_share(ring, share), p), distance(core::at_share(ring, other), p));
}

}  // namespace

TEST_CASE("an ellipse begins at the end of its long axis", "[ring_start]") {
    Polygon ellipse;
    for (const Point p : support::disc(720, 1.0)) ellipse.push_back({30.0 * p.x, 50.0 * p.y});
    CHECK(from_an_end(ellipse, {0, 50}) < 0.05);
    CHECK(from_an_end(ellipse, {0, -50}) < 100.05);
}

TEST_CASE("the place goes with the shape, whatever point the ring is given from", "[ring_start]") {
    const Polygon horse = support::horse();
    const Point end = core::at_share(horse, core::ellipse_end(horse));
    const double size = core::perimeter(horse);
    for (const int first : {1, 5, 9}) CHECK(from_an_end(support::started_at(horse, first), end) < 1e-9 * size);
    for (const double angle : {0.3, 2.0, 4.5})
        CHECK(from_an_end(support::turned(horse, angle), support::turned(Polygon{end}, angle)[0]) < 1e-9 * size);
    const Polygon mirror = support::mirrored(horse);
    CHECK(from_an_end(mirror, support::mirrored(Polygon{end})[0]) < 1e-9 * size);
    Polygon finer = core::resample_ring(horse, 5000);
    CHECK(from_an_end(finer, end) < 1e-3 * size);
}

TEST_CASE("a ring put to a start is the same ring", "[ring_start]") {
    const Polygon horse = support::horse();
    for (const double share : {0.0, 0.25, 0.99}) {
        const Polygon started = core::started_at(horse, share);
        CHECK(started.front() == core::at_share(horse, share));
        CHECK(core::perimeter(started) == Approx(core::perimeter(horse)));
        CHECK(core::signed_area(started) == Approx(core::signed_area(horse)));
    }
    CHECK(core::at_share(horse, 0.0) == horse.front());
    CHECK(distance(core::at_share(horse, 1.0), horse.front()) < 1e-9);
}

TEST_CASE("a ring without length begins at its first point", "[ring_start]") {
    CHECK(core::ellipse_end(Polygon(4, Point{3, 4})) == 0.0);
    CHECK(core::at_share(Polygon(4, Point{3, 4}), 0.5) == Point{3, 4});
}
