#include "core/rerank/neighbour_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

constexpr float kOneSided = 0.25F;
constexpr float kLeastScale = 1e-12F;  // equal shapes only: their distances are 0

bool nearer(const Neighbour& a, const Neighbour& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.item < b.item);
}

float finite_or_last(float distance) {
    return std::isfinite(distance) ? distance : std::numeric_limits<float>::max();
}

/// The entries that can be used, ascending.
std::vector<Neighbour> sound_list(const std::vector<Neighbour>& list, std::size_t own, std::size_t n) {
    std::vector<Neighbour> out;
    for (const Neighbour& entry : list) {
        const auto item = static_cast<std::size_t>(entry.item);
        if (entry.item < 0 || item >= n || item == own || !std::isfinite(entry.distance)) continue;
        out.push_back({entry.item, std::max(entry.distance, 0.0F)});
    }
    std::sort(out.begin(), out.end(), nearer);
    std::vector<Neighbour> once;
    for (const Neighbour& entry : out) {
        const auto same = [&entry](const Neighbour& other) { return other.item == entry.item; };
        if (std::none_of(once.begin(), once.end(), same)) once.push_back(entry);
    }
    return once;
}

bool contains(const std::vector<Neighbour>& list, std::size_t item) {
    return std::any_of(list.begin(), list.end(),
                       [item](const Neighbour& n) { return static_cast<std::size_t>(n.item) == item; });
}

/// Appends the steps of one item: the likeness to itself is 1.
void add_steps(const NearestLists& lists, std::size_t item, NeighbourGraph& graph) {
    std::vector<NeighbourGraph::Step> steps{{static_cast<std::int32_t>(item), 1.0F}};
    float sum = 1.0F;
    for (const Neighbour& n : lists[item]) {
        const auto other = static_cast<std::size_t>(n.item);
        const float like = likeness(n.distance, graph.scale[item], graph.scale[other], contains(lists[other], item));
        steps.push_back({n.item, like});
        sum += like;
    }
    std::sort(steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.to < b.to; });
    for (NeighbourGraph::Step& step : steps) step.share /= sum;
    graph.steps.insert(graph.steps.end(), steps.begin(), steps.end());
    graph.from.push_back(graph.steps.size());
}

}  // namespace

float likeness(float distance, float scale_a, float scale_b, bool mutual) {
    const float like = std::exp(-(distance / scale_a) * (distance / scale_b));
    return mutual ? like : kOneSided * like;
}

NearestLists nearest_lists(std::span<const float> distances, std::size_t n, std::size_t count) {
    NearestLists lists(n);
    std::vector<Neighbour> row;
    for (std::size_t i = 0; i < n; ++i) {
        row.clear();
        for (std::size_t j = 0; j < n; ++j) {
            if (j != i) row.push_back({static_cast<std::int32_t>(j), finite_or_last(distances[i * n + j])});
        }
        const auto kept = static_cast<std::ptrdiff_t>(std::min(count, row.size()));
        std::partial_sort(row.begin(), row.begin() + kept, row.end(), nearer);
        lists[i].assign(row.begin(), row.begin() + kept);
    }
    return lists;
}

NeighbourGraph neighbour_graph(const NearestLists& lists) {
    const std::size_t n = lists.size();
    NearestLists sound(n);
    NeighbourGraph graph;
    for (std::size_t i = 0; i < n; ++i) {
        sound[i] = sound_list(lists[i], i, n);
        float sum = 0.0F;
        for (const Neighbour& entry : sound[i]) sum += entry.distance / static_cast<float>(sound[i].size());
        graph.scale.push_back(std::max(sum, kLeastScale));
        graph.reach.push_back(sound[i].empty() ? 0.0F : sound[i].back().distance);
    }
    graph.from.push_back(0);
    for (std::size_t i = 0; i < n; ++i) add_steps(sound, i, graph);
    return graph;
}

}  // namespace core
