#include "core/rerank/set_rerank.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"
#include "core/match/lanes.hpp"
#include "core/rerank/neighbour_graph.hpp"

namespace core {

namespace {

constexpr float kFarthestMet = 80.0F;  // above -log of every float > 0 that a walk gives

/// A square of floats, rows filled up to whole lanes.
struct Square {
    explicit Square(std::size_t n) : row(lane_groups(n)), lanes(n * row) {}
    [[nodiscard]] LaneGroup* at(std::size_t i) { return &lanes[i * row]; }
    [[nodiscard]] const LaneGroup* at(std::size_t i) const { return &lanes[i * row]; }
    [[nodiscard]] float* floats(std::size_t i) { return reinterpret_cast<float*>(at(i)); }
    [[nodiscard]] const float* floats(std::size_t i) const { return reinterpret_cast<const float*>(at(i)); }
    std::size_t row;
    std::vector<LaneGroup> lanes;
};

/// One row of S * from.
CROQUIS_LANES_CLONES void step_row(std::span<const NeighbourGraph::Step> steps, const Square& from, LaneGroup* to) {
    for (std::size_t g = 0; g < from.row; ++g) to[g].v = Lanes{};
    for (const NeighbourGraph::Step& step : steps) {
        const LaneGroup* row = from.at(static_cast<std::size_t>(step.to));
        const Lanes share = all_lanes(step.share);
        for (std::size_t g = 0; g < from.row; ++g) to[g].v += share * row[g].v;
    }
}

/// The transpose of S * from.
void step_and_turn(const NeighbourGraph& graph, const Square& from, Square& to, int jobs) {
    constexpr std::size_t kBlock = 16;  // rows at a time, so that the turned ones are written in runs
    const std::size_t n = graph.size(), blocks = (n + kBlock - 1) / kBlock;
    std::vector<std::vector<LaneGroup>> rows(static_cast<std::size_t>(jobs), std::vector<LaneGroup>(kBlock * from.row));
    parallel_for(blocks, jobs, [&](std::size_t block, int worker) {
        LaneGroup* own = rows[static_cast<std::size_t>(worker)].data();
        const std::size_t first = block * kBlock, count = std::min(kBlock, n - first);
        for (std::size_t i = 0; i < count; ++i) step_row(graph.steps_of(first + i), from, own + i * from.row);
        const auto* values = reinterpret_cast<const float*>(own);
        for (std::size_t j = 0; j < n; ++j) {
            float* turned = to.floats(j) + first;
            for (std::size_t i = 0; i < count; ++i) turned[i] = values[i * from.row * kLanes + j];
        }
    });
}

}  // namespace

std::vector<float> reranked_distances(std::span<const float> distances, std::size_t n, int jobs) {
    const NeighbourGraph graph = neighbour_graph(nearest_lists(distances, n));
    Square meeting(n), turned(n);
    for (std::size_t i = 0; i < n; ++i) meeting.floats(i)[i] = 1.0F;
    for (int t = 0; t < kWalkLength; ++t) {
        step_and_turn(graph, meeting, turned, jobs);  // (S A)'
        step_and_turn(graph, turned, meeting, jobs);  // (S (S A)')' = S A S', A being symmetric
        for (std::size_t i = 0; i < n; ++i) meeting.floats(i)[i] += 1.0F;
    }
    std::vector<float> out(n * n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            const float both = 0.5F * (meeting.floats(i)[j] + meeting.floats(j)[i]);
            const float share = both / std::sqrt(meeting.floats(i)[i] * meeting.floats(j)[j]);
            const float d = std::max(distances[i * n + j], 0.0F);
            const bool met = share > std::numeric_limits<float>::min();
            const float beyond = std::isfinite(d) ? d / (1.0F + d) : 1.0F;
            out[i * n + j] = out[j * n + i] = met ? std::max(0.0F, -std::log(share)) : kFarthestMet + 10.0F + beyond;
        }
    }
    return out;
}

}  // namespace core
