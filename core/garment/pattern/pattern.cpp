#include "core/garment/pattern/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/garment/pattern/allowance.hpp"
#include "core/garment/pattern/flatten.hpp"

namespace core {
namespace {

constexpr double kStraight_cm = 0.1;  // a fold may be bent so much
constexpr double kOnPlane_cm = 1e-6;
constexpr double kNotchAt = 0.4;  // of a seam: not in its middle, so that it shows which end is which
constexpr double kSliver = 0.25;  // of the mean quad
constexpr int kFewestNotchEdges = 4;
constexpr double kLongestGrain_cm = 50.0;
constexpr double kMostAllowance_cm = 10.0;

using EdgeKey = std::pair<std::uint32_t, std::uint32_t>;

EdgeKey key_of(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

/// Pieces by the edges of their borders.
std::multimap<EdgeKey, std::size_t> pieces_by_edge(const Cloth& cloth) {
    std::multimap<EdgeKey, std::size_t> out;
    for (std::size_t p = 0; p < cloth.pieces.size(); ++p) {
        const ClothPiece& piece = cloth.pieces[p];
        std::map<EdgeKey, int> count;
        for (std::size_t q = piece.first; q < piece.first + piece.count; ++q)
            for (std::size_t k = 0; k < 4; ++k)
                ++count[key_of(cloth.mesh.quads[q][k], cloth.mesh.quads[q][(k + 1) % 4])];
        for (const auto& [edge, quads] : count)
            if (quads == 1) out.emplace(edge, p);
    }
    return out;
}

/// A smooth curve through points (Catmull and Rom), `steps` pieces between two of them; ends stay.
std::vector<Point> smooth_through(const std::vector<Point>& points, int steps) {
    std::vector<Point> out;
    const auto at = [&](std::ptrdiff_t i) {
        const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
        if (i < 0) return points[0] * 2.0 - points[1];
        if (i > last) return points.back() * 2.0 - points[points.size() - 2];
        return points[static_cast<std::size_t>(i)];
    };
    for (std::ptrdiff_t i = 0; i + 1 < static_cast<std::ptrdiff_t>(points.size()); ++i) {
        const Point a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps, t2 = t * t, t3 = t2 * t;
            out.push_back(
                (b * 2.0 + (c - a) * t + (a * 2.0 - b * 5.0 + c * 4.0 - d) * t2 + (b * 3.0 - a - c * 3.0 + d) * t3) *
                0.5);
        }
    }
    out.push_back(points.back());
    return out;
}

/// One stretch of a border in terms of the cloth.
struct Stretch {
    std::vector<std::uint32_t> vertices;  // of the cloth, in order
    int partner = -1;                     // a piece of the cloth
    int line = -1;                        // of the network
};

class PatternMaker {
  public:
    PatternMaker(const Garment& garment, const PatternOptions& options, Pattern& pattern)
        : garment_(garment), options_(options), pattern_(pattern) {}

    void add_layer(std::size_t layer) {
        const Cloth& cloth = garment_.layers[layer].fitted;
        edges_ = pieces_by_edge(cloth);
        first_of_layer_ = pattern_.pieces.size();
        made_.assign(cloth.pieces.size(), -1);
        stretches_.clear();
        for (std::size_t p = 0; p < cloth.pieces.size(); ++p)
            if (cloth.pieces[p].mirror_of < 0) add_piece(cloth, layer, p);
        for (std::size_t p = first_of_layer_; p < pattern_.pieces.size(); ++p)
            for (std::size_t s = 0; s < pattern_.pieces[p].sides.size(); ++s) add_seam(cloth, p, s);
        for (std::size_t p = first_of_layer_; p < pattern_.pieces.size(); ++p) finish_piece(pattern_.pieces[p]);
    }

