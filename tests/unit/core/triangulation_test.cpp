#include "core/skeleton/triangulation.hpp"

#include <catch2/catch.hpp>

#include "core/geometry/polygon.hpp"
#include "support/shapes.hpp"

using core::Polygon;
using core::TriangleRole;
using core::Triangulation;

namespace {

Triangulation triangulated(const Polygon& ring) {
    const auto t = core::triangulate(ring);
    REQUIRE(t);
    return *t;
}

int count_of(const Triangulation& t, TriangleRole role) {
    return static_cast<int>(
        std::count_if(t.triangles.begin(), t.triangles.end(), [&](const auto& tri) { return tri.role() == role; }));
}

double area_of(const Polygon& ring, const core::Triangle& t) {
    const auto at = [&](int k) { return ring[static_cast<std::size_t>(t.vertices[static_cast<std::size_t>(k)])]; };
    return 0.5 * cross(at(1) - at(0), at(2) - at(0));
}

/// Everything that the header promises of the structure.
void check_structure(const Polygon& ring, const Triangulation& t) {
    const std::size_t n = ring.size();
    REQUIRE(t.triangles.size() == n - 2);
    REQUIRE(t.chords.size() == n - 3);
    double area = 0.0;
    for (const auto& triangle : t.triangles) {
        CHECK(area_of(ring, triangle) > 0.0);
        area += area_of(ring, triangle);
        const std::array<std::pair<int, int>, 3> ends{{{0, 1}, {1, 2}, {0, 2}}};
        for (std::size_t k = 0; k < 3; ++k) {
            const int u = triangle.vertices[static_cast<std::size_t>(ends[k].first)];
            const int v = triangle.vertices[static_cast<std::size_t>(ends[k].second)];
            CHECK(u < v);
            const bool outline = v == u + 1 || (u == 0 && v == static_cast<int>(n) - 1);
            REQUIRE((triangle.chords[k] < 0) == outline);
            if (outline) continue;
            const core::Chord& chord = t.chords[static_cast<std::size_t>(triangle.chords[k])];
            CHECK(std::pair{chord.u, chord.v} == std::pair{u, v});
        }
    }
    CHECK(area == Approx(core::signed_area(ring)));
    for (std::size_t c = 0; c < t.chords.size(); ++c) {
        const core::Chord& chord = t.chords[c];
        if (c > 0) CHECK(std::pair{t.chords[c - 1].u, t.chords[c - 1].v} < std::pair{chord.u, chord.v});
        const auto third = [&](int triangle) {
            const auto& v = t.triangles[static_cast<std::size_t>(triangle)].vertices;
            return v[0] + v[1] + v[2] - chord.u - chord.v;
        };
        CHECK((third(chord.inner) > chord.u && third(chord.inner) < chord.v));
        CHECK((third(chord.outer) < chord.u || third(chord.outer) > chord.v));
    }
}

}  // namespace

TEST_CASE("n samples give n - 2 triangles and n - 3 chords that fill the ring", "[triangulation]") {
    for (const Polygon& ring : {support::horse(), support::hand(), support::comb(5, 4), support::star(6, 5, 2),
                                core::resample_ring(support::l_shape(9, 2), 100)}) {
        check_structure(ring, triangulated(ring));
    }
}

TEST_CASE("cocircular and collinear samples are no trouble", "[triangulation]") {
    const Polygon grid = core::resample_ring(support::rectangle(8, 8), 32);
    check_structure(grid, triangulated(grid));
    const Polygon circle = support::disc(100, 1.0);
    check_structure(circle, triangulated(circle));
    Polygon thin{{0, 0}};
    for (int i = 1; i <= 20; ++i) thin.push_back({static_cast<double>(i), 0});
    for (int i = 20; i >= 0; --i) thin.push_back({static_cast<double>(i), 1e-9});
    check_structure(thin, triangulated(thin));
}

