#include "core/rerank/set_rerank.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/rerank/neighbour_graph.hpp"
#include "support/point_chains.hpp"

using support::chain_distances;

TEST_CASE("walks follow a chain far beyond its nearest before they cross to another", "[rerank]") {
    constexpr std::size_t kEach = 25;
    const std::vector<float> d = chain_distances(kEach, 9.2);
    const std::size_t n = 2 * kEach;
    REQUIRE(d[0 * n + kEach] < d[0 * n + 12]);  // across is nearer than half way along
    const std::vector<float> walked = core::reranked_distances(d, n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const bool same_chain = (i < kEach) == (j < kEach);
            const std::size_t across = (i + kEach) % n;
            const bool far = std::max(i, j) - std::min(i, j) > 17;  // the ends of the two chains are linked
            if (same_chain && !far) CHECK(walked[i * n + j] < walked[i * n + across]);
        }
    }
}

TEST_CASE("re-ranked distances are symmetric, 0 to oneself, finite, and the same on any number of threads",
          "[rerank]") {
    const std::vector<float> d = chain_distances(31, 3.0);
    const std::size_t n = 62;
    const std::vector<float> walked = core::reranked_distances(d, n, 1);
    for (std::size_t i = 0; i < n; ++i) {
        CHECK(walked[i * n + i] == 0.0F);
        for (std::size_t j = 0; j < n; ++j) {
            CHECK(walked[i * n + j] == walked[j * n + i]);
            CHECK(std::isfinite(walked[i * n + j]));
            CHECK(walked[i * n + j] >= 0.0F);
        }
    }
    CHECK(core::reranked_distances(d, n, 3) == walked);
}

TEST_CASE("the sum over walks is the one of its definition", "[rerank]") {
    const std::vector<float> d = chain_distances(9, 2.5);
    const std::size_t n = 18;
    const core::NeighbourGraph graph = core::neighbour_graph(core::nearest_lists(d, n));
    std::vector<double> s(n * n, 0.0), power(n * n, 0.0), sum(n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        power[i * n + i] = 1.0;
        for (const auto& step : graph.steps_of(i)) s[i * n + static_cast<std::size_t>(step.to)] = step.share;
    }
    for (int t = 0; t <= core::kWalkLength; ++t) {
        std::vector<double> next(n * n, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t k = 0; k < n; ++k) {
                    sum[i * n + j] += power[i * n + k] * power[j * n + k];
                    next[i * n + j] += power[i * n + k] * s[k * n + j];
                }
            }
        }
        power = next;
    }
    const std::vector<float> walked = core::reranked_distances(d, n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const double share = sum[i * n + j] / std::sqrt(sum[i * n + i] * sum[j * n + j]);
            CHECK(std::exp(-walked[i * n + j]) == Approx(share).epsilon(1e-4));
        }
    }
}

TEST_CASE("what no walk leads to comes last, in its old order", "[rerank]") {
    constexpr std::size_t kEach = 20;
    const std::vector<float> d = chain_distances(kEach, 1e6);  // nobody lists anybody of the other chain
    const std::size_t n = 2 * kEach;
    const std::vector<float> walked = core::reranked_distances(d, n);
    for (std::size_t j = 1; j < kEach; ++j) {
        CHECK(walked[j] < walked[kEach]);
        CHECK(walked[kEach + j] >= walked[kEach + j - 1]);
    }
}

TEST_CASE("small sets and equal shapes are no special case", "[rerank]") {
    CHECK(core::reranked_distances({}, 0).empty());
    CHECK(core::reranked_distances(std::vector<float>{0.0F}, 1) == std::vector<float>{0.0F});
    const std::vector<float> same = core::reranked_distances(std::vector<float>(9, 0.0F), 3);
    for (const std::size_t k : {2, 3, 5, 6, 7}) CHECK(same[k] == same[1]);
    CHECK(same[1] < 0.5F);
    const float inf = std::numeric_limits<float>::infinity();
    for (const float x : core::reranked_distances(std::vector<float>{0, inf, inf, 0}, 2)) CHECK(std::isfinite(x));
}
