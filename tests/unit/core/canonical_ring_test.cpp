#include "core/contour/canonical_ring.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/geometry/polygon.hpp"
#include "support/shapes.hpp"

namespace {

core::Polygon canonical(const core::Polygon& ring, const core::CanonicalSampling& options = {}) {
    return core::canonical_ring(ring, core::ring_moments(ring), options);
}

double farthest_apart(const core::Polygon& a, const core::Polygon& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, core::distance(a[i], b[i]));
    return most;
}

}  // namespace

TEST_CASE("canonical points can be evenly spaced, anti-clockwise, and start at an end of the shape",
          "[canonical_ring]") {
    const core::Polygon points = canonical(support::rectangle(40, 10), {.slenderness = 1.0, .thickness = 0.0});
    REQUIRE(points.size() == 320);
    CHECK(core::signed_area(points) > 0.0);
    const double step = core::perimeter(points) / 320;
    for (std::size_t i = 0; i < points.size(); ++i) {
        CHECK(core::distance(points[i], points[(i + 1) % points.size()]) == Approx(step).epsilon(0.06));
    }
    CHECK(std::abs(points.front().x) == Approx(20.0).epsilon(0.05));
}

TEST_CASE("points are denser where the shape is thick", "[canonical_ring]") {
    const core::Polygon body_with_tail{{0, 0}, {40, 0}, {40, 18}, {120, 18}, {120, 22}, {40, 22}, {40, 40}, {0, 40}};
    const auto on_the_tail = [&](double thickness) {
        const core::Polygon points = canonical(body_with_tail, {.slenderness = 1.0, .thickness = thickness});
        CHECK(points.size() == 320);
        CHECK(core::signed_area(points) > 0.0);
        const double right = core::ring_moments(body_with_tail).centroid.x;
        return std::count_if(points.begin(), points.end(), [&](core::Point p) { return p.x + right > 42.0; });
    };
    const auto even = static_cast<double>(on_the_tail(0.0)), default_ = static_cast<double>(on_the_tail(0.3));
    CHECK(even == Approx(320.0 * 160 / 320).epsilon(0.06));
    CHECK(default_ < 0.9 * even);
    CHECK(default_ > 0.6 * even);
    CHECK(static_cast<double>(on_the_tail(1.0)) < 0.4 * even);
}

TEST_CASE("wherever the ring starts, the points are the same", "[canonical_ring]") {
    const core::Polygon horse = core::resample_ring(support::horse(), 200);
    const core::Polygon points = canonical(horse);
    for (const int first : {1, 37, 111}) {
        CHECK(farthest_apart(points, canonical(support::started_at(horse, first))) < 0.2);
    }
}

TEST_CASE("a turned shape has turned points", "[canonical_ring]") {
    const core::Polygon horse = core::resample_ring(support::horse(), 400);
    const double step = core::perimeter(horse) / 320;
    for (const double angle : {0.4, 1.9, 3.0}) {
        CHECK(farthest_apart(support::turned(canonical(horse), angle), canonical(support::turned(horse, angle))) <
              step);
    }
}

TEST_CASE("slenderness takes from the length what it gives to the width", "[canonical_ring]") {
    const auto ratio = [](double slenderness) {
        const core::Polygon ring = canonical(support::rectangle(80, 5), {.slenderness = slenderness});
        const auto spread = core::ring_moments(ring).spread();
        return spread.along / spread.across;
    };
    CHECK(ratio(1.0) == Approx(16.0).epsilon(0.05));
    CHECK(ratio(0.5) == Approx(4.0).epsilon(0.05));
    CHECK(ratio(0.0) == Approx(1.0).epsilon(0.05));
}
