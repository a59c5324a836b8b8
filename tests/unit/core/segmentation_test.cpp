#include "core/skeleton/segmentation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/skeleton/chord_profile.hpp"
#include "support/segmented.hpp"
#include "support/shapes.hpp"

using core::PieceKind;
using core::Polygon;
using core::Segmentation;
using support::Cut;

namespace {

struct Segmented {
    Polygon ring;
    core::ArcMeasures arcs;
    core::Triangulation t;
    Segmentation s;
};

Segmented segmented(const Polygon& ring, const std::vector<Cut>& cuts) {
    Segmented out{ring, core::ArcMeasures(ring), *core::triangulate(ring), {}};
    for (const Cut& cut : cuts) REQUIRE(support::chord_between(out.t, cut) >= 0);
    out.s = core::segment(out.t, support::cuts_at(out.t, cuts));
    return out;
}

int count_of(const Segmentation& s, PieceKind kind) {
    return static_cast<int>(
        std::count_if(s.pieces.begin(), s.pieces.end(), [&](const auto& piece) { return piece.kind() == kind; }));
}

/// The values of table 5.1, whatever the shipped ones are.
core::ShapeParameters table_5_1() {
    core::ShapeParameters p;
    p.small_area = 0.01;
    p.thresh_small_clr = 0.75;
    p.thresh_any_clr = 0.9;
    p.sharp_turn_deg = 20.0;
    return p;
}

/// A body 20 wide, from `bottom` to 10, whose upper side carries these points, from right to left; the bump's base is
/// the chord between its first and its last.
Polygon with_bump(const Polygon& bump, double bottom = 0.0) {
    Polygon ring{{0, bottom}, {20, bottom}, {20, 10}};
    ring.insert(ring.end(), bump.begin(), bump.end());
    ring.push_back({0, 10});
    return ring;
}

/// Whether a terminal of this outline above its base is significant.
bool is_kept(const Polygon& bump, const core::ShapeParameters& p, double bottom = 0.0) {
    const int first = 3, last = 2 + static_cast<int>(bump.size());
    const Segmented shape = segmented(with_bump(bump, bottom), {{first, last}});
    REQUIRE(shape.s.pieces.size() == 2);
    return core::without_insignificant_terminals(shape.ring, shape.arcs, shape.t, shape.s, p).pieces.size() == 2;
}

/// Five squares in a row, samples 0 to 5 below and 6 to 11 above from right to left.
Polygon ladder() {
    Polygon ring;
    for (int x = 0; x <= 5; ++x) ring.push_back({static_cast<double>(x), 0});
    for (int x = 5; x >= 0; --x) ring.push_back({static_cast<double>(x), 1});
    return ring;
}

}  // namespace

TEST_CASE("pieces are terminals, sleeves and junctions by their number of chords", "[segmentation]") {
    const Polygon cross = support::cross(5, 2);
    SECTION("none: the whole shape") {
        const Segmented whole = segmented(cross, {});
        REQUIRE(whole.s.pieces.size() == 1);
        CHECK(whole.s.pieces[0].kind() == PieceKind::Whole);
        CHECK(whole.s.pieces[0].triangles.size() == 10);
    }
    SECTION("one chord makes two terminals") {
        const Segmented two = segmented(cross, {{1, 4}});
        CHECK(two.s.pieces.size() == 2);
        CHECK(count_of(two.s, PieceKind::Terminal) == 2);
    }
    SECTION("two make a sleeve between terminals") {
        const Segmented three = segmented(cross, {{1, 4}, {7, 10}});
        CHECK(three.s.pieces.size() == 3);
        CHECK(count_of(three.s, PieceKind::Terminal) == 2);
        CHECK(count_of(three.s, PieceKind::Sleeve) == 1);
    }
    SECTION("four arms around a square") {
        const Segmented five = segmented(cross, {{1, 4}, {4, 7}, {7, 10}, {10, 1}});
        CHECK(five.s.pieces.size() == 5);
        CHECK(count_of(five.s, PieceKind::Terminal) == 4);
        CHECK(count_of(five.s, PieceKind::Junction) == 1);
        for (const core::Piece& piece : five.s.pieces) CHECK(piece.triangles.size() == 2);
    }
}

