#pragma once
// From a contour to the rectified chordal axis transform: the steps of thesis 5.1 and 5.2 in order, each kept for
// whoever wants to look at it.

#include "core/base/result.hpp"
#include "core/skeleton/cat_graph.hpp"
#include "core/skeleton/chord_profile.hpp"
#include "core/skeleton/inertia.hpp"

namespace core {

struct Skeleton {
    Polygon contour;                ///< smoothed, evenly spaced
    std::vector<double> cornerity;  ///< one a contour point
    std::vector<int> corners;       ///< contour points
    Polygon samples;                ///< anti-clockwise
    ArcMeasures arcs;               ///< of the samples
    InertiaAxis axis;
    Triangulation triangulation;  ///< of the samples stretched along the axis
    ChordProfile profile;
    Segmentation csp_pieces;          ///< as the extended profile cuts
    Segmentation significant_pieces;  ///< insignificant terminals merged
    Segmentation merged_pieces;       ///< junction blocks merged and trimmed
    Segmentation pieces;              ///< runs of sleeves joined: what the descriptor stands on
    CatGraph graph;                   ///< of `pieces`
    double skeletal_length = 0.0;     ///< taken before runs of sleeves are joined, in the unit of the contour
};

/// `contour` as largest_contour gives it: anti-clockwise, y up. BadOutline when nothing of it can be triangulated.
/// About 1 ms for 100 samples.
[[nodiscard]] Result<Skeleton> skeletonise(const Polygon& contour, const ShapeParameters& parameters);

}  // namespace core
