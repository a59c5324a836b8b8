#include "core/evaluate/retrieval_metrics.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using core::metrics_of_ranking;
using core::RetrievalMetrics;

namespace {

/// Relevant at ranks 1, 3 and 6 of eight; C = 3.
const std::vector<char> kRanking{1, 0, 1, 0, 0, 1, 0, 0};

}  // namespace

TEST_CASE("the metrics of a small ranking, by hand", "[metrics]") {
    const RetrievalMetrics m = metrics_of_ranking(kRanking, 3);
    CHECK(m.nn == 1.0);
    CHECK(m.ft == Approx(2.0 / 3.0));
    CHECK(m.st == Approx(1.0));
    // P = 3/32, R = 1.
    CHECK(m.e == Approx(2.0 * 3 / 32 / (3.0 / 32 + 1)));
    CHECK(m.dcg == Approx((1 + 1 / std::log2(3.0) + 1 / std::log2(6.0)) / (1 + 1 + 1 / std::log2(3.0))));
    CHECK(m.ap == Approx((1.0 + 2.0 / 3 + 3.0 / 6) / 3));
}

TEST_CASE("precision is linear between the recall levels of the hits", "[metrics]") {
    const RetrievalMetrics m = metrics_of_ranking(kRanking, 3);
    // Precision 1 at recall 1/3, 2/3 at 2/3, 1/2 at 1; entry k is recall (k + 1) / 20.
    CHECK(m.precision[0] == Approx(1.0));
    CHECK(m.precision[5] == Approx(1.0));                                // 0.30, before the first level
    CHECK(m.precision[9] == Approx(1.0 + (2.0 / 3 - 1.0) * 0.5));        // 0.50, half way to the second
    CHECK(m.precision[14] == Approx(2.0 / 3 + (0.5 - 2.0 / 3) * 0.25));  // 0.75
    CHECK(m.precision[19] == Approx(0.5));
}

TEST_CASE("a perfect ranking has 1 everywhere but for E, a useless one nearly 0", "[metrics]") {
    const RetrievalMetrics best = metrics_of_ranking({1, 1, 0, 0, 0}, 2);
    for (const double v : {best.nn, best.ft, best.st, best.dcg, best.ap, best.precision[0], best.precision[19]}) {
        CHECK(v == Approx(1.0));
    }
    const RetrievalMetrics worst = metrics_of_ranking({0, 0, 0, 0, 0, 1}, 1);
    for (const double v : {worst.nn, worst.ft, worst.st}) CHECK(v == 0.0);
    CHECK(worst.ap == Approx(1.0 / 6));
    CHECK(worst.dcg == Approx(1.0 / std::log2(6.0)));
}

TEST_CASE("E looks at the nearest 32 only", "[metrics]") {
    std::vector<char> late(40, 0);
    late[31] = 1;
    CHECK(metrics_of_ranking(late, 1).e == Approx(2.0 / 32 / (1.0 / 32 + 1)));
    late[31] = 0;
    late[32] = 1;
    CHECK(metrics_of_ranking(late, 1).e == 0.0);
}

TEST_CASE("a class of none and an empty ranking give zeros", "[metrics]") {
    CHECK(metrics_of_ranking({0, 0}, 0).dcg == 0.0);
    CHECK(metrics_of_ranking({}, 0).nn == 0.0);
    CHECK(metrics_of_ranking({}, 3).ap == 0.0);
}

TEST_CASE("the mean of several queries", "[metrics]") {
    const RetrievalMetrics mean = core::mean_metrics({metrics_of_ranking({1, 0}, 1), metrics_of_ranking({0, 1}, 1)});
    CHECK(mean.nn == Approx(0.5));
    CHECK(mean.st == Approx(1.0));
    CHECK(mean.ap == Approx(0.75));
    CHECK(mean.precision[10] == Approx(0.75));
    CHECK(core::mean_metrics({}).ap == 0.0);
}

TEST_CASE("a ranking ascends, ties by index", "[metrics]") {
    CHECK(core::ranking({3, 1, 2, 1, 0}) == std::vector<int>{4, 1, 3, 2, 0});
    CHECK(core::ranking({7, 7, 7}) == std::vector<int>{0, 1, 2});
}

