#include "core/rerank/query_rerank.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/parallel.hpp"
#include "core/rerank/set_rerank.hpp"

namespace core {

QueryReranker::QueryReranker(NeighbourGraph graph, int jobs) : graph_(std::move(graph)), own_(graph_.size()) {
    parallel_for(graph_.size(), jobs, [this](std::size_t item, int) {
        std::vector<float> start(graph_.size());
        for (const NeighbourGraph::Step& step : graph_.steps_of(item))
            start[static_cast<std::size_t>(step.to)] = step.share;
        own_[item] = 1.0F + chances_to_meet(std::move(start))[item];
    });
}

/// For every item the chance that a walk from it is, after equally many steps, where one is whose first step leads to
/// `start`: sum over t of S^t p_t with p_1 = start and p_{t+1} = p_t S, from the inside outwards.
std::vector<float> QueryReranker::chances_to_meet(std::vector<float> start) const {
    const std::size_t n = graph_.size();
    std::vector<std::vector<float>> places{std::move(start)};
    for (int t = 1; t < kWalkLength; ++t) {
        std::vector<float> next(n);
        for (std::size_t i = 0; i < n; ++i) {
            const float here = places.back()[i];
            if (here == 0.0F) continue;
            for (const NeighbourGraph::Step& step : graph_.steps_of(i)) {
                next[static_cast<std::size_t>(step.to)] += here * step.share;
            }
        }
        places.push_back(std::move(next));
    }
    std::vector<float> inner(n), chance(n);
    for (std::size_t t = places.size(); t-- > 0;) {
        for (std::size_t i = 0; i < n; ++i) inner[i] = places[t][i] + chance[i];
        for (std::size_t i = 0; i < n; ++i) {
            float sum = 0.0F;
            for (const NeighbourGraph::Step& step : graph_.steps_of(i)) {
                sum += step.share * inner[static_cast<std::size_t>(step.to)];
            }
            chance[i] = sum;
        }
    }
    return chance;
}

namespace {

/// The first step of the query's walk, as neighbour_graph gives it to an item: to its nearest, by likeness.
std::vector<float> first_step(const NeighbourGraph& graph, std::span<const float> distances,
                              const std::vector<std::int32_t>& nearest) {
    std::vector<float> start(graph.size());
    const std::size_t count = std::min(kNearestCount, nearest.size());
    float scale = 0.0F;
    for (std::size_t k = 0; k < count; ++k) {
        scale += distances[static_cast<std::size_t>(nearest[k])] / static_cast<float>(count);
    }
    scale = std::max(scale, 1e-12F);
    float sum = 0.0F;
    for (std::size_t k = 0; k < count; ++k) {
        const auto item = static_cast<std::size_t>(nearest[k]);
        const float d = distances[item];
        if (!std::isfinite(d)) continue;
        start[item] = likeness(d, scale, graph.scale[item], d <= graph.reach[item]);
        sum += start[item];
    }
    if (sum > 0.0F) {
        for (float& share : start) share /= sum;
    }
    return start;
}

}  // namespace

std::vector<std::int32_t> QueryReranker::order(std::span<const float> distances,
                                               const QueryRerankOptions& options) const {
    const auto distance_of = [&distances](std::int32_t item) {
        const float d = distances[static_cast<std::size_t>(item)];
        return std::isfinite(d) ? std::max(d, 0.0F) : std::numeric_limits<float>::max();
    };
    std::vector<std::int32_t> by_distance(graph_.size());
    std::iota(by_distance.begin(), by_distance.end(), 0);
    std::stable_sort(by_distance.begin(), by_distance.end(),
                     [&](std::int32_t a, std::int32_t b) { return distance_of(a) < distance_of(b); });
    std::vector<float> score = chances_to_meet(first_step(graph_, distances, by_distance));
    for (std::size_t i = 0; i < score.size(); ++i) score[i] /= std::sqrt(own_[i]);
    std::vector<std::int32_t> order = by_distance;
    const auto movable = order.begin() + (options.keep_first && !order.empty() ? 1 : 0);
    std::stable_sort(movable, order.end(), [&score](std::int32_t a, std::int32_t b) {
        return score[static_cast<std::size_t>(a)] > score[static_cast<std::size_t>(b)];
    });
    return order;
}

}  // namespace core
