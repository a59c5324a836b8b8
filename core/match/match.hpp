#pragma once
// The distance of two shapes and which part of one answers to which part of the other (thesis chapter 6).
//
// What is minimised, exactly. Both rings of terminals are cut open, one at a stop point of A and one at a stop point of
// B, and B is read forwards or backwards. A *match* is a sequence of pairs (x_1, y_1) … (x_k, y_k), k >= 0, of parts
// (terminals or wings) such that in both opened rings x_i ends before x_{i+1} starts and y_i before y_{i+1}: no two
// share a terminal, no block interleaves, the order is kept, and none runs over a cut. Its cost is
//
//     sum_i node_distance(x_i, y_i)                                        (eq. 5.2)
//   + sum_i |w (d(x_i, x_{i+1}) - d(y_i, y_{i+1}))|²                       (weighted inter-distances, consecutive
//   pairs, not cyclic)
//   + sum of the norms of all terminals of A and of B in no x_i and no y_i (eq. 5.3).
//
// The distance is the least cost over all matches, all pairs of stop points and both directions: all pairs, where the
// thesis shifts the two alternately. It is >= 0, 0 for equal shapes and for mirror images, symmetric to the last bit
// (inside, the two shapes are put into a fixed order), and no metric.
// The recursion is the thesis's decision matrix made exact: an entry is a pair, since the inter-distance depends on the
// pair before. So all five options (terminal or wing on either side, or leaving out) are open at every entry. Cost: in
// the worst case the square of the number of pairs of parts, for every pair of stop points, four entries at a time;
// about 13 parts and 3 stop points a shape in practice. Single precision: within 1e-5 of the sum of all norms.

#include <optional>
#include <utility>
#include <vector>

#include "core/match/part_ring.hpp"

namespace core {

/// One matched pair and what made up its cost.
struct MatchedPair {
    int part_a = 0;          ///< index into the descriptor of A
    int part_b = 0;          ///< and of B
    double features = 0.0;   ///< root of the weighted feature differences
    double signature = 0.0;  ///< squared signature difference
    double d_e = 0.0;        ///< squared weighted differences to the pair before; 0 for the first
    double d_be = 0.0;
    double d_a = 0.0;
    [[nodiscard]] double cost() const { return features + signature + d_e + d_be + d_a; }
};

struct Match {
    double distance = 0.0;
    bool reversed = false;           ///< B was read backwards
    std::vector<MatchedPair> pairs;  ///< in the order of A's ring from the best start
    std::vector<int> left_out_a;     ///< terminals in no pair, ascending
    std::vector<int> left_out_b;
    double left_out_cost = 0.0;  ///< sum of their norms
};

/// Working memory that is kept from one pair of shapes to the next; one per thread.
class Matcher {
  public:
    /// The distance alone.
    [[nodiscard]] double distance(const MatchableShape& a, const MatchableShape& b);
    /// Distance and correspondence.
    [[nodiscard]] Match match(const MatchableShape& a, const MatchableShape& b);
    /// Distance of a shape to its own clockwise reading: how asymmetric it is (7.1.2). 0 for a symmetric shape.
    [[nodiscard]] double asymmetry(const MatchableShape& shape);

  private:
    /// A step that may be taken next, with the gain from where it leads to.
    struct Onward {
        Lanes gain{};
        const OpenedRing::Step* step = nullptr;
    };
    /// One way to cut both rings open, and its cost.
    struct Cut {
        float cost = 0.0F;
        std::size_t open_a = 0, open_b = 0;  ///< indices into PartRing::opened
        bool reversed = false;
    };
    /// A pair as members of both opened rings.
    struct Link {
        std::size_t x = 0, y = 0;
    };
    /// Pairs as indices into the parts of both rings.
    using Chain = std::vector<std::pair<int, int>>;

    void fill_own(const PartRing& a, const PartRing& b);
    void order_own(const PartRing& a, const OpenedRing& open_b, bool reversed);
    float solve(const PartRing& a, const OpenedRing& open_a, const OpenedRing& open_b, float give_up_at);
    void fill_before(const OpenedRing& open, const float* least, bool by_part, float* out);
    void connect(const PartRing& a, const OpenedRing& open_a, const OpenedRing& open_b, std::size_t to);
    void try_cuts(const PartRing& a, const PartRing& b, bool reversed, Cut& best);
    Cut best_cut(const MatchableShape& a, const MatchableShape& b);
    std::optional<Link> next_link(const PartRing& a, const OpenedRing& open_a, const PartRing& b,
                                  const OpenedRing& open_b, const Link* after) const;
    Chain trace(const PartRing& a, const OpenedRing& open_a, const PartRing& b, const OpenedRing& open_b) const;
    static void explain(const PartRing& a, const PartRing& b, const Chain& chain, Match& match);

    std::size_t own_row_ = 0;                    // groups of parts of b
    std::vector<LaneGroup> own_, own_reversed_;  // parts of a x parts of b: node distance less what the pair spares
    std::vector<LaneGroup> own_in_order_;        // parts of a x members of the opened b
    std::vector<LaneGroup> gains_;               // members of a x members of b: see solve
    // Bounds that look at one shape alone: the least own gain of each member of b and part of a, and of all that can
    // come before.
    std::vector<LaneGroup> least_of_b_, before_b_;
    std::vector<float> least_of_a_, before_a_;
    std::vector<float> until_;    // see fill_before
    std::vector<Onward> onward_;  // see connect
};

}  // namespace core
