#include "core/match/part_ring.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "core/parts/describe.hpp"
#include "support/arm_ring.hpp"
#include "support/random_descriptor.hpp"
#include "support/shapes.hpp"

using core::Feature;
using core::MatchableShape;
using core::Part;
using core::PartRing;
using core::RingPart;

namespace {

/// The weights of table 5.2, whatever the shipped ones are.
core::ShapeParameters table_5_2() {
    core::ShapeParameters p;
    p.w_area = p.w_perimeter = 1;
    p.w_eccentricity = 10;
    p.w_circularity = p.w_rectangularity = 40;
    p.w_convexity = p.w_solidity = 25;
    p.w_bending_energy = 0.5;
    p.w_chord_length_ratio = 10;
    p.w_d_e = 100;
    p.w_d_be = 1;
    p.w_d_a = 0.1;
    return p;
}

Part wing(int first, int count) {
    Part part;
    part.first_terminal = first;
    part.terminal_count = count;
    return part;
}

std::vector<int> stops(const std::vector<Part>& wings, int terminals, bool backwards = false) {
    std::vector<Part> parts(static_cast<std::size_t>(terminals));
    for (int t = 0; t < terminals; ++t) parts[static_cast<std::size_t>(t)] = wing(t, 1);
    parts.insert(parts.end(), wings.begin(), wings.end());
    return core::stop_points(parts, terminals, backwards);
}

using Ints = std::vector<int>;

RingPart with(const std::array<float, core::kFeatureCount>& weighted, float signature) {
    RingPart part;
    part.weighted = weighted;
    part.signature.fill(signature);
    return part;
}

}  // namespace

TEST_CASE("a terminal is a stop point in no wing, or first in all that hold it", "[part_ring]") {
    CHECK(stops({}, 4) == Ints{0, 1, 2, 3});
    CHECK(stops({wing(1, 2)}, 4) == Ints{0, 1, 3});
    // The example of 6.1: a wing of t2 to t5, and t4 as the start would cut it.
    CHECK(stops({wing(2, 4)}, 8) == Ints{0, 1, 2, 6, 7});
    // First in one wing, later in another: no stop point.
    CHECK(stops({wing(1, 2), wing(2, 2)}, 5) == Ints{0, 1, 4});
    // Nested wings with the same first terminal.
    CHECK(stops({wing(1, 2), wing(1, 3)}, 5) == Ints{0, 1, 4});
    // Over the end of the list.
    CHECK(stops({wing(4, 2)}, 5) == Ints{1, 2, 3, 4});
}

TEST_CASE("read clockwise, a stop point is last in all wings that hold it", "[part_ring]") {
    CHECK(stops({wing(1, 2)}, 4, true) == Ints{0, 2, 3});
    CHECK(stops({wing(2, 4)}, 8, true) == Ints{0, 1, 5, 6, 7});
    CHECK(stops({wing(4, 2)}, 5, true) == Ints{0, 1, 2, 3});
}

TEST_CASE("where wings leave no stop point, both directions cut at the same place", "[part_ring]") {
    const std::vector<Part> all{wing(0, 2), wing(1, 2), wing(2, 2)};
    CHECK(stops(all, 3) == Ints{0});
    CHECK(stops(all, 3, true) == Ints{2});
    CHECK(stops({}, 0).empty());
}

TEST_CASE("weights are multiplied in, each with its own feature", "[part_ring]") {
    core::ShapeDescriptor shape = support::arm_ring({{0, 0}, {1, 0}});
    shape.parts[0].features = {3, 5, 2, 0.5, 0.25, 0.2, 0.4, 8, 0.3F};
    const MatchableShape ready = core::matchable(shape, table_5_2());
    const std::array<double, core::kFeatureCount> expected{3, 5, 20, 20, 10, 5, 10, 4, 3};
    for (std::size_t k = 0; k < core::kFeatureCount; ++k) {
        CHECK(ready.forwards.parts[0].weighted[k] == Approx(expected[k]));
        CHECK(ready.backwards.parts[0].weighted[k] == Approx(expected[k]));
    }
}

TEST_CASE("eq. 5.3: the norm is the length of the weighted features plus the squares of the signature", "[part_ring]") {
    core::ShapeDescriptor shape = support::arm_ring({{0, 3}, {1, 7}});
    shape.parts[0].features[static_cast<std::size_t>(Feature::Eccentricity)] = 0.4F;  // times 10: 3, 4 gives 5
    shape.parts[0].signature.fill(2.0F);                                              // twelve times 4
    const PartRing ring = core::matchable(shape, table_5_2()).forwards;
    CHECK(ring.parts[0].norm == Approx(5 + 48));
    CHECK(ring.parts[1].norm == Approx(7));
    CHECK(ring.terminal_norm[0] == Approx(53));
    CHECK(ring.norms == Approx(60));
}

