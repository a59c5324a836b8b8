#include "core/match/decision_matrix.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "support/arm_ring.hpp"

using core::DecisionMatrix;
using core::PartRing;

namespace {

using Pairs = DecisionMatrix::Chain;

/// Per cent of the cross's bending along one arm: curvature at an inner corner is 1 / sqrt 32, at an outer one
/// 1 / sqrt 20; two and two of four and eight.
const double kOneArm = 100 * (2 / std::sqrt(32.0) + 2 / std::sqrt(20.0)) / (4 / std::sqrt(32.0) + 8 / std::sqrt(20.0));

constexpr float kNever = std::numeric_limits<float>::infinity();

/// Area with weight 1; inter-distances as in table 5.2.
PartRing ring_of(const core::ShapeDescriptor& shape) {
    core::ShapeParameters p;
    p.w_area = 1;
    p.w_d_e = 100;
    p.w_d_be = 1;
    p.w_d_a = 0.1;
    return core::matchable(shape, p).forwards;
}

struct Answer {
    double cost = 0.0;
    Pairs pairs;
};

/// Both rings cut at their first stop point, neither turned round.
Answer least(const PartRing& a, const PartRing& b) {
    DecisionMatrix matrix;
    matrix.set_rings(a, b);
    matrix.set_cut(a, b.opened[0], false);
    Answer answer;
    answer.cost = double{matrix.solve(a, a.opened[0], b.opened[0], kNever)} + a.norms + b.norms;
    matrix.trace(a, a.opened[0], b, b.opened[0], answer.pairs);
    return answer;
}

}  // namespace

TEST_CASE("option 1: terminal and terminal", "[decision_matrix]") {
    const Answer answer =
        least(ring_of(support::arm_ring({{0, 10}, {1, 20}})), ring_of(support::arm_ring({{0, 11}, {1, 22}})));
    CHECK(answer.cost == Approx(1 + 2));
    CHECK(answer.pairs == Pairs{{0, 0}, {1, 1}});
}

TEST_CASE("option 2: a terminal and a wing", "[decision_matrix]") {
    // The first two terminals of B together are what A has as one. They differ by 1; A's part ends a side before the
    // next one starts and points the other way, B's ends where the next one starts and points 135 degrees off.
    const Answer answer = least(ring_of(support::arm_ring({{0, 6000}, {2, 4000}})),
                                ring_of(support::arm_ring({{0, 700}, {1, 800}, {2, 4000}}, {{0, 2, 6001}})));
    CHECK(answer.pairs == Pairs{{0, 3}, {1, 2}});
    CHECK(answer.cost == Approx(1 + 5.0 * 5.0 + kOneArm * kOneArm + 4.5 * 4.5));
}

TEST_CASE("option 3: a wing and a terminal is option 2 with the shapes exchanged", "[decision_matrix]") {
    const PartRing whole = ring_of(support::arm_ring({{0, 30}})),
                   parted = ring_of(support::arm_ring({{0, 5}, {1, 6}}, {{0, 2, 31}}));
    const Answer there = least(whole, parted), back = least(parted, whole);
    CHECK(there.cost == Approx(1));
    CHECK(there.pairs == Pairs{{0, 2}});
    CHECK(back.cost == Approx(1));
    CHECK(back.pairs == Pairs{{2, 0}});
}

TEST_CASE("option 4: a wing and a wing, where their terminals do not answer to each other", "[decision_matrix]") {
    const Answer answer = least(ring_of(support::arm_ring({{0, 2}, {1, 9}}, {{0, 2, 40}})),
                                ring_of(support::arm_ring({{0, 9}, {1, 2}}, {{0, 2, 41}})));
    CHECK(answer.cost == Approx(1));  // 9 and 9 alone: 4
    CHECK(answer.pairs == Pairs{{2, 2}});
}

TEST_CASE("option 5: a terminal is left out at the cost of its norm", "[decision_matrix]") {
    SECTION("on one side") {
        const Answer answer =
            least(ring_of(support::arm_ring({{0, 10}})), ring_of(support::arm_ring({{0, 10}, {1, 3}})));
        CHECK(answer.cost == Approx(3));
        CHECK(answer.pairs == Pairs{{0, 0}});
    }
    SECTION("before and after the pair") {
        const Answer answer =
            least(ring_of(support::arm_ring({{1, 10}})), ring_of(support::arm_ring({{0, 3}, {1, 10}, {2, 4}})));
        CHECK(answer.cost == Approx(7));
        CHECK(answer.pairs == Pairs{{0, 1}});
    }
}

