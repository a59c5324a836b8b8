#include "core/skeleton/sampling.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "core/geometry/polygon.hpp"
#include "core/skeleton/corners.hpp"
#include "core/skeleton/triangulation.hpp"
#include "support/ring_checks.hpp"
#include "support/shapes.hpp"

using core::Point;
using core::Polygon;
using core::sample_outline;

namespace {

/// A triangle of sides 3, 4, 5, one point a unit: corners at 0, 3 and 7.
const Polygon kTriangle{{0, 0}, {1, 0}, {2, 0},     {3, 0},     {3, 1},     {3, 2},
                        {3, 3}, {3, 4}, {2.4, 3.2}, {1.8, 2.4}, {1.2, 1.6}, {0.6, 0.8}};
const std::vector<int> kCorners{0, 3, 7};

void check_same(const Polygon& got, const Polygon& expected) {
    REQUIRE(got.size() == expected.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        INFO("sample " << i);
        CHECK(got[i].x == Approx(expected[i].x).margin(1e-12));
        CHECK(got[i].y == Approx(expected[i].y).margin(1e-12));
    }
}

/// Samples from each of the triangle's corners to the next.
std::array<int, 3> samples_a_side(const Polygon& samples) {
    std::array<int, 3> count{};
    std::size_t side = 0;
    for (const Point p : samples) {
        if (distance(p, {3, 0}) < 1e-12) side = 1;
        if (distance(p, {3, 4}) < 1e-12) side = 2;
        ++count[side];
    }
    return count;
}

}  // namespace

TEST_CASE("each stretch gets its share of the samples, and the surplus goes by cumulative cornerity", "[sampling]") {
    // 10 samples: shares 2.5, 3.33, 4.17, so 2 + 3 + 4, and one is left over.
    std::vector<double> cornerity(12, 0.0);
    SECTION("to the first side when that is the most ragged") {
        cornerity[1] = 1.0;
        CHECK(samples_a_side(sample_outline(kTriangle, cornerity, kCorners, 10)) == std::array{3, 3, 4});
    }
    SECTION("to the second") {
        cornerity[1] = 1.0;
        cornerity[4] = cornerity[5] = 0.6;
        CHECK(samples_a_side(sample_outline(kTriangle, cornerity, kCorners, 10)) == std::array{2, 4, 4});
    }
    SECTION("to the third") {
        cornerity[9] = 0.1;
        CHECK(samples_a_side(sample_outline(kTriangle, cornerity, kCorners, 10)) == std::array{2, 3, 5});
    }
    SECTION("11 samples: shares 2.75, 3.67, 4.58 leave two, for the two most ragged") {
        cornerity[1] = 0.5;
        cornerity[8] = 0.7;
        CHECK(samples_a_side(sample_outline(kTriangle, cornerity, kCorners, 11)) == std::array{3, 3, 5});
    }
}

TEST_CASE("within a stretch the samples are even, corners included", "[sampling]") {
    std::vector<double> cornerity(12, 0.0);
    cornerity[1] = 1.0;
    check_same(sample_outline(kTriangle, cornerity, kCorners, 10),
               {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 4.0 / 3}, {3, 8.0 / 3}, {3, 4}, {2.25, 3}, {1.5, 2}, {0.75, 1}});
}

TEST_CASE("the count is exact and every corner is a sample, whatever the shape", "[sampling]") {
    for (const Polygon& shape : {support::horse(), support::hand(), support::comb(5, 6), support::star(7, 9, 4)}) {
        const Polygon contour = core::resample_ring(shape, 400);
        const auto cornerity = core::cornerity(contour, 10);
        const auto corners = core::corners(cornerity, 10, 0.5);
        REQUIRE(!corners.empty());
        for (const int count : {40, 100, 173}) {
            const Polygon samples = sample_outline(contour, cornerity, corners, count);
            CHECK(samples.size() == static_cast<std::size_t>(count));
            for (const int c : corners) {
                const Point corner = contour[static_cast<std::size_t>(c)];
                CHECK(std::any_of(samples.begin(), samples.end(), [&](Point p) { return distance(p, corner) < 1e-9; }));
            }
        }
    }
}

