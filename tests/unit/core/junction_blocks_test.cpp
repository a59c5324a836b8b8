#include "core/skeleton/junction_blocks.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>
#include <numbers>

#include "core/geometry/polygon.hpp"
#include "core/skeleton/chord_profile.hpp"
#include "support/segmented.hpp"
#include "support/shapes.hpp"

using core::PieceKind;
using core::Point;
using core::Polygon;
using core::Segmentation;

namespace {

/// A ring with its pieces, and the strain as thesis 5.2.3 defines it, straight from the words.
struct Shape {
    Polygon ring;
    core::Triangulation t;
    Segmentation s;

    Shape(const Polygon& outline, const std::vector<char>& cuts)
        : ring(outline), t(*core::triangulate(outline)), s(core::segment(t, cuts)) {}

    [[nodiscard]] Point at(int i) const { return ring[static_cast<std::size_t>(i)]; }

    [[nodiscard]] Point centroid(const core::Piece& piece) const {
        Point sum;
        double area = 0.0;
        for (const int id : piece.triangles) {
            const auto& v = t.triangles[static_cast<std::size_t>(id)].vertices;
            const double twice = core::cross(at(v[1]) - at(v[0]), at(v[2]) - at(v[0]));
            sum = sum + (at(v[0]) + at(v[1]) + at(v[2])) * (twice / 3.0);
            area += twice;
        }
        return sum * (1.0 / area);
    }

    /// n times the sum of (theta - pi/2)² |C| |S| over the n chords of the piece.
    [[nodiscard]] double strain(const core::Piece& piece) const {
        double sum = 0.0;
        for (const int id : piece.chords) {
            const core::Chord& c = t.chords[static_cast<std::size_t>(id)];
            const Point chord = at(c.v) - at(c.u), segment = midpoint(at(c.u), at(c.v)) - centroid(piece);
            if (length(segment) == 0.0) continue;
            const double theta = std::acos(dot(chord, segment) / (length(chord) * length(segment)));
            sum += std::pow(theta - std::numbers::pi / 2, 2.0) * length(chord) * length(segment);
        }
        return static_cast<double>(piece.chords.size()) * sum;
    }

    [[nodiscard]] double strain_of_junctions(const Segmentation& of) const {
        double total = 0.0;
        for (const core::Piece& piece : of.pieces) total += piece.kind() == PieceKind::Junction ? strain(piece) : 0.0;
        return total;
    }

    /// The chords between two junctions.
    [[nodiscard]] std::vector<int> connecting() const {
        std::vector<int> chords;
        for (std::size_t c = 0; c < s.cuts.size(); ++c) {
            const auto is_junction = [&](int triangle) {
                const int piece = s.piece_of_triangle[static_cast<std::size_t>(triangle)];
                return s.pieces[static_cast<std::size_t>(piece)].kind() == PieceKind::Junction;
            };
            if (s.cuts[c] != 0 && is_junction(t.chords[c].inner) && is_junction(t.chords[c].outer)) {
                chords.push_back(static_cast<int>(c));
            }
        }
        return chords;
    }

    [[nodiscard]] Segmentation without(const std::vector<int>& chords, std::uint32_t dropped) const {
        std::vector<char> cuts = s.cuts;
        for (std::size_t k = 0; k < chords.size(); ++k) {
            if ((dropped >> k & 1U) != 0) cuts[static_cast<std::size_t>(chords[k])] = 0;
        }
        return core::segment(t, cuts);
    }
};

Shape cut_everywhere(const Polygon& ring) {
    return {ring, std::vector<char>(ring.size() - 3, 1)};
}

int junctions(const Segmentation& s) {
    return static_cast<int>(std::count_if(s.pieces.begin(), s.pieces.end(),
                                          [](const auto& piece) { return piece.kind() == PieceKind::Junction; }));
}

Segmentation merged(const Shape& shape, int limit = 10) {
    core::ShapeParameters p;
    p.junction_block_limit = limit;
    return core::with_merged_junctions(shape.ring, shape.t, shape.s, p);
}

/// Two bars across a beam whose ends they stand at: the junctions lie `beam` apart.
Polygon double_cross(double beam) {
    return {{1, 0},        {beam + 1, 0}, {beam + 1, -4}, {beam + 3, -4}, {beam + 3, 0}, {beam + 7, 0}, {beam + 7, 2},
            {beam + 3, 2}, {beam + 3, 6}, {beam + 1, 6},  {beam + 1, 2},  {1, 2},        {1, 6},        {-1, 6},
            {-1, 2},       {-5, 2},       {-5, 0},        {-1, 0},        {-1, -4},      {1, -4}};
}

}  // namespace

TEST_CASE("the block in the middle of a star merges into one junction without strain", "[junction_blocks]") {
    for (const int tips : {4, 5, 6, 7, 8}) {
        const Shape star = cut_everywhere(support::star(tips, 10, 4));
        REQUIRE(junctions(star.s) == tips - 2);
        const Segmentation whole = merged(star);
        INFO(tips << " tips");
        CHECK(junctions(whole) == 1);
        CHECK(whole.pieces.size() == static_cast<std::size_t>(tips) + 1);
        CHECK(star.strain_of_junctions(whole) == Approx(0.0).margin(1e-9));
    }
}