  private:
    void add_piece(const Cloth& cloth, std::size_t layer, std::size_t index) {
        const ClothPiece& source = cloth.pieces[index];
        const PieceMesh part = mesh_of_piece(cloth, source);
        const Result<FlatPiece> flat = flatten(part.mesh, {});
        if (!flat) {
            pattern_.faults.push_back({0, "piece \"" + source.name + "\": " + flat.error().message});
            return;
        }
        PatternPiece piece;
        piece.name = source.name;
        piece.layer = static_cast<int>(layer);
        piece.copies = has_image(cloth, index) ? 2 : 1;
        piece.mean_strain = flat->mean_strain;
        piece.high_strain = flat->high_strain;
        piece.largest_strain = flat->largest_strain;
        piece.strain = flat->strain;
        for (const Quad& q : part.mesh.quads)
            piece.quads.push_back({flat->places[q[0]], flat->places[q[1]], flat->places[q[2]], flat->places[q[3]]});
        piece.most_strained = most_strained(piece);
        std::map<std::uint32_t, Point> place;
        for (std::size_t v = 0; v < part.vertex.size(); ++v) place[part.vertex[v]] = flat->places[v];
        std::vector<std::uint32_t> border;
        const Result<std::vector<std::uint32_t>> ring = disc_border(part.mesh);  // good: it was laid flat
        for (const std::uint32_t v : *ring) border.push_back(part.vertex[v]);
        made_[index] = static_cast<int>(pattern_.pieces.size());
        stretches_.emplace_back();
        for (Stretch& stretch : stretches_of(cloth, index, border)) {
            piece.sides.push_back(side_of(cloth, stretch, place, index));
            stretches_.back().push_back(std::move(stretch));
        }
        piece.on_fold = std::any_of(piece.sides.begin(), piece.sides.end(),
                                    [](const PatternSide& s) { return s.kind == PatternSide::Kind::Fold; });
        if (piece.on_fold) piece.copies = 1;
        pattern_.pieces.push_back(std::move(piece));
    }

    /// The middle of the quad with the largest strain of those that are no slivers.
    [[nodiscard]] static Point most_strained(const PatternPiece& piece) {
        const auto area = [](const std::array<Point, 4>& q) { return 0.5 * std::abs(cross(q[2] - q[0], q[3] - q[1])); };
        double mean = 0.0, most = -1.0;
        for (const auto& q : piece.quads) mean += area(q) / static_cast<double>(piece.quads.size());
        Point best;
        for (std::size_t i = 0; i < piece.quads.size(); ++i) {
            const auto& q = piece.quads[i];
            if (piece.strain[i] <= most || area(q) < kSliver * mean) continue;
            most = piece.strain[i];
            best = (q[0] + q[1] + q[2] + q[3]) * 0.25;
        }
        return best;
    }

    [[nodiscard]] static bool has_image(const Cloth& cloth, std::size_t index) {
        return std::any_of(cloth.pieces.begin(), cloth.pieces.end(),
                           [&](const ClothPiece& p) { return p.mirror_of == static_cast<int>(index); });
    }

    [[nodiscard]] int partner_of(std::size_t piece, std::uint32_t a, std::uint32_t b) const {
        const auto [first, last] = edges_.equal_range(key_of(a, b));
        for (auto at = first; at != last; ++at)
            if (at->second != piece) return static_cast<int>(at->second);
        return -1;
    }

    /// Every line has an even number of edges, so that one end of each is in the middle of its line.
    [[nodiscard]] static int line_of(const Cloth& cloth, std::uint32_t a, std::uint32_t b) {
        return cloth.line.empty() ? -1 : std::max(cloth.line[a], cloth.line[b]);
    }

    /// The border from one change of partner or line to the next.
    [[nodiscard]] std::vector<Stretch> stretches_of(const Cloth& cloth, std::size_t piece,
                                                    std::vector<std::uint32_t> border) const {
        const std::size_t n = border.size();
        const auto kind_at = [&](std::size_t i) {
            const std::uint32_t a = border[i % n], b = border[(i + 1) % n];
            return std::pair(partner_of(piece, a, b), line_of(cloth, a, b));
        };
        std::size_t start = 0;
        while (start < n && kind_at(start) == kind_at(start + n - 1)) ++start;
        std::vector<Stretch> out;
        for (std::size_t i = start; i < start + n; ++i) {
            const auto [partner, line] = kind_at(i);
            if (out.empty() || kind_at(i) != kind_at(i + n - 1) || i == start)
                out.push_back({{border[i % n]}, partner, line});
            out.back().vertices.push_back(border[(i + 1) % n]);
        }
        return out;
    }

