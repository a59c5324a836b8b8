#pragma once
// Which chords cut the shape: the chord strength profile of the chordal axis transform and its extension
// (thesis 5.2, 5.2.1).

#include <vector>

#include "core/skeleton/triangulation.hpp"

namespace core {

/// The three measures of every chord. Geometry is that of the unstretched samples.
struct ChordMeasures {
    std::vector<double> strength;  ///< eq. 5.1: 1 - (phi + theta) / pi, in (-1, 1]; 0 for a cyclic quadrilateral
    std::vector<double>
        compactness;  ///< perimeter² / area of the quadrilateral of the two flanking triangles; >= 16 for convex ones
    std::vector<double> half_disk;  ///< samples of the smaller arc when all lie in the disc over the chord, else 0
};

[[nodiscard]] ChordMeasures measure_chords(const Polygon& samples, const Triangulation& triangulation);

/// One flag a chord: 1 where the value is a local maximum in `order` (chords_along_outline): at one of its two places
/// no less than both neighbours there and greater than one of them.
[[nodiscard]] std::vector<char> local_maxima(const std::vector<int>& order, const std::vector<double>& value);

/// What each chord was selected for; a chord with any flag cuts the shape.
struct ChordProfile {
    std::vector<char> by_strength;
    std::vector<char> by_compactness;
    std::vector<char> by_half_disk;
    [[nodiscard]] std::vector<char> cuts() const;
};

[[nodiscard]] ChordProfile extended_profile(const Polygon& samples, const Triangulation& triangulation);

}  // namespace core
