#include "ui/screens/sheet_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

struct Dashes {
    double on = 0, off = 0;  ///< pixels; off 0: one whole line
};

InkPiece piece(core::Point a, core::Point b, double radius) {
    const auto r = static_cast<float>(radius);
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(b.x), static_cast<float>(b.y), r, r};
}

/// The line in pieces, those of the gaps left out.
std::vector<InkPiece> pieces_of(const core::Polyline& px, double radius, const Dashes& dashes) {
    std::vector<InkPiece> pieces;
    double along = 0;
    for (std::size_t i = 1; i < px.size(); ++i) {
        const double length = core::distance(px[i - 1], px[i]);
        if (length <= 0) continue;
        if (dashes.off <= 0) {
            pieces.push_back(piece(px[i - 1], px[i], radius));
            continue;
        }
        const double period = dashes.on + dashes.off;
        for (double at = 0; at < length;) {
            const double phase = std::fmod(along + at, period);
            const bool on = phase < dashes.on;
            const double step = std::min(length - at, std::max((on ? dashes.on : period) - phase, 0.01));
            const core::Point a = px[i - 1] + (px[i] - px[i - 1]) * (at / length);
            const core::Point b = px[i - 1] + (px[i] - px[i - 1]) * ((at + step) / length);
            if (on) pieces.push_back(piece(a, b, radius));
            at += step;
        }
        along += length;
    }
    return pieces;
}

}  // namespace

void draw_sheet_line(DrawList& list, const SheetLine& line, double scale, const Rect& clip) {
    if (line.px.size() < 2) return;
    const float strength = line.dimmed ? 0.32F : 1.0F;
    const double width = (line.selected ? 8.0 : 4.5) * scale;
    switch (line.kind) {
        case SheetLine::Kind::Body:  // one piece would show where it overlaps the next: the band is opaque
            if (!line.dimmed) list.ink(pieces_of(line.px, 7.5 * scale, {}), Colour::hex(0xDAD3C2), clip);
            [[fallthrough]];
        case SheetLine::Kind::Plane:
            list.ink(pieces_of(line.px, width / 2, {}), line.dimmed ? Colour::hex(0xA9A49C) : palette::kInk, clip);
            break;
        case SheetLine::Kind::Temporary:
            list.ink(pieces_of(line.px, width / 2, {}), line.dimmed ? Colour::hex(0xDDB5AA) : palette::kSanguine, clip);
            break;
        case SheetLine::Kind::Mirrored:
            list.ink(pieces_of(line.px, 1.5 * scale, {4 * scale, 7 * scale}), palette::kMuted.faded(strength), clip);
            break;
        case SheetLine::Kind::Cut:
            list.ink(pieces_of(line.px, 2.25 * scale, {14 * scale, 10 * scale}), palette::kSanguine.faded(strength),
                     clip);
            break;
        case SheetLine::Kind::Seam:  // of cloth that is there: its edge, no more
            if (!line.dimmed) list.ink(pieces_of(line.px, 1.1 * scale, {}), palette::kInk.faded(0.8F), clip);
            break;
        case SheetLine::Kind::Tape:
            list.ink(pieces_of(line.px, 1.75 * scale, {}), line.dimmed ? Colour::hex(0xDDB5AA) : palette::kSanguine,
                     clip);
            break;
    }
}

void draw_convex(DrawList& list, const std::vector<core::Point>& corners, Colour colour, const Rect& clip) {
    if (corners.size() < 3) return;
    // rows of one-pixel boxes would be many commands: capsules three pixels high that overlap by nothing
    double top = 1e9, bottom = -1e9;
    for (const core::Point& p : corners) {
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    top = std::max(top, clip.y);
    bottom = std::min(bottom, clip.bottom());
    for (double y = std::floor(top); y < bottom; y += 1) {
        double left = 1e9, right = -1e9;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const core::Point a = corners[i], b = corners[(i + 1) % corners.size()];
            if ((a.y <= y + 0.5) == (b.y <= y + 0.5)) continue;
            const double x = a.x + (b.x - a.x) * (y + 0.5 - a.y) / (b.y - a.y);
            left = std::min(left, x);
            right = std::max(right, x);
        }
        left = std::max(left, clip.x);
        right = std::min(right, clip.right());
        if (right > left) list.box({left, y, right - left, 1}, 0, colour);
    }
}

void draw_handle(DrawList& list, core::Point at, double scale, bool held) {
    const double side = (held ? 20 : 16) * scale;
    list.box({at.x - side / 2, at.y - side / 2, side, side}, 3 * scale, palette::kSheet, palette::kSanguine, 3 * scale);
}

void draw_open_end(DrawList& list, core::Point at, double scale, const Rect& clip) {
    if (!clip.contains(at.x, at.y)) return;
    const double side = 24 * scale;
    list.box({at.x - side / 2, at.y - side / 2, side, side}, side / 2, palette::kNone, palette::kSanguine, 3 * scale);
}

}  // namespace ui
