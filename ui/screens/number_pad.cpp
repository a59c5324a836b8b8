#include "ui/screens/number_pad.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

constexpr std::size_t kMostWhole = 3, kMostTenths = 1;

}  // namespace

void NumberEdit::type(char digit) {
    if (digit < '0' || digit > '9') return;
    if (fresh) text.clear();
    fresh = false;
    const std::size_t dot = text.find('.');
    const bool room = dot == std::string::npos ? text.size() < kMostWhole : text.size() - dot - 1 < kMostTenths;
    if (room) text += digit;
}

void NumberEdit::point() {
    if (fresh) text.clear();
    fresh = false;
    if (text.find('.') != std::string::npos) return;
    text += text.empty() ? "0." : ".";
}

void NumberEdit::erase() {
    if (fresh) text.clear();
    fresh = false;
    if (!text.empty()) text.pop_back();
}

std::optional<double> NumberEdit::value() const {
    if (text.empty()) return std::nullopt;
    return std::strtod(text.c_str(), nullptr);
}

NumberPadLayout number_pad_layout(const Rect& area, double scale) {
    NumberPadLayout out;
    const double gap = std::round(12 * scale), field = std::max(64.0, std::round(80 * scale));
    out.name_baseline = area.y + std::round(26 * scale);
    out.field = {area.x, area.y + std::round(40 * scale), area.width, field};
    out.range_baseline = out.field.bottom() + std::round(32 * scale);
    const double top = out.range_baseline + gap * 1.5;
    const double high = std::min(std::round(92 * scale), std::floor((area.bottom() - top - 3 * gap) / 4));
    const double wide = std::floor((area.width - 2 * gap) / 3);
    const auto at = [&](std::size_t row, std::size_t column) {
        return Rect{area.x + static_cast<double>(column) * (wide + gap), top + static_cast<double>(row) * (high + gap),
                    wide, high};
    };
    for (std::size_t digit = 1; digit <= 9; ++digit) out.keys[digit] = at((9 - digit) / 3, (digit - 1) % 3);
    out.keys[kPadPoint] = at(3, 0);
    out.keys[0] = at(3, 1);
    out.keys[kPadErase] = at(3, 2);
    return out;
}

void draw_number_pad(DrawList& list, const FontSet& fonts, const Strings& words, const NumberEdit& edit,
                     const std::string& name, const std::string& range, bool wrong, const NumberPadLayout& layout,
                     double scale, std::optional<std::size_t> pressed) {
    const TextStyle label{Face::SemiBold, 22 * scale, -0.01}, small{Face::Medium, 18 * scale, 0},
        number{Face::Medium, 34 * scale, 0};
    const double line = std::max(1.5, 2 * scale);
    draw_fitted(list, fonts, name, label, palette::kInk, layout.field.x, layout.name_baseline, layout.field.width,
                Align::Left);
    list.box(layout.field, 16 * scale, palette::kSheet, palette::kSanguine, line * 1.5);
    std::string shown = edit.text;
    if (const std::size_t dot = shown.find('.'); dot != std::string::npos) shown.replace(dot, 1, words["decimal"]);
    const double x = layout.field.x + 28 * scale, y = layout.field.centre_y() + cap_drop(number);
    const double end = x + fonts.width_px(shown, number);
    if (edit.fresh && !shown.empty()) {  // as a text that is selected
        list.box({x - 6 * scale, layout.field.y + 14 * scale, end - x + 12 * scale, layout.field.height - 28 * scale},
                 8 * scale, palette::kWell);
    }
    list.text(fonts, shown, number, palette::kInk, x, y);
    list.box({end + 3 * scale, layout.field.y + 16 * scale, line, layout.field.height - 32 * scale}, 0,
             palette::kSanguine);
    list.text(fonts, "cm", number, palette::kMuted, layout.field.right() - 28 * scale, y, Align::Right);
    draw_fitted(list, fonts, range, small, wrong ? palette::kSanguine : palette::kMuted, layout.field.x,
                layout.range_baseline, layout.field.width, Align::Left);
    for (std::size_t i = 0; i < kPadKeys; ++i) {
        const bool down = pressed == i;
        const Rect r = down ? scaled(layout.keys[i], 0.97) : layout.keys[i];
        list.box(r, 16 * scale, down ? palette::kWell : palette::kSheet, palette::kLine, std::max(1.0, scale));
        if (i == kPadErase) {
            const double size = 34 * scale;
            list.icon(Icon::Back, r.centre_x(), r.centre_y(), size, size / 32 * 2.2, palette::kInk);
        } else {
            const std::string sign = i == kPadPoint ? words["decimal"] : std::to_string(i);
            list.text(fonts, sign, number, palette::kInk, r.centre_x(), r.centre_y() + cap_drop(number), Align::Centre);
        }
    }
}

}  // namespace ui
