#include "core/geometry/segment.hpp"

#include <catch2/catch.hpp>

using core::nearest_on_segments;

TEST_CASE("crossing, skew, parallel and touching segments", "[segment]") {
    const auto crossing = nearest_on_segments({0, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 3, 0});
    CHECK(crossing.distance == Approx(0.0).margin(1e-15));
    CHECK(crossing.s == Approx(0.5));
    CHECK(crossing.t == Approx(0.25));
    CHECK(nearest_on_segments({0, 0, 0}, {2, 0, 0}, {1, -1, 3}, {1, 3, 3}).distance == Approx(3.0));
    CHECK(nearest_on_segments({0, 0, 0}, {2, 0, 0}, {5, 4, 0}, {9, 4, 0}).distance == Approx(5.0));
    CHECK(nearest_on_segments({0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {3, 3, 3}).distance == Approx(0.0).margin(1e-15));
    CHECK(nearest_on_segments({0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 1, 0}).distance == Approx(1.0));  // a point
    CHECK(nearest_on_segments({1, 1, 1}, {1, 1, 1}, {1, 1, 4}, {1, 1, 4}).distance == Approx(3.0));  // two points
}

TEST_CASE("the place on a segment that is nearest to a point", "[segment]") {
    CHECK(core::nearest_on_segment({0, 0, 0}, {4, 0, 0}, {1, 7, 0}) == Approx(0.25));
    CHECK(core::nearest_on_segment({0, 0, 0}, {4, 0, 0}, {-3, 1, 0}) == 0.0);
    CHECK(core::nearest_on_segment({0, 0, 0}, {4, 0, 0}, {9, 1, 0}) == 1.0);
    CHECK(core::nearest_on_segment({2, 2, 2}, {2, 2, 2}, {9, 1, 0}) == 0.0);
}
