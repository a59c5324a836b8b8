#include "ui/screens/station_screen.hpp"

#include <algorithm>
#include <cmath>

#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

/// Draws and notes targets while it goes down a column; a first pass without drawing measures a panel.
class Builder {
  public:
    Builder(StationPage& page, const FontSet& fonts, const std::vector<Strings>& languages, const StationState& state,
            SizePx screen)
        : page_(page),
          fonts_(fonts),
          languages_(languages),
          words_(languages[state.language]),
          state_(state),
          s_(ScreenScale::of(screen)) {
        body_ = s_.text(Face::Regular, 20);
        strong_ = s_.text(Face::SemiBold, 20);
        head_ = s_.text(Face::SemiBold, 22);
        pad_ = s_.px(28);
        line_ = std::max(1.5, s_.px(2));
    }

    void build() {
        if (state_.align) return aligning(*state_.align);
        const double margin = s_.px(40), gap = s_.px(24), top = header_height() + s_.px(8);
        page_.list.box({0, 0, s_.width(), s_.height()}, 0, palette::kBoard);
        const bool three = !s_.upright && s_.width() >= 1600;
        double bottom = 0;
        if (three) {
            const double unit = (s_.width() - 2 * margin - 2 * gap) / 1792;
            const double w0 = std::round(580 * unit), w1 = std::round(612 * unit),
                         w2 = s_.width() - 2 * margin - 2 * gap - w0 - w1;
            bottom = std::max(
                {column(margin, w0, top, {&Builder::tablet}),
                 column(margin + w0 + gap, w1, top, {&Builder::collection, &Builder::idle}),
                 column(margin + w0 + w1 + 2 * gap, w2, top, {&Builder::visitors, &Builder::health_and_ends})});
        } else {
            const double w = std::round((s_.width() - 2 * margin - gap) / 2);
            bottom = std::max(
                column(margin, w, top, {&Builder::tablet, &Builder::idle, &Builder::ends}),
                column(margin + w + gap, w, top, {&Builder::collection, &Builder::visitors, &Builder::health}));
        }
        page_.most_scroll = std::max(0.0, bottom + state_.scroll + s_.px(40) - s_.height());
        header();
    }

  private:
    using Panel = void (Builder::*)();

    /// One cross to be touched, and what to do in the middle of the upper half, where none ever stands.
    void aligning(const StationState::Align& align) {
        page_.list.box({0, 0, s_.width(), s_.height()}, 0, palette::kSheet);
        const double cx = s_.width() / 2, top = s_.height() * 0.26, arm = s_.px(36);
        draw_fitted(page_.list, fonts_, words_["align_title"], s_.text(Face::DisplaySemiBold, 48, -0.015),
                    palette::kInk, cx, top, s_.width() * 0.7, Align::Centre);
        const std::string step = filled_in(words_["align_step"],
                                           {{"a", std::to_string(align.step + 1)}, {"b", std::to_string(align.count)}});
        page_.list.text(fonts_, step, s_.text(Face::Regular, 28), palette::kMuted, cx, top + s_.px(64), Align::Centre);
        const core::Point at{align.cross.x * s_.width(), align.cross.y * s_.height()};
        draw_line(page_.list, {at.x - arm, at.y}, {at.x + arm, at.y}, line_, palette::kInk);
        draw_line(page_.list, {at.x, at.y - arm}, {at.x, at.y + arm}, line_, palette::kInk);
        const double r = s_.px(16);
        page_.list.box({at.x - r, at.y - r, 2 * r, 2 * r}, r, palette::kNone, palette::kSanguine, line_);
        drawing_ = true;
        const double wide = std::max(s_.px(240), fonts_.width_px(words_["cancel"], strong_) + s_.px(72));
        button_at({std::round(cx - wide / 2), std::round(s_.height() * 0.68), wide, s_.target(72)}, words_["cancel"],
                  ButtonKind::Quiet, StationAction::LeaveAlign);
    }

    [[nodiscard]] double header_height() const { return s_.px(32) + s_.target(72) + s_.px(24); }

