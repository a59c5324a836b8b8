#include "core/parts/depth.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/parts/describe.hpp"
#include "support/segmented.hpp"
#include "support/shapes.hpp"

using core::PartTree;
using core::PieceKind;
using core::Polygon;
using core::Skeleton;

namespace {

/// Thresholds of 5 %, 10 %, 15 % … in the iterations 0, 1, 2 …
core::ShapeParameters five_and_five() {
    core::ShapeParameters p;
    p.depth_threshold_first = 5;
    p.depth_threshold_step = 5;
    return p;
}

int piece(const Skeleton& s, int from, int to) {
    const int node = support::piece_behind(s, from, to);
    REQUIRE(node >= 0);
    return node;
}

template <typename T>
T at(const std::vector<T>& values, int node) {
    return values[static_cast<std::size_t>(node)];
}

/// A bar of 9 by 1 with three teeth at 1 to 2, 4 to 5 and 7 to 8, cut at every tooth's foot and on both its sides:
///
///          first      second     third
///            |          |          |
///     end -- J -- S --- J -- S --- J -- end
///
struct Caterpillar {
    Skeleton s;
    int left_end, right_end, first, second, third, j1, j2, j3, s12, s23;

    Caterpillar(double a, double b, double c)
        : s(support::skeleton_cut_at(
              {{0, 0}, {1, 0}, {2, 0},     {4, 0},     {5, 0}, {7, 0}, {8, 0},     {9, 0},
               {9, 1}, {8, 1}, {8, 1 + c}, {7, 1 + c}, {7, 1}, {5, 1}, {5, 1 + b}, {4, 1 + b},
               {4, 1}, {2, 1}, {2, 1 + a}, {1, 1 + a}, {1, 1}, {0, 1}},
              {{1, 20}, {2, 17}, {3, 16}, {4, 13}, {5, 12}, {6, 9}, {17, 20}, {13, 16}, {9, 12}})) {
        REQUIRE(s.graph.nodes.size() == 10);
        left_end = piece(s, 20, 1);
        right_end = piece(s, 6, 9);
        first = piece(s, 17, 20);
        second = piece(s, 13, 16);
        third = piece(s, 9, 12);
        j1 = piece(s, 1, 20);
        j2 = piece(s, 3, 16);
        j3 = piece(s, 9, 6);
        s12 = piece(s, 2, 17);
        s23 = piece(s, 4, 13);
    }
};

}  // namespace

TEST_CASE("equal teeth: the ends merge first, the middle junction is left", "[depth]") {
    // Area 15, perimeter 32. A tooth has 13.3 % of area and 15.6 % of perimeter, an end 6.7 and 9.4: at a threshold of
    // 20 % (iteration 3) both merge with their junction. The compound has 26.7 and 28.1 %: at 30 % (iteration 5) it
    // merges with the sleeve.
    const Caterpillar c(2, 2, 2);
    const PartTree tree = core::part_tree(c.s, five_and_five());
    CHECK(tree.root == c.j2);
    CHECK(at(tree.iteration, c.j1) == 3);
    CHECK(at(tree.iteration, c.j3) == 3);
    CHECK(at(tree.iteration, c.s12) == 5);
    CHECK(at(tree.iteration, c.s23) == 5);
    CHECK(at(tree.iteration, c.j2) == -1);
    for (const int terminal : {c.left_end, c.right_end, c.first, c.second, c.third}) {
        CHECK(at(tree.iteration, terminal) == -1);
    }
}

TEST_CASE("depth is 0 at the root and grows away from it", "[depth]") {
    const Caterpillar c(2, 2, 2);
    const PartTree tree = core::part_tree(c.s, five_and_five());
    const std::vector<std::pair<int, int>> expected{{c.j2, 0},    {c.second, 1},   {c.s12, 1},   {c.s23, 1},
                                                    {c.j1, 2},    {c.j3, 2},       {c.first, 3}, {c.left_end, 3},
                                                    {c.third, 3}, {c.right_end, 3}};
    for (const auto& [node, depth] : expected) CHECK(at(tree.depth, node) == depth);
    CHECK(at(tree.parent, c.j1) == c.s12);
    CHECK(at(tree.parent, c.s12) == c.j2);
    CHECK(at(tree.parent, c.first) == c.j1);
    CHECK(at(tree.parent, c.j2) == -1);
    CHECK(at(tree.parent_chord, c.j2) == -1);
    CHECK(at(tree.parent_chord, c.first) == support::chord_between(c.s.triangulation, {17, 20}));
}

TEST_CASE("a large terminal holds its junction back: the root moves towards it", "[depth]") {
    // The third tooth is 40 long: three quarters of the shape hang at the third junction.
    const Caterpillar c(2, 2, 40);
    const PartTree tree = core::part_tree(c.s, five_and_five());
    CHECK(tree.root == c.j3);
    CHECK(at(tree.depth, c.j1) == 4);
    CHECK(at(tree.iteration, c.j3) == -1);
    CHECK(at(tree.iteration, c.j1) < at(tree.iteration, c.j2));
}

