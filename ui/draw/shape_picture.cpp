#include "ui/draw/shape_picture.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "core/geometry/polygon.hpp"
#include "ui/draw/tag_place.hpp"

namespace ui {

namespace {

using core::Point;
using core::Polygon;
using core::Rgb;

constexpr Rgb kInk{0x1E, 0x1B, 0x18};
constexpr Rgb kMuted{0x6A, 0x62, 0x59};
constexpr Rgb kSheet{0xFF, 0xFD, 0xF8};
constexpr Rgb kClay{0xD8, 0xCF, 0xBF};
constexpr Rgb kTerminal{0x75, 0xA7, 0xE0};
constexpr Rgb kSleeve{0x8F, 0xC9, 0x8A};
constexpr Rgb kJunction{0xE0, 0x7A, 0x66};

struct CairoDeleter {
    void operator()(cairo_t* c) const { cairo_destroy(c); }
    void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
};

/// A page of paper to draw on.
class Page {
  public:
    Page(int width, int height)
        : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
          cairo_(cairo_create(surface_.get())) {
        colour(kSheet);
        cairo_paint(cairo_.get());
        cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_ROUND);
        cairo_select_font_face(cairo_.get(), "Inter", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    }
    [[nodiscard]] cairo_t* get() const { return cairo_.get(); }
    void colour(Rgb c, double alpha = 1.0) const {
        cairo_set_source_rgba(cairo_.get(), c.r / 255.0, c.g / 255.0, c.b / 255.0, alpha);
    }
    void text(double x, double y, double size, Rgb c, const std::string& words) const {
        colour(c);
        cairo_set_font_size(cairo_.get(), size);
        cairo_move_to(cairo_.get(), x, y);
        cairo_show_text(cairo_.get(), words.c_str());
    }
    [[nodiscard]] core::Result<void> write(const std::string& path) const {
        if (cairo_surface_write_to_png(surface_.get(), path.c_str()) != CAIRO_STATUS_SUCCESS) {
            return core::unexpected(core::ErrorCode::WriteFailed,
                                    "the picture could not be written; check the folder and the free space", path);
        }
        return {};
    }

  private:
    std::unique_ptr<cairo_surface_t, CairoDeleter> surface_;
    std::unique_ptr<cairo_t, CairoDeleter> cairo_;
};

/// Draws in the coordinates of one shape, fitted into a square panel, y up.
class Panel {
  public:
    Panel(const Page& page, const Polygon& outline, double x, double y, double size) : page_(page), outline_(outline) {
        Point low = outline.front(), high = outline.front();
        for (const Point& p : outline) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        scale_ = size * 0.88 / std::max({high.x - low.x, high.y - low.y, 1e-9});
        offset_ = {x + size / 2.0 - scale_ * (low.x + high.x) / 2.0, y + size / 2.0 + scale_ * (low.y + high.y) / 2.0};
    }

    [[nodiscard]] Point at(Point p) const { return {offset_.x + scale_ * p.x, offset_.y - scale_ * p.y}; }

    void fill(const Polygon& ring, Rgb c, double alpha = 1.0) const {
        path(ring, true);
        page_.colour(c, alpha);
        cairo_fill(page_.get());
    }
    void stroke(const Polygon& ring, Rgb c, double width, bool closed = true, double alpha = 1.0) const {
        path(ring, closed);
        page_.colour(c, alpha);
        cairo_set_line_width(page_.get(), width);
        cairo_stroke(page_.get());
    }
    void line(Point a, Point b, Rgb c, double width) const { stroke({a, b}, c, width, false); }
    void dot(Point p, double radius, Rgb c) const {
        const Point q = at(p);
        cairo_new_path(page_.get());
        cairo_arc(page_.get(), q.x, q.y, radius, 0.0, 6.2831853);
        page_.colour(c);
        cairo_fill(page_.get());
    }
    /// A number on a disc.
    void tag(Point p, int number, Rgb c) const {
        const Point q = at(p);
        cairo_new_path(page_.get());
        cairo_arc(page_.get(), q.x, q.y, 10.0, 0.0, 6.2831853);
        page_.colour(c);
        cairo_fill_preserve(page_.get());
        page_.colour(kSheet);
        cairo_set_line_width(page_.get(), 1.5);
        cairo_stroke(page_.get());
        const bool dark = 0.299 * c.r + 0.587 * c.g + 0.114 * c.b < 120.0;
        const std::string words = std::to_string(number);
        page_.text(q.x - 3.6 * static_cast<double>(words.size()), q.y + 4.6, 13.0, dark ? kSheet : kInk, words);
    }
    [[nodiscard]] const Polygon& outline() const { return outline_; }