TEST_CASE("where every chord cuts, each triangle is a piece of its own kind", "[segmentation]") {
    const Polygon ring = support::horse();
    const auto t = core::triangulate(ring);
    const Segmentation s = core::segment(*t, std::vector<char>(t->chords.size(), 1));
    REQUIRE(s.pieces.size() == t->triangles.size());
    for (std::size_t i = 0; i < s.pieces.size(); ++i) {
        CHECK(s.pieces[i].triangles == std::vector<int>{static_cast<int>(i)});
        const core::TriangleRole role = t->triangles[i].role();
        const PieceKind expected = role == core::TriangleRole::Terminal ? PieceKind::Terminal
                                   : role == core::TriangleRole::Sleeve ? PieceKind::Sleeve
                                                                        : PieceKind::Junction;
        CHECK(s.pieces[i].kind() == expected);
    }
}

TEST_CASE("pieces share all triangles among them, and each cut lies on the border of two", "[segmentation]") {
    for (const Polygon& ring : {support::horse(), support::hand(), support::comb(6, 4)}) {
        const auto t = core::triangulate(ring);
        const Segmentation s = core::segment(*t, core::extended_profile(ring, *t).cuts());
        std::vector<int> seen(t->triangles.size(), 0), borders(t->chords.size(), 0);
        int previous = -1;
        for (std::size_t i = 0; i < s.pieces.size(); ++i) {
            CHECK(s.pieces[i].triangles.front() > previous);
            previous = s.pieces[i].triangles.front();
            for (const int k : s.pieces[i].triangles) {
                ++seen[static_cast<std::size_t>(k)];
                CHECK(s.piece_of_triangle[static_cast<std::size_t>(k)] == static_cast<int>(i));
            }
            for (const int c : s.pieces[i].chords) {
                ++borders[static_cast<std::size_t>(c)];
                const int other = s.neighbour(static_cast<int>(i), c, *t);
                CHECK(other != static_cast<int>(i));
                CHECK(s.neighbour(other, c, *t) == static_cast<int>(i));
            }
        }
        CHECK(seen == std::vector<int>(seen.size(), 1));
        for (std::size_t c = 0; c < borders.size(); ++c) CHECK(borders[c] == (s.cuts[c] != 0 ? 2 : 0));
    }
}

TEST_CASE("the arc behind a chord runs anti-clockwise round the piece", "[segmentation]") {
    // The right arm of the cross lies between the samples 1 and 4.
    const Segmented shape = segmented(support::cross(5, 2), {{1, 4}});
    const core::Chord& c = shape.t.chords[static_cast<std::size_t>(support::chord_between(shape.t, {1, 4}))];
    const int arm = shape.s.piece_of_triangle[static_cast<std::size_t>(c.inner)];
    const int rest = shape.s.piece_of_triangle[static_cast<std::size_t>(c.outer)];
    const int chord = shape.s.pieces[static_cast<std::size_t>(arm)].chords[0];
    CHECK(core::arc_behind(shape.s, shape.t, arm, chord).from == 1);
    CHECK(core::arc_behind(shape.s, shape.t, arm, chord).to == 4);
    CHECK(core::arc_behind(shape.s, shape.t, rest, chord).from == 4);
    CHECK(core::arc_behind(shape.s, shape.t, rest, chord).to == 1);
}

TEST_CASE("the extended profile takes what strength alone misses", "[segmentation]") {
    // A round head on a stick: no chord inside the head is strong, its fullest half disk lies at its middle.
    Polygon spoon{{-1, -12}, {1, -12}, {1, -9}, {1, -6}, {1, -3}};
    for (int k = 0; k <= 12; ++k) {
        const double angle = (-70.0 + k * 320.0 / 12.0) * std::numbers::pi / 180.0;
        spoon.push_back({4 * std::cos(angle), 1 + 4 * std::sin(angle)});
    }
    for (const double y : {-3.0, -6.0, -9.0}) spoon.push_back({-1, y});
    const auto t = core::triangulate(spoon);
    REQUIRE(t);
    const core::ChordProfile profile = core::extended_profile(spoon, *t);
    const auto number = [](const std::vector<char>& flags) { return std::count(flags.begin(), flags.end(), 1); };
    CHECK(number(profile.by_half_disk) > 0);
    CHECK(core::segment(*t, profile.cuts()).pieces.size() > core::segment(*t, profile.by_strength).pieces.size());
}

TEST_CASE("a flat terminal is insignificant at any size: chord over arc above 0.9", "[segmentation]") {
    // Chord 4 over an arc of 2 + 2 sqrt(1.25) = 4.236: ratio 0.944; the corners beside it turn clockwise, but are not
    // its own.
    const Polygon flat{{12, 10}, {11, 10.5}, {9, 10.5}, {8, 10}};
    CHECK_FALSE(is_kept(flat, table_5_1()));
    // Twice as high: ratio 0.828, and 1.5 % of the area.
    const Polygon higher{{12, 10}, {11, 11}, {9, 11}, {8, 10}};
    CHECK(is_kept(higher, table_5_1()));
    core::ShapeParameters p = table_5_1();
    p.thresh_any_clr = 0.82;
    CHECK_FALSE(is_kept(higher, p));
}

