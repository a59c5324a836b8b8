#include "core/parts/wings.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/parts/describe.hpp"
#include "core/parts/features.hpp"
#include "support/segmented.hpp"
#include "support/shapes.hpp"

using core::Part;
using core::Polygon;
using core::ShapeParameters;
using core::Skeleton;

namespace {

/// A bar of 9 by 1 with three teeth, cut at every tooth's foot and on both its sides. Anti-clockwise from the lower
/// left: terminals 0 (right end), 1 (third tooth), 2 (second), 3 (first), 4 (left end).
Skeleton caterpillar(double a, double b, double c) {
    Skeleton s = support::skeleton_cut_at(
        {{0, 0},     {1, 0}, {2, 0}, {4, 0},     {5, 0},     {7, 0}, {8, 0}, {9, 0},     {9, 1},     {8, 1}, {8, 1 + c},
         {7, 1 + c}, {7, 1}, {5, 1}, {5, 1 + b}, {4, 1 + b}, {4, 1}, {2, 1}, {2, 1 + a}, {1, 1 + a}, {1, 1}, {0, 1}},
        {{1, 20}, {2, 17}, {3, 16}, {4, 13}, {5, 12}, {6, 9}, {17, 20}, {13, 16}, {9, 12}});
    REQUIRE(s.graph.nodes.size() == 10);
    return s;
}

/// No part is salient, and any difference makes a wing: what the tree gives by itself.
ShapeParameters nothing_salient() {
    ShapeParameters p;
    p.depth_threshold_first = p.depth_threshold_step = 5;
    p.large_t = p.small_long_t = p.large_long_t = p.size_bent_t = 1000;
    p.wing_step = 1e-3;
    p.wing_salient_limit = 2;
    return p;
}

std::vector<Part> parts(const Skeleton& s, const ShapeParameters& p) {
    return core::parts_of(s, core::part_tree(s, p), p);
}

/// (first terminal, terminals, first sample, last sample) of the wings.
using Wing = std::array<int, 4>;
std::vector<Wing> wings_of(const std::vector<Part>& all, int terminals) {
    std::vector<Wing> wings;
    for (std::size_t i = static_cast<std::size_t>(terminals); i < all.size(); ++i) {
        wings.push_back({all[i].first_terminal, all[i].terminal_count, all[i].start_sample, all[i].end_sample});
    }
    return wings;
}

}  // namespace

TEST_CASE("terminals come anti-clockwise from the one whose arc starts at the lowest sample", "[wings]") {
    const std::vector<Part> all = parts(caterpillar(2, 2, 2), nothing_salient());
    const std::vector<std::pair<int, int>> arcs{{6, 9}, {9, 12}, {13, 16}, {17, 20}, {20, 1}};
    REQUIRE(all.size() >= arcs.size());
    for (std::size_t t = 0; t < arcs.size(); ++t) {
        CHECK(all[t].first_terminal == static_cast<int>(t));
        CHECK(all[t].terminal_count == 1);
        CHECK(std::pair{all[t].start_sample, all[t].end_sample} == arcs[t]);
    }
}

TEST_CASE("every subtree below the root is a wing over a run of terminals", "[wings]") {
    // The root is the middle junction; on each side of it hang a sleeve and, behind it, a junction with tooth and end.
    const std::vector<Part> all = parts(caterpillar(2, 2, 2), nothing_salient());
    CHECK(wings_of(all, 5) == std::vector<Wing>{{0, 2, 5, 12}, {0, 2, 4, 13}, {3, 2, 17, 2}, {3, 2, 16, 3}});
}

TEST_CASE("no wing holds the root: none has all terminals, none runs over all that hangs at it", "[wings]") {
    for (const Polygon& outline : {support::horse(), support::hand(), support::comb(6, 5)}) {
        const auto shape = core::describe_in_steps(outline);
        REQUIRE(shape);
        const auto& d = shape->descriptor;
        const auto root = static_cast<std::size_t>(shape->tree.root);
        const core::Piece& piece = shape->skeleton.pieces.pieces[root];
        for (const Part& part : d.parts) {
            CHECK(part.terminal_count < d.terminal_count);
            for (const int chord : piece.chords) {  // a chord of the root lies whole within the arc or whole outside
                const core::Chord& c = shape->skeleton.triangulation.chords[static_cast<std::size_t>(chord)];
                const int n = shape->skeleton.arcs.count();
                const int length = (part.end_sample - part.start_sample + n) % n;
                const auto within = [&](int sample) { return (sample - part.start_sample + n) % n <= length; };
                CHECK((within(c.u) && within(c.v)) == ((part.start_sample == c.u && part.end_sample == c.v) ||
                                                       (part.start_sample == c.v && part.end_sample == c.u)));
            }
        }
    }
}

