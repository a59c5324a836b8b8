#include "ui/screens/notice_screen.hpp"

#include <cmath>

namespace ui {
namespace {

std::string prefix(Notice notice) {
    switch (notice) {
        case Notice::CollectionMissing:
            return "missing";
        case Notice::CollectionDamaged:
            return "damaged";
        default:
            return "no_models";
    }
}

TextStyle button_style(const FindLayout& l) {
    return {Face::SemiBold, l.px(l.compact ? 20 : 24), 0};
}

}  // namespace

std::string board_key(Notice notice) {
    return notice == Notice::None ? "hint_board" : "no_collection_board";
}

Rect NoticeScreen::button(std::size_t language, const FindLayout& l) const {
    const double text = fonts_->width_px((*languages_)[language]["start_drawing"], button_style(l));
    const double width = std::round(text + l.px(88)), height = std::round(l.px(l.compact ? 68 : 80));
    return {std::round(l.screen.width / 2.0 - width / 2), std::round(l.screen.height * 0.637), width, height};
}

DrawList NoticeScreen::draw(Notice notice, std::size_t language, const FindLayout& l, std::optional<Control> pressed,
                            std::size_t pressed_item) const {
    DrawList list;
    const Strings& words = (*languages_)[language];
    const double cx = l.screen.width / 2.0, height = l.screen.height;
    list.box({0, 0, static_cast<double>(l.screen.width), height}, 0, palette::kBoard);
    draw_wordmark(list, *fonts_, l);

    const double icon = l.px(l.compact ? 96 : 128);
    list.icon(notice == Notice::NoModels ? Icon::Collection : Icon::Warning, cx, height * 0.282, icon, l.px(5),
              palette::kSanguine);
    TextStyle title{Face::DisplaySemiBold, l.px(l.compact ? 48 : 64), -0.015};
    const std::string title_words = words[prefix(notice) + "_title"];
    const double room = l.screen.width - l.px(96), wide = fonts_->width_px(title_words, title);
    if (wide > room) title.size_px *= room / wide;
    list.text(*fonts_, title_words, title, palette::kInk, cx, height * 0.45, Align::Centre);

    const TextStyle lead{Face::Regular, l.px(l.compact ? 22 : 28), 0};
    double y = height * 0.51;
    const std::string text = words[prefix(notice) + "_text"];
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        for (const std::string& line : fonts_->wrap(text.substr(at, end - at), lead, room)) {
            list.text(*fonts_, line, lead, palette::kMuted, cx, y, Align::Centre);
            y += l.px(l.compact ? 32 : 40);
        }
        at = end + 1;
    }
    Rect r = button(language, l);
    const bool down = pressed == Control::StartDrawing;
    if (down) r = {r.centre_x() - r.width * 0.485, r.centre_y() - r.height * 0.485, r.width * 0.97, r.height * 0.97};
    list.box(r, r.height / 2, down ? palette::kInk.faded(0.82F) : palette::kInk);
    const TextStyle s = button_style(l);
    list.text(*fonts_, words["start_drawing"], s, palette::kSheet, r.centre_x(), r.centre_y() + s.size_px * 0.364,
              Align::Centre);
    draw_footer(list, *fonts_, *languages_, language, l, pressed, pressed_item);
    return list;
}

std::vector<BoardTouch::Target> NoticeScreen::targets(std::size_t language, const FindLayout& layout) const {
    std::vector<BoardTouch::Target> all = footer_targets(layout, languages_->size());
    all.push_back({Control::StartDrawing, 0, button(language, layout)});
    return all;
}

}  // namespace ui