  private:
    void path(const Polygon& ring, bool closed) const {
        bool first = true;
        for (const Point& p : ring) {
            const Point q = at(p);
            (first ? cairo_move_to : cairo_line_to)(page_.get(), q.x, q.y);
            first = false;
        }
        if (closed) cairo_close_path(page_.get());
    }
    const Page& page_;
    const Polygon& outline_;
    double scale_ = 1.0;
    Point offset_;
};

Rgb colour_of(core::PieceKind kind) {
    return kind == core::PieceKind::Terminal ? kTerminal : kind == core::PieceKind::Sleeve ? kSleeve : kJunction;
}

Polygon triangle_of(const core::Skeleton& s, const core::Triangle& t) {
    Polygon corners;
    for (const int v : t.vertices) corners.push_back(s.samples[static_cast<std::size_t>(v)]);
    return corners;
}

Polygon ring_of(const core::ShapeDescriptor& d, const core::Part& part) {
    const int n = static_cast<int>(d.samples.size());
    Polygon ring;
    int i = part.start_sample;
    do {
        ring.push_back(d.samples[static_cast<std::size_t>(i)]);
        i = (i + 1) % n;
    } while (i != part.end_sample);
    if (part.end_sample != part.start_sample) ring.push_back(d.samples[static_cast<std::size_t>(part.end_sample)]);
    return ring;
}

void draw_sampling(const Panel& panel, const core::Skeleton& s) {
    panel.fill(s.contour, kClay, 0.6);
    panel.stroke(s.contour, kMuted, 1.0);
    for (const Point& p : s.samples) panel.dot(p, 2.0, kInk);
    for (const int c : s.corners) panel.dot(s.contour[static_cast<std::size_t>(c)], 4.0, {0xA8, 0x37, 0x1C});
}

void draw_triangles(const Panel& panel, const core::Skeleton& s) {
    for (const core::Triangle& t : s.triangulation.triangles) {
        const core::TriangleRole role = t.role();
        const Rgb c = role == core::TriangleRole::Terminal ? kTerminal
                      : role == core::TriangleRole::Sleeve ? kSleeve
                                                           : kJunction;
        panel.fill(triangle_of(s, t), c, 0.8);
        panel.stroke(triangle_of(s, t), kSheet, 0.8);
    }
    panel.stroke(s.samples, kInk, 1.2);
}

void draw_chords(const Panel& panel, const core::Skeleton& s) {
    panel.fill(s.samples, kClay, 0.4);
    const auto chord = [&](std::size_t i, Rgb c, double width) {
        const core::Chord& ends = s.triangulation.chords[i];
        panel.line(s.samples[static_cast<std::size_t>(ends.u)], s.samples[static_cast<std::size_t>(ends.v)], c, width);
    };
    for (std::size_t i = 0; i < s.triangulation.chords.size(); ++i) chord(i, {0xC8, 0xBE, 0xAE}, 0.6);
    for (std::size_t i = 0; i < s.triangulation.chords.size(); ++i) {
        if (s.profile.by_half_disk[i] != 0) chord(i, {0x2A, 0x5B, 0xD0}, 4.5);
        if (s.profile.by_compactness[i] != 0) chord(i, {0x2E, 0x9B, 0x4F}, 3.0);
        if (s.profile.by_strength[i] != 0) chord(i, {0xC8, 0x2A, 0x20}, 1.6);
    }
    panel.stroke(s.samples, kInk, 1.2);
}

void draw_pieces(const Panel& panel, const core::Skeleton& s, const core::Segmentation& pieces,
                 const core::CatGraph* graph) {
    for (const core::Piece& piece : pieces.pieces) {
        for (const int t : piece.triangles) {
            const Polygon corners = triangle_of(s, s.triangulation.triangles[static_cast<std::size_t>(t)]);
            panel.fill(corners, colour_of(piece.kind()), 0.8);
            panel.stroke(corners, colour_of(piece.kind()), 0.6);
        }
    }
    for (std::size_t i = 0; i < pieces.cuts.size(); ++i) {
        const core::Chord& c = s.triangulation.chords[i];
        if (pieces.cuts[i] != 0) {
            panel.line(s.samples[static_cast<std::size_t>(c.u)], s.samples[static_cast<std::size_t>(c.v)], kSheet, 1.6);
        }
    }
    panel.stroke(s.samples, kInk, 1.2);
    if (graph == nullptr) return;
    for (const core::SkeletalSegment& segment : graph->skeleton) panel.line(segment.from, segment.to, kInk, 2.2);
}

void draw_depth(const Panel& panel, const core::DescribedShape& shape) {
    const core::Skeleton& s = shape.skeleton;
    draw_pieces(panel, s, s.pieces, nullptr);
    for (std::size_t i = 0; i < s.graph.nodes.size(); ++i) {
        const int parent = shape.tree.parent[i];
        if (parent < 0) continue;
        panel.line(s.graph.nodes[i].centroid, s.graph.nodes[static_cast<std::size_t>(parent)].centroid, kInk, 1.8);
    }
    for (std::size_t i = 0; i < s.graph.nodes.size(); ++i) {
        panel.tag(s.graph.nodes[i].centroid, std::max(0, shape.tree.depth[i]), colour_of(s.graph.nodes[i].kind));
    }
}

void draw_terminals(const Panel& panel, const core::ShapeDescriptor& d) {
    panel.fill(d.samples, kClay, 0.5);
    panel.stroke(d.samples, kInk, 1.2);
    for (int t = 0; t < d.terminal_count; ++t) {
        const core::Part& part = d.parts[static_cast<std::size_t>(t)];
        const Rgb c = kPartColours[static_cast<std::size_t>(t) % kPartColours.size()];
        panel.fill(ring_of(d, part), c, 0.85);
        panel.stroke(ring_of(d, part), kInk, part.salient ? 2.2 : 0.8);
    }
    for (int t = 0; t < d.terminal_count; ++t) {
        panel.tag(tag_place(ring_of(d, d.parts[static_cast<std::size_t>(t)])), t,
                  kPartColours[static_cast<std::size_t>(t) % kPartColours.size()]);
    }
}

void draw_wings(const Panel& panel, const core::ShapeDescriptor& d) {
    panel.fill(d.samples, kClay, 0.5);
    std::vector<std::size_t> order;
    for (std::size_t i = static_cast<std::size_t>(d.terminal_count); i < d.parts.size(); ++i) order.push_back(i);
    const auto area = [&d](std::size_t i) {
        return d.parts[i].features[static_cast<std::size_t>(core::Feature::Area)];
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return area(a) > area(b); });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Polygon ring = ring_of(d, d.parts[order[k]]);
        panel.fill(ring, kPartColours[k % kPartColours.size()], 0.45);
        panel.line(ring.front(), ring.back(), kInk, 2.0);
    }
    panel.stroke(d.samples, kInk, 1.2);
}