TEST_CASE("a wing groups no more salient terminals than the limit", "[wings]") {
    // Every terminal of more than 5 % of the perimeter at an eccentricity of 2 is salient: the teeth (2 over 1), not
    // the ends.
    const Skeleton s = caterpillar(2, 2, 2);
    ShapeParameters p = nothing_salient();
    p.small_long_t = 5;
    p.small_et = 2;
    const std::vector<Part> all = parts(s, p);
    for (const std::size_t t : {1U, 2U, 3U}) CHECK(all[t].salient);
    for (const std::size_t t : {0U, 4U}) CHECK_FALSE(all[t].salient);
    CHECK(wings_of(all, 5).size() == 4);  // one salient tooth each
    p.wing_salient_limit = 0;
    CHECK(wings_of(parts(s, p), 5).empty());
}

TEST_CASE("two salient terminals may be grouped, three may not", "[wings]") {
    // With a third tooth of 40 the root is the third junction: behind the first hang two terminals, behind the second
    // three. All are salient.
    const Skeleton s = caterpillar(2, 2, 40);
    ShapeParameters p = nothing_salient();
    p.small_long_t = 1;
    p.small_et = 0.1;
    for (std::size_t t = 0; t < 5; ++t) CHECK(parts(s, p)[t].salient);
    const auto most_grouped = [&](int limit) {
        p.wing_salient_limit = limit;
        int most = 0;
        for (const Wing& wing : wings_of(parts(s, p), 5)) most = std::max(most, wing[1]);
        return most;
    };
    CHECK(most_grouped(1) == 0);
    CHECK(most_grouped(2) == 2);
    CHECK(most_grouped(3) == 3);
}

TEST_CASE("a wing differs from what has the same terminals by a step of perimeter", "[wings]") {
    // The wing behind the junction has 28.1 % of the perimeter, with the sleeve 40.6 %: 12.5 more.
    const Skeleton s = caterpillar(2, 2, 2);
    ShapeParameters p = nothing_salient();
    p.wing_step = 12.4;
    CHECK(wings_of(parts(s, p), 5).size() == 4);
    p.wing_step = 12.6;
    CHECK(wings_of(parts(s, p), 5) == std::vector<Wing>{{0, 2, 5, 12}, {3, 2, 17, 2}});
}

TEST_CASE("a tip with its sleeve is a wing of one terminal", "[wings]") {
    // A cross whose right arm is cut at its foot and again before its tip.
    const Skeleton s = support::skeleton_cut_at({{1, -5},
                                                 {1, -1},
                                                 {9, -1},
                                                 {11, -1},
                                                 {11, 1},
                                                 {9, 1},
                                                 {1, 1},
                                                 {1, 5},
                                                 {-1, 5},
                                                 {-1, 1},
                                                 {-5, 1},
                                                 {-5, -1},
                                                 {-1, -1},
                                                 {-1, -5}},
                                                {{1, 6}, {6, 9}, {9, 12}, {12, 1}, {2, 5}});
    REQUIRE(s.graph.nodes.size() == 6);
    const std::vector<Part> all = parts(s, nothing_salient());
    CHECK(wings_of(all, 4) == std::vector<Wing>{{0, 1, 1, 6}});
    CHECK(std::pair{all[0].start_sample, all[0].end_sample} == std::pair{2, 5});
}

TEST_CASE("parts are measured on their own arcs", "[wings]") {
    const Skeleton s = caterpillar(2, 3, 4);
    const ShapeParameters p = nothing_salient();
    for (const Part& part : parts(s, p)) {
        const Part expected = core::measure_part(s.samples, s.arcs, {part.start_sample, part.end_sample}, p);
        CHECK(part.features == expected.features);
        CHECK(part.signature == expected.signature);
    }
}

TEST_CASE("wings are in order, cover the terminals within their arcs, and repeat none", "[wings]") {
    for (const Polygon& outline : {support::horse(), support::hand(), support::comb(8, 4), support::star(6, 9, 3)}) {
        const auto d = core::describe(outline);
        REQUIRE(d);
        const int n = static_cast<int>(d->samples.size());
        for (std::size_t i = static_cast<std::size_t>(d->terminal_count); i < d->parts.size(); ++i) {
            const Part& wing = d->parts[i];
            const int length = (wing.end_sample - wing.start_sample + n) % n;
            for (int t = 0; t < d->terminal_count; ++t) {
                const Part& terminal = d->parts[static_cast<std::size_t>(t)];
                const int from = (terminal.start_sample - wing.start_sample + n) % n;
                const int to = from + (terminal.end_sample - terminal.start_sample + n) % n;
                const bool grouped =
                    (t - wing.first_terminal + d->terminal_count) % d->terminal_count < wing.terminal_count;
                CHECK(grouped == (to <= length));
            }
            if (i == static_cast<std::size_t>(d->terminal_count)) continue;
            const Part& before = d->parts[i - 1];
            CHECK(std::pair{before.first_terminal, before.terminal_count} <=
                  std::pair{wing.first_terminal, wing.terminal_count});
        }
    }
}

TEST_CASE("a shape without terminals has no parts, one of two pieces no wing", "[wings]") {
    const Polygon bar{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}};
    CHECK(parts(support::skeleton_cut_at(bar, {}), nothing_salient()).empty());
    const std::vector<Part> two = parts(support::skeleton_cut_at(bar, {{1, 6}}), nothing_salient());
    REQUIRE(two.size() == 2);
    CHECK(wings_of(two, 2).empty());
}
