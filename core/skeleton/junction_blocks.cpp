#include "core/skeleton/junction_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace core {

namespace {

/// Area and area-weighted centroid of a set of triangles, summed so that sets can be joined.
struct Mass {
    double area = 0.0;
    Point moment;
    void add(const Mass& other) {
        area += other.area;
        moment = moment + other.moment;
    }
    void remove(const Mass& other) {
        area -= other.area;
        moment = moment - other.moment;
    }
    [[nodiscard]] Point centroid() const { return area > 0.0 ? moment * (1.0 / area) : moment; }
};

class Strain {
  public:
    Strain(const Polygon& samples, const Triangulation& triangulation)
        : samples_(samples), triangulation_(triangulation), origin_(samples.front()) {}

    [[nodiscard]] Mass mass_of(int triangle) const {
        const auto& v = triangulation_.triangles[static_cast<std::size_t>(triangle)].vertices;
        const Point a = at(v[0]), b = at(v[1]), c = at(v[2]);
        const double area = 0.5 * std::abs(cross(b - a, c - a));
        return {area, (a + b + c) * (area / 3.0)};
    }

    /// One term of the sum: a chord of a junction with this centroid.
    [[nodiscard]] double of_chord(int chord, Point centroid) const {
        const Chord& c = triangulation_.chords[static_cast<std::size_t>(chord)];
        const Point along = at(c.v) - at(c.u);
        const Point segment = midpoint(at(c.u), at(c.v)) - centroid;
        const double theta = std::atan2(std::abs(cross(along, segment)), dot(along, segment));
        const double off = theta - std::numbers::pi / 2.0;
        return off * off * length(along) * length(segment);
    }

    [[nodiscard]] double of_junction(const std::vector<int>& chords, Point centroid) const {
        double sum = 0.0;
        for (const int c : chords) sum += of_chord(c, centroid);
        return static_cast<double>(chords.size()) * sum;
    }

  private:
    [[nodiscard]] Point at(int i) const { return samples_[static_cast<std::size_t>(i)] - origin_; }
    const Polygon& samples_;
    const Triangulation& triangulation_;
    Point origin_;
};

/// Adjacent junctions, numbered within the block, and the chords between them.
struct Block {
    std::vector<int> pieces;
    std::vector<int> chords;                 // connecting
    std::vector<std::pair<int, int>> joins;  // for each connecting chord the two members
    std::vector<Mass> masses;
    std::vector<std::vector<int>> outer;  // for each member its other chords
};

std::vector<Block> junction_blocks(const Triangulation& t, const Segmentation& s, const Strain& strain) {
    std::vector<Block> blocks;
    std::vector<int> member(s.pieces.size(), -1);
    for (std::size_t first = 0; first < s.pieces.size(); ++first) {
        if (s.pieces[first].kind() != PieceKind::Junction || member[first] >= 0) continue;
        Block block;
        block.pieces.push_back(static_cast<int>(first));
        member[first] = 0;
        for (std::size_t k = 0; k < block.pieces.size(); ++k) {
            const int piece = block.pieces[k];
            Mass mass;
            for (const int triangle : s.pieces[static_cast<std::size_t>(piece)].triangles)
                mass.add(strain.mass_of(triangle));
            block.masses.push_back(mass);
            block.outer.emplace_back();
            for (const int chord : s.pieces[static_cast<std::size_t>(piece)].chords) {
                const int other = s.neighbour(piece, chord, t);
                if (s.pieces[static_cast<std::size_t>(other)].kind() != PieceKind::Junction) {
                    block.outer.back().push_back(chord);
                } else if (member[static_cast<std::size_t>(other)] < 0) {
                    member[static_cast<std::size_t>(other)] = static_cast<int>(block.pieces.size());
                    block.pieces.push_back(other);
                    block.chords.push_back(chord);
                    block.joins.emplace_back(static_cast<int>(k), member[static_cast<std::size_t>(other)]);
                }
            }
        }
        if (!block.chords.empty()) blocks.push_back(std::move(block));
    }
    return blocks;
}

/// Strain of the block when bit i of `kept` says whether connecting chord i still cuts.
double strain_of(const Block& block, const std::vector<char>& kept, const Strain& strain) {
    std::vector<int> root(block.pieces.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&root](int i) {
        while (root[static_cast<std::size_t>(i)] != i) i = root[static_cast<std::size_t>(i)];
        return i;
    };
    for (std::size_t c = 0; c < block.chords.size(); ++c) {
        if (kept[c] == 0) root[static_cast<std::size_t>(find(block.joins[c].second))] = find(block.joins[c].first);
    }
    std::vector<Mass> masses(block.pieces.size());
    std::vector<std::vector<int>> chords(block.pieces.size());
    for (std::size_t k = 0; k < block.pieces.size(); ++k) {
        const auto r = static_cast<std::size_t>(find(static_cast<int>(k)));
        masses[r].add(block.masses[k]);
        chords[r].insert(chords[r].end(), block.outer[k].begin(), block.outer[k].end());
    }
    for (std::size_t c = 0; c < block.chords.size(); ++c) {
        if (kept[c] == 0) continue;
        for (const int end : {block.joins[c].first, block.joins[c].second}) {
            chords[static_cast<std::size_t>(find(end))].push_back(block.chords[c]);
        }
    }
    double total = 0.0;
    for (std::size_t k = 0; k < block.pieces.size(); ++k) {
        if (!chords[k].empty()) total += strain.of_junction(chords[k], masses[k].centroid());
    }
    return total;
}

/// Strains closer than this share are equal.
constexpr double kTie = 1e-9;

std::vector<char> least_strain_exhaustive(const Block& block, const Strain& strain) {
    const std::size_t k = block.chords.size();
    std::vector<char> kept(k, 1), best = kept;
    double least = strain_of(block, kept, strain);
    for (std::uint32_t dropped = 1; dropped < (1U << k); ++dropped) {
        for (std::size_t c = 0; c < k; ++c) kept[c] = (dropped >> c & 1U) == 0 ? 1 : 0;
        const double value = strain_of(block, kept, strain);
        if (value < least * (1.0 - kTie)) {
            least = value;
            best = kept;
        }
    }
    return best;
}

std::vector<char> least_strain_greedy(const Block& block, const Strain& strain) {
    std::vector<char> kept(block.chords.size(), 1);
    double least = strain_of(block, kept, strain);
    for (;;) {
        int drop = -1;
        for (std::size_t c = 0; c < kept.size(); ++c) {
            if (kept[c] == 0) continue;
            kept[c] = 0;
            const double value = strain_of(block, kept, strain);
            kept[c] = 1;
            if (value < least * (1.0 - kTie)) {
                least = value;
                drop = static_cast<int>(c);
            }
        }
        if (drop < 0) return kept;
        kept[static_cast<std::size_t>(drop)] = 0;
    }
}

}  // namespace

