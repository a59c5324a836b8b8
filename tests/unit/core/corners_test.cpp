#include "core/skeleton/corners.hpp"

#include <catch2/catch.hpp>

#include "core/geometry/polygon.hpp"
#include "support/shapes.hpp"

using core::Polygon;

namespace {

constexpr int kWindow = 10;
constexpr double kExtent = 0.5;

std::vector<int> corners_of(const Polygon& contour) {
    return core::corners(core::cornerity(contour, kWindow), kWindow, kExtent);
}

}  // namespace

TEST_CASE("cornerity is the distance to the centroid of three points half a window apart", "[corners]") {
    // 20 points round a square of side 5, one apart; window 4: two before, two after.
    const Polygon square = core::resample_ring(support::rectangle(5, 5), 20);
    const std::vector<double> c = core::cornerity(square, 4);
    REQUIRE(c.size() == 20);
    // At the corner (0, 0): the centroid of (0, 2), (0, 0), (2, 0) is (2/3, 2/3).
    CHECK(c[0] == Approx(std::sqrt(2.0) * 2.0 / 3.0));
    // One further: (0, 1), (1, 0), (3, 0) have the centroid (4/3, 1/3).
    CHECK(c[1] == Approx(std::sqrt(2.0) / 3.0));
    CHECK(c[19] == Approx(std::sqrt(2.0) / 3.0));
    CHECK(c[2] == Approx(0.0).margin(1e-12));
    CHECK(c[3] == Approx(0.0).margin(1e-12));
}

TEST_CASE("a square has its four corners", "[corners]") {
    CHECK(corners_of(core::resample_ring(support::rectangle(25, 25), 100)) == std::vector<int>{0, 25, 50, 75});
}

TEST_CASE("a circle has none", "[corners]") {
    CHECK(corners_of(support::disc(100, 7.0)).empty());
    CHECK(corners_of(support::disc(400, 1e-3)).empty());
    CHECK(corners_of(support::moved(support::disc(400, 100.0), {5000, -3000})).empty());
}

TEST_CASE("reflex corners count as well", "[corners]") {
    const std::vector<int> found = corners_of(core::resample_ring(support::l_shape(40, 20), 160));
    CHECK(found == std::vector<int>{0, 40, 60, 80, 100, 120});
}

TEST_CASE("turning the list turns the answer", "[corners]") {
    const Polygon contour = core::resample_ring(support::horse(), 300);
    const std::vector<double> value = core::cornerity(contour, kWindow);
    const std::vector<int> found = corners_of(contour);
    REQUIRE(found.size() > 10);
    for (const int by : {1, 77, 299}) {
        const Polygon other = support::started_at(contour, by);
        const std::vector<double> other_value = core::cornerity(other, kWindow);
        for (int i = 0; i < 300; ++i) {
            REQUIRE(other_value[static_cast<std::size_t>(i)] == value[static_cast<std::size_t>((i + by) % 300)]);
        }
        std::vector<int> expected;
        for (const int i : found) expected.push_back((i - by + 300) % 300);
        std::sort(expected.begin(), expected.end());
        CHECK(corners_of(other) == expected);
    }
}

TEST_CASE("corners do not depend on place and size", "[corners]") {
    const Polygon contour = core::resample_ring(support::horse(), 300);
    CHECK(corners_of(support::moved(contour, {1024, -512})) == corners_of(contour));
    CHECK(corners_of(support::scaled(contour, 0.001)) == corners_of(contour));
}

TEST_CASE("a corner exceeds more than the extent of its window", "[corners]") {
    // Window 4, extent 1/2: three of the four points around must be lower.
    const auto found = [](const std::vector<double>& v) { return core::corners(v, 4, 0.5); };
    CHECK(found({0, 0, 0, 1, 2, 1, 0, 0, 0, 0}) == std::vector<int>{4});
    // A plateau of two points: the second is not lower than the first, three others are.
    CHECK(found({0, 0, 0, 2, 2, 0, 0, 0, 0, 0}) == std::vector<int>{3});
    // A plateau of three points: its first has two lower points only, which is not more than half.
    CHECK(found({0, 0, 0, 2, 2, 2, 0, 0, 0, 0}).empty());
    // The greater of two close peaks suppresses the other.
    CHECK(found({0, 0, 0, 2, 0, 3, 0, 0, 0, 0}) == std::vector<int>{5});
    // Over the end of the list.
    CHECK(found({2, 0, 0, 0, 0, 0, 0, 0, 0, 1}) == std::vector<int>{0});
    CHECK(found({}).empty());
}
