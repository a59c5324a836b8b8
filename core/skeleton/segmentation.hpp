#pragma once
// The pieces into which cutting chords part the triangles (thesis 5.2): terminal, sleeve and junction polygons.

#include <vector>

#include "core/skeleton/arc_measures.hpp"
#include "core/skeleton/shape_parameters.hpp"
#include "core/skeleton/triangulation.hpp"

namespace core {

/// By the number of chords that bound the piece: none (the shape is not cut at all), 1, 2, 3 or more.
enum class PieceKind { Whole, Terminal, Sleeve, Junction };

struct Piece {
    std::vector<int> triangles;  ///< ascending
    std::vector<int> chords;     ///< the cutting chords on its border, ascending
    [[nodiscard]] PieceKind kind() const {
        return chords.empty()       ? PieceKind::Whole
               : chords.size() == 1 ? PieceKind::Terminal
               : chords.size() == 2 ? PieceKind::Sleeve
                                    : PieceKind::Junction;
    }
};

struct Segmentation {
    std::vector<char> cuts;     ///< one flag a chord
    std::vector<Piece> pieces;  ///< ordered by their first triangle
    std::vector<int> piece_of_triangle;
    /// The piece on the other side of one of its chords.
    [[nodiscard]] int neighbour(int piece, int chord, const Triangulation& t) const {
        const Chord& c = t.chords[static_cast<std::size_t>(chord)];
        const int inner = piece_of_triangle[static_cast<std::size_t>(c.inner)];
        return inner == piece ? piece_of_triangle[static_cast<std::size_t>(c.outer)] : inner;
    }
};

/// Joins all triangles that meet at a chord without a cut. Linear time.
[[nodiscard]] Segmentation segment(const Triangulation& triangulation, std::vector<char> cuts);

/// The arc that a chord cuts off on the side of `piece`: from.first anti-clockwise to from.second.
struct Arc {
    int from = 0;
    int to = 0;
};
[[nodiscard]] Arc arc_behind(const Segmentation& s, const Triangulation& t, int piece, int chord);

/// Merges insignificant terminals (5.2.2) until none is left: flat ones, by the ratio of chord to arc, that have no
/// clockwise turn along their arc.
[[nodiscard]] Segmentation without_insignificant_terminals(const Polygon& samples, const ArcMeasures& arcs,
                                                           const Triangulation& triangulation, Segmentation s,
                                                           const ShapeParameters& parameters);

/// Joins each run of sleeves into one (reading notes: one sleeve node, kept apart from its terminal).
[[nodiscard]] Segmentation with_joined_sleeves(const Triangulation& triangulation, const Segmentation& s);

}  // namespace core
