#include "core/silhouette/live_silhouette.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "core/silhouette/bit_image.hpp"
#include "core/silhouette/closing_levels.hpp"
#include "core/silhouette/distance_raster.hpp"
#include "core/silhouette/far_off.hpp"

namespace core {
namespace {

constexpr int kLevels = ClosingLevels::kRadii + 1;  // level 0 is ink alone

/// Half the chords of discs, by the distance of their row from the centre.
std::vector<int> chords_of(int radius2) {
    std::vector<int> chords;
    for (int d = 0; d * d <= radius2; ++d) {
        auto half = static_cast<int>(std::sqrt(radius2 - d * d));
        while (half * half > radius2 - d * d) --half;
        while ((half + 1) * (half + 1) <= radius2 - d * d) ++half;
        chords.push_back(half);
    }
    return chords;
}

/// A connected part of the object: what is needed to choose and to join.
struct Piece {
    int area = 0;
    int left = 0, right = 0, top = 0, bottom = 0;
    [[nodiscard]] double diagonal() const {
        return length(Point{static_cast<double>(right - left + 1), static_cast<double>(bottom - top + 1)});
    }
};

struct Bridge {
    RasterPixel from, to;
};

}  // namespace

struct LiveSilhouette::Impl {
    SilhouetteOptions options;
    ClosingLevels closing;
    bool looks_far = true;  ///< false in a raster that is laid out for an object on its own
    std::uint64_t rebuilds = 0;

    // what is followed
    std::vector<std::vector<Point>> strokes;
    Point first;
    Frame frame;
    std::optional<DrawingLayout> layout;
    std::optional<Error> failure;

    // the working raster: pixel (x, y) is grid pixel (x + left, y + top)
    int left = 0, top = 0, width = 0, height = 0;
    GridBox box;  ///< of the samples, on the grid
    DistanceRaster raster;
    std::array<BitImage, kLevels> far;  ///< farther from ink than the level's radius
    std::array<std::vector<int>, kLevels> chords;

    // what is found
    BitImage object, taken, before;
    RunParts parts;
    std::vector<Piece> pieces;
    std::vector<char> wanted;
    std::unique_ptr<LiveSilhouette> near;  ///< the object on its own, where the rest lies far off
    bool uses_near = false;

    explicit Impl(const SilhouetteOptions& o)
        : options(o),
          closing(closing_levels(o, o.ink.diagonal_px * std::exp2(-0.125))),
          width((o.ink.diagonal_px + 2 * (margin_of(closing) + 1) + 63) / 64 * 64),
          height(width),
          raster(width, height, closing.reach) {
        for (BitImage& image : far) image = BitImage(width, height);
        for (int k = 1; k < kLevels; ++k) chords[static_cast<std::size_t>(k)] = chords_of(wall2(k));
        chords[0] = {0};
        object = taken = before = BitImage(width, height);
    }

    /// Free pixels about the samples: for walls, for discs and for distances.
    static int margin_of(const ClosingLevels& c) { return std::max(c.border, c.reach) + 2; }
    [[nodiscard]] int wall2(int level) const {
        return level == 0 ? 0 : closing.levels[static_cast<std::size_t>(level - 1)].wall2;
    }

    // --- following -------------------------------------------------------------------------------------------------

    void follow(const Drawing& drawing) {
        const bool known = is_known(drawing);
        if (!known) forget();
        const bool began = frame.right >= frame.left;
        if (began && !has_news(drawing)) return;
        const Frame all = frame_with_news(drawing);
        const Point start = began ? first : first_of(drawing);
        const Result<DrawingLayout> now = layout_of(start, all, options.ink);
        if (!now) {
            remember(drawing, start, all);
            layout.reset();
            failure = now.error();
            return;
        }
        const bool same = layout && *layout == *now;
        const bool fits = same && fits_raster(drawing);
        first = start;
        frame = all;
        layout = *now;
        failure.reset();
        if (fits) {
            append(drawing);
        } else {
            rebuild(drawing);
        }
        find_object();
        look_far(drawing);
    }

    void forget() {
        strokes.clear();
        frame = {};
        layout.reset();
    }

    static bool same_place(Point a, const PenSample& b) { return a.x == b.x && a.y == b.y; }

    static Point first_of(const Drawing& drawing) {
        for (const Stroke& s : drawing.strokes) {
            if (!s.samples.empty()) return {s.samples[0].x, s.samples[0].y};
        }
        return {};
    }

