#include "ui/draw/damage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ui {
namespace {

constexpr std::size_t kMostRects = 8;
constexpr double kWasteful = 1.25;       // two become one that is at most so much larger than both …
constexpr double kFree_px2 = 64.0 * 64;  // … and this
constexpr double kAbove_em = 1.5, kBelow_em = 0.8, kBeside_em = 1;  // a line's letters, accents included

double area_of(const Rect& r) {
    return r.width * r.height;
}

bool has_size(const Rect& r) {
    return r.width > 0 && r.height > 0;
}

Rect whole(const Rect& r) {
    const double x = std::floor(r.x), y = std::floor(r.y);
    return {x, y, std::ceil(r.right()) - x, std::ceil(r.bottom()) - y};
}

Rect reach(const BoxCommand& box) {
    return box.rect.shrunk(-(std::max(box.softness, 0.0) + 1));
}

Rect reach(const IconCommand& icon) {
    const double half = icon.size_px / 2 + 1;
    return {icon.centre_x - half, icon.centre_y - half, 2 * half, 2 * half};
}

Rect reach(const PictureCommand& picture) {
    return has_size(picture.within) ? common(picture.rect, picture.within) : picture.rect;
}

Rect reach(const InkCommand& ink) {
    Rect all;
    for (const InkPiece& p : ink.pieces) {
        const double pad = std::max(p.r0, p.r1) + 1.0;
        const Rect box{std::min(p.x0, p.x1) - pad, std::min(p.y0, p.y1) - pad, std::abs(p.x1 - p.x0) + 2 * pad,
                       std::abs(p.y1 - p.y0) + 2 * pad};
        all = has_size(all) ? around(all, box) : box;
    }
    return common(all, ink.clip);
}

/// Puts a rectangle among others, joining it with those that are better one with it.
void put(std::vector<Rect>& rects, Rect rect) {
    for (std::size_t i = 0; i < rects.size();) {
        const Rect joined = around(rects[i], rect);
        if (!overlap(rects[i], rect) && area_of(joined) > kWasteful * (area_of(rects[i]) + area_of(rect)) + kFree_px2) {
            ++i;
            continue;
        }
        rect = joined;
        rects.erase(rects.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;  // what is larger now may lie on another
    }
    rects.push_back(rect);
}

/// How many commands to pass over in each list until both go on alike; all that is left when they never do.
struct Gap {
    std::size_t before = 0, now = 0;
};

Gap gap_at(const std::vector<DrawCommand>& before, std::size_t i, const std::vector<DrawCommand>& now, std::size_t j) {
    const std::size_t left = before.size() - i, right = now.size() - j;
    for (std::size_t total = 1; total < left + right; ++total) {
        for (std::size_t a = 0; a <= total; ++a) {
            const std::size_t b = total - a;
            if (a < left && b < right && before[i + a] == now[j + b]) return {a, b};
        }
    }
    return {left, right};
}

}  // namespace

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

Rect common(const Rect& a, const Rect& b) {
    const double x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    return {x, y, std::max(std::min(a.right(), b.right()) - x, 0.0),
            std::max(std::min(a.bottom(), b.bottom()) - y, 0.0)};
}

Rect around(const Rect& a, const Rect& b) {
    const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

void Damage::add(const Rect& rect) {
    if (!has_size(rect)) return;
    put(rects_, whole(rect));
    while (rects_.size() > kMostRects) {  // the two that lose least by becoming one
        std::size_t best_i = 0, best_j = 1;
        double least = -1;
        for (std::size_t i = 0; i < rects_.size(); ++i) {
            for (std::size_t j = i + 1; j < rects_.size(); ++j) {
                const double waste = area_of(around(rects_[i], rects_[j])) - area_of(rects_[i]) - area_of(rects_[j]);
                if (least >= 0 && waste >= least) continue;
                least = std::max(waste, 0.0);
                best_i = i;
                best_j = j;
            }
        }
        const Rect joined = around(rects_[best_i], rects_[best_j]);
        rects_.erase(rects_.begin() + static_cast<std::ptrdiff_t>(best_j));
        rects_.erase(rects_.begin() + static_cast<std::ptrdiff_t>(best_i));
        put(rects_, joined);
    }
}

double Damage::area() const {
    double sum = 0;
    for (const Rect& r : rects_) sum += area_of(r);
    return sum;
}

Rect reach_of(const DrawCommand& command, const FontSet& fonts) {
    if (const auto* text = std::get_if<TextCommand>(&command)) {
        const double em = text->style.size_px;
        return {text->x - kBeside_em * em, text->y - kAbove_em * em,
                fonts.width_px(text->text, text->style) + 2 * kBeside_em * em, (kAbove_em + kBelow_em) * em};
    }
    if (const auto* box = std::get_if<BoxCommand>(&command)) return reach(*box);
    if (const auto* icon = std::get_if<IconCommand>(&command)) return reach(*icon);
    if (const auto* picture = std::get_if<PictureCommand>(&command)) return reach(*picture);
    return reach(std::get<InkCommand>(command));
}

Damage difference(const DrawList& before, const DrawList& now, const FontSet& fonts) {
    Damage damage;
    std::size_t i = 0, j = 0;
    while (i < before.commands.size() || j < now.commands.size()) {
        if (i < before.commands.size() && j < now.commands.size() && before.commands[i] == now.commands[j]) {
            ++i;
            ++j;
            continue;
        }
        const Gap gap = gap_at(before.commands, i, now.commands, j);
        for (std::size_t k = 0; k < gap.before; ++k) damage.add(reach_of(before.commands[i + k], fonts));
        for (std::size_t k = 0; k < gap.now; ++k) damage.add(reach_of(now.commands[j + k], fonts));
        i += gap.before;
        j += gap.now;
    }
    return damage;
}

}  // namespace ui
