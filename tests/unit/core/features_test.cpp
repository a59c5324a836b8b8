#include "core/parts/features.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "support/shapes.hpp"

using core::ArcMeasures;
using core::Feature;
using core::Part;
using core::Point;
using core::Polygon;
using core::ShapeParameters;

namespace {

double value(const Part& part, Feature f) {
    return part.features[static_cast<std::size_t>(f)];
}

/// What the thesis prints in table 5.1, whatever the shipped values are.
ShapeParameters table_5_1() {
    ShapeParameters p;
    p.small_area = 0.01;
    p.large_t = 20;
    p.small_long_t = 5;
    p.small_et = 2;
    p.large_long_t = 10;
    p.large_et = 1.25;
    p.n_pockets = 2;
    p.size_bent_t = 7;
    p.convexity_t = 0.9;
    p.signature_unit = 100;
    return p;
}

Part measured(const Polygon& ring, int from, int to) {
    return core::measure_part(ring, ArcMeasures(ring), {from, to}, table_5_1());
}

/// A square body of 10 with a tab on its upper side; the tab's arc leads from sample 3 to the last but one.
Polygon with_tab(const Polygon& tab) {
    Polygon ring{{0, 0}, {10, 0}, {10, 10}};
    ring.insert(ring.end(), tab.begin(), tab.end());
    ring.push_back({0, 10});
    return ring;
}

Part tab_of(const Polygon& tab) {
    return measured(with_tab(tab), 3, 2 + static_cast<int>(tab.size()));
}

}  // namespace

TEST_CASE("a tab of 2 by 4 on a square of 10: every feature by hand", "[features]") {
    const Part tab = tab_of({{6, 10}, {6, 14}, {4, 14}, {4, 10}});
    CHECK(tab.start_sample == 3);
    CHECK(tab.end_sample == 6);
    CHECK(value(tab, Feature::Area) == Approx(100.0 * 8 / 108));
    CHECK(value(tab, Feature::Perimeter) == Approx(100.0 * 10 / 48));
    CHECK(value(tab, Feature::Eccentricity) == Approx(4.0 / 2.0));
    CHECK(value(tab, Feature::Circularity) == Approx(4 * std::numbers::pi * 8 / (12 * 12)));
    CHECK(value(tab, Feature::Rectangularity) == Approx(1.0));
    CHECK(value(tab, Feature::Convexity) == Approx(0.0).margin(1e-6));
    CHECK(value(tab, Feature::Solidity) == Approx(0.0).margin(1e-6));
    CHECK(value(tab, Feature::ChordLengthRatio) == Approx(2.0 / 10.0));
    // At a right angle curvature is 1 / |AC|: twice 1 / sqrt 32 at the base, twice 1 / sqrt 20 at the tip; the sample
    // farthest from the mean (5, 8.5) is a lower corner.
    const double far = std::sqrt(25 + 8.5 * 8.5);
    CHECK(value(tab, Feature::BendingEnergy) == Approx(far * 2 * (1 / std::sqrt(32.0) + 1 / std::sqrt(20.0))));
}

TEST_CASE("the radial signature of a tab by hand: distances to its centroid in units of perimeter / 100",
          "[features]") {
    const Part tab = tab_of({{6, 10}, {6, 14}, {4, 14}, {4, 10}});
    const double unit = 48.0 / 100.0;
    // Twelve points on an arc of 10, ends included; the centroid is (5, 12).
    for (std::size_t i = 0; i < core::kSignatureSize; ++i) {
        const double along = 10.0 * static_cast<double>(i) / 11.0;
        const Point p = along < 4 ? Point{6, 10 + along} : along < 6 ? Point{10 - along, 14} : Point{4, 20 - along};
        CHECK(tab.signature[i] == Approx(distance(p, {5, 12}) / unit));
    }
}

TEST_CASE("eccentricity is height away from the body over width along it, whichever is longer", "[features]") {
    CHECK(value(tab_of({{8, 10}, {8, 11}, {2, 11}, {2, 10}}), Feature::Eccentricity) == Approx(1.0 / 6.0));
    CHECK(value(tab_of({{5.5, 10}, {5.5, 16}, {4.5, 16}, {4.5, 10}}), Feature::Eccentricity) == Approx(6.0));
}

TEST_CASE("the rectangle of least area turns with a part that leans", "[features]") {
    // A bar of 1 by 8 on a slanting base: its box is its own, not the one along the axes.
    const double c = std::cos(0.6), s = std::sin(0.6);
    const Point right{5, 10}, left = right - Point{c, s}, up{-8 * s, 8 * c};
    const Part bar = measured({{0, 0}, {10, 0}, {10, 10}, right, right + up, left + up, left, {0, 9}}, 3, 6);
    CHECK(value(bar, Feature::Rectangularity) == Approx(1.0));
    CHECK(value(bar, Feature::Eccentricity) == Approx(8.0));
    // A triangle fills half of its box.
    CHECK(value(tab_of({{7, 10}, {5, 13}, {3, 10}}), Feature::Rectangularity) == Approx(0.5));
}