TEST_CASE("eq. 5.2: node distance is the length of the feature difference plus the squared signature difference",
          "[part_ring]") {
    const RingPart a = with({1, 2, 0, 0, 0, 0, 0, 0, 5}, 1.0F), b = with({4, 2, 0, 4, 0, 0, 0, 0, 5}, 1.5F);
    CHECK(core::node_distance(a, b) == Approx(5 + 12 * 0.25));
    CHECK(core::node_distance(b, a) == core::node_distance(a, b));
    CHECK(core::node_distance(a, a) == 0.0F);
}

TEST_CASE("a wing spares the norms of its terminals, in steps of 2^-11", "[part_ring]") {
    const PartRing ring =
        core::matchable(support::arm_ring({{0, 3}, {1, 7}, {3, 11}}, {{1, 2, 50}, {2, 2, 50}}), table_5_2()).forwards;
    CHECK(ring.parts[0].spared == 3.0F);
    CHECK(ring.parts[3].spared == 18.0F);
    CHECK(ring.parts[4].spared == 14.0F);  // the last and the first terminal
    CHECK(ring.norms == 21.0F);
}

TEST_CASE("inter-distances by hand: on a cross of perimeter 40", "[part_ring]") {
    const core::ShapeDescriptor shape = support::arm_ring({{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {{1, 2, 1}});
    const PartRing ring = core::matchable(shape, table_5_2()).forwards;
    SECTION("neighbouring arms meet in a corner and stand at right angles") {
        const core::InterDistance& d = ring.between(0, 1);
        CHECK(d.d_e == 0.0F);
        CHECK(d.d_be == 0.0F);
        CHECK(d.d_a == Approx(0.1 * 90));
    }
    SECTION("opposite arms: 2 apart of 40, one arm's bending between them, turned by 180 degrees") {
        // Curvature at an inner corner is 1 / sqrt 32, at an outer one 1 / sqrt 20; two and two of four and eight.
        const double inner = 1 / std::sqrt(32.0), outer = 1 / std::sqrt(20.0);
        const core::InterDistance& d = ring.between(0, 2);
        CHECK(d.d_e == Approx(100.0 * 2 / 40));
        CHECK(d.d_be == Approx(100 * (2 * inner + 2 * outer) / (4 * inner + 8 * outer)));
        CHECK(d.d_a == Approx(0.1 * 180));
    }
    SECTION("the way back leads round the other side") {
        // From the end of the upper arm, sample 7, anti-clockwise to the start of the right arm, sample 1.
        const double inner = 1 / std::sqrt(32.0), outer = 1 / std::sqrt(20.0);
        const core::InterDistance& d = ring.between(1, 0);
        CHECK(d.d_e == Approx(100.0 * std::sqrt(8.0) / 40));
        CHECK(d.d_be == Approx(100 * (3 * inner + 4 * outer) / (4 * inner + 8 * outer)));
    }
    SECTION("a wing's direction is the mean of its samples") {
        // Upper and left arm: from sample 4 to 10, about the middle of (1, 1) and (-1, -1): the direction is (-1, 1).
        CHECK(ring.between(4, 0).d_a == Approx(0.1 * 135));
        CHECK(ring.between(4, 1).d_a == Approx(0.1 * 45));
    }
}

TEST_CASE("inter-distances do not depend on where the shape lies, how it is turned and how large it is",
          "[part_ring]") {
    const core::ShapeDescriptor shape = support::arm_ring({{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {{1, 2, 1}});
    const PartRing here = core::matchable(shape, table_5_2()).forwards;
    for (const core::Polygon& samples :
         {support::moved(shape.samples, {130, -70}), support::turned(support::moved(shape.samples, {9, 4}), 0.7),
          support::scaled(support::moved(shape.samples, {-3, 8}), 6)}) {
        core::ShapeDescriptor copy = shape;
        copy.samples = samples;
        const PartRing there = core::matchable(copy, table_5_2()).forwards;
        for (std::size_t i = 0; i < here.inter.size(); ++i) {
            CHECK(there.inter[i].d_e == Approx(here.inter[i].d_e).margin(1e-5));
            CHECK(there.inter[i].d_be == Approx(here.inter[i].d_be).margin(1e-5));
            CHECK(there.inter[i].d_a == Approx(here.inter[i].d_a).margin(1e-4));
        }
    }
}

TEST_CASE("the clockwise ring is what the mirror image reads anti-clockwise", "[part_ring]") {
    core::ShapeDescriptor shape = support::arm_ring({{0, 1}, {1, 2}, {2, 3}, {3, 4}}, {{1, 2, 5}});
    for (std::size_t k = 0; k < core::kSignatureSize; ++k) shape.parts[0].signature[k] = static_cast<float>(k);
    const MatchableShape ready = core::matchable(shape, table_5_2());
    const PartRing& back = ready.backwards;
    // Terminals count the other way round, a wing starts at what was its last.
    CHECK(back.parts[0].first == 3);
    CHECK(back.parts[3].first == 0);
    CHECK(back.parts[4].first == 1);
    CHECK(back.parts[4].count == 2);
    CHECK(back.terminal_norm[0] == 4.0F);
    CHECK(back.parts[0].signature.front() == 11.0F);
    CHECK(ready.forwards.parts[0].signature.front() == 0.0F);
    // Clockwise the right arm is followed by the lower one; between it and the left one lies the lower arm.
    CHECK(back.between(0, 3).d_e == 0.0F);
    CHECK(back.between(0, 2).d_e == Approx(5.0));
    CHECK(back.between(1, 0).d_e == 0.0F);
    CHECK(back.between(0, 1).d_a == ready.forwards.between(0, 1).d_a);
    // Stop points: terminals that are last in every wing, counted the other way round. The wing holds 1 and 2.
    CHECK(ready.forwards.stop_points == Ints{0, 1, 3});
    CHECK(back.stop_points == Ints{0, 1, 3});
    // Places on the outline run the other way: an arm from 1/4 to 2/4 (less a side) lies from 2/4 to 3/4.
    CHECK(back.parts[1].from == static_cast<core::OutlinePlace>(-ready.forwards.parts[1].to));
    CHECK(back.parts[1].to == static_cast<core::OutlinePlace>(-ready.forwards.parts[1].from));
}

TEST_CASE("an opened ring holds the parts that do not run over its cut, by where they end", "[part_ring]") {
    // Wings over {0, 1}, {1, 2} and {2, 0}: no stop point, so the cut is before terminal 0, which the last one runs
    // over.
    const PartRing ring =
        core::matchable(support::arm_ring({{0, 1}, {1, 2}, {2, 3}}, {{0, 2, 4}, {1, 2, 5}, {2, 2, 6}}), table_5_2())
            .forwards;
    REQUIRE(ring.opened.size() == 1);
    const auto& members = ring.opened[0].members;
    Ints parts, before;
    for (const auto& member : members) {
        parts.push_back(member.part);
        before.push_back(member.before);
    }
    CHECK(parts == Ints{0, 1, 3, 2, 4});
    // Terminal 1 and the wing over 0 and 1 end at 2: terminal 2 comes after three members, the wing over 1 and 2 after
    // terminal 0 alone.
    CHECK(before == Ints{0, 1, 0, 3, 1});
}

TEST_CASE("there is one opened ring a stop point, with steps between all parts that may follow one another",
          "[part_ring]") {
    std::mt19937 random(7);
    for (int round = 0; round < 40; ++round) {
        const core::ShapeDescriptor shape = support::random_descriptor(random, 2 + round % 6);
        const MatchableShape ready = core::matchable(shape);
        for (const PartRing* ring : {&ready.forwards, &ready.backwards}) {
            REQUIRE(ring->opened.size() == ring->stop_points.size());
            for (std::size_t k = 0; k < ring->opened.size(); ++k) {
                const core::OpenedRing& open = ring->opened[k];
                const auto position = [&](int part) {
                    const RingPart& p = ring->parts[static_cast<std::size_t>(part)];
                    return (p.first - ring->stop_points[k] + ring->terminal_count) % ring->terminal_count;
                };
                const auto end = [&](int part) {
                    return position(part) + ring->parts[static_cast<std::size_t>(part)].count;
                };
                std::set<int> held;
                std::set<std::pair<int, int>> expected, found;
                for (const auto& member : open.members) held.insert(member.part);
                for (int p = 0; p < static_cast<int>(ring->parts.size()); ++p) {
                    CHECK((held.count(p) == 1) == (end(p) <= ring->terminal_count));
                    for (int q = 0; q < static_cast<int>(ring->parts.size()); ++q) {
                        if (held.count(p) == 1 && held.count(q) == 1 && end(p) <= position(q)) expected.emplace(p, q);
                    }
                }
                for (std::size_t g = 0; g + 1 < open.steps_from.size(); ++g) {
                    for (int s = open.steps_from[g]; s < open.steps_from[g + 1]; ++s) {
                        const core::OpenedRing::Step& step = open.steps[static_cast<std::size_t>(s)];
                        const int member = open.steps_to[static_cast<std::size_t>(s)];
                        const int to = open.members[static_cast<std::size_t>(member)].part;
                        for (std::size_t lane = 0; lane < core::kWideLanes; ++lane) {
                            if (!std::isfinite(step.d_e[lane])) continue;
                            const int from = open.members[g * core::kWideLanes + lane].part;
                            found.emplace(from, to);
                            const core::InterDistance& d =
                                ring->between(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
                            CHECK(step.d_e[lane] == d.d_e);
                            CHECK(step.d_be[lane] == d.d_be);
                            CHECK(step.d_a[lane] == d.d_a);
                        }
                    }
                }
                CHECK(found == expected);
            }
        }
    }
}