TEST_CASE("the order is kept: of two parts that changed places one is left out on both sides", "[decision_matrix]") {
    const Answer answer =
        least(ring_of(support::arm_ring({{0, 10}, {1, 50}})), ring_of(support::arm_ring({{0, 50}, {1, 10}})));
    CHECK(answer.cost == Approx(10 + 10));
    CHECK(answer.pairs == Pairs{{1, 0}});
    // Parts so heavy that they would pay for any difference in place.
    const Answer heavy = least(ring_of(support::arm_ring({{0, 50000}, {1, 40000}})),
                               ring_of(support::arm_ring({{0, 40000}, {1, 50000}})));
    CHECK(heavy.pairs.size() == 2);  // 10000 twice is less than 40000 twice
    const Answer apart =
        least(ring_of(support::arm_ring({{0, 50000}, {1, 9000}})), ring_of(support::arm_ring({{0, 9000}, {1, 50000}})));
    CHECK(apart.cost == Approx(9000 + 9000));
    CHECK(apart.pairs == Pairs{{0, 1}});
}

TEST_CASE("blocks do not interleave: of two wings over one terminal one is taken", "[decision_matrix]") {
    // Both wings of A fit the terminals of B without cost, but share A's second terminal.
    const PartRing a = ring_of(support::arm_ring({{0, 1}, {1, 1}, {2, 1}}, {{0, 2, 30}, {1, 2, 40}}));
    const PartRing b = ring_of(support::arm_ring({{0, 30}, {1, 40}}));
    const Answer answer = least(a, b);
    // The wing of 40 with its like, and 30 left out with A's first terminal or matched to it at 29.
    REQUIRE_FALSE(answer.pairs.empty());
    CHECK(answer.pairs.back() == std::pair{4, 1});
    CHECK(answer.cost >= 29);
    CHECK(answer.cost <= 31);
}

TEST_CASE("consecutive pairs cost the squares of how differently they lie, by hand", "[decision_matrix]") {
    // A: right and left; B: right and up. Between A's: 2 of 40 apart, the bending of one arm, 180 degrees; between B's:
    // nothing, nothing, 90 degrees.
    const double place = 5.0 * 5.0 + kOneArm * kOneArm + 9.0 * 9.0;
    const Answer answer =
        least(ring_of(support::arm_ring({{0, 2000}, {2, 1000}})), ring_of(support::arm_ring({{0, 2000}, {1, 1001}})));
    CHECK(answer.cost == Approx(1 + place));
    CHECK(answer.pairs == Pairs{{0, 0}, {1, 1}});
    // Where that is more than the norms, one of them is left out.
    const Answer small =
        least(ring_of(support::arm_ring({{0, 200}, {2, 100}})), ring_of(support::arm_ring({{0, 200}, {1, 100}})));
    CHECK(small.cost == Approx(100 + 100));
    CHECK(small.pairs == Pairs{{0, 0}});
}

TEST_CASE("the first and the last pair are not compared: the ring is open", "[decision_matrix]") {
    // Three pairs cost two steps. Moving the last arm changes the step to it and none from it to the first.
    const Answer same = least(ring_of(support::arm_ring({{0, 5000}, {1, 5000}, {2, 5000}})),
                              ring_of(support::arm_ring({{0, 5000}, {1, 5000}, {2, 5000}})));
    CHECK(same.cost == Approx(0).margin(1e-3));
    const Answer moved = least(ring_of(support::arm_ring({{0, 5000}, {1, 5000}, {2, 5000}})),
                               ring_of(support::arm_ring({{0, 5000}, {1, 5000}, {3, 5000}})));
    CHECK(moved.cost == Approx(25 + kOneArm * kOneArm + 81));
}

TEST_CASE("nothing matches where leaving everything out costs less", "[decision_matrix]") {
    core::ShapeDescriptor far = support::arm_ring({{0, 1}});
    far.parts[0].signature.fill(1.0F);
    core::ShapeDescriptor opposite = far;
    opposite.parts[0].signature.fill(-1.0F);  // at four times the squares of the norm
    const Answer answer = least(ring_of(far), ring_of(opposite));
    CHECK(answer.cost == Approx(2 * (1 + 12)));
    CHECK(answer.pairs.empty());
}

TEST_CASE("giving up answers nothing below the limit, and the least cost where that is below it", "[decision_matrix]") {
    const PartRing a = ring_of(support::arm_ring({{0, 10}, {1, 20}, {2, 5}})),
                   b = ring_of(support::arm_ring({{0, 12}, {1, 17}, {3, 5}}));
    DecisionMatrix matrix;
    matrix.set_rings(a, b);
    matrix.set_cut(a, b.opened[0], false);
    const float least_gain = matrix.solve(a, a.opened[0], b.opened[0], kNever);
    REQUIRE(least_gain < 0.0F);
    for (const float more : {0.5F, 3.0F, 20.0F}) {
        CHECK(matrix.solve(a, a.opened[0], b.opened[0], least_gain + more) == least_gain);
        CHECK(matrix.solve(a, a.opened[0], b.opened[0], least_gain - more) >= least_gain - more);
    }
}
