#pragma once
// The distance of two shapes and which part of one answers to which part of the other (thesis chapter 6, and the future
// work of 8.2).
//
// What is minimised, exactly. Both rings of terminals are cut open, one at a stop point of A and one at a stop point of
// B, and B is read forwards or backwards: a configuration. Every configuration has a least-cost match M
// (core/match/decision_matrix.hpp) with the cost of eq. 5.2 and 5.3. With
//
//     parts(M)   = cost(M) / sqrt(norms of all terminals of A and of B)
//     outline(M) = aligned_difference of the outlines, with the places where the parts of M start and end as anchors
//
// its distance is
//
//     kOutlineWeight * outline(M) + parts(M) * min(1, outline(M) / kNearlyEqual)
//
// (where outlines coincide, differing parts are those of the segmentation, not of the shapes) and the distance of the
// shapes is the least over all configurations: all pairs of stop points, where the thesis shifts the two alternately.
// It is >= 0, 0 for equal shapes and, but for rounding, for mirror images; symmetric to the last bit (the shapes are
// put in_order first); and no metric.
//
// The thesis stops at the least cost(M). What the additions gained, sum of Kimia-99 and Kimia-216 in per cent: the
// thesis's cost 170.7; divided by the root of the norms, so that shapes of many parts do not lie far from everything,
// 171.7; with the outlines along the match that costs least 181.5; with those of every configuration 190. Turning
// nearly equal outlines and passing over their parts changes nothing there, but a shape then lies nearer to its own
// turned copy than to its like in 97 per cent instead of 92. Weights from 150 to 340 differ by 0.4.
//
// Cost: 18 configurations in practice (3 stop points a shape). No memory is allocated once a Matcher has seen shapes of
// this size.

#include <limits>
#include <vector>

#include "core/match/decision_matrix.hpp"

namespace core {

/// Distance of a configuration: see above.
[[nodiscard]] float configuration_distance(float parts, float outline);

/// The order in which two shapes are compared, whichever way they are given: the one with fewer parts first, then by
/// content. False when b comes first.
[[nodiscard]] bool in_order(const PartRing& a, const PartRing& b);

/// Weight of the outlines against the parts, whose cost over the root of the norms is about 10 between classes.
inline constexpr float kOutlineWeight = 250.0F;

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
    double part_cost = 0.0;          ///< cost(M): sum of the pairs and of what is left out
    double outline = 0.0;            ///< outline_difference along M
    bool reversed = false;           ///< B was read backwards
    std::vector<MatchedPair> pairs;  ///< in the order of A's ring from the best start
    std::vector<int> left_out_a;     ///< terminals in no pair, ascending
    std::vector<int> left_out_b;
    double left_out_cost = 0.0;  ///< sum of their norms
};

/// What the outlines of a configuration are known to differ by at least, with B read as A is and the other way round.
struct LeastOutlines {
    float along = 0.0F, against = 0.0F;
};

/// Working memory that is kept from one pair of shapes to the next; one per thread.
class Matcher {
  public:
    /// The distance alone. As soon as it cannot come below `give_up_at`, give_up_at comes back: the sooner, the more is
    /// known about the outlines.
    [[nodiscard]] double distance(const MatchableShape& a, const MatchableShape& b,
                                  double give_up_at = std::numeric_limits<double>::infinity(),
                                  LeastOutlines least = {});
    /// Distance and correspondence.
    [[nodiscard]] Match match(const MatchableShape& a, const MatchableShape& b);
    /// Distance of a shape to its own clockwise reading: how asymmetric it is (7.1.2). 0 for a symmetric shape.
    [[nodiscard]] double asymmetry(const MatchableShape& shape);
    /// The thesis's own distance: the least cost(M) over all configurations.
    [[nodiscard]] double part_cost(const MatchableShape& a, const MatchableShape& b);

  private:
    using Chain = DecisionMatrix::Chain;
    /// The best configuration so far.
    struct Best {
        float distance = 0.0F;
        float part_cost = 0.0F;
        float outline = 0.0F;
        bool reversed = false;
        Chain chain;
    };

    void try_cuts(const PartRing& a, const PartRing& b, bool reversed, float least_outline);
    void try_both(const MatchableShape& a, const MatchableShape& b, float give_up_at, LeastOutlines least = {});
    float outline_along(const PartRing& a, const PartRing& b, float give_up_at);

    DecisionMatrix matrix_;
    Chain chain_;  // of the configuration at hand
    Best best_;
    // Outlines compared so far in this direction: configurations often lead to the same pairs.
    struct Compared {
        Chain pairs;
        float outline = 0.0F;
    };
    std::vector<Compared> compared_;
    std::size_t compared_count_ = 0;
    Chain pairs_;  // chain_ from its first place on a's outline
    std::vector<OutlineAnchor> anchors_;
};

}  // namespace core