    double column(double x, double width, double y, std::initializer_list<Panel> panels) {
        y -= state_.scroll;
        for (const Panel panel : panels) {
            x_ = x + pad_;
            width_ = width - 2 * pad_;
            drawing_ = false;
            y_ = y + pad_;
            (this->*panel)();
            const double height = y_ - y + pad_ - s_.px(12);
            const Rect r{x, y, width, height};
            page_.list.box({r.x - 1, r.y - 1, r.width + 2, r.height + 2}, s_.px(24) + 1, palette::kNone, palette::kEdge,
                           1);
            page_.list.box(r, s_.px(24), palette::kSheet);
            drawing_ = true;
            y_ = y + pad_;
            (this->*panel)();
            y += height + s_.px(24);
        }
        return y;
    }

    void header() {
        const double height = header_height(), button = s_.target(72), y = s_.px(32);
        page_.list.box({0, 0, s_.width(), height}, 0, palette::kBoard);
        drawing_ = true;
        const TextStyle title = s_.text(Face::DisplaySemiBold, 40, -0.015);
        page_.list.text(fonts_, words_["station"], title, palette::kInk, s_.px(40), y + button / 2 + cap_drop(title));
        const double after = s_.px(40) + fonts_.width_px(words_["station"], title) + s_.px(32);
        const double close = std::max(s_.px(200), fonts_.width_px(words_["close"], strong_) + s_.px(72));
        const double clean = std::max(s_.px(200), fonts_.width_px(words_["clean_screen"], strong_) + s_.px(72));
        const double x_close = s_.width() - s_.px(40) - close, x_clean = x_close - s_.px(16) - clean;
        page_.list.text(fonts_, fonts_.cut(state_.place, body_, std::max(0.0, x_clean - after - s_.px(16))), body_,
                        palette::kMuted, after, y + button / 2 + cap_drop(body_));
        button_at({x_clean, y, clean, button}, words_["clean_screen"], ButtonKind::Quiet, StationAction::Clean);
        button_at({x_close, y, close, button}, words_["close"], ButtonKind::Primary, StationAction::Close);
        // nothing that scrolled under the header can be touched there
        std::stable_partition(page_.targets.begin(), page_.targets.end(), [&](const BoardTouch::Target& t) {
            return t.rect.y < height &&
                   (t.item == station_item(StationAction::Clean) || t.item == station_item(StationAction::Close));
        });
        std::erase_if(page_.targets, [&](const BoardTouch::Target& t) {
            const bool mine =
                t.item == station_item(StationAction::Clean) || t.item == station_item(StationAction::Close);
            return !mine && t.rect.centre_y() < height;
        });
    }

    // pieces of a panel, each going on below the last

    void button_at(const Rect& r, const std::string& words, ButtonKind kind, StationAction action, bool on = true,
                   double fill = 0, std::size_t index = 0) {
        if (!drawing_) return;
        const std::size_t item = station_item(action, index);
        draw_button(page_.list, fonts_, r, words, strong_, kind, state_.pressed == item, line_, on, fill);
        if (on) page_.targets.push_back({Control::Station, item, r});
    }

    void title(const std::string& key) {
        if (drawing_) page_.list.text(fonts_, words_[key], head_, palette::kInk, x_, y_ + head_.size_px * 0.8);
        y_ += std::round(head_.size_px * 1.9);
    }

    void fact(const std::string& what, const std::string& value, std::optional<bool> good = {}) {
        const double row = std::round(std::max(s_.px(40), body_.size_px * 1.6)), base = y_ + row / 2 + cap_drop(body_);
        if (drawing_) {
            const TextStyle style{Face::Medium, body_.size_px, 0};
            const double wide = fonts_.width_px(value, style);
            page_.list.text(fonts_, fonts_.cut(what, body_, width_ - wide - s_.px(56)), body_, palette::kMuted, x_,
                            base);
            page_.list.text(fonts_, value, style, palette::kInk, x_ + width_, base, Align::Right);
            if (good) {
                page_.list.icon(*good ? Icon::Check : Icon::Warning, x_ + width_ - wide - s_.px(24), y_ + row / 2,
                                s_.px(22), s_.px(22) / 32 * 3.4, *good ? palette::kOk : palette::kSanguine);
            }
        }
        y_ += row;
    }

