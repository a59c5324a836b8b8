#include "core/skeleton/chord_profile.hpp"

#include <catch2/catch.hpp>

#include "support/shapes.hpp"

using core::Polygon;

namespace {

core::ChordMeasures measures_of(const Polygon& ring) {
    const auto t = core::triangulate(ring);
    REQUIRE(t);
    return core::measure_chords(ring, *t);
}

/// The value of the chord between two samples.
double value_at(const Polygon& ring, const std::vector<double>& values, int u, int v) {
    const auto t = core::triangulate(ring);
    for (std::size_t c = 0; c < t->chords.size(); ++c) {
        if (t->chords[c].u == u && t->chords[c].v == v) return values[c];
    }
    FAIL("no chord from " << u << " to " << v);
    return 0.0;
}

}  // namespace

TEST_CASE("the strength of a chord is 0 where the quadrilateral is cyclic", "[chord_profile]") {
    for (const Polygon& ring : {support::rectangle(4, 1), Polygon{{0, 0}, {4, 0}, {3, 2}, {1, 2}}}) {
        const auto m = measures_of(ring);
        REQUIRE(m.strength.size() == 1);
        CHECK(m.strength[0] == Approx(0.0).margin(1e-12));
    }
}

TEST_CASE("strength by hand: one less the opposite angles over pi", "[chord_profile]") {
    // A rhombus of 60 and 120 degrees, cut by its short diagonal: 60 + 60 opposite, 1 - 2/3.
    const double h = std::sqrt(3.0);
    CHECK(measures_of({{0, 0}, {2, 0}, {3, h}, {1, h}}).strength[0] == Approx(1.0 / 3.0));
}

TEST_CASE("compactness by hand: perimeter squared over area of the quadrilateral", "[chord_profile]") {
    CHECK(measures_of(support::rectangle(1, 1)).compactness[0] == Approx(16.0));
    CHECK(measures_of(support::rectangle(4, 1)).compactness[0] == Approx(100.0 / 4.0));
    const double h = std::sqrt(3.0);
    CHECK(measures_of({{0, 0}, {2, 0}, {3, h}, {1, h}}).compactness[0] == Approx(64.0 / (2.0 * h)));
}

TEST_CASE("the half disk counts the samples of the smaller arc, if it holds them all", "[chord_profile]") {
    // A body with a shallow cap over the chord 2-6 (radius 2 about (0, 3)): three samples within.
    const Polygon shallow{{-2, -9}, {2, -9}, {2, 3}, {1.2, 4.2}, {0, 4.6}, {-1.2, 4.2}, {-2, 3}};
    CHECK(value_at(shallow, measures_of(shallow).half_disk, 2, 6) == 3.0);
    // One sample outside the disc takes all.
    Polygon pointed = shallow;
    pointed[4] = {0, 5.2};
    CHECK(value_at(pointed, measures_of(pointed).half_disk, 2, 6) == 0.0);
    // A sample on the circle is still in the disc.
    pointed[4] = {0, 5};
    CHECK(value_at(pointed, measures_of(pointed).half_disk, 2, 6) == 3.0);
}

TEST_CASE("a local maximum is no less than both neighbours and more than one", "[chord_profile]") {
    // Eight chords once each, walked cyclically.
    const std::vector<int> order{0, 1, 2, 3, 4, 5, 6, 7};
    const auto maxima = [&](const std::vector<double>& v) { return core::local_maxima(order, v); };
    CHECK(maxima({0, 1, 0, 0, 2, 2, 0, 0}) == std::vector<char>{0, 1, 0, 0, 1, 1, 0, 0});
    // The inside of a plateau is more than neither neighbour.
    CHECK(maxima({0, 3, 3, 3, 3, 0, 1, 2}) == std::vector<char>{0, 1, 0, 0, 1, 0, 0, 1});
    // The near side of a shoulder is less than its higher neighbour, the far side is not.
    CHECK(maxima({0, 1, 1, 2, 1, 1, 0, 0}) == std::vector<char>{0, 1, 0, 1, 0, 1, 0, 0});
    CHECK(maxima({5, 5, 5, 5, 5, 5, 5, 5}) == std::vector<char>(8, 0));
    // Over the end of the list.
    CHECK(maxima({3, 1, 1, 1, 1, 1, 1, 3})[0] == 1);
    CHECK(maxima({3, 1, 1, 1, 1, 1, 1, 3})[7] == 1);
}

TEST_CASE("one of a chord's two places is enough", "[chord_profile]") {
    CHECK(core::local_maxima({0, 1, 2, 1}, {5, 4, 1})[0] == 1);
    // Chord 1 stands next to a stronger one at its first place, at its second between weaker ones.
    CHECK(core::local_maxima({0, 1, 2, 1, 2, 0}, {5, 4, 1})[1] == 1);
}

TEST_CASE("each measure selects, and any selection cuts", "[chord_profile]") {
    const core::ChordProfile profile{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 1, 1, 0}};
    CHECK(profile.cuts() == std::vector<char>{1, 1, 1, 0});
}

TEST_CASE("the profile cuts the tips of a star off", "[chord_profile]") {
    const Polygon star = support::star(5, 10, 4);
    const auto t = core::triangulate(star);
    const std::vector<char> cuts = core::extended_profile(star, *t).cuts();
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        const core::Chord& chord = t->chords[c];
        const int steps = chord.v - chord.u;
        if (std::min(steps, 10 - steps) == 2) {
            INFO("chord " << chord.u << " - " << chord.v);
            CHECK(cuts[c] == 1);
        }
    }
}