TEST_CASE("junctions that no chord joins are no block", "[junction_blocks]") {
    // Six arms, two junctions, and the beam between them is a sleeve.
    const Polygon ring = double_cross(12);
    const auto cuts = support::cuts_at(*core::triangulate(ring),
                                       {{1, 4}, {4, 7}, {7, 10}, {10, 1}, {0, 11}, {11, 14}, {14, 17}, {17, 0}});
    const Shape shape(ring, cuts);
    REQUIRE(shape.s.pieces.size() == 9);
    REQUIRE(junctions(shape.s) == 2);
    CHECK(merged(shape).cuts == cuts);
}

TEST_CASE("a block keeps the subset of its chords with the least strain", "[junction_blocks]") {
    std::vector<Shape> shapes;
    for (const Polygon& ring : {support::hand(), support::horse(), support::comb(5, 4), support::star(7, 10, 3),
                                double_cross(0.5), double_cross(3), support::cross(7, 3)}) {
        shapes.push_back(cut_everywhere(ring));
        shapes.emplace_back(ring, core::extended_profile(ring, *core::triangulate(ring)).cuts());
    }
    int blocks = 0;
    for (const Shape& shape : shapes) {
        const std::vector<int> chords = shape.connecting();
        REQUIRE(chords.size() <= 10);
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t dropped = 0; dropped < (1U << chords.size()); ++dropped) {
            least = std::min(least, shape.strain_of_junctions(shape.without(chords, dropped)));
        }
        CHECK(shape.strain_of_junctions(merged(shape)) == Approx(least).margin(1e-9));
        blocks += chords.empty() ? 0 : 1;
    }
    CHECK(blocks >= 8);
}

TEST_CASE("only chords between junctions are dropped", "[junction_blocks]") {
    const Shape shape = cut_everywhere(support::hand());
    const std::vector<int> chords = shape.connecting();
    const Segmentation after = merged(shape);
    for (std::size_t c = 0; c < after.cuts.size(); ++c) {
        if (std::find(chords.begin(), chords.end(), static_cast<int>(c)) == chords.end()) CHECK(after.cuts[c] == 1);
    }
}

TEST_CASE("a block above the limit drops chords while a single one lowers the strain", "[junction_blocks]") {
    for (const Polygon& ring : {support::star(9, 10, 4), support::comb(40, 3), support::hand()}) {
        const Shape shape = cut_everywhere(ring);
        const std::vector<int> chords = shape.connecting();
        const Segmentation after = merged(shape, 0);
        const double strain = shape.strain_of_junctions(after);
        CHECK(strain <= shape.strain_of_junctions(shape.s) * (1 + 1e-9));
        for (const int c : chords) {
            if (after.cuts[static_cast<std::size_t>(c)] == 0) continue;
            std::vector<char> cuts = after.cuts;
            cuts[static_cast<std::size_t>(c)] = 0;
            CHECK(shape.strain_of_junctions(core::segment(shape.t, cuts)) >= strain * (1 - 1e-6));
        }
    }
}

TEST_CASE("trimming takes the triangles of an arm out of its junction", "[junction_blocks]") {
    // A T whose stem has samples at every unit, cut off only near its tip: the rest of it is part of the junction.
    const Polygon ring{{-1, 0}, {-1, -1}, {-1, -2}, {-1, -3}, {-1, -4}, {1, -4}, {1, -3}, {1, -2},
                       {1, -1}, {1, 0},   {5, 0},   {5, 2},   {0, 2},   {-5, 2}, {-5, 0}};
    const auto t = core::triangulate(ring);
    const Shape shape(ring, support::cuts_at(*t, {{3, 6}, {0, 12}, {9, 12}}));
    REQUIRE(shape.s.pieces.size() == 4);
    REQUIRE(junctions(shape.s) == 1);
    const Segmentation after = core::with_trimmed_junctions(shape.ring, shape.t, shape.s);
    CHECK(after.cuts == support::cuts_at(*t, {{0, 9}, {0, 12}, {9, 12}}));
    CHECK(after.pieces.size() == 4);
}

TEST_CASE("trimming neither changes the topology nor adds strain, and leaves nothing to trim", "[junction_blocks]") {
    for (const Polygon& outline : {support::hand(), support::horse(), support::comb(5, 6), double_cross(8)}) {
        const Polygon ring = core::resample_ring(outline, 90);
        const Shape shape(ring, core::extended_profile(ring, *core::triangulate(ring)).cuts());
        const Segmentation before = merged(shape);
        const Segmentation after = core::with_trimmed_junctions(shape.ring, shape.t, before);
        REQUIRE(after.pieces.size() == before.pieces.size());
        std::vector<std::size_t> degrees_before, degrees_after;
        for (const core::Piece& piece : before.pieces) degrees_before.push_back(piece.chords.size());
        for (const core::Piece& piece : after.pieces) degrees_after.push_back(piece.chords.size());
        std::sort(degrees_before.begin(), degrees_before.end());
        std::sort(degrees_after.begin(), degrees_after.end());
        CHECK(degrees_before == degrees_after);
        CHECK(shape.strain_of_junctions(after) <= shape.strain_of_junctions(before) * (1 + 1e-9));
        const Segmentation again = core::with_trimmed_junctions(shape.ring, shape.t, after);
        CHECK(again.cuts == after.cuts);
    }
}
