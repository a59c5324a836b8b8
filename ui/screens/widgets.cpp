#include "ui/screens/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace ui {
namespace {

constexpr double kLeastText_px = 16, kLeastTarget_px = 64;
const Rect kEverywhere{0, 0, 1e6, 1e6};

}  // namespace

ScreenScale ScreenScale::of(SizePx screen) {
    ScreenScale s;
    s.screen = screen;
    s.upright = screen.height > screen.width;
    const double w = s.upright ? 1080 : 1920, h = s.upright ? 1920 : 1080;
    s.scale = std::min(screen.width / w, screen.height / h);
    return s;
}

double ScreenScale::px(double design) const {
    return std::round(design * scale);
}

double ScreenScale::target(double design) const {
    return std::max(px(design), std::min(design, kLeastTarget_px));
}

TextStyle ScreenScale::text(Face face, double design, double tracking) const {
    return {face, std::max(design * scale, std::min(design, kLeastText_px)), tracking};
}

std::string filled_in(std::string words, const std::vector<std::pair<std::string, std::string>>& values) {
    for (const auto& [name, value] : values) {
        const std::string braced = "{" + name + "}";
        for (std::size_t at = words.find(braced); at != std::string::npos; at = words.find(braced, at + value.size())) {
            words.replace(at, braced.size(), value);
        }
    }
    return words;
}

std::string number_in(const Strings& words, std::int64_t number) {
    std::string digits = std::to_string(number);
    const std::size_t first = digits[0] == '-' ? 1 : 0;
    for (std::size_t at = digits.size(); at > first + 3;) {
        at -= 3;
        digits.insert(at, words["group"]);
    }
    return digits;
}

std::string tenths_in(const Strings& words, double number) {
    const auto tenths = std::llround(std::abs(number) * 10);
    return (number < 0 && tenths > 0 ? "-" : "") + number_in(words, tenths / 10) + words["decimal"] +
           std::to_string(tenths % 10);
}

double draw_centred_lines(DrawList& list, const FontSet& fonts, const std::string& text, const TextStyle& style,
                          Colour colour, double x, double y, double width, double line_height) {
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        for (const std::string& line : fonts.wrap(text.substr(at, end - at), style, width)) {
            list.text(fonts, line, style, colour, x, y, Align::Centre);
            y += line_height;
        }
        at = end + 1;
    }
    return y;
}

void draw_fitted(DrawList& list, const FontSet& fonts, const std::string& text, TextStyle style, Colour colour,
                 double x, double y, double width, Align align) {
    const double wide = fonts.width_px(text, style);
    if (wide > width && wide > 0) style.size_px *= width / wide;
    list.text(fonts, text, style, colour, x, y, align);
}

void draw_button(DrawList& list, const FontSet& fonts, const Rect& rect, const std::string& words,
                 const TextStyle& style, ButtonKind kind, bool pressed, double line_px, bool on, double fill) {
    const Rect r = pressed ? scaled(rect, 0.97) : rect;
    const float a = on ? 1.0F : palette::kOffShare;
    Colour text = palette::kInk;
    if (kind == ButtonKind::Primary) {
        list.box(r, r.height / 2, (pressed ? palette::kInk.faded(0.82F) : palette::kInk).faded(a));
        text = palette::kSheet;
    } else {
        const bool destructive = kind == ButtonKind::Destructive;
        const Colour edge =
            destructive ? palette::kSanguine : (kind == ButtonKind::Quiet ? palette::kLine : palette::kInk);
        const Colour ground = pressed ? palette::kWell : (kind == ButtonKind::Quiet ? palette::kSheet : palette::kNone);
        list.box(r, r.height / 2, ground.faded(a), edge.faded(a), line_px);
        if (destructive) text = palette::kSanguine;
    }
    if (fill > 0) {  // runs along the edge from the left
        const Rect inner = r.shrunk(line_px * 2);
        list.box({inner.x, inner.bottom() - 3 * line_px, inner.width * std::min(fill, 1.0), 3 * line_px}, 1.5 * line_px,
                 palette::kSanguine);
    }
    draw_fitted(list, fonts, words, style, text.faded(a), r.centre_x(), r.centre_y() + cap_drop(style),
                r.width - style.size_px * 1.2, Align::Centre);
}

std::vector<Rect> switch_segments(const Rect& rect, std::size_t count) {
    std::vector<Rect> segments;
    const double inset = std::round(rect.height / 12), width = (rect.width - 2 * inset) / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
        segments.push_back({rect.x + inset + width * static_cast<double>(i), rect.y, width, rect.height});
    }
    return segments;
}

void draw_switch(DrawList& list, const FontSet& fonts, const Rect& rect, const std::vector<std::string>& words,
                 std::size_t chosen, std::optional<std::size_t> pressed, double size_px) {
    list.box(rect, rect.height / 2, palette::kWell);
    const double inset = std::round(rect.height / 12);
    const std::vector<Rect> segments = switch_segments(rect, words.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
        Rect pill{segments[i].x, rect.y + inset, segments[i].width, rect.height - 2 * inset};
        const bool down = pressed == i;
        if (down) pill = scaled(pill, 0.97);
        if (i == chosen) {
            const double unit = rect.height / 36;
            list.shadow(pill, pill.height / 2, unit, 2.5 * unit, palette::kShade.faded(1.4F));
            list.box(pill, pill.height / 2, palette::kSheet);
        } else if (down) {
            list.box(pill, pill.height / 2, palette::kLine);
        }
        const TextStyle style{i == chosen ? Face::SemiBold : Face::Medium, size_px, 0};
        draw_fitted(list, fonts, words[i], style, i == chosen ? palette::kInk : palette::kMuted, pill.centre_x(),
                    pill.centre_y() + cap_drop(style), pill.width - size_px * 0.6, Align::Centre);
    }
}

void draw_bar(DrawList& list, const Rect& rect, double share, Colour fill, Colour ground) {
    list.box(rect, rect.height / 2, ground);
    if (share <= 0) return;
    list.box({rect.x, rect.y, std::max(rect.height, rect.width * std::min(share, 1.0)), rect.height}, rect.height / 2,
             fill);
}

void draw_arc(DrawList& list, double cx, double cy, double rx, double ry, double from, double to, double line_px,
              Colour colour) {
    const int steps = std::max(2, static_cast<int>(std::abs(to - from) * std::max(rx, ry) / 6));
    std::vector<InkPiece> pieces;
    const auto at = [&](int i) {
        const double angle = from + (to - from) * i / steps;
        return core::Point{cx + rx * std::cos(angle), cy + ry * std::sin(angle)};
    };
    const auto radius = static_cast<float>(line_px / 2);
    for (int i = 0; i < steps; ++i) {
        const core::Point a = at(i), b = at(i + 1);
        pieces.push_back({static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(b.x),
                          static_cast<float>(b.y), radius, radius});
    }
    list.ink(std::move(pieces), colour, kEverywhere);
}

void draw_line(DrawList& list, core::Point a, core::Point b, double line_px, Colour colour) {
    const auto radius = static_cast<float>(line_px / 2);
    list.ink({{static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(b.x), static_cast<float>(b.y),
               radius, radius}},
             colour, kEverywhere);
}

}  // namespace ui
