#include "core/skeleton/cat_graph.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/skeleton/chord_profile.hpp"
#include "support/segmented.hpp"
#include "support/shapes.hpp"

using core::CatGraph;
using core::PieceKind;
using core::Point;
using core::Polygon;

namespace {

/// The four arms of a cross of reach 5 and width 2, and the square between them.
core::Skeleton cross_in_five() {
    return support::skeleton_cut_at(support::cross(5, 2), {{1, 4}, {4, 7}, {7, 10}, {10, 1}});
}

/// Nodes that can be reached from the first.
std::size_t reached(const CatGraph& graph) {
    std::vector<char> seen(graph.nodes.size(), 0);
    std::vector<int> open{0};
    seen[0] = 1;
    std::size_t count = 1;
    while (!open.empty()) {
        const auto here = static_cast<std::size_t>(open.back());
        open.pop_back();
        for (const int next : graph.nodes[here].neighbours) {
            if (seen[static_cast<std::size_t>(next)] != 0) continue;
            seen[static_cast<std::size_t>(next)] = 1;
            ++count;
            open.push_back(next);
        }
    }
    return count;
}

void check_near(Point a, Point b) {
    CHECK(a.x == Approx(b.x).margin(1e-12));
    CHECK(a.y == Approx(b.y).margin(1e-12));
}

}  // namespace

TEST_CASE("a cross is one junction with four terminals", "[cat_graph]") {
    const core::Skeleton s = cross_in_five();
    const auto& nodes = s.graph.nodes;
    REQUIRE(nodes.size() == 5);
    const int middle = support::piece_behind(s, 4, 1);
    const auto& centre = nodes[static_cast<std::size_t>(middle)];
    CHECK(centre.kind == PieceKind::Junction);
    CHECK(centre.neighbours.size() == 4);
    check_near(centre.centroid, {0, 0});
    const std::vector<std::pair<support::Cut, Point>> arms{
        {{1, 4}, {3, 0}}, {{4, 7}, {0, 3}}, {{7, 10}, {-3, 0}}, {{10, 1}, {0, -3}}};
    for (const auto& [cut, place] : arms) {
        const auto& arm = nodes[static_cast<std::size_t>(support::piece_behind(s, cut.first, cut.second))];
        CHECK(arm.kind == PieceKind::Terminal);
        CHECK(arm.neighbours == std::vector<int>{middle});
        CHECK(arm.chords == std::vector<int>{support::chord_between(s.triangulation, cut)});
        check_near(arm.centroid, place);
    }
}

TEST_CASE("the skeleton leads from the middles of chords to the centroids of terminals and junctions", "[cat_graph]") {
    const CatGraph graph = cross_in_five().graph;
    REQUIRE(graph.skeleton.size() == 8);  // one for each end of the four chords
    for (const core::SkeletalSegment& segment : graph.skeleton) {
        const auto& node = graph.nodes[static_cast<std::size_t>(segment.node)];
        check_near(segment.to, node.centroid);
        CHECK(length(segment.from) == Approx(1.0));  // the sides of the square lie at 1 from the middle
    }
}

TEST_CASE("a sleeve's skeleton leads from middle to middle", "[cat_graph]") {
    // Three squares in a row, cut between them.
    const Polygon bar{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}};
    const core::Skeleton s = support::skeleton_cut_at(bar, {{1, 6}, {2, 5}});
    REQUIRE(s.graph.nodes.size() == 3);
    const int sleeve =
        support::piece_behind(s, 6, 1) == support::piece_behind(s, 2, 5) ? -1 : support::piece_behind(s, 1, 6);
    REQUIRE(sleeve >= 0);
    REQUIRE(s.graph.nodes[static_cast<std::size_t>(sleeve)].kind == PieceKind::Sleeve);
    int segments = 0;
    for (const core::SkeletalSegment& segment : s.graph.skeleton) {
        if (segment.node != sleeve) continue;
        ++segments;
        CHECK(segment.from.y == Approx(0.5));
        CHECK(segment.to.y == Approx(0.5));
        CHECK(distance(segment.from, segment.to) == Approx(1.0));
    }
    CHECK(segments == 1);
    // Half a unit in each terminal, one in the sleeve.
    CHECK(s.skeletal_length == Approx(2.0));
}

TEST_CASE("the skeletal length takes the three longest segments of a junction", "[cat_graph]") {
    // Terminals: 4 times from 1 to 3; junction: three of the four from 0 to 1.
    CHECK(core::skeletal_length(cross_in_five().graph) == Approx(4 * 2.0 + 3 * 1.0));
    // With arms of unequal width the longest: a middle of 2 by 6 has two segments of 1 and two of 3.
    const Polygon wide{{3, -5}, {3, -1}, {7, -1}, {7, 1},   {3, 1},   {3, 5},
                       {-3, 5}, {-3, 1}, {-7, 1}, {-7, -1}, {-3, -1}, {-3, -5}};
    const core::Skeleton s = support::skeleton_cut_at(wide, {{1, 4}, {4, 7}, {7, 10}, {10, 1}});
    REQUIRE(s.graph.nodes.size() == 5);
    CHECK(s.skeletal_length == Approx(4 * 2.0 + 3.0 + 3.0 + 1.0));
}

TEST_CASE("a shape that is not cut is one node without a skeleton", "[cat_graph]") {
    const core::Skeleton s = support::skeleton_cut_at(support::rectangle(4, 2), {});
    REQUIRE(s.graph.nodes.size() == 1);
    CHECK(s.graph.nodes[0].kind == PieceKind::Whole);
    CHECK(s.graph.nodes[0].neighbours.empty());
    check_near(s.graph.nodes[0].centroid, {2, 1});
    CHECK(s.graph.skeleton.empty());
    CHECK(s.skeletal_length == 0.0);
}

TEST_CASE("terminals have one neighbour, sleeves two, junctions more; there is no cycle", "[cat_graph]") {
    for (const Polygon& ring :
         {support::horse(), support::hand(), support::comb(9, 3), support::star(6, 9, 3), support::l_shape(9, 2)}) {
        const auto t = core::triangulate(ring);
        const std::vector<char> profile = core::extended_profile(ring, *t).cuts();
        const std::vector<char> everywhere(t->chords.size(), 1);
        for (const std::vector<char>& cuts : {profile, everywhere}) {
            const core::Segmentation s = core::segment(*t, cuts);
            const CatGraph graph = core::cat_graph(ring, *t, s);
            std::size_t ends = 0;
            for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
                const core::CatNode& node = graph.nodes[i];
                const std::size_t degree = node.neighbours.size();
                ends += degree;
                CHECK(node.chords.size() == degree);
                CHECK((node.kind == PieceKind::Terminal) == (degree == 1));
                CHECK((node.kind == PieceKind::Sleeve) == (degree == 2));
                CHECK((node.kind == PieceKind::Junction) == (degree >= 3));
                for (const int other : node.neighbours) {
                    const auto& back = graph.nodes[static_cast<std::size_t>(other)].neighbours;
                    CHECK(std::count(back.begin(), back.end(), static_cast<int>(i)) == 1);
                }
            }
            // As many edges as nodes less one, and all hang together: a tree.
            CHECK(ends == 2 * (graph.nodes.size() - 1));
            CHECK(reached(graph) == graph.nodes.size());
        }
    }
}