TEST_CASE("every shape queries the others: four shapes of two classes, by hand", "[metrics]") {
    const std::vector<std::string> classes{"a", "a", "b", "b"};
    const std::vector<float> distances{
        0, 1, 2, 3,  // 1 first: a hit, then two misses
        2, 0, 1, 3,  // 2 first: a miss; 0 is second
        1, 2, 0, 3,  // 3 comes last
        5, 5, 5, 0,  // ties: 0, 1, 2
    };
    const core::ShapeTest test = core::shape_test(distances, classes, 2);
    CHECK(test.hits_by_rank == std::vector<int>{1, 1});
    CHECK(core::shape_test(distances, classes, 3).hits_by_rank == std::vector<int>{1, 1, 2});
    // One other of each class: two of four found within two ranks.
    CHECK(test.total == Approx(0.5));
    // The query included, nearest 2C = 4 are all: 1. With C = 2 of four shapes nothing can be missed.
    CHECK(test.bullseye == Approx(1.0));
}

TEST_CASE("the bull's-eye counts the query and the nearest 2C", "[metrics]") {
    // Classes of one each but for a pair: the pair's 2C is 4, the others' 2.
    const std::vector<std::string> classes{"a", "b", "c", "d", "e", "a"};
    std::vector<float> distances(36, 1.0F);
    for (std::size_t i = 0; i < 6; ++i) distances[i * 6 + i] = 0.0F;
    // Query 0: ties by index put 5 at the sixth place, beyond four. Query 5: 5, 0, 1, 2 hold both.
    CHECK(core::shape_test(distances, classes, 1).bullseye == Approx((0.5 + 1 + 1 + 1 + 1 + 1.0) / 6));
}

TEST_CASE("more ranks than others of the class: the share is of those that there are", "[metrics]") {
    CHECK(core::shape_test({0, 1, 1, 0}, {"a", "a"}, 1).total == Approx(1.0));
    CHECK(core::shape_test({0, 1, 2, 1, 0, 2, 2, 1, 0}, {"a", "a", "b"}, 2).total == Approx(1.0));
    CHECK(core::shape_test({0}, {"a"}, 1).total == 0.0);
}

TEST_CASE("what is found everywhere is 1, to the last bit", "[metrics]") {
    constexpr std::size_t kShapes = 33, kClass = 11;
    std::vector<std::string> classes;
    std::vector<float> distances;
    for (std::size_t i = 0; i < kShapes; ++i) {
        classes.push_back(std::to_string(i / kClass));
        for (std::size_t j = 0; j < kShapes; ++j)
            distances.push_back(i == j ? 0.0F : static_cast<float>(j) + (i / kClass == j / kClass ? 1.0F : 100.0F));
    }
    const core::ShapeTest test = core::shape_test(distances, classes, 10);
    CHECK(test.total == 1.0);
    CHECK(test.bullseye == 1.0);
    const RetrievalMetrics one = metrics_of_ranking({1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0}, 10);
    const RetrievalMetrics mean = core::mean_metrics(std::vector<RetrievalMetrics>(49, one));
    CHECK(one.ft == 1.0);
    CHECK(mean.nn == 1.0);
    CHECK(mean.ft == 1.0);
    CHECK(mean.st == 1.0);
}

TEST_CASE("ties are told where they may decide what is among the nearest", "[metrics]") {
    const std::vector<std::string> classes{"a", "a", "b", "b"};
    const auto ties = [&](const std::vector<float>& first_row, int ranks) {
        std::vector<float> distances = first_row;
        for (const float d : {1, 0, 2, 3, 1, 2, 0, 3, 1, 2, 3, 0}) distances.push_back(d);
        return core::shape_test(distances, classes, ranks).ties;
    };
    CHECK(ties({0, 1, 2, 3}, 3) == 0);
    CHECK(ties({0, 1, 1, 3}, 1) == 1);  // either may be the first
    CHECK(ties({0, 1, 3, 3}, 1) == 0);  // the last two may change places, and the first stays
    CHECK(ties({0, 1, 3, 3}, 2) == 1);
    CHECK(ties({0, 0, 1, 2}, 2) == 0);  // at the query's own distance is no tie of two others
}