    /// Whether what is followed is a beginning of this drawing.
    [[nodiscard]] bool is_known(const Drawing& drawing) const {
        if (drawing.strokes.size() < strokes.size()) return false;
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            const std::vector<PenSample>& samples = drawing.strokes[i].samples;
            const bool may_grow = i + 1 == strokes.size();
            if (samples.size() < strokes[i].size() || (!may_grow && samples.size() != strokes[i].size())) return false;
            if (!std::equal(strokes[i].begin(), strokes[i].end(), samples.begin(), same_place)) return false;
        }
        return true;
    }

    /// The number of samples of stroke i that are known.
    [[nodiscard]] std::size_t known_samples(std::size_t i) const { return i < strokes.size() ? strokes[i].size() : 0; }

    [[nodiscard]] bool has_news(const Drawing& drawing) const {
        bool any = false;
        each_new_sample(drawing, [&](const PenSample&, const PenSample&) { any = true; });
        return any;
    }

    [[nodiscard]] Frame frame_with_news(const Drawing& drawing) const {
        Frame all = frame;
        each_new_sample(drawing, [&](const PenSample&, const PenSample& s) {
            if (all.right < all.left) all = {s.x, s.y, s.x, s.y};
            all = {std::min(all.left, s.x), std::min(all.top, s.y), std::max(all.right, s.x),
                   std::max(all.bottom, s.y)};
        });
        return all;
    }