TEST_CASE("a terminal of less than 1 % of the area is insignificant above 0.75", "[segmentation]") {
    // Half as large as the one above, so the same ratio 0.828; its area is 0.37 %.
    const Polygon small{{11, 10}, {10.5, 10.5}, {9.5, 10.5}, {9, 10}};
    CHECK_FALSE(is_kept(small, table_5_1()));
    core::ShapeParameters p = table_5_1();
    p.small_area = 0.003;
    CHECK(is_kept(small, p));
    // Small, but steep: 2 over 1 + 2 sqrt(0.89) = 0.693.
    CHECK(is_kept({{11, 10}, {10.5, 10.8}, {9.5, 10.8}, {9, 10}}, table_5_1()));
}

TEST_CASE("a sharp clockwise turn along its arc makes a flat terminal significant", "[segmentation]") {
    // Ratio 0.925, and a notch that turns by -33 degrees.
    const Polygon notched{{12, 10}, {11, 10.5}, {10, 10.2}, {9, 10.5}, {8, 10}};
    const double bottom = -20;  // deep enough for the chord to be one of the triangulation
    CHECK(is_kept(notched, table_5_1(), bottom));
    core::ShapeParameters p = table_5_1();
    p.sharp_turn_deg = 40.0;
    CHECK_FALSE(is_kept(notched, p, bottom));
    // As large a turn to the left is none.
    CHECK_FALSE(is_kept({{12, 10}, {11, 10.3}, {10, 10.6}, {9, 10.3}, {8, 10}}, table_5_1(), bottom));
}

TEST_CASE("merging goes on with what has become a terminal by it", "[segmentation]") {
    // A flat step on a flat step: the lower one is a sleeve until the upper one is gone.
    const Polygon ring =
        with_bump({{14, 10}, {13, 10.4}, {11, 10.4}, {10.4, 10.6}, {9.6, 10.6}, {9, 10.4}, {7, 10.4}, {6, 10}}, -60);
    const Segmented shape = segmented(ring, {{3, 10}, {5, 8}});
    REQUIRE(count_of(shape.s, PieceKind::Sleeve) == 1);
    core::ShapeParameters p = table_5_1();
    p.sharp_turn_deg = 60.0;
    const Segmentation merged = core::without_insignificant_terminals(shape.ring, shape.arcs, shape.t, shape.s, p);
    CHECK(merged.pieces.size() == 1);
    CHECK(merged.pieces[0].kind() == PieceKind::Whole);
}

TEST_CASE("a run of sleeves becomes one, apart from the terminals at its ends", "[segmentation]") {
    const Segmented shape = segmented(ladder(), {{1, 10}, {2, 9}, {3, 8}, {4, 7}});
    REQUIRE(count_of(shape.s, PieceKind::Sleeve) == 3);
    const Segmentation joined = core::with_joined_sleeves(shape.t, shape.s);
    CHECK(joined.pieces.size() == 3);
    CHECK(count_of(joined, PieceKind::Terminal) == 2);
    CHECK(count_of(joined, PieceKind::Sleeve) == 1);
    CHECK(joined.cuts == support::cuts_at(shape.t, {{1, 10}, {4, 7}}));
}

TEST_CASE("sleeves on both sides of a junction stay two", "[segmentation]") {
    // The arms of the cross at twice their length, cut at the middle: terminal, sleeve, junction.
    const Polygon ring{{1, -5}, {1, -3}, {1, -1}, {3, -1}, {5, -1},  {5, 1},   {3, 1},   {1, 1},   {1, 5},
                       {-1, 5}, {-1, 1}, {-3, 1}, {-5, 1}, {-5, -1}, {-3, -1}, {-1, -1}, {-1, -3}, {-1, -5}};
    const Segmented shape = segmented(ring, {{1, 16}, {2, 15}, {3, 6}, {2, 7}, {7, 10}, {10, 15}, {11, 14}});
    CHECK(count_of(shape.s, PieceKind::Junction) == 1);
    CHECK(count_of(shape.s, PieceKind::Sleeve) == 3);
    CHECK(core::with_joined_sleeves(shape.t, shape.s).cuts == shape.s.cuts);
}
