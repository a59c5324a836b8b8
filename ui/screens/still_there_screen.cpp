#include "ui/screens/still_there_screen.hpp"

#include <cmath>
#include <numbers>

#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

constexpr float kVeil = 0.93F;

struct Buttons {
    Rect keep, over;
};

Buttons buttons(const FontSet& fonts, const Strings& words, const ScreenScale& s) {
    const TextStyle style = s.text(Face::SemiBold, 28);
    const double gap = s.px(24), height = s.target(96);
    const double keep = std::round(fonts.width_px(words["keep_drawing"], style) + s.px(112));
    const double over = std::round(fonts.width_px(words["start_over"], style) + s.px(112));
    const double cx = s.width() / 2, y = std::round(s.height() * 0.685);
    if (keep + gap + over > s.width() - s.px(48)) {  // one below the other
        return {{std::round(cx - keep / 2), y, keep, height},
                {std::round(cx - over / 2), y + height + gap, over, height}};
    }
    const double x = std::round(cx - (keep + gap + over) / 2);
    return {{x, y, keep, height}, {x + keep + gap, y, over, height}};
}

}  // namespace

DrawList StillThereScreen::draw(const StillThereState& state, SizePx screen) const {
    DrawList list;
    const Strings& words = (*languages_)[state.language];
    const ScreenScale s = ScreenScale::of(screen);
    const double cx = s.width() / 2, cy = s.height() * 0.335, radius = s.px(118);
    list.box({0, 0, s.width(), s.height()}, 0, palette::kBoard.faded(kVeil));
    const double top = -std::numbers::pi / 2, whole = 2 * std::numbers::pi;
    draw_arc(list, cx, cy, radius, radius, 0, whole, s.px(10), palette::kLine);
    if (state.share > 0)
        draw_arc(list, cx, cy, radius, radius, top, top + whole * state.share, s.px(10), palette::kSanguine);
    const TextStyle figure = s.text(Face::DisplaySemiBold, 92, -0.02);
    list.text(*fonts_, std::to_string(state.seconds), figure, palette::kInk, cx, cy + cap_drop(figure), Align::Centre);
    draw_fitted(list, *fonts_, words["still_title"], s.text(Face::DisplaySemiBold, 72, -0.015), palette::kInk, cx,
                s.height() * 0.568, s.width() - s.px(96), Align::Centre);
    draw_fitted(list, *fonts_, words["still_text"], s.text(Face::Regular, 28), palette::kMuted, cx, s.height() * 0.624,
                s.width() - s.px(96), Align::Centre);
    const Buttons b = buttons(*fonts_, words, s);
    const TextStyle style = s.text(Face::SemiBold, 28);
    draw_button(list, *fonts_, b.keep, words["keep_drawing"], style, ButtonKind::Primary,
                state.pressed == Control::KeepDrawing, s.px(2));
    draw_button(list, *fonts_, b.over, words["start_over"], style, ButtonKind::Plain,
                state.pressed == Control::StartOver, s.px(2));
    return list;
}

std::vector<BoardTouch::Target> StillThereScreen::targets(const StillThereState& state, SizePx screen) const {
    const Buttons b = buttons(*fonts_, (*languages_)[state.language], ScreenScale::of(screen));
    return {{Control::KeepDrawing, 0, b.keep}, {Control::StartOver, 0, b.over}};
}

}  // namespace ui