Segmentation with_merged_junctions(const Polygon& samples, const Triangulation& triangulation, const Segmentation& s,
                                   const ShapeParameters& parameters) {
    const Strain strain(samples, triangulation);
    std::vector<char> cuts = s.cuts;
    for (const Block& block : junction_blocks(triangulation, s, strain)) {
        const bool small = static_cast<int>(block.chords.size()) <= parameters.junction_block_limit;
        const std::vector<char> kept =
            small ? least_strain_exhaustive(block, strain) : least_strain_greedy(block, strain);
        for (std::size_t c = 0; c < kept.size(); ++c) cuts[static_cast<std::size_t>(block.chords[c])] = kept[c];
    }
    return segment(triangulation, std::move(cuts));
}

namespace {

/// A junction while it is being trimmed.
struct Trimmed {
    std::vector<int> chords;
    Mass mass;
};

/// The triangle of `piece` at `chord`.
int triangle_inside(const Triangulation& t, const Segmentation& s, int piece, int chord) {
    const Chord& c = t.chords[static_cast<std::size_t>(chord)];
    return s.piece_of_triangle[static_cast<std::size_t>(c.inner)] == piece ? c.inner : c.outer;
}

/// The chord to which the cut moves when the triangle at `chord` is trimmed away; -1 when that would change the
/// topology.
int chord_behind(const Triangulation& t, int triangle, int chord) {
    const Triangle& tri = t.triangles[static_cast<std::size_t>(triangle)];
    if (tri.role() != TriangleRole::Sleeve) return -1;
    for (const int c : tri.chords) {
        if (c >= 0 && c != chord) return c;
    }
    return -1;
}

}  // namespace

Segmentation with_trimmed_junctions(const Polygon& samples, const Triangulation& triangulation, Segmentation s) {
    const Strain strain(samples, triangulation);
    for (std::size_t i = 0; i < s.pieces.size(); ++i) {
        if (s.pieces[i].kind() != PieceKind::Junction) continue;
        const int piece = static_cast<int>(i);
        Trimmed junction{s.pieces[i].chords, {}};
        for (const int t : s.pieces[i].triangles) junction.mass.add(strain.mass_of(t));
        double least = strain.of_junction(junction.chords, junction.mass.centroid());
        for (bool moved = true; moved;) {
            moved = false;
            for (std::size_t k = 0; k < junction.chords.size(); ++k) {
                const int chord = junction.chords[k];
                const int behind = s.neighbour(piece, chord, triangulation);
                if (s.pieces[static_cast<std::size_t>(behind)].kind() == PieceKind::Junction) continue;
                const int triangle = triangle_inside(triangulation, s, piece, chord);
                const int inwards = chord_behind(triangulation, triangle, chord);
                if (inwards < 0 || s.cuts[static_cast<std::size_t>(inwards)] != 0) continue;
                Trimmed candidate = junction;
                candidate.chords[k] = inwards;
                candidate.mass.remove(strain.mass_of(triangle));
                const double value = strain.of_junction(candidate.chords, candidate.mass.centroid());
                if (value > least * (1.0 + kTie)) continue;
                least = value;
                junction = std::move(candidate);
                s.cuts[static_cast<std::size_t>(chord)] = 0;
                s.cuts[static_cast<std::size_t>(inwards)] = 1;
                s.piece_of_triangle[static_cast<std::size_t>(triangle)] = behind;
                moved = true;
            }
        }
        s.pieces[i].chords = junction.chords;
    }
    return segment(triangulation, std::move(s.cuts));
}

}  // namespace core
