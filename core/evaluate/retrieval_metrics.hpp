#pragma once
// Retrieval metrics with the definitions of the SHREC'13 sketch track and of the Kimia and MPEG-7 tests.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace core {

inline constexpr std::size_t kPrecisionRecallPoints = 20;

/// Averages over queries; all in [0, 1], higher is better.
struct RetrievalMetrics {
    double nn = 0.0;        ///< share of queries whose first result has their class
    double ft = 0.0;        ///< first tier: share of the class in the nearest C
    double st = 0.0;        ///< second tier: in the nearest 2C
    double e = 0.0;         ///< E-measure of the nearest 32
    double dcg = 0.0;       ///< discounted cumulated gain over the whole ranking, normalised
    double ap = 0.0;        ///< average precision
    double first_5 = 0.0;   ///< share of queries with a result of their class among the first five …
    double first_10 = 0.0;  ///< … or ten
    std::array<double, kPrecisionRecallPoints> precision{};  ///< at recall 1/20, 2/20 … 1, linearly interpolated
};

/// Metrics of one ranking. relevant[i] says whether rank i + 1 has the query's class; class_size is C, the relevant
/// ones in the collection, all of which must be in the ranking. C = 0 gives zeros.
[[nodiscard]] RetrievalMetrics metrics_of_ranking(const std::vector<char>& relevant, int class_size);

/// Mean of several, zeros for none. Summed first, so that the mean of equal shares is that share.
[[nodiscard]] RetrievalMetrics mean_metrics(const std::vector<RetrievalMetrics>& all);

/// Indices of `distances` ascending by distance, ties by index (which is the order of ids).
[[nodiscard]] std::vector<int> ranking(const std::vector<float>& distances);

/// A square test: every shape queries the others.
struct ShapeTest {
    std::vector<int> hits_by_rank;  ///< same-class results at rank 1, 2, …
    double total = 0.0;             ///< share of same-class results in the nearest `ranks`
    double bullseye = 0.0;  ///< query included: same-class results in the nearest 2C, over C, averaged over queries
    int ties = 0;           ///< queries with two others at the same distance, one of them among the nearest `ranks`
};

/// distances: n x n, row: query. Ties by index.
[[nodiscard]] ShapeTest shape_test(const std::vector<float>& distances, const std::vector<std::string>& classes,
                                   int ranks);

}  // namespace core