TEST_CASE("an iteration goes on while what has become a terminal lets its neighbour merge", "[depth]") {
    // With a first threshold above everything all merges happen at once.
    core::ShapeParameters p = five_and_five();
    p.depth_threshold_first = 100;
    const Caterpillar c(2, 2, 2);
    const PartTree tree = core::part_tree(c.s, p);
    for (const int node : {c.j1, c.j3, c.s12, c.s23, c.j2})
        CHECK(at(tree.iteration, node) == (node == tree.root ? -1 : 0));
    CHECK(c.s.graph.nodes[static_cast<std::size_t>(tree.root)].kind == PieceKind::Junction);
    // Smaller compounds go first, so where the thresholds do not decide the largest is left.
    const Caterpillar heavy(2, 2, 40), other(40, 2, 2);
    CHECK(core::part_tree(heavy.s, p).root == heavy.j3);
    CHECK(core::part_tree(other.s, p).root == other.j1);
}

TEST_CASE("both area and perimeter have to be below the threshold", "[depth]") {
    // 15.6 % of perimeter at 13.3 % of area: a threshold of 14 is above the area alone.
    core::ShapeParameters p;
    p.depth_threshold_first = 14;
    p.depth_threshold_step = 0.9;
    const Caterpillar c(2, 2, 2);
    CHECK(at(core::part_tree(c.s, p).iteration, c.j1) == 2);  // 15.8
    p.depth_threshold_first = 15.7;
    CHECK(at(core::part_tree(c.s, p).iteration, c.j1) == 0);
}

TEST_CASE("the only junction is the root, however large the sleeves beside it are", "[depth]") {
    // A tooth near the end of a long bar; the bar's far part is a sleeve and a terminal.
    const Skeleton s = support::skeleton_cut_at(
        {{0, 0}, {1, 0}, {2, 0}, {30, 0}, {31, 0}, {31, 1}, {30, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}},
        {{1, 10}, {2, 7}, {7, 10}, {3, 6}});
    REQUIRE(s.graph.nodes.size() == 4 + 1);
    const PartTree tree = core::part_tree(s, five_and_five());
    CHECK(tree.root == piece(s, 10, 7));
}

TEST_CASE("without a junction the sleeve is the root, without a sleeve there is none", "[depth]") {
    const Polygon bar{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}};
    const Skeleton three = support::skeleton_cut_at(bar, {{1, 6}, {2, 5}});
    const PartTree of_three = core::part_tree(three, five_and_five());
    CHECK(of_three.root == piece(three, 1, 6));
    CHECK(of_three.bottom_up.size() == 2);
    const Skeleton two = support::skeleton_cut_at(bar, {{1, 6}});
    const Skeleton one = support::skeleton_cut_at(bar, {});
    for (const Skeleton* s : {&two, &one}) {
        const PartTree tree = core::part_tree(*s, five_and_five());
        CHECK(tree.root == -1);
        CHECK(tree.depth == std::vector<int>(s->graph.nodes.size(), -1));
        CHECK(tree.bottom_up.empty());
    }
}

TEST_CASE("the tree holds every node once, children before parents, one edge deeper", "[depth]") {
    for (const Polygon& outline : {support::horse(), support::hand(), support::comb(8, 5), support::star(7, 9, 3)}) {
        const auto shape = core::describe_in_steps(outline);
        REQUIRE(shape);
        const PartTree& tree = shape->tree;
        const auto& nodes = shape->skeleton.graph.nodes;
        REQUIRE(tree.root >= 0);
        CHECK(nodes[static_cast<std::size_t>(tree.root)].kind == PieceKind::Junction);
        CHECK(tree.bottom_up.size() == nodes.size() - 1);
        std::vector<char> done(nodes.size(), 0);
        for (const int node : tree.bottom_up) {
            CHECK(at(done, node) == 0);
            done[static_cast<std::size_t>(node)] = 1;
            const int parent = at(tree.parent, node);
            CHECK(at(done, parent) == 0);
            CHECK(at(tree.depth, node) == at(tree.depth, parent) + 1);
            const auto& neighbours = nodes[static_cast<std::size_t>(node)].neighbours;
            CHECK(std::count(neighbours.begin(), neighbours.end(), parent) == 1);
            const bool terminal = nodes[static_cast<std::size_t>(node)].kind == PieceKind::Terminal;
            CHECK((at(tree.iteration, node) < 0) == terminal);
            // A node becomes a compound no later than the one that takes it up.
            if (!terminal && parent != tree.root) CHECK(at(tree.iteration, node) <= at(tree.iteration, parent));
        }
    }
}