    [[nodiscard]] PatternSide side_of(const Cloth& cloth, const Stretch& stretch,
                                      const std::map<std::uint32_t, Point>& place, std::size_t index) const {
        PatternSide side;
        if (stretch.line >= 0) side.name = garment_.network.lines()[static_cast<std::size_t>(stretch.line)].name;
        side.edges = static_cast<int>(stretch.vertices.size()) - 1;
        std::vector<Point> points;
        for (std::size_t i = 0; i < stretch.vertices.size(); ++i) {
            points.push_back(place.at(stretch.vertices[i]));
            if (i > 0)
                side.in_space_cm +=
                    length(cloth.mesh.vertices[stretch.vertices[i]] - cloth.mesh.vertices[stretch.vertices[i - 1]]);
        }
        if (stretch.partner >= 0) side.kind = PatternSide::Kind::Seam;
        if (stretch.partner >= 0 &&
            cloth.pieces[static_cast<std::size_t>(stretch.partner)].mirror_of == static_cast<int>(index) &&
            is_straight(points) && on_plane(cloth, stretch)) {
            side.kind = PatternSide::Kind::Fold;
            points = {points.front(), points.back()};
        }
        side.line = points.size() > 2 ? smooth_through(points, options_.curve_steps) : points;
        return side;
    }

    [[nodiscard]] static bool on_plane(const Cloth& cloth, const Stretch& stretch) {
        return std::all_of(stretch.vertices.begin(), stretch.vertices.end(), [&](std::uint32_t v) {
            return std::abs(cloth.mesh.vertices[v].x) < kOnPlane_cm + kStraight_cm;
        });
    }

    [[nodiscard]] static bool is_straight(const std::vector<Point>& points) {
        const Point along = points.back() - points.front();
        const double size = length(along);
        return size > 0.0 && std::all_of(points.begin(), points.end(), [&](Point p) {
                   return std::abs(cross(along, p - points.front())) < kStraight_cm * size;
               });
    }

    /// The seam of a side, if its other side was not met before; and the notches of both.
    void add_seam(const Cloth& cloth, std::size_t piece, std::size_t side) {
        const Stretch& mine = stretches_[piece - first_of_layer_][side];
        if (pattern_.pieces[piece].sides[side].kind != PatternSide::Kind::Seam) return;
        const ClothPiece& partner = cloth.pieces[static_cast<std::size_t>(mine.partner)];
        const bool mirrored = partner.mirror_of >= 0;
        const int other = made_[static_cast<std::size_t>(mirrored ? partner.mirror_of : mine.partner)];
        if (other < 0) return;  // could not be laid flat
        const auto other_piece = static_cast<std::size_t>(other);
        if (other_piece < piece) return;  // met before, from its side
        const auto match = matching_side(cloth, mine, other_piece, mirrored);
        if (match < 0) return;
        const auto other_side = static_cast<std::size_t>(match);
        PatternSeam seam{piece, side, other_piece, other_side, mirrored, 0.0, 0.0};
        seam.length_a_cm = line_length_cm(pattern_.pieces[piece].sides[side].line);
        seam.length_b_cm = line_length_cm(pattern_.pieces[other_piece].sides[other_side].line);
        pattern_.seams.push_back(seam);
        add_notches(seam);
    }

    /// The side of the other piece along the same edges: by the places of its ends and middle, mirrored if need be.
    [[nodiscard]] int matching_side(const Cloth& cloth, const Stretch& mine, std::size_t other, bool mirrored) const {
        const auto at = [&](std::uint32_t v) {
            const Vec3 p = cloth.mesh.vertices[v];
            return mirrored ? Vec3{-p.x, p.y, p.z} : p;
        };
        const auto& candidates = stretches_[other - first_of_layer_];
        int best = -1;
        double least = 1.0;  // cm; fitting moves the two halves of a garment alike but not to the last digit
        for (std::size_t s = 0; s < candidates.size(); ++s) {
            const auto& theirs = candidates[s].vertices;
            if (theirs.size() != mine.vertices.size() || candidates[s].line != mine.line) continue;
            const auto apart = [&](bool reversed) {
                double most = 0.0;
                for (std::size_t i = 0; i < theirs.size(); ++i)
                    most = std::max(most, length(cloth.mesh.vertices[theirs[reversed ? theirs.size() - 1 - i : i]] -
                                                 at(mine.vertices[i])));
                return most;
            };
            const double d = std::min(apart(false), apart(true));
            if (d < least) least = d, best = static_cast<int>(s);
        }
        return best;
    }

    /// A notch on either side, at the same vertex of the seam. A seam with the own image has one, on both copies.
    void add_notches(const PatternSeam& seam) {
        PatternSide& a = pattern_.pieces[seam.piece_a].sides[seam.side_a];
        if (a.edges < kFewestNotchEdges) return;
        const int at = static_cast<int>(std::lround(kNotchAt * a.edges));
        put_notch(seam.piece_a, seam.side_a, at);
        if (seam.piece_b == seam.piece_a && seam.side_b == seam.side_a) return;
        // the other piece passes the seam the other way, but for a mirrored one, which is drawn unmirrored
        put_notch(seam.piece_b, seam.side_b, seam.mirrored ? at : a.edges - at);
    }

