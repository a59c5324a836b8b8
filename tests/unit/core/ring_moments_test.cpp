#include "core/contour/ring_moments.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "support/shapes.hpp"

TEST_CASE("moments of a rectangle are those of the textbook", "[ring_moments]") {
    const core::RingMoments m = core::ring_moments(support::moved(support::rectangle(6, 2), {10, -3}));
    CHECK(m.area == Approx(12.0));
    CHECK(m.centroid.x == Approx(13.0));
    CHECK(m.centroid.y == Approx(-2.0));
    CHECK(m.xx == Approx(36.0 / 12));
    CHECK(m.yy == Approx(4.0 / 12));
    CHECK(m.xy == Approx(0.0).margin(1e-12));
    CHECK(m.spread().along == Approx(std::sqrt(3.0)));
    CHECK(m.spread().across == Approx(std::sqrt(1.0 / 3)));
}

TEST_CASE("moments turn with the ring", "[ring_moments]") {
    for (const double angle : {-1.2, -0.4, 0.3, 1.5}) {
        const core::RingMoments m = core::ring_moments(support::turned(support::rectangle(6, 2), angle));
        CHECK(m.long_axis_rad() == Approx(angle));
        CHECK(m.spread().along == Approx(std::sqrt(3.0)));
    }
}

TEST_CASE("far from the origin moments keep their digits", "[ring_moments]") {
    const core::RingMoments m = core::ring_moments(support::moved(support::disc(200, 5), {1e6, -1e6}));
    CHECK(m.xx == Approx(25.0 / 4).epsilon(1e-3));
    CHECK(m.xx == Approx(m.yy).epsilon(1e-6));
}

TEST_CASE("the sign of the area is that of the direction, and nothing has none", "[ring_moments]") {
    core::Polygon ring = support::hand();
    const double area = core::ring_moments(ring).area;
    std::reverse(ring.begin(), ring.end());
    CHECK(core::ring_moments(ring).area == Approx(-area));
    CHECK(core::ring_moments({}).area == 0.0);
    CHECK(core::ring_moments({{1, 1}, {2, 2}, {3, 3}}).area == 0.0);
}