TEST_CASE("convexity and solidity are reversed and grow with vertices off the hull", "[features]") {
    // A notch of 2 in a tab of 4 by 4: five vertices, four on the hull.
    const Part notched = tab_of({{7, 10}, {7, 14}, {5, 12}, {3, 14}, {3, 10}});
    const double around = 4 + 4 + 4 + 2 * std::sqrt(8.0);
    CHECK(value(notched, Feature::Convexity) == Approx((1 - 16 / around) * 5 / 4));
    CHECK(value(notched, Feature::Solidity) == Approx((1 - 12.0 / 16.0) * 5 / 4));
    // The same outline with the middles of its straight sides: more vertices, no more of them on the hull.
    const Part more = tab_of({{7, 10}, {7, 12}, {7, 14}, {5, 12}, {3, 14}, {3, 12}, {3, 10}});
    CHECK(value(more, Feature::Convexity) == Approx((1 - 16 / around) * 7 / 4));
    CHECK(value(more, Feature::Solidity) == Approx((1 - 12.0 / 16.0) * 7 / 4));
}

TEST_CASE("half a disc has the values of the books", "[features]") {
    using std::numbers::pi;
    const double radius = 7.0;
    const Part half = measured(support::disc(400, radius), 0, 200);
    const double close = 1e-3;
    CHECK(value(half, Feature::Area) == Approx(50.0));
    CHECK(value(half, Feature::Perimeter) == Approx(50.0));
    CHECK(value(half, Feature::Eccentricity) == Approx(0.5).epsilon(close));
    CHECK(value(half, Feature::Circularity) == Approx(2 * pi * pi / ((pi + 2) * (pi + 2))).epsilon(close));
    CHECK(value(half, Feature::Rectangularity) == Approx(pi / 4).epsilon(close));
    CHECK(value(half, Feature::ChordLengthRatio) == Approx(2 / pi).epsilon(close));
    CHECK(value(half, Feature::BendingEnergy) == Approx(201 * 0.5));  // on a circle sin a / (2 R sin a) * R a sample
    // The centroid of a half disc lies 4 r / 3 pi from its middle; a unit is 2 pi r / 100.
    const double offset = 4 / (3 * pi), unit = 2 * pi / 100;
    CHECK(half.signature.front() == Approx(std::sqrt(1 + offset * offset) / unit).epsilon(close));
    CHECK(half.signature.back() == Approx(half.signature.front()));
    const double at = pi * 5 / 11;
    CHECK(half.signature[5] == Approx(std::hypot(std::cos(at), std::sin(at) - offset) / unit).epsilon(close));
}