    void put_notch(std::size_t piece, std::size_t side, int edge) {
        const std::vector<Point>& line = pattern_.pieces[piece].sides[side].line;
        const auto steps = static_cast<std::size_t>(options_.curve_steps);
        const std::size_t i = std::clamp<std::size_t>(static_cast<std::size_t>(edge) * steps, 1, line.size() - 2);
        const Point along = line[i + 1] - line[i - 1];
        const double size = std::max(length(along), 1e-12);
        pattern_.pieces[piece].notches.push_back({line[i], Point{along.y / size, -along.x / size}});
    }

    /// Cut line and grain, when sides are known.
    void finish_piece(PatternPiece& piece) const {
        Polygon ring;
        std::vector<double> away;
        for (const PatternSide& side : piece.sides)
            for (std::size_t i = 0; i + 1 < side.line.size(); ++i) {
                ring.push_back(side.line[i]);
                away.push_back(allowance_of(side));
            }
        piece.cut_line = moved_outward(ring, away);
        piece.grain = grain_in(ring);
    }

    /// A hole is faced, not turned in: it gets no more than a seam.
    [[nodiscard]] double allowance_of(const PatternSide& side) const {
        if (side.kind == PatternSide::Kind::Fold) return 0.0;
        const bool hem = side.kind == PatternSide::Kind::Hem && !side.name.ends_with(" hole");
        return hem ? options_.hem_allowance_cm : options_.seam_allowance_cm;
    }

    /// In the middle of the longest of some upright chords.
    [[nodiscard]] static std::array<Point, 2> grain_in(const Polygon& ring) {
        double low = ring[0].x, high = ring[0].x;
        for (const Point p : ring) low = std::min(low, p.x), high = std::max(high, p.x);
        std::array<Point, 2> best{};
        double most = 0.0;
        for (int k = 1; k < 12; ++k) {
            const double x = low + (high - low) * (k + 0.013) / 12.0;
            std::vector<double> ys;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point a = ring[i], b = ring[(i + 1) % ring.size()];
                if ((a.x < x) != (b.x < x)) ys.push_back(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
            }
            std::sort(ys.begin(), ys.end());
            for (std::size_t i = 0; i + 1 < ys.size(); i += 2) {
                // chords near the middle are preferred
                const double size = (ys[i + 1] - ys[i]) * (1.0 - 0.04 * std::abs(k - 6));
                if (size <= most) continue;
                most = size;
                const double half = 0.5 * std::min(0.6 * (ys[i + 1] - ys[i]), kLongestGrain_cm);
                const double middle = 0.5 * (ys[i] + ys[i + 1]);
                best = {Point{x, middle - half}, Point{x, middle + half}};
            }
        }
        return best;
    }

    const Garment& garment_;
    const PatternOptions& options_;
    Pattern& pattern_;
    std::multimap<EdgeKey, std::size_t> edges_;
    std::vector<int> made_;                        // of each piece of the cloth: its piece of the pattern, or -1
    std::vector<std::vector<Stretch>> stretches_;  // of the layer's pieces of the pattern
    std::size_t first_of_layer_ = 0;
};

}  // namespace

double PatternSeam::mismatch() const {
    return std::abs(length_a_cm - length_b_cm) / std::max({length_a_cm, length_b_cm, 1e-12});
}

double line_length_cm(const std::vector<Point>& line) {
    double sum = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
    return sum;
}

Result<Pattern> make_pattern(const Design& design, const Garment& garment, const PatternOptions& options) {
    for (const double allowance : {options.seam_allowance_cm, options.hem_allowance_cm})
        if (!(allowance >= 0.0 && allowance <= kMostAllowance_cm))
            return unexpected(ErrorCode::BadArgument, "An allowance must lie between 0 and 10 cm.");
    if (options.curve_steps < 1 || options.curve_steps > 32)
        return unexpected(ErrorCode::BadArgument, "Curves can be drawn with 1 to 32 steps an edge.");
    Pattern pattern;
    pattern.name = design.name;
    PatternMaker maker(garment, options, pattern);
    for (std::size_t layer = 0; layer < garment.layers.size(); ++layer) maker.add_layer(layer);
    if (pattern.pieces.empty())
        return unexpected(ErrorCode::BadArgument, "The garment has no piece that can be laid flat.");
    return pattern;
}

}  // namespace core