constexpr double kPanel = 360.0;
constexpr double kHead = 30.0;

}  // namespace

core::Result<void> write_description_picture(const core::DescribedShape& shape, const std::string& title,
                                             const std::string& path) {
    const core::Skeleton& s = shape.skeleton;
    constexpr int kColumns = 4;
    const std::array<std::string, 8> names{"Corners and samples",
                                           "Terminal, sleeve, junction triangles",
                                           "Chord profile",
                                           "Polygons",
                                           "Significant, skeleton",
                                           "Depth and tree",
                                           "Terminals (bold: salient)",
                                           "Wings"};
    const Page page(static_cast<int>(kColumns * kPanel), static_cast<int>(2.0 * (kPanel + kHead) + 40.0));
    page.text(16.0, 28.0, 20.0, kInk, title);
    for (int k = 0; k < 8; ++k) {
        const int column = k % kColumns, row = k / kColumns;
        const double x = column * kPanel, y = 40.0 + row * (kPanel + kHead);
        page.text(x + 16.0, y + 20.0, 15.0, kMuted, names[static_cast<std::size_t>(k)]);
        const Panel panel(page, s.samples, x, y + kHead, kPanel);
        switch (k) {
            case 0:
                draw_sampling(panel, s);
                break;
            case 1:
                draw_triangles(panel, s);
                break;
            case 2:
                draw_chords(panel, s);
                break;
            case 3:
                draw_pieces(panel, s, s.csp_pieces, nullptr);
                break;
            case 4:
                draw_pieces(panel, s, s.pieces, &s.graph);
                break;
            case 5:
                draw_depth(panel, shape);
                break;
            case 6:
                draw_terminals(panel, shape.descriptor);
                break;
            default:
                draw_wings(panel, shape.descriptor);
                break;
        }
    }
    return page.write(path);
}

