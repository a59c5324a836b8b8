#include "core/skeleton/arc_measures.hpp"

#include <catch2/catch.hpp>

#include "core/geometry/polygon.hpp"
#include "support/shapes.hpp"

using core::ArcMeasures;
using core::Polygon;

TEST_CASE("lengths, areas and steps of arcs run anti-clockwise and over the end of the list", "[arc_measures]") {
    const ArcMeasures arcs(support::moved(support::rectangle(4, 3), {100, -50}));
    CHECK(arcs.count() == 4);
    CHECK(arcs.perimeter() == Approx(14.0));
    CHECK(arcs.area() == Approx(12.0));
    CHECK(arcs.length(0, 2) == Approx(7.0));
    CHECK(arcs.length(2, 1) == Approx(11.0));
    CHECK(arcs.length(3, 0) == Approx(3.0));
    CHECK(arcs.length(2, 2) == Approx(14.0));
    CHECK(arcs.area(0, 2) == Approx(6.0));
    CHECK(arcs.area(0, 1) == Approx(0.0).margin(1e-12));
    CHECK(arcs.area(3, 3) == Approx(12.0));
    CHECK(arcs.steps(0, 3) == 3);
    CHECK(arcs.steps(3, 0) == 1);
    CHECK(arcs.steps(1, 1) == 4);
}

TEST_CASE("an arc that runs into the shape has negative area", "[arc_measures]") {
    const ArcMeasures arcs(Polygon{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
    CHECK(arcs.area(2, 4) == Approx(-6.0));
}

TEST_CASE("bending by hand: sine of the turn over the far distance, the shape at unit radius", "[arc_measures]") {
    // A square of side 2: radius sqrt 2; at each corner |(B-A) x (C-B)| / (|B-A| |C-B| |A-C|) = 4 / (2 2 2 sqrt 2).
    const ArcMeasures arcs(support::rectangle(2, 2));
    const double corner = std::sqrt(2.0) * 4.0 / (8.0 * std::sqrt(2.0));
    CHECK(corner == Approx(0.5));
    CHECK(arcs.bending() == Approx(4 * corner));
    CHECK(arcs.bending(1, 2) == Approx(2 * corner));
    CHECK(arcs.bending(3, 0) == Approx(2 * corner));
    CHECK(arcs.bending(2, 1) == Approx(4 * corner));
    CHECK(arcs.bending(2, 2) == Approx(4 * corner));
}

TEST_CASE("bending does not depend on size and place", "[arc_measures]") {
    const Polygon horse = support::horse();
    const double here = ArcMeasures(horse).bending(3, 17);
    CHECK(ArcMeasures(support::scaled(horse, 37.0)).bending(3, 17) == Approx(here));
    CHECK(ArcMeasures(support::moved(horse, {1e4, -1e4})).bending(3, 17) == Approx(here));
}

TEST_CASE("arcs agree with direct sums", "[arc_measures]") {
    const Polygon ring = support::hand();
    const ArcMeasures arcs(ring);
    for (int from = 0; from < arcs.count(); ++from) {
        for (int to = 0; to < arcs.count(); ++to) {
            Polygon part{ring[static_cast<std::size_t>(from)]};
            for (int k = 1; k <= arcs.steps(from, to); ++k) {
                part.push_back(ring[static_cast<std::size_t>((from + k) % arcs.count())]);
            }
            REQUIRE(arcs.length(from, to) == Approx(core::chain_length(part)));
            REQUIRE(arcs.area(from, to) == Approx(core::signed_area(part)).margin(1e-9));
        }
    }
}

TEST_CASE("doubled samples bend by nothing and are no number trouble", "[arc_measures]") {
    CHECK(std::isfinite(ArcMeasures(Polygon{{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}}).bending()));
}
