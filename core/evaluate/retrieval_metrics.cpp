#include "core/evaluate/retrieval_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace core {

namespace {

/// Precision at recall k / 20: linear between the recall levels of the relevant results, 1 / C, 2 / C …; constant
/// before the first.
void fill_precision(const std::vector<double>& precision_at_hit, std::array<double, kPrecisionRecallPoints>& out) {
    const double hits = static_cast<double>(precision_at_hit.size());
    for (std::size_t k = 0; k < out.size(); ++k) {
        const double wanted = static_cast<double>(k + 1) / static_cast<double>(out.size()) * hits;  // in hits
        const double low = std::floor(wanted);
        if (low < 1.0) {
            out[k] = precision_at_hit.front();
        } else if (low >= hits) {
            out[k] = precision_at_hit.back();
        } else {
            const auto i = static_cast<std::size_t>(low);
            out[k] = precision_at_hit[i - 1] + (precision_at_hit[i] - precision_at_hit[i - 1]) * (wanted - low);
        }
    }
}

}  // namespace

RetrievalMetrics metrics_of_ranking(const std::vector<char>& relevant, int class_size) {
    RetrievalMetrics m;
    if (class_size <= 0 || relevant.empty()) return m;
    const double c = class_size;
    double hits = 0.0, gain = 0.0, ideal = 0.0, precision_sum = 0.0, hits_c = 0.0, hits_2c = 0.0, hits_32 = 0.0;
    std::vector<double> precision_at_hit;
    for (std::size_t i = 0; i < relevant.size(); ++i) {
        const double rank = static_cast<double>(i) + 1.0;
        const double discount = rank < 2.0 ? 1.0 : std::log2(rank);
        if (rank <= c) ideal += 1.0 / discount;
        if (relevant[i] == 0) continue;
        hits += 1.0;
        gain += 1.0 / discount;
        precision_sum += hits / rank;
        precision_at_hit.push_back(hits / rank);
        if (rank <= c) hits_c += 1.0;
        if (rank <= 2.0 * c) hits_2c += 1.0;
        if (rank <= 32.0) hits_32 += 1.0;
        if (rank <= 5.0) m.first_5 = 1.0;
        if (rank <= 10.0) m.first_10 = 1.0;
    }
    m.nn = relevant[0] != 0 ? 1.0 : 0.0;
    m.ft = hits_c / c;
    m.st = hits_2c / c;
    const double p = hits_32 / 32.0, r = hits_32 / c;
    m.e = p + r > 0.0 ? 2.0 * p * r / (p + r) : 0.0;
    m.dcg = gain / ideal;
    m.ap = precision_sum / c;
    if (!precision_at_hit.empty()) fill_precision(precision_at_hit, m.precision);
    return m;
}

namespace {

/// Calls with each of the figures, those of both.
template <typename Call>
void for_each_figure(RetrievalMetrics& a, const RetrievalMetrics& b, const Call& call) {
    call(a.nn, b.nn);
    call(a.ft, b.ft);
    call(a.st, b.st);
    call(a.e, b.e);
    call(a.dcg, b.dcg);
    call(a.ap, b.ap);
    call(a.first_5, b.first_5);
    call(a.first_10, b.first_10);
    for (std::size_t k = 0; k < a.precision.size(); ++k) call(a.precision[k], b.precision[k]);
}

}  // namespace

RetrievalMetrics mean_metrics(const std::vector<RetrievalMetrics>& all) {
    RetrievalMetrics mean;
    if (all.empty()) return mean;
    for (const RetrievalMetrics& m : all) for_each_figure(mean, m, [](double& sum, double figure) { sum += figure; });
    const auto count = static_cast<double>(all.size());
    for_each_figure(mean, mean, [count](double& sum, double) { sum /= count; });
    return mean;
}

std::vector<int> ranking(const std::vector<float>& distances) {
    std::vector<int> order(distances.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return distances[static_cast<std::size_t>(a)] < distances[static_cast<std::size_t>(b)];
    });
    return order;
}

namespace {

int class_size_of(const std::vector<std::string>& classes, std::size_t query) {
    return static_cast<int>(std::count(classes.begin(), classes.end(), classes[query]));
}

/// Whether the nearest `ranks` others, and which they are, depend on the order of indices.
bool has_tie(const std::vector<float>& row, const std::vector<int>& order, std::size_t query, int ranks) {
    int rank = 0;
    float before = std::numeric_limits<float>::quiet_NaN();
    for (const int k : order) {
        const auto other = static_cast<std::size_t>(k);
        if (other == query) continue;
        if (row[other] == before) return true;
        before = row[other];
        if (++rank > ranks) return false;
    }
    return false;
}

}  // namespace

ShapeTest shape_test(const std::vector<float>& distances, const std::vector<std::string>& classes, int ranks) {
    const std::size_t n = classes.size();
    ShapeTest test;
    test.hits_by_rank.assign(static_cast<std::size_t>(ranks), 0);
    double possible = 0.0, found = 0.0;
    for (std::size_t q = 0; q < n; ++q) {
        const std::vector<float> row(distances.begin() + static_cast<std::ptrdiff_t>(q * n),
                                     distances.begin() + static_cast<std::ptrdiff_t>((q + 1) * n));
        const std::vector<int> order = ranking(row);
        const int c = class_size_of(classes, q);
        int rank = 0, bullseye_hits = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const auto other = static_cast<std::size_t>(order[k]);
            const bool same = classes[other] == classes[q];
            if (static_cast<int>(k) < 2 * c && same) ++bullseye_hits;
            if (other == q || rank >= ranks) continue;
            if (same) {
                ++test.hits_by_rank[static_cast<std::size_t>(rank)];
                found += 1.0;
            }
            ++rank;
        }
        possible += std::min(ranks, c - 1);
        test.bullseye += static_cast<double>(bullseye_hits) / c;
        test.ties += has_tie(row, order, q, ranks) ? 1 : 0;
    }
    if (n > 0) test.bullseye /= static_cast<double>(n);
    test.total = possible > 0.0 ? found / possible : 0.0;
    return test;
}

}  // namespace core
