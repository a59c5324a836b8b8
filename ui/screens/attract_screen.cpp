#include "ui/screens/attract_screen.hpp"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

constexpr double kSoftEdge = 0.22;  // of the picture's width, over which the line becomes form

/// Where the ramp stands over a rect, as the picture command wants it: opacity 0 at the first share of the rect's
/// width, 1 at the second. `edge` and `width` in pixels.
PictureCommand::Ramp ramp_over(const Rect& rect, double from_x, double to_x) {
    return {(from_x - rect.x) / rect.width, (to_x - rect.x) / rect.width};
}

}  // namespace

AttractLayout attract_layout(SizePx screen, std::size_t language_count) {
    AttractLayout l;
    l.scale = ScreenScale::of(screen);
    const ScreenScale& s = l.scale;
    const double margin = s.px(s.upright ? 64 : 96);
    l.text_x = margin;
    l.wordmark_y = s.px(122);
    const double width = std::min(s.target(144) * static_cast<double>(language_count), screen.width - 2 * margin);
    const double height = s.target(72);
    l.language = {margin, screen.height - s.px(72) - height, width, height};
    if (s.upright) {
        l.stage = {margin / 2, s.px(760), screen.width - margin, s.px(900)};
        l.title_y = s.px(360);
        l.text_width = screen.width - 2 * margin;
    } else {
        const double left = std::round(screen.width * 0.385);
        l.stage = {left, s.px(90), screen.width - left - s.px(72), s.height() - s.px(180)};
        l.title_y = std::round(screen.height / 2.0) - s.px(48);
        l.text_width = left - margin - s.px(24);
    }
    l.lead_y = l.title_y + s.px(108) + s.px(84);
    return l;
}

DrawList AttractScreen::draw(const AttractState& state, SizePx screen) const {
    DrawList list;
    const Strings& words = (*languages_)[state.language];
    const AttractLayout l = attract_layout(screen, languages_->size());
    const ScreenScale& s = l.scale;
    list.box({0, 0, s.width(), s.height()}, 0, palette::kSheet);
    const double dx = std::round(state.drift.x), dy = std::round(state.drift.y);

    const Rect inked{l.stage.x + state.inked.x + dx, l.stage.y + state.inked.y + dy, state.inked.width,
                     state.inked.height};
    const Rect form{l.stage.x + state.form_box.x + dx, l.stage.y + state.form_box.y + dy, state.form_box.width,
                    state.form_box.height};
    // one edge for both, from the right of what is shown to its left
    const double left = std::min(inked.x, form.width > 0 ? form.x : inked.x);
    const double right = std::max(inked.right(), form.width > 0 ? form.right() : inked.right());
    const double soft = kSoftEdge * (right - left);
    const double edge = right - state.form_share * (right - left + soft);
    const Rect whole{l.stage.x + dx, l.stage.y + dy, l.stage.width, l.stage.height};
    if (inked.width > 0 && inked.height > 0) {
        PictureCommand ink{state.ink, whole, PictureCommand::Mode::Tint, palette::kInk, state.opacity, {0, 0, 1, 1},
                           {},        inked};
        if (state.form_share > 0) ink.ramp = ramp_over(whole, edge + soft, edge);
        list.commands.emplace_back(ink);
    }
    std::vector<InkPiece> wet = state.wet_ink;
    for (InkPiece& piece : wet) {
        piece.x0 += static_cast<float>(l.stage.x + dx);
        piece.x1 += static_cast<float>(l.stage.x + dx);
        piece.y0 += static_cast<float>(l.stage.y + dy);
        piece.y1 += static_cast<float>(l.stage.y + dy);
    }
    list.ink(std::move(wet), palette::kInk, {0, 0, s.width(), s.height()});
    if (state.form_share > 0 && form.width > 0) {
        PictureCommand picture{state.form, whole, PictureCommand::Mode::Picture, {}, state.opacity, {0, 0, 1, 1},
                               {},         {}};
        picture.ramp = ramp_over(whole, edge, edge + soft);
        list.commands.emplace_back(picture);
    }

    const double x = l.text_x + dx;
    list.text(*fonts_, "Croquis", s.text(Face::DisplaySemiBold, 44, -0.03), palette::kInk, x, l.wordmark_y + dy);
    const TextStyle hero = s.text(Face::DisplaySemiBold, 104, -0.03);
    draw_fitted(list, *fonts_, words["attract_title_1"], hero, palette::kInk, x, l.title_y + dy, l.text_width,
                Align::Left);
    draw_fitted(list, *fonts_, words["attract_title_2"], hero, palette::kInk, x, l.title_y + s.px(108) + dy,
                l.text_width, Align::Left);
    const TextStyle lead = s.text(Face::Regular, 32);
    double y = l.lead_y + dy;
    for (const std::string& line : fonts_->wrap(words["attract_lead"], lead, l.text_width)) {
        list.text(*fonts_, line, lead, palette::kMuted, x, y);
        y += std::round(lead.size_px * 1.4);
    }
    std::vector<std::string> names;
    for (const Strings& language : *languages_) names.push_back(language["name"]);
    draw_switch(list, *fonts_, l.language, names, state.language, state.pressed_language,
                s.text(Face::Medium, 20).size_px);
    return list;
}

std::vector<BoardTouch::Target> AttractScreen::targets(SizePx screen) const {
    std::vector<BoardTouch::Target> all;
    const std::vector<Rect> segments =
        switch_segments(attract_layout(screen, languages_->size()).language, languages_->size());
    for (std::size_t i = 0; i < segments.size(); ++i) all.push_back({Control::Language, i, segments[i]});
    return all;
}

}  // namespace ui