TEST_CASE("the triangulation is Delaunay: of two diagonals it takes the one with the smaller angles",
          "[triangulation]") {
    const Triangulation t = triangulated({{0, 0}, {3, -1}, {6, 0}, {3, 1}});
    REQUIRE(t.chords.size() == 1);
    CHECK(std::pair{t.chords[0].u, t.chords[0].v} == std::pair{1, 3});
    CHECK(t.chords[0].inner == 1);  // the triangle 1 2 3, after 0 1 3
    CHECK(t.chords[0].outer == 0);
}

TEST_CASE("a triangle has no chord", "[triangulation]") {
    const Triangulation t = triangulated({{0, 0}, {1, 0}, {0, 1}});
    CHECK(t.triangles.size() == 1);
    CHECK(t.chords.empty());
    CHECK(core::chords_along_outline(t, 3).empty());
}

TEST_CASE("a star has one terminal triangle a tip, a cross one an arm", "[triangulation]") {
    const Triangulation star = triangulated(support::star(5, 10, 4));
    CHECK(count_of(star, TriangleRole::Terminal) == 5);
    CHECK(count_of(star, TriangleRole::Sleeve) == 0);
    CHECK(count_of(star, TriangleRole::Junction) == 3);
    const Triangulation cross = triangulated(support::cross(5, 2));
    CHECK(count_of(cross, TriangleRole::Terminal) == 4);
    CHECK(count_of(cross, TriangleRole::Sleeve) == 4);
    CHECK(count_of(cross, TriangleRole::Junction) == 2);
}

TEST_CASE("there are always two more terminals than junctions, for the triangles form a tree", "[triangulation]") {
    for (const Polygon& ring : {support::horse(), support::hand(), support::comb(7, 5), support::disc(50, 3)}) {
        const Triangulation t = triangulated(ring);
        CHECK(count_of(t, TriangleRole::Terminal) == count_of(t, TriangleRole::Junction) + 2);
    }
}

TEST_CASE("a walk along the outline meets the chords in order, each twice", "[triangulation]") {
    // A fan from sample 0 over a convex ring: the chords 0-2, 0-3.
    const Triangulation fan = triangulated({{0, 0}, {2, -1.5}, {2.2, -0.5}, {2.2, 0.5}, {2, 1.5}});
    REQUIRE(fan.chords.size() == 2);
    REQUIRE(std::pair{fan.chords[0].u, fan.chords[0].v} == std::pair{0, 2});
    REQUIRE(std::pair{fan.chords[1].u, fan.chords[1].v} == std::pair{0, 3});
    // At 0 from the chord that leads farthest, then at 2, then at 3.
    CHECK(core::chords_along_outline(fan, 5) == std::vector<int>{1, 0, 0, 1});

    const Polygon horse = support::horse();
    const Triangulation t = triangulated(horse);
    const std::vector<int> order = core::chords_along_outline(t, static_cast<int>(horse.size()));
    REQUIRE(order.size() == 2 * t.chords.size());
    for (int c = 0; c < static_cast<int>(t.chords.size()); ++c) CHECK(std::count(order.begin(), order.end(), c) == 2);
    // Neighbours in the walk share a sample or follow each other round a terminal: both lie on one triangle.
    for (std::size_t i = 0; i < order.size(); ++i) {
        const core::Chord& a = t.chords[static_cast<std::size_t>(order[i])];
        const core::Chord& b = t.chords[static_cast<std::size_t>(order[(i + 1) % order.size()])];
        CHECK((a.inner == b.inner || a.inner == b.outer || a.outer == b.inner || a.outer == b.outer));
    }
}

TEST_CASE("rings that cannot be triangulated are told apart", "[triangulation]") {
    CHECK(core::triangulate({}).error().code == core::ErrorCode::BadOutline);
    CHECK(core::triangulate({{0, 0}, {1, 0}}).error().code == core::ErrorCode::BadOutline);
    CHECK(core::triangulate({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).error().code == core::ErrorCode::BadOutline);
    CHECK(core::triangulate({{0, 0}, {1, 0}, {0, 0}, {0, 1}}).error().code == core::ErrorCode::BadOutline);
    CHECK(core::triangulate({{0, 0}, {1, 0}, {2, 0}}).error().code == core::ErrorCode::BadOutline);
}