    void remember(const Drawing& drawing, Point start, const Frame& all) {
        first = start;
        frame = all;
        strokes.resize(drawing.strokes.size());
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            for (std::size_t k = strokes[i].size(); k < drawing.strokes[i].samples.size(); ++k) {
                strokes[i].push_back({drawing.strokes[i].samples[k].x, drawing.strokes[i].samples[k].y});
            }
        }
    }

    template <typename Visit>
    void each_new_sample(const Drawing& drawing, Visit visit) const {
        for (std::size_t i = strokes.empty() ? 0 : strokes.size() - 1; i < drawing.strokes.size(); ++i) {
            const std::vector<PenSample>& samples = drawing.strokes[i].samples;
            for (std::size_t k = known_samples(i); k < samples.size(); ++k)
                visit(samples[k > 0 ? k - 1 : 0], samples[k]);
        }
    }

    [[nodiscard]] bool fits_raster(const Drawing& drawing) const {
        GridBox grown = box;
        each_new_sample(drawing, [&](const PenSample&, const PenSample& s) { grown.take(layout->place(s)); });
        const int margin = margin_of(closing);
        return grown.left - left >= margin && grown.top - top >= margin && grown.right - left < width - margin &&
               grown.bottom - top < height - margin;
    }

    void append(const Drawing& drawing) {
        each_new_sample(drawing, [&](const PenSample& from, const PenSample& to) {
            box.take(layout->place(to));
            draw(layout->place(from), layout->place(to));
        });
        remember(drawing, first, frame);
        for (const RasterPixel p : raster.settle()) clear_about(p);
    }

    void rebuild(const Drawing& drawing) {
        ++rebuilds;
        strokes.clear();
        box = box_of(drawing, *layout);
        left = (box.left + box.right) / 2 - width / 2;
        top = (box.top + box.bottom) / 2 - height / 2;
        raster.clear();
        each_new_sample(
            drawing, [&](const PenSample& from, const PenSample& to) { draw(layout->place(from), layout->place(to)); });
        remember(drawing, first, frame);
        raster.settle_all();
        for (int k = 0; k < kLevels; ++k) raster.farther_than(wall2(k), far[static_cast<std::size_t>(k)]);
    }

    void draw(FixedPoint a, FixedPoint b) {
        each_capsule_run(a, b, closing.half, [&](int y, int x0, int x1) { raster.ink(y - top, x0 - left, x1 - left); });
    }

    void clear_about(RasterPixel p) {
        for (std::size_t k = 0; k < far.size(); ++k) {
            const std::vector<int>& chord = chords[k];
            far[k].clear_run(p.y, p.x - chord[0], p.x + chord[0]);
            for (int d = 1; d < static_cast<int>(chord.size()); ++d) {
                const int half = chord[static_cast<std::size_t>(d)];
                far[k].clear_run(p.y - d, p.x - half, p.x + half);
                far[k].clear_run(p.y + d, p.x - half, p.x + half);
            }
        }
    }

    // --- finding ---------------------------------------------------------------------------------------------------

    /// Rows that can hold anything but outside.
    [[nodiscard]] int first_row() const { return std::max(box.top - top - margin_of(closing), 0); }
    [[nodiscard]] int last_row() const { return std::min(box.bottom - top + margin_of(closing), height - 1); }

    void find_object() {
        object.fill(false);
        taken.fill(false);
        for (int y = first_row(); y <= last_row(); ++y) {
            for (int w = 0; w < object.words(); ++w) object.row(y)[w] = ~far[0].row(y)[w];
        }
        for (int level = 0; level < kLevels; ++level) fill_enclosed(level);
        fill_holes();
        join_pieces();
    }

    /// Fills what is enclosed at this level and was not at a lower one.
    void fill_enclosed(int level) {
        const BitImage& open = far[static_cast<std::size_t>(level)];
        parts.find(open, true, RunParts::Joined::BySides, first_row(), last_row());
        if (parts.count() < 2) return;
        // Part 0 is the outside: the first row is free.
        wanted.assign(static_cast<std::size_t>(parts.count()), level == 0 ? 1 : 0);
        wanted[0] = 0;
        if (level > 0) find_roomy(closing.levels[static_cast<std::size_t>(level - 1)].room2);
        for (const BitRun& run : parts.runs()) {
            if (wanted[static_cast<std::size_t>(run.part)] == 0) continue;
            taken.set_run(run.y, run.x0, run.x1);
            set_about(run, chords[static_cast<std::size_t>(level)]);
        }
    }

    /// Wants the parts that no lower level took and that hold a pixel as far from ink as is asked.
    void find_roomy(int room2) {
        for (const BitRun& run : parts.runs()) {
            char& want = wanted[static_cast<std::size_t>(run.part)];
            if (run.part == 0 || want != 0 || taken.at(run.x0, run.y)) continue;
            want = raster.any_at_least(run.y, run.x0, run.x1, room2) ? 1 : 0;
        }
    }

    void set_about(const BitRun& run, const std::vector<int>& chord) {
        object.set_run(run.y, run.x0 - chord[0], run.x1 + chord[0]);
        for (int d = 1; d < static_cast<int>(chord.size()); ++d) {
            const int half = chord[static_cast<std::size_t>(d)];
            object.set_run(run.y - d, run.x0 - half, run.x1 + half);
            object.set_run(run.y + d, run.x0 - half, run.x1 + half);
        }
    }

    void fill_holes() {
        parts.find(object, false, RunParts::Joined::BySides, first_row(), last_row());
        if (parts.count() < 2) return;
        for (const BitRun& run : parts.runs()) {
            if (run.part != 0) object.set_run(run.y, run.x0, run.x1);
        }
    }

    // --- pieces ----------------------------------------------------------------------------------------------------

    void measure_pieces() {
        parts.find(object, true, RunParts::Joined::ByCorners, first_row(), last_row());
        pieces.assign(static_cast<std::size_t>(parts.count()), {});
        for (const BitRun& run : parts.runs()) {
            Piece& p = pieces[static_cast<std::size_t>(run.part)];
            if (p.area == 0) p = {0, run.x0, run.x1, run.y, run.y};
            p.area += run.x1 - run.x0 + 1;
            p.left = std::min(p.left, run.x0);
            p.right = std::max(p.right, run.x1);
            p.bottom = run.y;
        }
    }

    /// The largest piece, and every other piece that is no stray mark and lies near it or near one already joined.
    void join_pieces() {
        measure_pieces();
        if (pieces.size() < 2) return;
        const auto largest =
            static_cast<int>(std::max_element(pieces.begin(), pieces.end(),
                                              [](const Piece& a, const Piece& b) { return a.area < b.area; }) -
                             pieces.begin());
        std::vector<int> waiting;
        for (int p = 0; p < static_cast<int>(pieces.size()); ++p) {
            if (p != largest && pieces[static_cast<std::size_t>(p)].diagonal() >= closing.stray) waiting.push_back(p);
        }
        object.fill(false);
        add_piece(largest);
        for (bool grown = true; grown && !waiting.empty();) {
            grown = false;
            before = object;
            std::erase_if(waiting, [&](int piece) {
                const std::optional<Bridge> bridge = nearest(piece);
                if (!bridge) return false;
                draw_bridge(*bridge);
                add_piece(piece);
                return grown = true;
            });
        }
        fill_holes();
    }

    void add_piece(int piece) {
        for (const BitRun& run : parts.runs()) {
            if (run.part == piece) object.set_run(run.y, run.x0, run.x1);
        }
    }

    void draw_bridge(const Bridge& bridge) {
        each_capsule_run({bridge.from.x * kSubpixels, bridge.from.y * kSubpixels},
                         {bridge.to.x * kSubpixels, bridge.to.y * kSubpixels}, closing.half,
                         [&](int y, int x0, int x1) { object.set_run(y, x0, x1); });
    }

    /// Where the piece is nearest to the object as it was: see nearest() in closing.cpp, which this equals.
    [[nodiscard]] std::optional<Bridge> nearest(int piece) const {
        int best2 = closing.join2 + 1;
        std::optional<Bridge> best;
        const auto reach = static_cast<int>(std::sqrt(closing.join2));
        for (const BitRun& run : parts.runs()) {
            if (run.part != piece || !anything_about(run, reach)) continue;
            for (int x = run.x0; x <= run.x1; ++x) look_about(x, run.y, reach, best2, best);
        }
        return best;
    }

    /// Whether the object as it was has a pixel within `reach` rows and columns of the run.
    [[nodiscard]] bool anything_about(const BitRun& run, int reach) const {
        const int from = std::max(run.x0 - reach, 0) / 64, to = std::min(run.x1 + reach, width - 1) / 64;
        for (int y = std::max(run.y - reach, 0); y <= std::min(run.y + reach, height - 1); ++y) {
            for (int w = from; w <= to; ++w) {
                if (before.row(y)[w] != 0) return true;
            }
        }
        return false;
    }

    void look_about(int x, int y, int reach, int& best2, std::optional<Bridge>& best) const {
        for (int dy = -reach; dy <= reach; ++dy) {
            if (dy * dy >= best2) continue;
            const int v = y + dy;
            if (v < 0 || v >= height) continue;
            const int from = std::max(x - reach, 0), to = std::min(x + reach, width - 1);
            const std::uint64_t* row = before.row(v);
            if ((row[from / 64] | row[to / 64]) == 0) continue;  // reach is below 32
            for (int u = from; u <= to; ++u) {
                if (!before.at(u, v)) continue;
                const int dx = u - x, d2 = dx * dx + dy * dy;
                if (d2 >= best2) continue;
                best2 = d2;
                best = Bridge{{x, y}, {u, v}};
            }
        }
    }

    // --- far off ---------------------------------------------------------------------------------------------------

    [[nodiscard]] GridBox box_of_object() const {
        GridBox out;
        for (int y = first_row(); y <= last_row(); ++y) {
            for (int w = 0; w < object.words(); ++w) {
                const std::uint64_t word = object.row(y)[w];
                if (word == 0) continue;
                const int x0 = 64 * w + std::countr_zero(word) + left, x1 = 64 * w + 63 - std::countl_zero(word) + left;
                if (out.empty()) out = {x0, y + top, x1, y + top};
                out = {std::min(out.left, x0), out.top, std::max(out.right, x1), y + top};
            }
        }
        return out;
    }

    void look_far(const Drawing& drawing) {
        uses_near = false;
        if (!looks_far) return;
        const GridBox box_now = box_of_object();
        if (!rest_is_far_off(box_now, box)) return;
        const Drawing part = part_within(drawing, *layout, box_now);
        if (!near) {
            near = std::make_unique<LiveSilhouette>(options);
            near->impl_->looks_far = false;
        }
        near->follow(part);
        uses_near = near->impl_->layout.has_value();
    }

    // --- giving ----------------------------------------------------------------------------------------------------

    [[nodiscard]] Result<Silhouette> silhouette() const {
        if (failure) return unexpected(*failure);
        if (!layout) return unexpected(layout_of(Point{}, Frame{}, options.ink).error());  // nothing drawn
        if (uses_near) return near->silhouette();
        const int x0 = box.left - closing.border, y0 = box.top - closing.border;
        Silhouette out;
        out.image = BinaryImage(box.right + closing.border - x0 + 1, box.bottom + closing.border - y0 + 1);
        out.raster = {layout->scale,
                      Point{-layout->origin.x * layout->scale - x0, -layout->origin.y * layout->scale - y0}};
        for (int y = 0; y < out.image.height; ++y) {
            object.copy_bytes(y + y0 - top, x0 - left, out.image.width, &out.image.at(0, y));
        }
        return out;
    }
};

LiveSilhouette::LiveSilhouette(const SilhouetteOptions& options) : impl_(std::make_unique<Impl>(options)) {}
LiveSilhouette::~LiveSilhouette() = default;
LiveSilhouette::LiveSilhouette(LiveSilhouette&&) noexcept = default;
LiveSilhouette& LiveSilhouette::operator=(LiveSilhouette&&) noexcept = default;

void LiveSilhouette::follow(const Drawing& drawing) {
    impl_->follow(drawing);
}

Result<Silhouette> LiveSilhouette::silhouette() const {
    return impl_->silhouette();
}

std::uint64_t LiveSilhouette::rebuilds() const {
    return impl_->rebuilds + (impl_->near ? impl_->near->rebuilds() : 0);
}

}  // namespace core
