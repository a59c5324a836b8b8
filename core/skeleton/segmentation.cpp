#include "core/skeleton/segmentation.hpp"

#include <cmath>
#include <numbers>

namespace core {

Segmentation segment(const Triangulation& triangulation, std::vector<char> cuts) {
    Segmentation s;
    s.cuts = std::move(cuts);
    const std::size_t n = triangulation.triangles.size();
    s.piece_of_triangle.assign(n, -1);
    std::vector<int> open;
    for (std::size_t first = 0; first < n; ++first) {
        if (s.piece_of_triangle[first] >= 0) continue;
        const int id = static_cast<int>(s.pieces.size());
        s.pieces.emplace_back();
        open.assign(1, static_cast<int>(first));
        s.piece_of_triangle[first] = id;
        while (!open.empty()) {
            const int t = open.back();
            open.pop_back();
            for (const int c : triangulation.triangles[static_cast<std::size_t>(t)].chords) {
                if (c < 0 || s.cuts[static_cast<std::size_t>(c)] != 0) continue;
                const Chord& chord = triangulation.chords[static_cast<std::size_t>(c)];
                const int next = chord.inner == t ? chord.outer : chord.inner;
                if (s.piece_of_triangle[static_cast<std::size_t>(next)] >= 0) continue;
                s.piece_of_triangle[static_cast<std::size_t>(next)] = id;
                open.push_back(next);
            }
        }
    }
    for (std::size_t t = 0; t < n; ++t) {
        s.pieces[static_cast<std::size_t>(s.piece_of_triangle[t])].triangles.push_back(static_cast<int>(t));
    }
    for (std::size_t c = 0; c < s.cuts.size(); ++c) {
        if (s.cuts[c] == 0) continue;
        const Chord& chord = triangulation.chords[c];
        for (const int t : {chord.inner, chord.outer}) {
            const int piece = s.piece_of_triangle[static_cast<std::size_t>(t)];
            s.pieces[static_cast<std::size_t>(piece)].chords.push_back(static_cast<int>(c));
        }
    }
    return s;
}

Arc arc_behind(const Segmentation& s, const Triangulation& t, int piece, int chord) {
    const Chord& c = t.chords[static_cast<std::size_t>(chord)];
    return s.piece_of_triangle[static_cast<std::size_t>(c.inner)] == piece ? Arc{c.u, c.v} : Arc{c.v, c.u};
}

namespace {

bool turns_clockwise(const Polygon& samples, Arc arc, double more_than_deg) {
    const int n = static_cast<int>(samples.size());
    const auto at = [&](int i) { return samples[static_cast<std::size_t>((i + n) % n)]; };
    const double limit = more_than_deg * std::numbers::pi / 180.0;
    for (int i = (arc.from + 1) % n; i != arc.to; i = (i + 1) % n) {
        const Point in = at(i) - at(i - 1), out = at(i + 1) - at(i);
        if (-std::atan2(cross(in, out), dot(in, out)) > limit) return true;
    }
    return false;
}

bool is_insignificant(const Polygon& samples, const ArcMeasures& arcs, Arc arc, const ShapeParameters& p) {
    const double chord =
        distance(samples[static_cast<std::size_t>(arc.from)], samples[static_cast<std::size_t>(arc.to)]);
    const double ratio = chord / arcs.length(arc.from, arc.to);
    const double share = arcs.area(arc.from, arc.to) / arcs.area();
    const bool flat = ratio > p.thresh_any_clr || (share < p.small_area && ratio > p.thresh_small_clr);
    return flat && !turns_clockwise(samples, arc, p.sharp_turn_deg);
}

}  // namespace

Segmentation without_insignificant_terminals(const Polygon& samples, const ArcMeasures& arcs,
                                             const Triangulation& triangulation, Segmentation s,
                                             const ShapeParameters& parameters) {
    for (bool merged = true; merged;) {
        merged = false;
        std::vector<char> cuts = s.cuts;
        for (std::size_t i = 0; i < s.pieces.size(); ++i) {
            const Piece& piece = s.pieces[i];
            if (piece.kind() != PieceKind::Terminal) continue;
            const Arc arc = arc_behind(s, triangulation, static_cast<int>(i), piece.chords[0]);
            if (!is_insignificant(samples, arcs, arc, parameters)) continue;
            cuts[static_cast<std::size_t>(piece.chords[0])] = 0;
            merged = true;
        }
        if (merged) s = segment(triangulation, std::move(cuts));
    }
    return s;
}

Segmentation with_joined_sleeves(const Triangulation& triangulation, const Segmentation& s) {
    std::vector<char> cuts = s.cuts;
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        if (cuts[c] == 0) continue;
        const Chord& chord = triangulation.chords[c];
        const auto kind = [&](int t) {
            return s.pieces[static_cast<std::size_t>(s.piece_of_triangle[static_cast<std::size_t>(t)])].kind();
        };
        if (kind(chord.inner) == PieceKind::Sleeve && kind(chord.outer) == PieceKind::Sleeve) cuts[c] = 0;
    }
    return segment(triangulation, std::move(cuts));
}

}  // namespace core