    void words(const std::string& text, Colour colour, bool head = false) {
        const TextStyle& style = head ? strong_ : body_;
        for (const std::string& line : fonts_.wrap(text, style, width_)) {
            y_ += std::round(style.size_px * 1.4);
            if (drawing_) page_.list.text(fonts_, line, style, colour, x_, y_ - style.size_px * 0.3);
        }
    }

    void rule() {
        y_ += s_.px(12);
        if (drawing_) page_.list.box({x_, y_, width_, 1}, 0, palette::kLine);
        y_ += s_.px(16);
    }

    /// What a row is for: on two lines where one is too narrow, so that all rows are written in one size.
    void row_label(const std::string& what, double height, double room) {
        std::vector<std::string> lines{what};
        if (fonts_.width_px(what, body_) > room) lines = fonts_.wrap(what, body_, room);
        const double line = body_.size_px * 1.2;
        double y = y_ + height / 2 + cap_drop(body_) - line * (static_cast<double>(lines.size()) - 1) / 2;
        for (const std::string& words : lines) {
            draw_fitted(page_.list, fonts_, words, body_, palette::kInk, x_, y, room, Align::Left);
            y += line;
        }
    }

    void row_switch(const std::string& what, const std::vector<std::string>& choices, std::size_t chosen,
                    StationAction action) {
        const double height = s_.target(66);
        double each = s_.target(92);  // the widest word with room about it, too
        for (const std::string& words : choices)
            each = std::max(each, fonts_.width_px(words, strong_) + 1.6 * body_.size_px);
        const double wide = std::min(width_ * 0.52, each * static_cast<double>(choices.size()) + s_.px(12));
        const Rect r{x_ + width_ - wide, y_, wide, height};
        if (drawing_) {
            row_label(what, height, width_ - wide - s_.px(16));
            segments(r, choices, chosen, action);
        }
        y_ += height + s_.px(8);
    }

    /// The same under its words, as wide as the panel.
    void wide_switch(const std::string& what, const std::vector<std::string>& choices, std::size_t chosen,
                     StationAction action) {
        words(what, palette::kInk);
        y_ += s_.px(12);
        const Rect r{x_, y_, width_, s_.target(66)};
        if (drawing_) segments(r, choices, chosen, action);
        y_ += r.height + s_.px(8);
    }

