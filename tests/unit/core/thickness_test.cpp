#include "core/contour/thickness.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/geometry/polygon.hpp"
#include "support/shapes.hpp"

namespace {

constexpr int kPoints = 160;

std::vector<double> thickness(const core::Polygon& ring, double greatest) {
    return core::thickness_along(core::resample_ring(ring, kPoints), greatest);
}

double least(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}
double most(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

/// A square of 40 with a tail of 80 x 4 on its right.
core::Polygon body_with_tail() {
    return {{0, 0}, {40, 0}, {40, 18}, {120, 18}, {120, 22}, {40, 22}, {40, 40}, {0, 40}};
}

}  // namespace

TEST_CASE("a long bar is as thick as it is wide", "[thickness]") {
    const std::vector<double> t = thickness(support::rectangle(200, 10), 1000);
    CHECK(least(t) == Approx(10.0).epsilon(0.02));
    std::vector<double> sorted = t;
    std::sort(sorted.begin(), sorted.end());
    CHECK(sorted[kPoints / 2] == Approx(10.0).epsilon(0.02));
}

TEST_CASE("in a disc nothing is across, and the greatest counts", "[thickness]") {
    for (const double t : thickness(support::disc(160, 50), 70)) CHECK(t == Approx(70.0));
}

TEST_CASE("a corner is no thin place", "[thickness]") {
    CHECK(least(thickness(support::rectangle(40, 40), 1000)) > 35.0);
}

TEST_CASE("a tail is thin and a body is not", "[thickness]") {
    const core::Polygon ring = core::resample_ring(body_with_tail(), kPoints);
    const std::vector<double> t = core::thickness_along(ring, 60);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (ring[i].x > 60 && ring[i].x < 110) CHECK(t[i] == Approx(4.0).epsilon(0.05));
        if (ring[i].x < 1) CHECK(t[i] > 30.0);
    }
}

TEST_CASE("thickness goes with the shape", "[thickness]") {
    const core::Polygon horse = core::resample_ring(support::horse(), kPoints);
    const std::vector<double> t = core::thickness_along(horse, 20);
    const core::Polygon moved = support::turned(support::scaled(horse, 3), 0.7);
    const std::vector<double> of_copy = core::thickness_along(moved, 60);
    const std::vector<double> of_mirrored = core::thickness_along(support::mirrored(horse), 20);
    for (std::size_t i = 0; i < t.size(); ++i) CHECK(of_copy[i] == Approx(3 * t[i]));
    std::vector<double> sorted = t, sorted_mirrored = of_mirrored;
    std::sort(sorted.begin(), sorted.end());
    std::sort(sorted_mirrored.begin(), sorted_mirrored.end());
    for (std::size_t i = 0; i < t.size(); ++i) CHECK(sorted_mirrored[i] == Approx(sorted[i]));
}

TEST_CASE("a slightly different outline is about as thick everywhere", "[thickness]") {
    const core::Polygon horse = core::resample_ring(support::horse(), kPoints);
    const std::vector<double> t = core::thickness_along(horse, 20);
    core::Polygon other = horse;
    for (std::size_t i = 0; i < other.size(); ++i) {
        const double by = 0.01 * (i % 2 == 0 ? 1.0 : -1.0);
        other[i] = other[i] + core::Point{by, -by};
    }
    const std::vector<double> of_other = core::thickness_along(other, 20);
    for (std::size_t i = 0; i < t.size(); ++i) CHECK(std::abs(of_other[i] - t[i]) < 0.05 * most(t));
}
