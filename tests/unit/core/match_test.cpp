#include "core/match/match.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "core/parts/describe.hpp"
#include "support/exhaustive_match.hpp"
#include "support/random_descriptor.hpp"
#include "support/shapes.hpp"

using core::Match;
using core::MatchableShape;
using core::MatchedPair;
using core::PartRing;
using support::ExhaustiveMatch;

namespace {

constexpr double kRounding = 1e-3;

MatchableShape shape_of(const core::Polygon& contour) {
    const auto descriptor = core::describe(contour);
    REQUIRE(descriptor);
    return core::matchable(*descriptor);
}

struct Named {
    const char* name;
    core::Polygon contour;
};

std::vector<Named> shapes() {
    return {{"horse", support::horse()},   {"hand", support::hand()},        {"cross", support::cross(8, 3)},
            {"comb", support::comb(4, 5)}, {"star", support::star(5, 9, 4)}, {"L", support::l_shape(9, 3)}};
}

/// Cost of the match as its pairs and left-outs say, from the rings alone; also that it is a match.
double cost_of(const Match& match, const MatchableShape& shape_a, const MatchableShape& shape_b) {
    const PartRing& a = shape_a.forwards;
    const PartRing& b = match.reversed ? shape_b.backwards : shape_b.forwards;
    double cost = 0.0;
    std::multiset<int> covered_a(match.left_out_a.begin(), match.left_out_a.end());
    std::multiset<int> covered_b;  // in the ring's direction
    for (const int t : match.left_out_b) covered_b.insert(match.reversed ? b.terminal_count - 1 - t : t);
    for (const int t : covered_a) cost += a.terminal_norm[static_cast<std::size_t>(t)];
    for (const int t : covered_b) cost += b.terminal_norm[static_cast<std::size_t>(t)];
    for (std::size_t k = 0; k < match.pairs.size(); ++k) {
        const auto x = static_cast<std::size_t>(match.pairs[k].part_a),
                   y = static_cast<std::size_t>(match.pairs[k].part_b);
        for (int t = 0; t < a.parts[x].count; ++t) covered_a.insert((a.parts[x].first + t) % a.terminal_count);
        for (int t = 0; t < b.parts[y].count; ++t) covered_b.insert((b.parts[y].first + t) % b.terminal_count);
        cost += ExhaustiveMatch::node_cost(a.parts[x], b.parts[y]);
        if (k == 0) continue;
        const auto px = static_cast<std::size_t>(match.pairs[k - 1].part_a);
        const auto py = static_cast<std::size_t>(match.pairs[k - 1].part_b);
        cost += ExhaustiveMatch::step_cost(a.between(px, x), b.between(py, y));
    }
    // Every terminal is in one pair or left out, and none twice.
    for (int t = 0; t < a.terminal_count; ++t) CHECK(covered_a.count(t) == 1);
    for (int t = 0; t < b.terminal_count; ++t) CHECK(covered_b.count(t) == 1);
    return cost;
}

/// Whether the parts follow each other once round the ring, from a stop point.
bool in_order(const PartRing& ring, const std::vector<int>& parts) {
    for (const int start : ring.stop_points) {
        int from = 0;
        bool fits = true;
        for (const int p : parts) {
            const core::RingPart& part = ring.parts[static_cast<std::size_t>(p)];
            const int at = (part.first - start + ring.terminal_count) % ring.terminal_count;
            fits = fits && at >= from && at + part.count <= ring.terminal_count;
            from = at + part.count;
        }
        if (fits) return true;
    }
    return false;
}

void check_match(const MatchableShape& a, const MatchableShape& b) {
    core::Matcher matcher;
    const ExhaustiveMatch::Least expected = ExhaustiveMatch::least(a, b);
    const double tolerance = kRounding + 1e-5 * expected.part_cost;
    CHECK(matcher.part_cost(a, b) == Approx(expected.part_cost).margin(tolerance));
    CHECK(matcher.distance(a, b) > expected.distance - kRounding);
    CHECK(matcher.distance(a, b) < expected.at_most + kRounding);
    const Match match = matcher.match(a, b);
    CHECK(match.distance == matcher.distance(a, b));
    CHECK(match.part_cost > expected.part_cost - tolerance);
    CHECK(cost_of(match, a, b) == Approx(match.part_cost).margin(tolerance));
    const double norms = double{a.forwards.norms} + double{b.forwards.norms};
    const auto parts = static_cast<float>(match.part_cost / std::sqrt(norms));
    CHECK(core::configuration_distance(parts, static_cast<float>(match.outline)) ==
          Approx(match.distance).margin(kRounding));
    double explained = match.left_out_cost;
    std::vector<int> of_a, of_b;
    for (const MatchedPair& pair : match.pairs) {
        explained += pair.cost();
        of_a.push_back(pair.part_a);
        of_b.push_back(pair.part_b);
    }
    CHECK(explained == Approx(match.part_cost).margin(tolerance));
    CHECK(in_order(a.forwards, of_a));
    CHECK(in_order(match.reversed ? b.backwards : b.forwards, of_b));
}

}  // namespace

TEST_CASE("the distance is the least over all matches: random rings against exhaustive search", "[match]") {
    std::mt19937 random(42);
    for (int round = 0; round < 300; ++round) {
        const int n = 2 + static_cast<int>(random() % 4), m = 2 + static_cast<int>(random() % 4);
        const MatchableShape a = core::matchable(support::random_descriptor(random, n));
        const MatchableShape b = core::matchable(support::random_descriptor(random, m));
        INFO("round " << round << ": " << n << " terminals against " << m);
        check_match(a, b);
    }
}