    void segments(const Rect& r, const std::vector<std::string>& choices, std::size_t chosen, StationAction action) {
        std::optional<std::size_t> pressed;
        if (state_.pressed && station_action(*state_.pressed) == action) pressed = station_index(*state_.pressed);
        draw_switch(page_.list, fonts_, r, choices, chosen, pressed, body_.size_px);
        const std::vector<Rect> places = switch_segments(r, choices.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            page_.targets.push_back({Control::Station, station_item(action, i), places[i]});
    }

    void stepper(const std::string& what, const std::string& value, std::size_t index) {
        const double height = s_.target(64), wide = std::max(s_.px(236), 2 * height + s_.px(96));
        const Rect r{x_ + width_ - wide, y_, wide, height};
        if (drawing_) {
            row_label(what, height, width_ - wide - s_.px(16));
            page_.list.box(r, height / 2, palette::kWell, palette::kLine, line_);
            for (const bool more : {false, true}) {
                const Rect knob{more ? r.right() - height : r.x, r.y, height, height};
                const std::size_t item = station_item(more ? StationAction::More : StationAction::Less, index);
                page_.list.box(state_.pressed == item ? scaled(knob, 0.97) : knob, height / 2,
                               state_.pressed == item ? palette::kWell : palette::kSheet, palette::kLine, line_);
                page_.list.icon(more ? Icon::Plus : Icon::Minus, knob.centre_x(), knob.centre_y(), s_.px(32),
                                s_.px(32) / 32 * 2.8, palette::kInk);
                page_.targets.push_back({Control::Station, item, knob});
            }
            page_.list.text(fonts_, value, strong_, palette::kInk, r.centre_x(), r.centre_y() + cap_drop(strong_),
                            Align::Centre);
        }
        y_ += height + s_.px(8);
    }

    struct Choice {
        std::string words;
        ButtonKind kind;
        StationAction action;
        bool on = true;
        double fill = 0;
    };
    /// Side by side, as wide as they are together: all alike, or where the words of one need more, each as its words;
    /// below each other where that leaves too little room about them.
    void buttons(const std::vector<Choice>& choices) {
        y_ += s_.px(14);
        const double height = s_.target(66), gap = s_.px(12), count = static_cast<double>(choices.size());
        const double all = width_ - gap * (count - 1);
        double words = 0;
        bool alike = true;
        for (const Choice& c : choices) {
            const double wide = fonts_.width_px(c.words, strong_);
            words += wide;
            alike = alike && wide + 2 * strong_.size_px <= all / count;
        }
        if ((all - words) / count < 1.8 * strong_.size_px) {
            for (const Choice& c : choices) {
                button_at({x_, y_, width_, height}, c.words, c.kind, c.action, c.on, c.fill);
                y_ += height + s_.px(12);
            }
            return;
        }
        double x = x_;
        for (const Choice& c : choices) {
            const double wide = alike ? all / count : fonts_.width_px(c.words, strong_) + (all - words) / count;
            button_at({x, y_, wide, height}, c.words, c.kind, c.action, c.on, c.fill);
            x += wide + gap;
        }
        y_ += height + s_.px(12);
    }

    // the panels

    void tablet() {
        title("tablet");
        fact(state_.tablet_there ? state_.tablet_name : words_["tablet"],
             words_[state_.tablet_there ? "connected" : "not_connected"], state_.tablet_there);
        fact(words_["report_rate"],
             state_.report_rate_hz ? number_in(words_, std::llround(*state_.report_rate_hz)) + " Hz" : "–");
        fact(words_["pen_to_screen"],
             state_.pen_to_screen_ms ? number_in(words_, std::llround(*state_.pen_to_screen_ms)) + " ms" : "–");
        y_ += s_.px(10);
        const Rect area{x_, y_, width_, s_.px(s_.upright ? 200 : 180)};
        if (drawing_) {
            page_.test_area = area;
            page_.list.box(area, s_.px(16), palette::kBoard);
            const TextStyle hint = s_.text(Face::Medium, 17);
            page_.list.text(fonts_, words_["test_pen"], hint, palette::kMuted, area.centre_x(),
                            area.bottom() - s_.px(24), Align::Centre);
            page_.list.ink(state_.trail, palette::kInk, area);
        }
        y_ += area.height + s_.px(16);
        const double row = std::round(body_.size_px * 2);
        if (drawing_) {
            const double label = width_ * 0.24, value = width_ * 0.16, base = y_ + row / 2 + cap_drop(body_);
            page_.list.text(fonts_, words_["pressure"], body_, palette::kMuted, x_, base);
            draw_bar(page_.list, {x_ + label, std::round(y_ + row / 2 - s_.px(5)), width_ - label - value, s_.px(10)},
                     state_.pressure, palette::kInk, palette::kWell);
            page_.list.text(fonts_, std::to_string(std::lround(state_.pressure * 100)) + " %",
                            {Face::Medium, body_.size_px, 0}, palette::kInk, x_ + width_, base, Align::Right);
        }
        y_ += row;
        fact(words_["tilt"], state_.tilt_deg ? number_in(words_, std::llround(*state_.tilt_deg)) + "°" : "–");
        fact(words_["across"], state_.across ? number_in(words_, std::llround(state_.across->x)) + " × " +
                                                   number_in(words_, std::llround(state_.across->y)) + " %"
                                             : "–");
        rule();
        wide_switch(words_["pressure_curve"], {words_["curve_soft"], words_["curve_normal"], words_["curve_firm"]},
                    state_.curve, StationAction::Curve);
        wide_switch(words_["tablet_turn"], {"0°", "90°", "180°", "270°"}, state_.turn, StationAction::Turn);
        if (!state_.align_message.empty()) words(state_.align_message, palette::kInk);
        buttons({{words_["align"], ButtonKind::Plain, StationAction::Align, state_.can_align}});
    }

    void collection() {
        if (state_.open_list) return list_panel(*state_.open_list);
        title("collection");
        fact(words_["models"], number_in(words_, state_.models));
        fact(words_["views"], number_in(words_, state_.views));
        fact(words_["search_time"],
             state_.search_ms ? number_in(words_, std::llround(*state_.search_ms)) + " ms" : "–");
        fact(words_["last_change"], state_.changed.empty() ? words_["never"] : state_.changed);
        rule();
        if (state_.importing) {
            words(filled_in(words_["adding"], {{"n", number_in(words_, state_.total)}}), palette::kInk, true);
            std::string counts = filled_in(words_["adding_counts"], {{"a", number_in(words_, state_.done)},
                                                                     {"b", number_in(words_, state_.unreadable)}});
            if (state_.per_minute)
                counts +=
                    filled_in(words_["adding_rate"], {{"n", number_in(words_, std::llround(*state_.per_minute))}});
            if (state_.minutes_left)
                counts += filled_in(words_["adding_time"], {{"t", number_in(words_, *state_.minutes_left)}});
            words(counts, palette::kMuted);
            y_ += s_.px(12);
            if (drawing_) {
                const double share =
                    state_.total > 0 ? static_cast<double>(state_.done) / static_cast<double>(state_.total) : 0;
                draw_bar(page_.list, {x_, y_, width_, s_.px(12)}, share, palette::kSanguine, palette::kWell);
            }
            y_ += s_.px(20);
            words(words_["adding_on"], palette::kMuted);
            buttons({{words_["see_problems"], ButtonKind::Plain, StationAction::Problems},
                     {words_["stop"], ButtonKind::Plain, StationAction::Stop}});
            return;
        }
        if (!state_.import_ended.empty()) words(state_.import_ended, palette::kMuted);
        if (state_.stale) words(words_["stale_title"], palette::kSanguine);
        std::vector<Choice> choices{{words_["add_models"], ButtonKind::Primary, StationAction::Add, state_.can_add},
                                    {words_["see_problems"], ButtonKind::Plain, StationAction::Problems}};
        if (state_.stale)
            choices.insert(choices.begin() + 1, {words_["update_models"], ButtonKind::Plain, StationAction::Update});
        buttons(choices);
    }

    void list_panel(const StationState::List& open) {
        title(open.folders ? "choose_folder" : "see_problems");
        words(fonts_.cut(open.title, body_, width_), palette::kMuted);
        y_ += s_.px(10);
        const double height = s_.target(64);
        for (std::size_t i = 0; i < open.rows.size(); ++i) {
            if (!open.folders) {
                words(open.rows[i], palette::kInk);
                continue;
            }
            const Rect r{x_, y_, width_, height};
            if (drawing_) {
                const std::size_t item = station_item(StationAction::Folder, i);
                page_.list.box(r, s_.px(16), state_.pressed == item ? palette::kWell : palette::kBoard);
                page_.list.text(fonts_, fonts_.cut(open.rows[i], body_, width_ - s_.px(48)), body_, palette::kInk,
                                r.x + s_.px(24), r.centre_y() + cap_drop(body_));
                page_.targets.push_back({Control::Station, item, r});
            }
            y_ += height + std::max(8.0, s_.px(8));
        }
        if (!open.folders) {
            buttons({{words_["close"], ButtonKind::Primary, StationAction::LeaveList}});
            return;
        }
        if (open.all > open.rows.size()) pages(open);
        words(open.model_files > 0 ? filled_in(words_["folder_models"], {{"n", number_in(words_, open.model_files)}})
                                   : words_["folder_empty"],
              palette::kMuted);
        buttons({{words_["add_these"], ButtonKind::Primary, StationAction::AddThese, open.model_files > 0},
                 {words_["folder_up"], ButtonKind::Plain, StationAction::FolderUp},
                 {words_["cancel"], ButtonKind::Plain, StationAction::LeaveList}});
    }

    /// Which of many folders the rows are, between the ways to those before and after.
    void pages(const StationState::List& open) {
        const double height = s_.target(64);
        const std::size_t last = open.first + open.rows.size();
        if (drawing_) {
            for (const bool later : {false, true}) {
                const Rect knob{later ? x_ + width_ - height : x_, y_, height, height};
                const std::size_t item = station_item(later ? StationAction::Later : StationAction::Earlier);
                const bool on = later ? last < open.all : open.first > 0;
                page_.list.box(state_.pressed == item ? scaled(knob, 0.97) : knob, height / 2, palette::kSheet,
                               palette::kLine, line_);
                const double c = knob.centre_x(), m = knob.centre_y(), d = s_.px(8) * (later ? 1 : -1);
                const Colour ink = palette::kInk.faded(on ? 1.0F : palette::kOffShare);
                draw_line(page_.list, {c - d / 2, m - s_.px(10)}, {c + d / 2, m}, line_ * 1.4, ink);
                draw_line(page_.list, {c + d / 2, m}, {c - d / 2, m + s_.px(10)}, line_ * 1.4, ink);
                if (on) page_.targets.push_back({Control::Station, item, knob});
            }
            const std::string which = number_in(words_, static_cast<std::int64_t>(open.first + 1)) + "–" +
                                      number_in(words_, static_cast<std::int64_t>(last)) + " / " +
                                      number_in(words_, static_cast<std::int64_t>(open.all));
            page_.list.text(fonts_, which, body_, palette::kMuted, x_ + width_ / 2, y_ + height / 2 + cap_drop(body_),
                            Align::Centre);
        }
        y_ += height + s_.px(8);
    }

    void idle() {
        title("idle_times");
        const std::array<const char*, kIdleTimeCount> keys{"idle_ask", "idle_countdown", "idle_empty", "idle_garment"};
        for (std::size_t i = 0; i < keys.size(); ++i)
            stepper(words_[keys[i]], std::to_string(state_.idle_s[i]) + " s", i);
    }

    void visitors() {
        title("visitors_see");
        std::vector<std::string> names;
        for (const Strings& language : languages_) names.push_back(language["short"]);
        row_switch(words_["language_start"], names, state_.start_language, StationAction::Language);
        row_switch(words_["hand_start"], {words_["left"], words_["right"]}, state_.start_left ? 0 : 1,
                   StationAction::Hand);
        row_switch(words_["garment_mode"], {words_["off"], words_["on"]}, state_.garment ? 1 : 0,
                   StationAction::Garment);
        row_switch(words_["shadow"], {words_["off"], words_["on"]}, state_.shadow ? 1 : 0, StationAction::Shadow);
        row_switch(words_["part_colours"], {words_["colours_soft"], words_["colours_strong"]}, state_.colours,
                   StationAction::Colours);
    }

    [[nodiscard]] std::string duration() const {
        const std::int64_t minutes = state_.running_s / 60, hours = minutes / 60, days = hours / 24;
        if (days > 0)
            return filled_in(words_["days_hours"], {{"d", std::to_string(days)}, {"h", std::to_string(hours % 24)}});
        return filled_in(words_["hours_minutes"], {{"h", std::to_string(hours)}, {"m", std::to_string(minutes % 60)}});
    }

    void health() {
        title("health");
        fact(words_["running_for"], duration());
        fact(words_["frames_worst"], tenths_in(words_, state_.worst_frame_ms) + " ms", state_.worst_frame_ms <= 100);
        if (state_.pen_live) fact(words_["pen_input"], words_[*state_.pen_live ? "live" : "silent"], *state_.pen_live);
        fact(words_["memory"], number_in(words_, std::llround(state_.memory_mb)) + " MB");
        fact(words_["free_disk"], tenths_in(words_, state_.free_disk_gb) + " GB", state_.free_disk_gb >= 1);
        if (!state_.health_message.empty()) words(state_.health_message, palette::kInk);
        buttons({{words_["self_test"], ButtonKind::Plain, StationAction::SelfTest},
                 {words_["save_report"], ButtonKind::Plain, StationAction::SaveReport}});
    }

    void ends() {
        y_ -= s_.px(14);
        buttons({{words_["restart"], ButtonKind::Plain, StationAction::Restart},
                 {words_["exit_hold"], ButtonKind::Destructive, StationAction::Exit, true, state_.exit_held}});
    }

    /// Both in one panel, so that three columns fit the screen.
    void health_and_ends() {
        health();
        ends();
    }

    StationPage& page_;
    const FontSet& fonts_;
    const std::vector<Strings>& languages_;
    const Strings& words_;
    const StationState& state_;
    ScreenScale s_;
    TextStyle body_, strong_, head_;
    double pad_ = 0, line_ = 1, x_ = 0, y_ = 0, width_ = 0;
    bool drawing_ = false;
};

}  // namespace

StationPage StationScreen::build(const StationState& state, SizePx screen) const {
    StationPage page;
    Builder(page, *fonts_, *languages_, state, screen).build();
    return page;
}

}  // namespace ui
