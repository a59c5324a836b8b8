#include "core/rerank/query_rerank.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/rerank/set_rerank.hpp"
#include "support/point_chains.hpp"

using core::QueryReranker;
using support::chain_distances;

namespace {

constexpr std::size_t kEach = 25;

/// Two rows with room between; the query lies beyond the start of the first row, nearer to the second's start than to
/// the first's middle.
struct TwoRows {
    std::vector<float> between = chain_distances(kEach, 9.2);
    std::vector<float> query = std::vector<float>(between.begin(), between.begin() + 2 * kEach);
    TwoRows() {
        for (float& d : query) d += 0.3F;
    }
    [[nodiscard]] QueryReranker reranker(int jobs = 1) const {
        return QueryReranker(core::neighbour_graph(core::nearest_lists(between, 2 * kEach)), jobs);
    }
};

}  // namespace

TEST_CASE("a query finds the row that it begins before the other one, which is nearer", "[rerank]") {
    const TwoRows rows;
    const std::vector<std::int32_t> order = rows.reranker().order(rows.query);
    REQUIRE(order.size() == 2 * kEach);
    constexpr std::size_t kFirst = 19;
    REQUIRE(rows.query[kEach] < rows.query[kFirst / 2 + 1]);
    for (std::size_t k = 0; k < kFirst; ++k) CHECK(order[k] < static_cast<std::int32_t>(kEach));
    std::vector<std::int32_t> all = order;
    std::sort(all.begin(), all.end());
    for (std::size_t k = 0; k < all.size(); ++k) CHECK(all[k] == static_cast<std::int32_t>(k));
}

TEST_CASE("an item that asks is answered in the order of the set", "[rerank]") {
    const TwoRows rows;
    const std::size_t n = 2 * kEach;
    const std::vector<float> walked = core::reranked_distances(rows.between, n);
    const QueryReranker reranker = rows.reranker();
    for (const std::size_t item : {0U, 12U, 30U}) {
        const std::vector<float> query(rows.between.begin() + static_cast<std::ptrdiff_t>(item * n),
                                       rows.between.begin() + static_cast<std::ptrdiff_t>((item + 1) * n));
        const std::vector<std::int32_t> order = reranker.order(query);
        CHECK(order.front() == static_cast<std::int32_t>(item));
        std::vector<std::int32_t> nearest(n);
        for (std::size_t k = 0; k < n; ++k) nearest[k] = static_cast<std::int32_t>(k);
        std::stable_sort(nearest.begin(), nearest.end(), [&](std::int32_t a, std::int32_t b) {
            return walked[item * n + static_cast<std::size_t>(a)] < walked[item * n + static_cast<std::size_t>(b)];
        });
        std::vector<std::int32_t> ten(order.begin(), order.begin() + 10),
            expected(nearest.begin(), nearest.begin() + 10);
        std::sort(ten.begin(), ten.end());
        std::sort(expected.begin(), expected.end());
        std::vector<std::int32_t> common;
        std::set_intersection(ten.begin(), ten.end(), expected.begin(), expected.end(), std::back_inserter(common));
        CHECK(common.size() >= 9);
    }
}

TEST_CASE("the first place is kept unless it is not to be", "[rerank]") {
    TwoRows rows;
    rows.query[kEach + 3] = 0.01F;  // one of the other row, alone
    const QueryReranker reranker = rows.reranker();
    CHECK(reranker.order(rows.query).front() == static_cast<std::int32_t>(kEach + 3));
    CHECK(reranker.order(rows.query, {.keep_first = false}).front() < static_cast<std::int32_t>(kEach));
}

TEST_CASE("threads change nothing, and equal scores go by distance, then item", "[rerank]") {
    const TwoRows rows;
    CHECK(rows.reranker(1).order(rows.query) == rows.reranker(3).order(rows.query));
    const QueryReranker alone(core::neighbour_graph(core::NearestLists(14)));
    std::vector<float> distances(14, 5.0F);
    distances[13] = 1.0F;
    const std::vector<std::int32_t> order = alone.order(distances);
    CHECK(order.front() == 13);
    CHECK(std::is_sorted(order.begin() + 1, order.end()));
}

TEST_CASE("distances that are not finite come last, and no item is lost", "[rerank]") {
    TwoRows rows;
    rows.query.assign(2 * kEach, std::numeric_limits<float>::infinity());
    rows.query[7] = 1.0F;
    rows.query[9] = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::int32_t> order = rows.reranker().order(rows.query);
    CHECK(order.front() == 7);
    CHECK(order.size() == 2 * kEach);
    CHECK(QueryReranker(core::NeighbourGraph{{0}, {}, {}, {}}).order({}).empty());
}
