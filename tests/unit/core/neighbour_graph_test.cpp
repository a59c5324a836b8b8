#include "core/rerank/neighbour_graph.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using core::NearestLists;
using core::Neighbour;
using core::NeighbourGraph;

TEST_CASE("nearest lists ascend, ties go by item, and nobody lists itself", "[rerank]") {
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<float> d{0, 2, 1, 2, /**/ 2, 0, inf, 3, /**/ 1, inf, 0, 1, /**/ 2, 3, 1, 0};
    const NearestLists lists = core::nearest_lists(d, 4, 2);
    CHECK(lists[0] == std::vector<Neighbour>{{2, 1}, {1, 2}});
    CHECK(lists[1] == std::vector<Neighbour>{{0, 2}, {3, 3}});
    CHECK(lists[2] == std::vector<Neighbour>{{0, 1}, {3, 1}});
    CHECK(core::nearest_lists(d, 4, 9)[1].size() == 3);
    CHECK(core::nearest_lists(d, 4, 9)[1].back().item == 2);
    CHECK(core::nearest_lists({}, 0).empty());
}

TEST_CASE("the steps of every item sum to 1 and lead to itself and its list", "[rerank]") {
    const NeighbourGraph graph = core::neighbour_graph({{{1, 1.0F}, {2, 3.0F}}, {{0, 1.0F}}, {{1, 2.0F}}});
    REQUIRE(graph.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        float sum = 0.0F;
        for (const NeighbourGraph::Step& step : graph.steps_of(i)) sum += step.share;
        CHECK(sum == Approx(1.0F));
    }
    CHECK(graph.scale[0] == Approx(2.0F));
    CHECK(graph.reach[0] == 3.0F);
    const auto steps = graph.steps_of(0);
    REQUIRE(steps.size() == 3);
    const float mutual = std::exp(-1.0F / (2.0F * 1.0F)), one_sided = 0.25F * std::exp(-9.0F / (2.0F * 2.0F));
    CHECK(steps[1].share / steps[0].share == Approx(mutual));
    CHECK(steps[2].share / steps[0].share == Approx(one_sided));
}

TEST_CASE("what a damaged list may hold is passed over", "[rerank]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const NeighbourGraph graph =
        core::neighbour_graph({{{7, 1.0F}, {-1, 1.0F}, {0, 0.0F}, {1, 2.0F}, {1, 5.0F}, {2, nan}}, {{0, 2.0F}}, {}});
    CHECK(graph.steps_of(0).size() == 2);
    CHECK(graph.steps_of(2).size() == 1);
    CHECK(graph.steps_of(2)[0].share == 1.0F);
    CHECK(graph.scale[2] > 0.0F);
}

TEST_CASE("equal shapes, at distance 0, are as like as can be", "[rerank]") {
    const NeighbourGraph graph = core::neighbour_graph({{{1, 0.0F}}, {{0, 0.0F}}});
    CHECK(graph.steps_of(0)[1].share == Approx(0.5F));
}
