#pragma once
// The decision matrix of thesis 6.2 made exact: the least-cost match of two rings of parts that are cut open.
//
// A *match* is a sequence of pairs (x_1, y_1) ... (x_k, y_k), k >= 0, of parts (terminals or wings) such that in both
// opened rings x_i ends before x_{i+1} starts and y_i before y_{i+1}: no two share a terminal, no block interleaves,
// the order is kept, and none runs over a cut. Its cost is
//
//     sum_i node_distance(x_i, y_i)                                        (eq. 5.2)
//   + sum_i |w (d(x_i, x_{i+1}) - d(y_i, y_{i+1}))|²                       (weighted inter-distances, consecutive
//   pairs, not cyclic)
//   + sum of the norms of all terminals of A and of B in no x_i and no y_i (eq. 5.3).
//
// An entry is a pair, since the inter-distance depends on the pair before. So all five options (terminal or wing on
// either side, or leaving out) are open at every entry. Cost: in the worst case the square of the number of pairs of
// parts, for every pair of cuts, four entries at a time. Single precision: within 1e-5 of the sum of all norms.

#include <optional>
#include <utility>
#include <vector>

#include "core/match/part_ring.hpp"

namespace core {

/// Working memory that is kept from one pair of rings to the next; one per thread.
class DecisionMatrix {
  public:
    /// Pairs as indices into the parts of both rings, in the order of the ring.
    using Chain = std::vector<std::pair<int, int>>;

    /// Node distances of all parts of a and b, once for all cuts and both directions of b. A reversed part has the same
    /// features, and its signature turned round.
    void set_rings(const PartRing& a, const PartRing& b);

    /// Chooses the cut of b, which is the ring given to set_rings or its clockwise reading.
    void set_cut(const PartRing& a, const OpenedRing& open_b, bool reversed);

    /// The least cost over all matches for this cut of a, less the norms of all terminals, so never above 0; or
    /// anything not below `give_up_at`, if it is not below.
    [[nodiscard]] float solve(const PartRing& a, const OpenedRing& open_a, const OpenedRing& open_b, float give_up_at);

    /// The match solved last; valid when its cost was below give_up_at. Among equal ones the first in member order.
    void trace(const PartRing& a, const OpenedRing& open_a, const PartRing& b, const OpenedRing& open_b,
               Chain& chain) const;

  private:
    /// A step that may be taken next, with the gain from where it leads to.
    struct Onward {
        float gain = 0.0F;
        const OpenedRing::Step* step = nullptr;
    };
    /// A pair as members of both opened rings.
    struct Link {
        std::size_t x = 0, y = 0;
    };

    void fill_before(const OpenedRing& open, const float* least, bool by_part, float* out);
    void connect(const PartRing& a, const OpenedRing& open_a, const OpenedRing& open_b, std::size_t to);
    std::optional<Link> first_link(const OpenedRing& open_a, const OpenedRing& open_b) const;
    std::optional<Link> next_link(const PartRing& a, const OpenedRing& open_a, const PartRing& b,
                                  const OpenedRing& open_b, Link after) const;

    std::size_t own_row_ = 0;                    // groups of parts of b
    std::vector<LaneGroup> own_, own_reversed_;  // parts of a x parts of b: node distance less what the pair spares
    std::vector<LaneGroup> own_in_order_;        // parts of a x members of the opened b
    std::vector<LaneGroup> gains_;               // members of a x members of b: see solve
    std::vector<LaneGroup> onward_gains_;        // of these, what the best that follows gains
    std::vector<float> row_least_;               // least gain of each member of a
    // Bounds that look at one shape alone: the least own gain of each member of b and part of a, and of all that can
    // come before.
    std::vector<LaneGroup> least_of_b_, before_b_;
    std::vector<float> least_of_a_, before_a_;
    std::vector<float> until_;    // see fill_before
    std::vector<Onward> onward_;  // see connect
};

}  // namespace core
