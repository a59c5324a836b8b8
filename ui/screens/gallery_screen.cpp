#include "ui/screens/gallery_screen.hpp"

#include <algorithm>
#include <cmath>

#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

constexpr double kCardLeast_px = 500;  // wide, times the scale where that is above 1
constexpr double kPictureShape = 0.75;

class Builder {
  public:
    Builder(GalleryPage& page, const FontSet& fonts, const std::vector<Strings>& languages, const GalleryState& state,
            SizePx screen)
        : page_(page),
          list_(page.list),
          fonts_(fonts),
          words_(languages[state.language]),
          state_(state),
          screen_(screen),
          s_(ScreenScale::of(screen)),
          strong_(s_.text(Face::SemiBold, 20)),
          body_(s_.text(Face::Regular, 20)),
          margin_(s_.px(40)),
          gap_(s_.px(24)),
          line_(std::max(1.5, s_.px(2))) {}

    void build() {
        list_.box({0, 0, s_.width(), s_.height()}, 0, palette::kBoard);
        cards();
        header();
        bar();
        if (state_.rename) keyboard();
    }

  private:
    [[nodiscard]] double header_height() const { return s_.px(32) + s_.target(72) + s_.px(24); }
    [[nodiscard]] double bar_height() const {
        return state_.deleted.empty() && state_.message.empty() ? 0.0 : s_.target(72) + s_.px(40);
    }
    [[nodiscard]] bool left_handed() const { return state_.hand == Hand::Left; }
    /// Where it stands for the drawing hand.
    [[nodiscard]] Rect placed(Rect r) const {
        if (left_handed()) r.x = s_.width() - r.x - r.width;
        return r;
    }

    void target(const Rect& r, GalleryAction action, std::size_t index = 0) {
        if (!state_.rename) page_.targets.push_back({Control::Gallery, gallery_item(action, index), r});
    }
    [[nodiscard]] bool down(GalleryAction action, std::size_t index = 0) const {
        return !state_.rename && state_.pressed == gallery_item(action, index);
    }

    void button(const Rect& r, const std::string& words, ButtonKind kind, GalleryAction action) {
        draw_button(list_, fonts_, r, words, strong_, kind, down(action), line_);
        target(r, action);
    }
    [[nodiscard]] double button_width(const std::string& words) const {
        return std::round(std::max(s_.px(180), fonts_.width_px(words, strong_) + s_.px(72)));
    }

    /// Buttons stand on the side away from the hand's edge of the sheet, the title on the other.
    void header() {
        const double height = s_.target(72), y = s_.px(32);
        list_.box({0, 0, s_.width(), header_height()}, 0, palette::kBoard);
        std::erase_if(page_.targets, [&](const BoardTouch::Target& t) { return t.rect.centre_y() < header_height(); });
        double right = s_.width() - margin_;
        const auto next = [&](double width) {
            right -= width;
            const Rect r = placed({right, y, width, height});
            right -= s_.px(16);
            return r;
        };
        button(next(button_width(words_["close"])), words_["close"], ButtonKind::Primary, GalleryAction::Close);
        if (!state_.bin)
            button(next(button_width(words_["new_design"])), words_["new_design"], ButtonKind::Quiet,
                   GalleryAction::New);
        const std::vector<std::string> shelves{words_["tool_designs"], words_["bin"]};
        double widest = 0;
        for (const std::string& shelf : shelves) widest = std::max(widest, fonts_.width_px(shelf, strong_));
        const Rect r = next(std::round(2 * (widest + s_.px(56))));
        std::optional<std::size_t> held;
        if (state_.pressed && gallery_action(*state_.pressed) == GalleryAction::Shelf)
            held = gallery_index(*state_.pressed);
        draw_switch(list_, fonts_, r, shelves, state_.bin ? 1 : 0, held, strong_.size_px);
        const std::vector<Rect> segments = switch_segments(r, shelves.size());
        for (std::size_t i = 0; i < segments.size(); ++i) target(segments[i], GalleryAction::Shelf, i);
        const TextStyle title = s_.text(Face::DisplaySemiBold, 40, -0.015);
        const Rect room = placed({margin_, y, right - margin_, height});
        list_.text(fonts_, fonts_.cut(words_[state_.bin ? "bin" : "your_designs"], title, room.width), title,
                   palette::kInk, left_handed() ? room.right() : room.x, y + height / 2 + cap_drop(title),
                   left_handed() ? Align::Right : Align::Left);
    }

