#pragma once
// The distance of two shapes and which part of one answers to which part of the other (thesis chapter 6).
//
// What is minimised, exactly. Both rings of terminals are cut open, one at a stop point of A and one at a stop point of B, and
// B is read forwards or backwards. A *match* is a sequence of pairs (x_1, y_1) … (x_k, y_k), k >= 0, of parts (terminals or
// wings) such that in both opened rings x_i ends before x_{i+1} starts and y_i before y_{i+1}: no two share a terminal, no
// block interleaves, the order is kept, and none runs over a cut. Its cost is
//
//     sum_i node_distance(x_i, y_i)                                        (eq. 5.2)
//   + sum_i |w (d(x_i, x_{i+1}) - d(y_i, y_{i+1}))|²                       (weighted inter-distances, consecutive pairs, not cyclic)
//   + sum of the norms of all terminals of A and of B in no x_i and no y_i (eq. 5.3).
//
// The distance is the least cost over all matches, all pairs of stop points and both directions: all pairs, where the
// thesis shifts the two alternately. It is >= 0, 0 for equal shapes and for mirror images, symmetric, and no metric.
// The recursion is the thesis's decision matrix made exact: an entry knows the pair it was reached from, since the
// inter-distance depends on it. So all five options (terminal or wing on either side, or leaving out) are open at every entry.

#include <vector>

#include "core/match/part_ring.hpp"

namespace core {

/// One matched pair and what made up its cost.
struct MatchedPair {
    int part_a = 0;               ///< index into the descriptor of A
    int part_b = 0;               ///< and of B
    double features = 0.0;        ///< root of the weighted feature differences
    double signature = 0.0;       ///< squared signature difference
    double d_e = 0.0;             ///< squared weighted differences to the pair before; 0 for the first
    double d_be = 0.0;
    double d_a = 0.0;
    [[nodiscard]] double cost() const { return features + signature + d_e + d_be + d_a; }
};

struct Match {
    double distance = 0.0;
    bool reversed = false;             ///< B was read backwards
    std::vector<MatchedPair> pairs;    ///< in the order of A's ring from the best start
    std::vector<int> left_out_a;       ///< terminals in no pair, ascending
    std::vector<int> left_out_b;
    double left_out_cost = 0.0;        ///< sum of their norms
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
    /// A pair of parts, and the best that can follow it.
    struct Entry {
        float gain = 0.0F;  ///< cost of the best match from here on, minus that of leaving all its terminals out
        int next = -1;      ///< entry that follows; -1 for none
        int x = 0, y = 0;   ///< parts
    };
    /// The entries whose parts start at one position of A and one of B, and the least gain among them.
    struct Cell {
        int begin = 0, end = 0;
        float least = 0.0F;
    };
    /// One way to cut both rings open, and the least its cost can be.
    struct Configuration {
        float bound = 0.0F;
        int open_a = 0, open_b = 0;  ///< indices into PartRing::opened
        bool reversed = false;
    };
    struct Best {
        float cost = 0.0F;
        Configuration configuration;
    };

    void fill_node_distances(const PartRing& a, const PartRing& b, std::vector<float>& out) const;
    float fill_heads(const PartRing& a, const PartRing& b, const Configuration& c);
    float solve(const PartRing& a, const PartRing& b, const Configuration& c, float give_up_at);
    void continue_best(Entry& entry, const PartRing& a, const PartRing& b, int from_a, int from_b) const;
    void add_configurations(const PartRing& a, const PartRing& b, bool reversed);
    Best best_of_configurations(const PartRing& a, const PartRing& forwards, const PartRing& backwards);
    Match explain(const PartRing& a, const PartRing& b, const Best& best);

    std::vector<float> node_distance_, node_distance_reversed_;  // parts of a x parts of b
    std::vector<Configuration> configurations_;
    std::vector<float> head_bound_;     // (positions of a + 1) x (positions of b + 1): least gain of what may come before
    std::vector<Entry> entries_;
    std::vector<Cell> cells_;           // (positions of a + 1) x (positions of b + 1)
    std::vector<float> tail_;           // likewise: least gain of any entry that starts there or later in both
    int head_ = -1;
};

}  // namespace core
