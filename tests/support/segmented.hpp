#pragma once
// Segmentations and skeletons that are cut where a test says, so that a step is tested without those before it.

#include <utility>
#include <vector>

#include "core/skeleton/skeleton.hpp"

namespace support {

/// The two samples of a chord, in any order.
using Cut = std::pair<int, int>;

/// The chord between two samples, -1 where the triangulation has none.
inline int chord_between(const core::Triangulation& t, Cut cut) {
    const auto [u, v] = std::minmax(cut.first, cut.second);
    for (std::size_t c = 0; c < t.chords.size(); ++c) {
        if (t.chords[c].u == u && t.chords[c].v == v) return static_cast<int>(c);
    }
    return -1;
}

/// One flag a chord. Cuts that are no chord are left out: compare the number of pieces.
inline std::vector<char> cuts_at(const core::Triangulation& t, const std::vector<Cut>& cuts) {
    std::vector<char> flags(t.chords.size(), 0);
    for (const Cut& cut : cuts) {
        const int chord = chord_between(t, cut);
        if (chord >= 0) flags[static_cast<std::size_t>(chord)] = 1;
    }
    return flags;
}

/// The ring's own points are the samples, nothing is stretched, and these cuts make the final pieces.
inline core::Skeleton skeleton_cut_at(const core::Polygon& ring, const std::vector<Cut>& cuts) {
    core::Skeleton s;
    s.contour = s.samples = ring;
    s.arcs = core::ArcMeasures(ring);
    s.axis = core::axis_of_least_inertia(ring);
    s.triangulation = *core::triangulate(ring);
    s.pieces = core::segment(s.triangulation, cuts_at(s.triangulation, cuts));
    s.csp_pieces = s.significant_pieces = s.merged_pieces = s.pieces;
    s.graph = core::cat_graph(s.samples, s.triangulation, s.pieces);
    s.skeletal_length = core::skeletal_length(s.graph);
    return s;
}

/// The piece that holds the triangle at this chord on the side of the arc from → to.
inline int piece_behind(const core::Skeleton& s, int from, int to) {
    const int chord = chord_between(s.triangulation, {from, to});
    if (chord < 0) return -1;
    const core::Chord& c = s.triangulation.chords[static_cast<std::size_t>(chord)];
    return s.pieces.piece_of_triangle[static_cast<std::size_t>(from < to ? c.inner : c.outer)];
}

}  // namespace support