    void cards() {
        const double unit = std::max(1.0, s_.scale), inner = s_.width() - 2 * margin_;
        const auto columns =
            static_cast<std::size_t>(std::max(1.0, std::floor((inner + gap_) / (kCardLeast_px * unit + gap_))));
        const double width =
            std::floor((inner - gap_ * static_cast<double>(columns - 1)) / static_cast<double>(columns));
        const double height = std::max(s_.px(304), s_.target(64) + body_.size_px * 7.2);
        double y = header_height() + s_.px(8) - state_.scroll;
        if (state_.bin) {
            list_.text(fonts_, filled_in(words_["bin_keeps"], {{"n", std::to_string(state_.bin_days)}}), body_,
                       palette::kMuted, left_handed() ? s_.width() - margin_ : margin_, y + body_.size_px,
                       left_handed() ? Align::Right : Align::Left);
            y += std::round(body_.size_px * 2.2);
        }
        if (state_.cards.empty()) return nothing();
        for (std::size_t i = 0; i < state_.cards.size(); ++i) {
            const auto column = static_cast<double>(i % columns);
            card(i, placed({margin_ + column * (width + gap_), y, width, height}));
            if (i % columns == columns - 1 || i + 1 == state_.cards.size()) y += height + gap_;
        }
        page_.most_scroll = std::max(0.0, y + state_.scroll + bar_height() + s_.px(16) - s_.height());
    }

    void nothing() {
        const double x = s_.width() / 2, y = s_.height() * 0.45;
        list_.icon(Icon::Designs, x, y - s_.px(90), s_.px(96), s_.px(96) / 32 * 1.6, palette::kMuted);
        draw_centred_lines(list_, fonts_, words_[state_.bin ? "bin_empty" : "no_designs"], s_.text(Face::Regular, 28),
                           palette::kMuted, x, y, s_.width() - 2 * margin_, std::round(s_.px(40)));
    }

    void card(std::size_t i, const Rect& r) {
        if (r.bottom() < header_height() || r.y > s_.height()) return;
        page_.seen.push_back(i);
        const GalleryCard& card = state_.cards[i];
        const bool pressed = down(GalleryAction::Open, i);
        const Rect shown = pressed ? scaled(r, 0.99) : r;
        list_.box({shown.x - 1, shown.y - 1, shown.width + 2, shown.height + 2}, s_.px(20) + 1, palette::kNone,
                  palette::kEdge, 1);
        list_.box(shown, s_.px(20), pressed ? palette::kWell : palette::kSheet);
        if (card.open) list_.box(shown, s_.px(20), palette::kNone, palette::kSanguine, line_ * 1.5);
        const double pad = s_.px(16), tall = shown.height - 2 * pad, wide = std::round(tall * kPictureShape);
        const double picture_x = left_handed() ? shown.right() - pad - wide : shown.x + pad;
        picture(card, {picture_x, shown.y + pad, wide, tall});
        const double left = left_handed() ? shown.x + s_.px(20) : picture_x + wide + s_.px(20);
        const double room = shown.width - wide - pad - s_.px(40);
        words(card, left, shown.y + s_.px(24), room);
        buttons(i, {left, shown.bottom() - pad - s_.target(64), room, s_.target(64)});
        if (!state_.bin) target({r.x, r.y, r.width, r.height - s_.target(64) - 2 * pad}, GalleryAction::Open, i);
    }

    void picture(const GalleryCard& card, const Rect& r) {
        list_.box(r, s_.px(12), palette::kBoard);
        if (card.picture)
            list_.picture(*card.picture, r);
        else
            list_.icon(Icon::Designs, r.centre_x(), r.centre_y(), s_.px(64), s_.px(64) / 32 * 1.8, palette::kMuted);
    }

    void words(const GalleryCard& card, double x, double y, double room) {
        const TextStyle name = s_.text(Face::SemiBold, 24);
        const std::string shown = card.name.empty() ? words_["unnamed"] : card.name;
        std::vector<std::string> lines = fonts_.wrap(shown, name, room);
        if (lines.size() > 2) {
            lines[1] = fonts_.cut(lines[1] + " " + lines[2], name, room);
            lines.resize(2);
        }
        for (const std::string& line : lines) {
            y += std::round(name.size_px * 1.25);
            list_.text(fonts_, fonts_.cut(line, name, room), name, palette::kInk, x, y - name.size_px * 0.25);
        }
        y += std::round(body_.size_px * 1.5);
        list_.text(fonts_, fonts_.cut(card.date, body_, room), body_, palette::kMuted, x, y - body_.size_px * 0.25);
        if (!card.open) return;
        y += std::round(body_.size_px * 1.5);
        list_.text(fonts_, fonts_.cut(words_["design_open"], strong_, room), strong_, palette::kSanguine, x,
                   y - body_.size_px * 0.25);
    }