namespace {

/// The largest part with the terminals of this one: the whole limb, where a tip was matched.
const core::Part& limb_of(const core::ShapeDescriptor& d, const core::Part& part) {
    const auto area = [](const core::Part& p) { return p.features[static_cast<std::size_t>(core::Feature::Area)]; };
    const core::Part* limb = &part;
    for (const core::Part& other : d.parts) {
        const bool same = other.first_terminal == part.first_terminal && other.terminal_count == part.terminal_count;
        if (same && area(other) > area(*limb)) limb = &other;
    }
    return *limb;
}

/// Matched parts in one colour per pair, larger pairs first; paler what else belongs to their limbs.
void draw_matched(const Panel& panel, const core::ShapeDescriptor& d, const core::Match& match, bool side_b) {
    panel.fill(d.samples, kClay, 0.8);
    const auto part_of = [&](const core::MatchedPair& p) -> const core::Part& {
        return d.parts[static_cast<std::size_t>(side_b ? p.part_b : p.part_a)];
    };
    for (std::size_t k = 0; k < match.pairs.size(); ++k) {
        panel.fill(ring_of(d, limb_of(d, part_of(match.pairs[k]))), kPartColours[k % kPartColours.size()], 0.4);
    }
    for (std::size_t k = 0; k < match.pairs.size(); ++k) {
        panel.fill(ring_of(d, part_of(match.pairs[k])), kPartColours[k % kPartColours.size()], 0.9);
    }
    panel.stroke(d.samples, kInk, 1.6);
    for (std::size_t k = 0; k < match.pairs.size(); ++k) {
        panel.tag(tag_place(ring_of(d, part_of(match.pairs[k]))), static_cast<int>(k) + 1,
                  kPartColours[k % kPartColours.size()]);
    }
}

}  // namespace

core::Result<void> write_match_picture(const std::vector<MatchPictureItem>& items, const std::string& path) {
    const int columns = items.size() > 1 ? 2 : 1;
    const int rows = (static_cast<int>(items.size()) + columns - 1) / columns;
    constexpr double kSize = 300.0;
    const Page page(static_cast<int>(columns * (2.0 * kSize + 20.0)), static_cast<int>(rows * (kSize + kHead)));
    for (std::size_t i = 0; i < items.size(); ++i) {
        const MatchPictureItem& item = items[i];
        const double x = static_cast<double>(i % static_cast<std::size_t>(columns)) * (2.0 * kSize + 20.0);
        const std::size_t row = i / static_cast<std::size_t>(columns);
        const double y = static_cast<double>(row) * (kSize + kHead);
        char words[64];
        std::snprintf(words, sizeof words, "   %.1f%s", item.match->distance, item.match->reversed ? ", mirrored" : "");
        page.text(x + 12.0, y + 20.0, 14.0, kMuted, item.title_a + "  and  " + item.title_b + words);
        draw_matched(Panel(page, item.a->samples, x, y + kHead, kSize), *item.a, *item.match, false);
        draw_matched(Panel(page, item.b->samples, x + kSize, y + kHead, kSize), *item.b, *item.match, true);
    }
    return page.write(path);
}

namespace {

/// One shape's ring of parts as a disk.
class RingDisk {
  public:
    RingDisk(const Page& page, const core::ShapeDescriptor& d, const core::Match& match, bool side_b, Point centre)
        : page_(page), descriptor_(d), match_(match), side_b_(side_b), centre_(centre) {
        clockwise_ = side_b && match.reversed;
        if (match.pairs.empty()) return;
        const core::Part& first = part_of(0);
        start_ = clockwise_ ? first.first_terminal + first.terminal_count - 1 : first.first_terminal;
    }

