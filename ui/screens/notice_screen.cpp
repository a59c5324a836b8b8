#include "ui/screens/notice_screen.hpp"

#include <algorithm>
#include <cmath>

#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

/// What its strings begin with.
std::string prefix(Notice notice) {
    switch (notice) {
        case Notice::CollectionMissing:
            return "missing";
        case Notice::CollectionDamaged:
            return "damaged";
        case Notice::CollectionStale:
            return "stale";
        case Notice::Building:
            return "building";
        case Notice::NoTablet:
            return "no_tablet";
        case Notice::NoInput:
            return "no_input";
        default:
            return "no_models";
    }
}

Icon icon_of(Notice notice) {
    switch (notice) {
        case Notice::NoModels:
        case Notice::Building:
            return Icon::Collection;
        case Notice::NoTablet:
            return Icon::Tablet;
        default:
            return Icon::Warning;
    }
}

std::string text_of(const NoticeState& state, const Strings& words) {
    std::string text = words[prefix(state.notice) + "_text"];
    if (state.notice == Notice::NoModels && state.garment) {
        text = text.substr(0, text.find('\n') + 1) + words["garment_works"];
    }
    if (state.notice == Notice::NoInput) return filled_in(text, {{"c", state.code}});
    if (state.notice != Notice::Building) return text;
    std::string key = "building_progress";
    if (!state.minutes_left) key = "building_progress_untimed";
    if (state.minutes_left == 1) key = "building_progress_minute";
    const std::string progress = filled_in(words[key], {{"a", number_in(words, state.done)},
                                                        {"b", number_in(words, state.total)},
                                                        {"t", number_in(words, state.minutes_left.value_or(0))}});
    return progress + "\n" + text;
}

/// On upright screens the switches stand at the bottom: there is no board above.
FindLayout with_footer_below(FindLayout l) {
    if (!l.upright) return l;
    const double y = l.screen.height - l.px(32) - l.language.height;
    l.language.x = l.header.x;
    l.language.y = y;
    l.hand_switch.x = l.screen.width - l.header.x - l.hand_switch.width;
    l.hand_switch.y = y;
    return l;
}

std::string button_key(const NoticeState& state) {
    if (state.notice == Notice::NoModels && state.garment) return "go_to_garment";
    return state.notice == Notice::NoTablet ? "draw_by_touch" : "start_drawing";
}

}  // namespace

std::string board_key(Notice notice) {
    switch (notice) {
        case Notice::None:
        case Notice::NoTablet:
        case Notice::Building:
            return "hint_board";
        default:
            return "no_collection_board";
    }
}

Rect NoticeScreen::button(const NoticeState& state, const FindLayout& l) const {
    const ScreenScale s = ScreenScale::of(l.screen);
    const double text = fonts_->width_px((*languages_)[state.language][button_key(state)], s.text(Face::SemiBold, 24));
    const double width = std::round(text + s.px(88)), height = s.target(80);
    const double down = state.notice == Notice::Building ? s.px(16) : 0;
    return {std::round(l.screen.width / 2.0 - width / 2), std::round(l.screen.height * 0.637 + down), width, height};
}

DrawList NoticeScreen::draw(const NoticeState& state, const FindLayout& l) const {
    DrawList list;
    const Strings& words = (*languages_)[state.language];
    const ScreenScale s = ScreenScale::of(l.screen);
    const double cx = l.screen.width / 2.0, height = l.screen.height, room = l.screen.width - s.px(96);
    list.box({0, 0, static_cast<double>(l.screen.width), height}, 0, palette::kBoard);
    draw_wordmark(list, *fonts_, l);
    list.icon(icon_of(state.notice), cx, height * 0.282, s.px(128), s.px(128) / 32 * 1.5, palette::kSanguine);
    draw_fitted(list, *fonts_, words[prefix(state.notice) + "_title"], s.text(Face::DisplaySemiBold, 64, -0.015),
                palette::kInk, cx, height * 0.45, room, Align::Centre);
    const TextStyle lead = s.text(Face::Regular, 28);
    const double below = draw_centred_lines(list, *fonts_, text_of(state, words), lead, palette::kMuted, cx,
                                            height * 0.51, room, std::round(lead.size_px * 1.43));
    if (state.notice == Notice::Building) {
        const double width = std::min(s.px(600), room);
        const double share = state.total > 0 ? static_cast<double>(state.done) / static_cast<double>(state.total) : 0.0;
        draw_bar(list, {std::round(cx - width / 2), std::round(below), width, s.px(12)}, share, palette::kSanguine,
                 palette::kLine);
    }
    if (state.notice == Notice::NoInput) return list;  // nothing that could be touched is shown
    draw_button(list, *fonts_, button(state, l), words[button_key(state)], s.text(Face::SemiBold, 24),
                ButtonKind::Primary, state.pressed == Control::StartDrawing, s.px(2));
    draw_footer(list, *fonts_, *languages_, state.language, with_footer_below(l), state.pressed, state.pressed_item);
    return list;
}

std::vector<BoardTouch::Target> NoticeScreen::targets(const NoticeState& state, const FindLayout& layout) const {
    if (state.notice == Notice::NoInput) return {};
    std::vector<BoardTouch::Target> all = footer_targets(with_footer_below(layout), languages_->size());
    all.push_back({Control::StartDrawing, 0, button(state, layout)});
    return all;
}

}  // namespace ui