TEST_CASE("the whole outline as a part has no chord; its eccentricity is long over short", "[features]") {
    const Part whole = measured(support::rectangle(3, 12), 0, 0);
    CHECK(value(whole, Feature::Area) == Approx(100.0));
    CHECK(value(whole, Feature::Perimeter) == Approx(100.0));
    CHECK(value(whole, Feature::Eccentricity) == Approx(4.0));
    CHECK(value(whole, Feature::ChordLengthRatio) == 0.0);
    CHECK(value(whole, Feature::Circularity) == Approx(4 * std::numbers::pi * 36 / 900));
    CHECK(value(measured(support::disc(200, 3), 0, 0), Feature::Circularity) == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("features do not depend on size, place and rotation", "[features]") {
    const Polygon horse = support::horse();
    const Part here = measured(horse, 12, 19);
    for (const Polygon& copy : {support::scaled(horse, 23), support::moved(horse, {-300, 700}),
                                support::turned(horse, 1.1), support::turned(horse, 4)}) {
        const Part there = measured(copy, 12, 19);
        for (std::size_t k = 0; k < core::kFeatureCount; ++k) {
            CHECK(there.features[k] == Approx(here.features[k]).epsilon(1e-4));
        }
        for (std::size_t k = 0; k < core::kSignatureSize; ++k) {
            CHECK(there.signature[k] == Approx(here.signature[k]).epsilon(1e-4));
        }
    }
}

TEST_CASE("a mirrored part has the same features and its signature from the end", "[features]") {
    const Polygon horse = support::horse();
    const int n = static_cast<int>(horse.size());
    const Part here = measured(horse, 12, 19), there = measured(support::mirrored(horse), n - 19, n - 12);
    for (std::size_t k = 0; k < core::kFeatureCount; ++k) {
        CHECK(there.features[k] == Approx(here.features[k]).epsilon(1e-4));
    }
    for (std::size_t k = 0; k < core::kSignatureSize; ++k) {
        CHECK(there.signature[k] == Approx(here.signature[core::kSignatureSize - 1 - k]).epsilon(1e-4));
    }
}

TEST_CASE("a part without area has finite features", "[features]") {
    for (const auto& [from, to] : {std::pair{0, 1}, std::pair{1, 3}}) {
        const Part flat = measured({{0, 0}, {5, 0}, {5, 5}, {5, 9}, {0, 9}}, from, to);
        for (const float f : flat.features) CHECK(std::isfinite(f));
        for (const float r : flat.signature) CHECK(std::isfinite(r));
        CHECK(value(flat, Feature::Area) == Approx(0.0).margin(1e-6));
        CHECK(value(flat, Feature::ChordLengthRatio) == Approx(1.0));
    }
}

TEST_CASE("salient parts are large or long, by the thresholds of table 5.1", "[features]") {
    const Polygon ring = support::rectangle(10, 10);  // what the features are taken of here is of no matter
    const ArcMeasures arcs(ring);
    const auto salient = [&](double area, double perimeter, double eccentricity) {
        Part part;
        part.start_sample = 0;
        part.end_sample = 2;
        part.features[static_cast<std::size_t>(Feature::Area)] = static_cast<float>(area);
        part.features[static_cast<std::size_t>(Feature::Perimeter)] = static_cast<float>(perimeter);
        part.features[static_cast<std::size_t>(Feature::Eccentricity)] = static_cast<float>(eccentricity);
        return core::is_salient(ring, arcs, part, table_5_1());
    };
    SECTION("large: 20 % of area or of perimeter") {
        CHECK(salient(20, 1, 0.1));
        CHECK(salient(1, 20, 0.1));
        CHECK_FALSE(salient(19.9, 19.9, 0.1));
    }
    SECTION("long: 5 % of perimeter at an eccentricity of 2") {
        CHECK(salient(1, 5, 2));
        CHECK_FALSE(salient(1, 4.9, 2));
        CHECK_FALSE(salient(1, 5, 1.9));
    }
    SECTION("long: 10 % at 1.25") {
        CHECK(salient(1, 10, 1.25));
        CHECK_FALSE(salient(1, 9.9, 1.25));
        CHECK_FALSE(salient(1, 10, 1.2));
    }
}

TEST_CASE("a wide part with two large pockets is bent", "[features]") {
    // A crown of three peaks, the middle one a little higher, on a square of 100: 18.8 % of the perimeter, convexity
    // 0.84, its two pockets 1.10 % of the area each.
    const auto crown = [](int peaks, double floor) {
        Polygon ring{{0, 0}, {100, 0}, {100, 100}, {70, 100}};
        const double width = 40.0 / (peaks - 1);
        for (int k = 0; k < peaks; ++k) {
            ring.push_back({70 - width * k, k == 0 || k + 1 == peaks ? 112 : 112.5});
            if (k + 1 < peaks) ring.push_back({70 - width * (k + 0.5), floor});
        }
        ring.push_back({30, 100});
        ring.push_back({0, 100});
        return ring;
    };
    const auto is_bent = [](const Polygon& ring, const ShapeParameters& p) {
        const ArcMeasures arcs(ring);
        const Part part = core::measure_part(ring, arcs, {3, static_cast<int>(ring.size()) - 2}, p);
        REQUIRE(value(part, Feature::Perimeter) < p.large_t);
        REQUIRE(value(part, Feature::Eccentricity) < p.large_et);
        return core::is_salient(ring, arcs, part, p);
    };
    const ShapeParameters p = table_5_1();
    CHECK(is_bent(crown(3, 101), p));
    SECTION("one pocket is not enough") {
        CHECK_FALSE(is_bent(crown(2, 101), p));
    }
    SECTION("pockets of less than 1 % of the area do not count") {
        CHECK_FALSE(is_bent(crown(3, 102), p));
        ShapeParameters finer = p;
        finer.small_area = 0.009;
        CHECK(is_bent(crown(3, 102), finer));
    }
    SECTION("a part of less than SizeBentT is not looked at") {
        ShapeParameters larger = p;
        larger.size_bent_t = 19;
        CHECK_FALSE(is_bent(crown(3, 101), larger));
    }
    SECTION("nor one that is nearly convex") {
        ShapeParameters stricter = p;
        stricter.convexity_t = 0.8;
        CHECK_FALSE(is_bent(crown(3, 101), stricter));
    }
}
