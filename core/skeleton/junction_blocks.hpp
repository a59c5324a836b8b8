#pragma once
// Junction polygons that hang together: which to merge, and how far to trim them (thesis 5.2.3).

#include "core/skeleton/segmentation.hpp"

namespace core {

/// Each block of adjacent junctions keeps the subset of its connecting chords with the least strain,
/// n * sum (theta_i - pi/2)^2 |C_i| |S_i| over the n chords of each junction, summed over the junctions; S_i leads from
/// the junction's centroid to the middle of chord C_i. All 2^k subsets are tried for k <=
/// parameters.junction_block_limit; a larger block drops, one at a time, the chord whose loss lowers the strain most.
/// Of equal strains the one with more chords wins.
[[nodiscard]] Segmentation with_merged_junctions(const Polygon& samples, const Triangulation& triangulation,
                                                 const Segmentation& s, const ShapeParameters& parameters);

/// Moves chords of junctions inwards over triangles with one edge on the outline, as long as the strain of the junction
/// does not grow; the triangle goes to the terminal or sleeve behind. The topology stays.
[[nodiscard]] Segmentation with_trimmed_junctions(const Polygon& samples, const Triangulation& triangulation,
                                                  Segmentation s);

}  // namespace core