    /// Round buttons with a sign and its word below would need more room than a card has: signs alone for what can be
    /// undone, words in the bin.
    void buttons(std::size_t i, const Rect& row) {
        if (state_.bin) {
            const Rect r{row.x, row.y, std::min(row.width, button_width(words_["restore"])), row.height};
            draw_button(list_, fonts_, r, words_["restore"], strong_, ButtonKind::Plain,
                        down(GalleryAction::Restore, i), line_);
            return target(r, GalleryAction::Restore, i);
        }
        struct Sign {
            Icon icon;
            const char* key;
            GalleryAction action;
        };
        const std::array<Sign, 3> signs{Sign{Icon::Layers, "duplicate", GalleryAction::Duplicate},
                                        Sign{Icon::Pen, "rename", GalleryAction::Rename},
                                        Sign{Icon::Remove, "delete", GalleryAction::Delete}};
        const double gap = std::max(8.0, s_.px(8)), wide = std::floor((row.width - 2 * gap) / 3);
        const TextStyle caption = s_.text(Face::Medium, 16);
        for (std::size_t k = 0; k < signs.size(); ++k) {
            const Rect r{row.x + static_cast<double>(k) * (wide + gap), row.y, wide, row.height};
            const bool held = down(signs[k].action, i);
            const bool on = !state_.cards[i].open || signs[k].action != GalleryAction::Delete;
            const float share = on ? 1.0F : palette::kOffShare;
            list_.box(held ? scaled(r, 0.97) : r, s_.px(16), held ? palette::kWell : palette::kBoard);
            const double size = s_.px(28);
            list_.icon(signs[k].icon, r.centre_x(), r.y + r.height * 0.34, size, size / 32 * 2.2,
                       palette::kInk.faded(share));
            draw_fitted(list_, fonts_, words_[signs[k].key], caption, palette::kMuted.faded(share), r.centre_x(),
                        r.y + r.height * 0.82, r.width - s_.px(8), Align::Centre);
            if (on) target(r, signs[k].action, i);
        }
    }

    /// What was deleted and can be taken back, or what went wrong.
    void bar() {
        if (bar_height() == 0) return;
        const double inset = s_.px(4), height = s_.target(68) + 2 * inset;
        const double width = std::min(s_.width() - 2 * margin_, s_.px(960));
        const Rect r{std::round((s_.width() - width) / 2), s_.height() - height - s_.px(32), width, height};
        list_.shadow(r, height / 2, s_.px(8), s_.px(14), palette::kShade);
        list_.box(r, height / 2, palette::kInk);
        const bool undo = state_.message.empty();
        const std::string text =
            undo ? filled_in(words_["design_deleted"], {{"name", state_.deleted}}) : state_.message;
        const double side = undo ? button_width(words_["tool_undo"]) : 0;
        draw_fitted(list_, fonts_, text, s_.text(Face::Medium, 20), palette::kSheet, r.x + s_.px(36),
                    r.centre_y() + cap_drop(body_), r.width - side - s_.px(80), Align::Left);
        std::erase_if(page_.targets, [&](const BoardTouch::Target& t) {
            return t.rect.bottom() > r.y && t.rect.right() > r.x && t.rect.x < r.right();
        });
        if (!undo) return;
        const Rect b{r.right() - side - s_.px(6), r.y + inset, side, height - 2 * inset};
        draw_button(list_, fonts_, b, words_["tool_undo"], strong_, ButtonKind::Quiet, down(GalleryAction::UndoDelete),
                    line_);
        target(b, GalleryAction::UndoDelete);
    }

    void keyboard() {
        const KeyboardLayout layout = keyboard_layout(*state_.rename, words_, screen_);
        int held = -1;
        if (state_.pressed && gallery_action(*state_.pressed) == GalleryAction::Key)
            held = static_cast<int>(gallery_index(*state_.pressed));
        draw_keyboard(list_, fonts_, words_, *state_.rename, layout, screen_, held);
        for (std::size_t i = 0; i < layout.keys.size(); ++i)
            page_.targets.push_back({Control::Gallery, gallery_item(GalleryAction::Key, i), layout.keys[i].rect});
    }

    GalleryPage& page_;
    DrawList& list_;
    const FontSet& fonts_;
    const Strings& words_;
    const GalleryState& state_;
    SizePx screen_;
    ScreenScale s_;
    TextStyle strong_, body_;
    double margin_, gap_, line_;
};

}  // namespace

GalleryPage GalleryScreen::build(const GalleryState& state, SizePx screen) const {
    GalleryPage page;
    Builder(page, *fonts_, *languages_, state, screen).build();
    return page;
}

}  // namespace ui