TEST_CASE("a stretch too short for a share keeps its corner", "[sampling]") {
    // Two corners one apart on a ring of length 100, five samples: the short stretch's share is 0.05.
    const Polygon contour = core::resample_ring(support::rectangle(25, 25), 100);
    const Polygon samples = sample_outline(contour, std::vector<double>(100, 1.0), {10, 11}, 5);
    REQUIRE(samples.size() == 5);
    CHECK(samples[0] == contour[10]);
    CHECK(samples[1] == contour[11]);
}

TEST_CASE("more corners than samples: the strongest stay", "[sampling]") {
    const Polygon contour = core::resample_ring(support::rectangle(25, 25), 100);
    std::vector<double> cornerity(100, 0.0);
    std::vector<int> corners;
    for (int i = 0; i < 100; i += 10) {
        corners.push_back(i);
        cornerity[static_cast<std::size_t>(i)] = i;
    }
    const Polygon samples = sample_outline(contour, cornerity, corners, 5);
    REQUIRE(samples.size() == 5);
    for (const std::size_t i : {60, 70, 80, 90}) CHECK(std::count(samples.begin(), samples.end(), contour[i]) == 1);
}

TEST_CASE("without corners the ring is sampled evenly", "[sampling]") {
    const Polygon circle = support::disc(400, 10.0);
    check_same(sample_outline(circle, std::vector<double>(400, 0.0), {}, 100), core::resample_ring(circle, 100));
}

TEST_CASE("the samples do not depend on where the tracing started", "[sampling]") {
    const auto sampled = [](const Polygon& contour) {
        const auto cornerity = core::cornerity(contour, 10);
        Polygon s = sample_outline(contour, cornerity, core::corners(cornerity, 10, 0.5), 100);
        std::sort(s.begin(), s.end(), [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
        return s;
    };
    const Polygon contour = core::resample_ring(support::horse(), 400);
    for (const int by : {1, 123, 250}) check_same(sampled(support::started_at(contour, by)), sampled(contour));
}

TEST_CASE("a simple ring comes back unchanged", "[sampling]") {
    for (const Polygon& ring : {support::horse(), support::hand(), support::comb(4, 3), support::disc(100, 1)}) {
        REQUIRE(support::is_simple(ring));
        REQUIRE(core::signed_area(ring) > 0);
        CHECK(core::without_crossings(ring) == ring);
    }
    // Straight stretches are no fault.
    const Polygon square = core::resample_ring(support::rectangle(2, 2), 8);
    CHECK(core::without_crossings(square) == square);
}

TEST_CASE("a tail whose sides interleave loses samples until nothing crosses", "[sampling]") {
    const Polygon tail{{0, 0}, {10, 0}, {10, 4}, {15, 4.1}, {20, 4}, {15, 4.0}, {10, 4.2}, {10, 8}, {0, 8}};
    const Polygon crossed{{0, 0}, {10, 0}, {10, 4}, {15, 4.3}, {20, 4}, {15, 4.0}, {10, 4.2}, {10, 8}, {0, 8}};
    for (const Polygon& ring : {tail, crossed}) {
        const Polygon repaired = core::without_crossings(ring);
        CHECK(support::is_simple(repaired));
        CHECK(repaired.size() + 2 >= ring.size());
    }
}

TEST_CASE("spikes without width and doubled samples go, wherever the list starts", "[sampling]") {
    const Polygon spike{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 7}, {2, 9}, {2, 7}, {2, 4}, {0, 4}};
    const Polygon doubled{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 4}, {0, 4}};
    for (const Polygon& ring : {spike, doubled}) {
        for (int first = 0; first < static_cast<int>(ring.size()); ++first) {
            const Polygon repaired = core::without_crossings(support::started_at(ring, first));
            INFO("from sample " << first);
            CHECK(support::is_simple(repaired));
            CHECK(core::signed_area(repaired) >= 16.0);
        }
    }
}

TEST_CASE("whatever the ring, what is left is simple and can be triangulated, or has three samples", "[sampling]") {
    std::mt19937 random(7);
    for (int round = 0; round < 500; ++round) {
        Polygon ring;
        const int n = 4 + static_cast<int>(random() % 16);
        for (int i = 0; i < n; ++i)
            ring.push_back({static_cast<double>(random() % 9), static_cast<double>(random() % 9)});
        const Polygon repaired = core::without_crossings(ring);
        INFO("round " << round);
        REQUIRE(repaired.size() >= 3);
        if (repaired.size() > 3) {
            REQUIRE(support::is_simple(repaired));
            if (core::signed_area(repaired) > 0) REQUIRE(core::triangulate(repaired));
        }
    }
}
