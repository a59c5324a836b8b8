#pragma once
// Which pieces a region of n sides is cut into so that quads fill it with few irregular vertices. Side lengths in, a
// list of cuts out; no vertex exists yet (core/garment/fill_topology.hpp makes them).
//
// A region that a grid (4 sides) or a star (one irregular vertex with a quad grid between every two of its spokes; 3 or
// 5 sides) fills needs no cut. Any other gives away pieces until what remains is one of these. Two cuts do all the
// work, each at the price of one irregular vertex:
//
//   corner rectangle   an a x b grid leaves a corner; its inner corner becomes a vertex of valence 3 in the middle of a
//                      new side of a + b edges. One side more, the same total.
//   five-star          a chord from the side before to the side after two whole sides cuts off a star of five, its
//                      centre on the chord: a vertex of valence 5. One side less.
//
// For tiny regions a vertex of a side may count as a corner (split) or a corner as a vertex of a side (join); the
// vertex is then irregular itself.
//
// The condition for filling 4 sides with the pair of valence 3 and valence 5, that no side is longer than the others
// together, is exact, and so are the ranges of a and b used for 2 and 6 sides; with more irregular vertices a search
// tries a few values of a and b, then all as far as its budget goes. The distances are the thesis's (3.2.1), a star
// with one cut is its partition with one distorted region; the idea that few patterns and an integer search reach every
// even input is from K. Takayama, D. Panozzo, O. Sorkine-Hornung, Pattern-based quadrangulation for N-sided patches,
// 2014.

#include <vector>

#include "core/garment/side_counts.hpp"

namespace core {

struct FillStep {
    enum class Kind { Grid, Star, CornerRectangle, FiveStar, Split, Join };
    Kind kind = Kind::Grid;
    int side = 0;  ///< the corner meant is the one at the end of this side; a five-star takes side + 1 and side + 2
    int a = 0;     ///< edges taken from the end of `side`; Split: edges before the new corner
    int b = 0;     ///< edges taken from the beginning of the next side (five-star: of side + 3)

    friend bool operator==(const FillStep&, const FillStep&) = default;
};

/// Ends in a Grid or a Star.
struct FillPlan {
    std::vector<FillStep> steps;
    int score = 0;  ///< the smallest number of edges between an irregular vertex and what it should keep away from
};

/// The sides that remain when a step has taken its piece. After FiveStar and Join they begin with `step.side`. For Grid
/// and Star: no side.
[[nodiscard]] SideCounts sides_after(const SideCounts& sides, const FillStep& step);

/// How to look for plans.
enum class FillSearch {
    Quick,     ///< a few sizes for every cut
    Thorough,  ///< up to 64 sizes, splits and joins too, as far as the budget goes: for small regions
    Joining,   ///< joins until 4 sides are left, which always can be filled
};

/// Plans with `irregular` irregular vertices by their count of cuts and stars, best score first; few, not all. A plan
/// may still turn out impossible where pieces are so thin that vertices meet. Empty when there are none or the budget
/// is used up; it counts steps, so that the result does not depend on the machine: about 1 ms.
[[nodiscard]] std::vector<FillPlan> fill_plans(const SideCounts& sides, int irregular, FillSearch search);

}  // namespace core