    void draw(const std::vector<std::string>& names) const {
        for (int t = 0; t < descriptor_.terminal_count; ++t) {
            sector({t, 1}, kInner, kRim, kClay, 0.8);
            if (static_cast<std::size_t>(t) < names.size()) name(t, names[static_cast<std::size_t>(t)]);
        }
        draw_wings();
        for (std::size_t k = 0; k < match_.pairs.size(); ++k) draw_pair(k);
    }

  private:
    static constexpr double kRim = 104.0, kInner = 74.0, kStep = 17.0, kGap = 3.0;  // pixels
    static constexpr int kMostLayers = 3;

    /// A run of terminals.
    struct Run {
        int first = 0, count = 1;
    };

    [[nodiscard]] const core::Part& part_of(std::size_t pair) const {
        const core::MatchedPair& p = match_.pairs[pair];
        return descriptor_.parts[static_cast<std::size_t>(side_b_ ? p.part_b : p.part_a)];
    }

    /// Turns from the top, anti-clockwise, at which a run starts.
    [[nodiscard]] double turn_of(Run run) const {
        const int n = descriptor_.terminal_count;
        const int place = clockwise_ ? start_ - (run.first + run.count - 1) : run.first - start_;
        return static_cast<double>((place % n + n) % n) / n;
    }
    [[nodiscard]] Point at(double turn, double radius) const {
        const double angle = turn * 2.0 * 3.14159265358979323846;
        return centre_ - Point{std::sin(angle), std::cos(angle)} * radius;
    }

    void sector(Run run, double inner, double outer, Rgb colour, double alpha) const {
        constexpr int kSteps = 24;
        const double from = turn_of(run), width = static_cast<double>(run.count) / descriptor_.terminal_count;
        for (int k = 0; k <= 2 * kSteps + 1; ++k) {
            const bool out = k <= kSteps;
            const Point p = at(from + width * (out ? k : 2 * kSteps + 1 - k) / kSteps, out ? outer : inner);
            (k == 0 ? cairo_move_to : cairo_line_to)(page_.get(), p.x, p.y);
        }
        cairo_close_path(page_.get());
        page_.colour(colour, alpha);
        cairo_fill_preserve(page_.get());
        page_.colour(kSheet);
        cairo_set_line_width(page_.get(), 1.6);
        cairo_stroke(page_.get());
    }