TEST_CASE("small differences, where many matches are close, are told apart as well", "[match]") {
    std::mt19937 random(43);
    for (int round = 0; round < 150; ++round) {
        const core::ShapeDescriptor first = support::random_descriptor(random, 2 + static_cast<int>(random() % 4));
        core::ShapeDescriptor second = first;
        for (core::Part& part : second.parts) {
            for (float& f : part.features) f *= 1.0F + static_cast<float>(random() % 100) / 500.0F;
            for (float& r : part.signature) r += static_cast<float>(random() % 100) / 200.0F;
        }
        const MatchableShape a = core::matchable(first), b = core::matchable(second);
        INFO("round " << round);
        check_match(a, b);
    }
}

TEST_CASE("real outlines match as exhaustive search says", "[match]") {
    const auto all = shapes();
    for (const Named& first : all) {
        for (const Named& second : all) {
            const MatchableShape a = shape_of(first.contour), b = shape_of(second.contour);
            if (a.forwards.terminal_count > 5 || b.forwards.terminal_count > 5) continue;
            INFO(first.name << " against " << second.name);
            check_match(a, b);
        }
    }
}

TEST_CASE("a shape has no distance to itself, and each part answers to itself", "[match]") {
    core::Matcher matcher;
    for (const Named& shape : shapes()) {
        DYNAMIC_SECTION(shape.name) {
            const MatchableShape a = shape_of(shape.contour);
            CHECK(matcher.distance(a, a) == Approx(0.0).margin(kRounding));
            const Match match = matcher.match(a, a);
            CHECK(match.left_out_a.empty());
            CHECK(match.left_out_b.empty());
        }
    }
}

TEST_CASE("the distance is symmetric", "[match]") {
    core::Matcher matcher;
    std::mt19937 random(44);
    for (int round = 0; round < 200; ++round) {
        const MatchableShape a =
            core::matchable(support::random_descriptor(random, 1 + static_cast<int>(random() % 8)));
        const MatchableShape b =
            core::matchable(support::random_descriptor(random, 1 + static_cast<int>(random() % 8)));
        const double there = matcher.distance(a, b);
        INFO("round " << round);
        CHECK(matcher.distance(b, a) == there);
        CHECK(matcher.part_cost(b, a) == matcher.part_cost(a, b));
    }
}

TEST_CASE("giving up returns the limit, and only where the distance is not below it", "[match]") {
    core::Matcher matcher;
    const MatchableShape horse = shape_of(support::horse()), hand = shape_of(support::hand());
    const double distance = matcher.distance(horse, hand);
    for (const double share : {0.0, 0.3, 0.9, 1.0}) {
        CHECK(matcher.distance(horse, hand, share * distance) == Approx(share * distance));
    }
    for (const double share : {1.001, 1.5, 10.0}) CHECK(matcher.distance(horse, hand, share * distance) == distance);
}

TEST_CASE("an exactly mirrored outline is at hardly any distance, where other shapes are at 50 and more", "[match]") {
    core::Matcher matcher;
    for (const Named& shape : shapes()) {
        DYNAMIC_SECTION(shape.name) {
            const MatchableShape a = shape_of(shape.contour), b = shape_of(support::mirrored(shape.contour));
            CHECK(matcher.distance(a, b) < 2.0);
        }
    }
}

TEST_CASE("a descriptor read clockwise is at no distance to itself read anti-clockwise", "[match]") {
    core::Matcher matcher;
    const MatchableShape a = shape_of(support::horse());
    const MatchableShape mirror{a.backwards, a.forwards};
    CHECK(matcher.distance(a, mirror) == Approx(0.0).margin(kRounding));
    CHECK(matcher.match(a, mirror).reversed);
}

TEST_CASE("asymmetry is the distance to the clockwise reading", "[match]") {
    core::Matcher matcher;
    CHECK(matcher.asymmetry(shape_of(support::cross(8, 3))) < 6.0);
    const MatchableShape horse = shape_of(support::horse());
    CHECK(matcher.asymmetry(horse) > 1.0);
    std::mt19937 random(45);
    for (int round = 0; round < 50; ++round) {
        const MatchableShape shape =
            core::matchable(support::random_descriptor(random, 2 + static_cast<int>(random() % 3)));
        const ExhaustiveMatch::Least expected = ExhaustiveMatch::least(shape.forwards, shape.backwards);
        CHECK(matcher.asymmetry(shape) > expected.distance - kRounding);
        CHECK(matcher.asymmetry(shape) < expected.at_most + kRounding);
    }
}

TEST_CASE("shapes with hardly a part have finite distances to everything", "[match]") {
    core::Matcher matcher;
    const std::vector<core::Polygon> plain{
        support::disc(60, 10), support::rectangle(200, 0.5), {{0, 0}, {9, 0}, {3, 6}}, support::rectangle(5, 5)};
    for (const core::Polygon& one : plain) {
        for (const Named& other : shapes()) {
            const double d = matcher.distance(shape_of(one), shape_of(other.contour));
            CHECK(std::isfinite(d));
            CHECK(d > 0.0);
        }
        for (const core::Polygon& other : plain) CHECK(std::isfinite(matcher.distance(shape_of(one), shape_of(other))));
        CHECK(matcher.distance(shape_of(one), shape_of(one)) == Approx(0.0).margin(kRounding));
    }
}

TEST_CASE("a matcher keeps nothing of one pair that shows in the next", "[match]") {
    core::Matcher used, fresh;
    const MatchableShape horse = shape_of(support::horse()), star = shape_of(support::star(5, 9, 4));
    (void)used.match(horse, horse);
    (void)used.distance(horse, star);
    CHECK(used.distance(star, horse) == fresh.distance(star, horse));
}
