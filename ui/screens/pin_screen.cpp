#include "ui/screens/pin_screen.hpp"

#include <cmath>
#include <numbers>

#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

struct PinLayout {
    ScreenScale s;
    double cx = 0, top = 0, key = 0, pitch_x = 0, pitch_y = 0;
    Rect cancel;

    /// 1 … 9, then 0 below 8; 10 is the key that takes a digit back.
    [[nodiscard]] Rect key_rect(int digit) const {
        const int column = digit == 0 ? 1 : (digit == 10 ? 2 : (digit - 1) % 3);
        const int row = digit == 0 || digit == 10 ? 3 : (digit - 1) / 3;
        return {std::round(cx + (column - 1) * pitch_x - key / 2), std::round(top + row * pitch_y), key, key};
    }
};

PinLayout lay_out(SizePx screen) {
    PinLayout l;
    l.s = ScreenScale::of(screen);
    l.cx = l.s.width() / 2;
    l.key = l.s.target(122);
    l.pitch_x = std::max(l.s.px(144), l.key + 8);
    l.pitch_y = std::max(l.s.px(136), l.key + 8);
    const double height = l.s.px(320) + 4 * l.pitch_y + l.s.px(88) + l.s.target(72);
    l.top = std::round((l.s.height() - height) / 2 + l.s.px(320));
    const double width = std::max(l.s.px(200), l.s.target(160));
    l.cancel = {std::round(l.cx - width / 2), l.top + 4 * l.pitch_y + l.s.px(76), width, l.s.target(72)};
    return l;
}

}  // namespace

DrawList PinScreen::draw(const PinState& state, SizePx screen) const {
    DrawList list;
    const PinLayout l = lay_out(screen);
    const ScreenScale& s = l.s;
    const Strings& words = (*languages_)[state.language];
    list.box({0, 0, s.width(), s.height()}, 0, palette::kBoard);
    draw_fitted(list, *fonts_, words["pin_title"], s.text(Face::DisplaySemiBold, 48, -0.015), palette::kInk, l.cx,
                l.top - s.px(122), s.width() - s.px(96), Align::Centre);
    const double dot = s.px(28), pitch = s.px(56), y = l.top - s.px(62);
    for (int i = 0; i < state.length; ++i) {
        const double x = l.cx + (i - (state.length - 1) / 2.0) * pitch;
        const Rect r{x - dot / 2, y - dot / 2, dot, dot};
        const bool full = i < state.entered;
        list.box(r, dot / 2, full ? palette::kInk : palette::kNone, full ? palette::kInk : palette::kLine,
                 std::max(1.5, s.px(3)));
    }
    const float on = state.wait_s > 0 ? palette::kOffShare : 1.0F;
    const TextStyle digit = s.text(Face::Medium, 44);
    for (int d = 0; d <= 9; ++d) {
        Rect r = l.key_rect(d);
        const bool down = state.pressed == Control::Digit && state.pressed_item == static_cast<std::size_t>(d);
        if (down) r = scaled(r, 0.97);
        list.box(r, r.height / 2, (down ? palette::kWell : palette::kSheet).faded(on), palette::kLine.faded(on),
                 std::max(1.0, s.px(1)));
        list.text(*fonts_, std::to_string(d), digit, palette::kInk.faded(on), r.centre_x(),
                  r.centre_y() + cap_drop(digit), Align::Centre);
    }
    const Rect back = l.key_rect(10);
    if (state.pressed == Control::EraseDigit) list.box(back, back.height / 2, palette::kWell);
    list.icon(Icon::Back, back.centre_x(), back.centre_y(), s.px(40), s.px(40) / 32 * 2.2, palette::kInk.faded(on));
    std::string message;
    if (state.wait_s > 0) {
        message = filled_in(words["pin_wait"], {{"n", number_in(words, state.wait_s)}});
    } else if (state.wrong) {
        message = words["pin_wrong"];
    }
    list.text(*fonts_, message, s.text(Face::Medium, 24), palette::kSanguine, l.cx, l.top + 4 * l.pitch_y + s.px(36),
              Align::Centre);
    draw_button(list, *fonts_, l.cancel, words["cancel"], s.text(Face::SemiBold, 20), ButtonKind::Quiet,
                state.pressed == Control::Cancel, std::max(1.5, s.px(2)));
    return list;
}

std::vector<BoardTouch::Target> PinScreen::targets(const PinState& state, SizePx screen) const {
    const PinLayout l = lay_out(screen);
    std::vector<BoardTouch::Target> all{{Control::Cancel, 0, l.cancel}};
    if (state.wait_s > 0) return all;
    for (int d = 0; d <= 9; ++d) all.push_back({Control::Digit, static_cast<std::size_t>(d), l.key_rect(d)});
    all.push_back({Control::EraseDigit, 0, l.key_rect(10)});
    return all;
}

DrawList PinScreen::draw_cleaning(std::size_t language, double share, int seconds, SizePx screen) const {
    DrawList list;
    const ScreenScale s = ScreenScale::of(screen);
    const Strings& words = (*languages_)[language];
    const double cx = s.width() / 2, cy = s.height() * 0.335, top = -std::numbers::pi / 2, whole = 2 * std::numbers::pi;
    list.box({0, 0, s.width(), s.height()}, 0, palette::kBoard);
    draw_arc(list, cx, cy, s.px(118), s.px(118), 0, whole, s.px(10), palette::kLine);
    if (share > 0) draw_arc(list, cx, cy, s.px(118), s.px(118), top, top + whole * share, s.px(10), palette::kSanguine);
    const TextStyle figure = s.text(Face::DisplaySemiBold, 92, -0.02);
    list.text(*fonts_, std::to_string(seconds), figure, palette::kInk, cx, cy + cap_drop(figure), Align::Centre);
    draw_fitted(list, *fonts_, words["cleaning_title"], s.text(Face::DisplaySemiBold, 64, -0.015), palette::kInk, cx,
                s.height() * 0.568, s.width() - s.px(96), Align::Centre);
    const TextStyle lead = s.text(Face::Regular, 28);
    draw_centred_lines(list, *fonts_, words["cleaning_text"], lead, palette::kMuted, cx, s.height() * 0.624,
                       s.width() - s.px(96), std::round(lead.size_px * 1.43));
    return list;
}

}  // namespace ui