    /// Wings that group terminals, the smallest nearest the rim; those that would overlap lie further in.
    void draw_wings() const {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < descriptor_.parts.size(); ++i) {
            if (descriptor_.parts[i].terminal_count > 1) order.push_back(i);
        }
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return descriptor_.parts[a].terminal_count < descriptor_.parts[b].terminal_count;
        });
        std::vector<std::vector<char>> taken;
        for (const std::size_t i : order) {
            const core::Part& wing = descriptor_.parts[i];
            const auto is_free = [&](const std::vector<char>& layer) {
                for (int k = 0; k < wing.terminal_count; ++k) {
                    if (layer[terminal(wing, k)] != 0) return false;
                }
                return true;
            };
            std::size_t layer = 0;
            while (layer < taken.size() && !is_free(taken[layer])) ++layer;
            if (layer == kMostLayers) continue;
            if (layer == taken.size()) taken.emplace_back(descriptor_.terminal_count, 0);
            for (int k = 0; k < wing.terminal_count; ++k) taken[layer][terminal(wing, k)] = 1;
            const double outer = kInner - kGap - static_cast<double>(layer) * kStep;
            const std::size_t pair = pair_of(wing);
            const bool matched = pair < match_.pairs.size();
            sector({wing.first_terminal, wing.terminal_count}, outer - kStep + kGap, outer,
                   matched ? kPartColours[pair % kPartColours.size()] : kClay, matched ? 0.6 : 0.45);
        }
    }
    /// The pair whose part groups the same terminals; past the last one if there is none.
    [[nodiscard]] std::size_t pair_of(const core::Part& wing) const {
        std::size_t k = 0;
        while (k < match_.pairs.size() &&
               (part_of(k).first_terminal != wing.first_terminal || part_of(k).terminal_count != wing.terminal_count))
            ++k;
        return k;
    }
    [[nodiscard]] std::size_t terminal(const core::Part& part, int k) const {
        return static_cast<std::size_t>((part.first_terminal + k) % descriptor_.terminal_count);
    }

    /// The terminals of a matched part, in its colour, as one sector with its number.
    void draw_pair(std::size_t k) const {
        const core::Part& part = part_of(k);
        const Rgb colour = kPartColours[k % kPartColours.size()];
        const Run run{part.first_terminal, part.terminal_count};
        sector(run, kInner, kRim, colour, 0.95);
        const double middle = turn_of(run) + 0.5 * part.terminal_count / descriptor_.terminal_count;
        const Point p = at(middle, 0.5 * (kInner + kRim));
        const bool dark = 0.299 * colour.r + 0.587 * colour.g + 0.114 * colour.b < 120.0;
        centred(p, 14.0, dark ? kSheet : kInk, std::to_string(k + 1));
    }

    void name(int t, const std::string& words) const {
        const double middle = turn_of({t, 1}) + 0.5 / descriptor_.terminal_count;
        cairo_text_extents_t box;
        cairo_set_font_size(page_.get(), 13.0);
        cairo_text_extents(page_.get(), words.c_str(), &box);
        const Point p = at(middle, kRim + 10.0);
        const double aside =
            (p.x - centre_.x) / kRim;  // words start on the right, end on the left, stand on the middle
        page_.text(p.x - box.width * (0.5 - 0.5 * std::clamp(1.6 * aside, -1.0, 1.0)), p.y + 4.5, 13.0, kMuted, words);
    }

    void centred(Point p, double size, Rgb colour, const std::string& words) const {
        cairo_text_extents_t box;
        cairo_set_font_size(page_.get(), size);
        cairo_text_extents(page_.get(), words.c_str(), &box);
        page_.text(p.x - box.width / 2.0 - box.x_bearing, p.y - box.height / 2.0 - box.y_bearing, size, colour, words);
    }

    const Page& page_;
    const core::ShapeDescriptor& descriptor_;
    const core::Match& match_;
    bool side_b_ = false, clockwise_ = false;
    int start_ = 0;
    Point centre_;
};

}  // namespace

core::Result<void> write_ring_picture(const MatchPictureItem& item, const RingNames& names, const std::string& path) {
    constexpr double kSide = 380.0, kDisk = 290.0;
    const Page page(static_cast<int>(2.0 * kSide), static_cast<int>(kHead + kSide * 0.86 + kDisk));
    char words[64];
    std::snprintf(words, sizeof words, "   %.1f%s", item.match->distance, item.match->reversed ? ", mirrored" : "");
    page.text(16.0, 24.0, 15.0, kMuted, item.title_a + "  and  " + item.title_b + words);
    const double top = kHead - 0.07 * kSide;
    draw_matched(Panel(page, item.a->samples, 0.0, top, kSide), *item.a, *item.match, false);
    draw_matched(Panel(page, item.b->samples, kSide, top, kSide), *item.b, *item.match, true);
    const double middle = kHead + kSide * 0.86 + kDisk / 2.0;
    RingDisk(page, *item.a, *item.match, false, {kSide / 2.0, middle}).draw(names.a);
    RingDisk(page, *item.b, *item.match, true, {kSide * 1.5, middle}).draw(names.b);
    return page.write(path);
}

core::Result<void> write_segmentation_sheet(const std::vector<core::DescribedShape>& shapes,
                                            const std::vector<std::string>& titles, int columns,
                                            const std::string& path) {
    constexpr double kSize = 170.0;
    const int rows = (static_cast<int>(shapes.size()) + columns - 1) / columns;
    const Page page(static_cast<int>(columns * kSize), static_cast<int>(rows * (kSize + 18.0)));
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const double x = static_cast<double>(i % static_cast<std::size_t>(columns)) * kSize;
        const std::size_t row = i / static_cast<std::size_t>(columns);
        const double y = static_cast<double>(row) * (kSize + 18.0);
        page.text(x + 6.0, y + 14.0, 11.0, kMuted, titles[i]);
        const core::Skeleton& s = shapes[i].skeleton;
        draw_pieces(Panel(page, s.samples, x, y + 18.0, kSize), s, s.pieces, &s.graph);
    }
    return page.write(path);
}

}  // namespace ui
