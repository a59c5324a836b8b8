#pragma once
// Who is near whom in a collection: what re-ranking walks along. Small enough to be stored with an index.
//
//     NearestLists lists = nearest_lists(distances, n);               // n x n
//     NeighbourGraph graph = neighbour_graph(lists);                  // or from lists that were stored

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

struct Neighbour {
    std::int32_t item = 0;
    float distance = 0.0F;

    friend bool operator==(const Neighbour&, const Neighbour&) = default;
};

/// For each item its nearest others, ascending by distance, ties by item. Items are numbers from 0.
using NearestLists = std::vector<std::vector<Neighbour>>;

/// How many neighbours a list holds: about as many as like shapes can be hoped for. On the Kimia sets 8 and 10 do
/// equally well, 5 and 13 less so.
inline constexpr std::size_t kNearestCount = 10;

/// The lists of all items of a square of distances (row: from), itself left out; shorter where there are not so many
/// others. A distance that is not finite comes after all that are. n * n, plus sorting the few that are kept.
[[nodiscard]] NearestLists nearest_lists(std::span<const float> distances, std::size_t n,
                                         std::size_t count = kNearestCount);

/// Steps of a random walk: from each item to itself and its neighbours, by likeness.
struct NeighbourGraph {
    struct Step {
        std::int32_t to = 0;
        float share = 0.0F;
    };
    std::vector<std::size_t> from;  ///< steps of item i are steps[from[i]] … steps[from[i + 1] - 1], by `to`
    std::vector<Step> steps;        ///< the shares of an item sum to 1
    std::vector<float> scale;       ///< mean distance to the neighbours in its list; > 0
    std::vector<float> reach;       ///< distance to the last of them

    [[nodiscard]] std::size_t size() const { return scale.size(); }
    [[nodiscard]] std::span<const Step> steps_of(std::size_t item) const {
        return std::span(steps).subspan(from[item], from[item + 1] - from[item]);
    }
};

/// Likeness is exp(-d^2 / (scale of one * scale of the other)), so that dense and thin places of the collection count
/// alike (Zelnik-Manor and Perona, "Self-tuning spectral clustering", 2004), and a quarter of it where one counts the
/// other among its nearest but not the other way round: such links are what leads from one class into the next.
/// Lists may be stored ones: entries that name no item, itself or twice the same, or whose distance is not finite, are
/// passed over. Linear in entries, but for their sorting.
[[nodiscard]] NeighbourGraph neighbour_graph(const NearestLists& lists);

/// The likeness above, for items at distance d; mutual: each is among the other's nearest.
[[nodiscard]] float likeness(float distance, float scale_a, float scale_b, bool mutual);

}  // namespace core
