#include "ui/screens/find_screen.hpp"

#include <algorithm>
#include <cmath>

#include "ui/screens/card_text.hpp"
#include "ui/screens/garment_screen.hpp"
#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

using palette::kNone;

/// Type of the two arrangements: what is for reading keeps at least 16 px on small screens.
struct Type {
    TextStyle wordmark, tool, tag, board_hint, sheet_title, sheet_text, switched, chosen;
};

TextStyle style(Face face, double px, double tracking = 0) {
    return {face, px, tracking};
}

Type type_of(const FindLayout& l) {
    const auto px = [&](double design) { return l.px(design); };
    const double c = l.compact ? 1 : 0;
    Type t;
    t.wordmark = style(Face::DisplaySemiBold, px(36 - 8 * c), -0.03);
    t.tool = style(Face::Medium, px(16));
    t.tag = style(Face::SemiBold, px(19 - 4 * c));
    t.board_hint = style(Face::Regular, px(24 - 4 * c));
    t.sheet_title = style(Face::DisplaySemiBold, px(56 - 16 * c), -0.015);
    t.sheet_text = style(Face::Regular, px(28 - 6 * c));
    t.switched = style(Face::Medium, px(20 - 2 * c));
    t.chosen = style(Face::SemiBold, px(20 - 2 * c));
    return t;
}

/// Lines of text centred on a point.
void centred_lines(DrawList& list, const FontSet& fonts, const std::string& text, const TextStyle& s, Colour colour,
                   double cx, double cy, double width, double line_height) {
    const std::vector<std::string> lines = fonts.wrap(text, s, width);
    double y = cy - line_height * (static_cast<double>(lines.size()) - 1) / 2 + cap_drop(s);
    for (const std::string& line : lines) {
        list.text(fonts, line, s, colour, cx, y, Align::Centre);
        y += line_height;
    }
}

class Drawer {
  public:
    Drawer(DrawList& list, const FontSet& fonts, const Strings& words, const FindState& state, const FindLayout& layout)
        : list_(list), fonts_(fonts), words_(words), state_(state), l_(layout), type_(type_of(layout)) {}

    void sheet() {
        list_.box(l_.sheet, 0, palette::kSheet);
        for (const ShadowPart& shadow : state_.shadows) {
            list_.tinted(shadow.coverage, shadow.rect, palette::kShadow.faded(static_cast<float>(shadow.opacity)),
                         l_.sheet);
        }
        for (const WashPart& part : state_.wash) {
            const Colour c = palette::parts()[static_cast<std::size_t>(part.colour)];
            list_.wash(part.coverage, part.rect, c.faded(palette::kWashShare), part.opacity);
        }
        if (state_.sheet_empty) sheet_hint();
        const Rect& inked = state_.inked;
        if (inked.width > 0 && inked.height > 0) {
            // the same command while the ink grows, so that a new piece leaves the rest of the frame as it is
            list_.tinted(state_.ink, l_.sheet, palette::kInk,
                         {inked.x + l_.sheet.x, inked.y + l_.sheet.y, inked.width, inked.height});
        }
        list_.ink(state_.ahead_ink, palette::kInkAhead, l_.sheet);
        list_.ink(state_.wet_ink, palette::kInk, l_.sheet);
        if (state_.eraser_px) ring(*state_.eraser_px, 24);
    }

    /// Above all else: a pen that hovers over the board has its place there, too.
    void pen() {
        if (state_.pen_px && !state_.eraser_px) ring(*state_.pen_px, 10);
    }

    /// Under the sheet, whose shadow falls on it.
    void board() {
        list_.box(l_.board, 0, palette::kBoard);
        const double reach = l_.px(32);
        if (l_.upright) {
            list_.shadow({-2 * reach, l_.board.bottom(), l_.board.width + 4 * reach, 2 * reach}, 0, 0, reach,
                         palette::kShade.faded(1.5F));
            list_.box({0, l_.board.bottom() - 1, l_.board.width, 1}, 0, palette::kEdge.faded(1.2F));
            draw_wordmark(list_, fonts_, l_);
            return;
        }
        const bool right = l_.hand == Hand::Right;
        const double edge = right ? l_.board.right() : l_.board.x;
        const Rect border{right ? edge : edge - 2 * reach, -2 * reach, 2 * reach, l_.board.height + 4 * reach};
        list_.shadow(border, 0, 0, reach, palette::kShade.faded(1.5F));
        list_.box({right ? edge - 1 : edge, 0, 1, l_.board.height}, 0, palette::kEdge.faded(1.2F));
        draw_wordmark(list_, fonts_, l_);
    }

    void cards() {
        for (std::size_t i = 0; i < kCardCount; ++i) {
            const CardSlot& slot = state_.cards[i];
            if (!slot.now || (!slot.before && slot.mix < 1)) waiting(i);
            if (slot.before) card(i, *slot.before, slot.now ? 1 : 1 - slot.mix);
            if (slot.now) card(i, *slot.now, slot.mix);
        }
        if (!state_.cards[0].now && !state_.cards[0].before) board_message();
    }

    void tools() {
        tool(0, Icon::Pen, "tool_pen", Control::Pen, state_.tool == Tool::Pen, true);
        pen_widths(state_.tool == Tool::Pen);
        tool(1, Icon::Eraser, "tool_eraser", Control::Eraser, state_.tool == Tool::Eraser, true);
        tool(2, Icon::Undo, "tool_undo", Control::Undo, false, state_.can_undo);
        tool(3, Icon::Redo, "tool_redo", Control::Redo, false, state_.can_redo);
        tool(4, Icon::New, "tool_new", Control::New, false, !state_.sheet_empty);
        for (const Rect& divider : l_.dividers) {
            if (divider.width > 0) list_.box(divider, 1, palette::kLine);
        }
    }

  private:
    void ring(core::Point centre, double design_px) {
        const double d = l_.px(design_px);
        list_.box({centre.x - d / 2, centre.y - d / 2, d, d}, d / 2, kNone, palette::kInk, l_.px(2));
    }

    void sheet_hint() {
        const double cx = l_.sheet.centre_x(), cy = l_.sheet.centre_y();
        const double width = l_.sheet.width - l_.px(96);
        TextStyle title = type_.sheet_title;
        const double wide = fonts_.width_px(words_["hint_title"], title);
        if (wide > width) title.size_px *= width / wide;  // one line, however long the language says it
        list_.text(fonts_, words_["hint_title"], title, palette::kInk, cx, cy - l_.px(l_.compact ? 14 : 18),
                   Align::Centre);
        const double line = type_.sheet_text.size_px * 1.43;
        double y = cy + l_.px(l_.compact ? 28 : 39);
        for (const std::string& text : fonts_.wrap(words_["hint_text"], type_.sheet_text, width)) {
            list_.text(fonts_, text, type_.sheet_text, palette::kMuted, cx, y, Align::Centre);
            y += line;
        }
    }

    double card_radius(std::size_t i) const { return l_.px(i == 0 ? 20 : 16); }

    void waiting(std::size_t i) {
        list_.box(l_.cards[i], card_radius(i), kNone, palette::kLine, std::max(1.0, std::round(l_.px(2))));
    }

    void board_message() {
        const Rect& best = l_.cards[0];
        const double line = type_.board_hint.size_px * 1.42;
        if (!state_.sheet_cleared) {
            centred_lines(list_, fonts_, state_.board_message, type_.board_hint, palette::kMuted, best.centre_x(),
                          best.centre_y() - l_.px(4), best.width - l_.px(96), line);
            return;
        }
        list_.text(fonts_, words_["sheet_cleared"], type_.board_hint, palette::kMuted, best.centre_x(),
                   best.centre_y() - l_.px(28), Align::Centre);
        const Rect button = undo_clear_rect(l_);
        const bool down = state_.pressed == Control::UndoClear;
        list_.box(down ? scaled(button, 0.97) : button, button.height / 2, down ? palette::kWell : kNone, palette::kInk,
                  l_.px(2));
        list_.text(fonts_, words_["tool_undo"], type_.chosen, palette::kInk, button.centre_x(),
                   button.centre_y() + cap_drop(type_.chosen), Align::Centre);
    }

    void card(std::size_t i, const CardFace& face, double opacity) {
        const Rect& r = l_.cards[i];
        const float a = static_cast<float>(opacity);
        if (i == 0) list_.shadow(r, card_radius(i), l_.px(8), l_.px(28), palette::kShade.faded(a));
        const double line = std::max(1.0, std::round(l_.px(1)));
        list_.box({r.x - line, r.y - line, r.width + 2 * line, r.height + 2 * line}, card_radius(i) + line, kNone,
                  palette::kEdge.faded(a), line);
        const bool down = state_.pressed == Control::Card && state_.pressed_item == i;
        list_.box(r, card_radius(i), (down ? palette::kWell : palette::kSheet).faded(a));
        list_.picture(face.picture, l_.card_pictures[i], opacity);
        if (i == 0) {
            best_text(face, a);
            return;
        }
        if (face.picture == PictureId{}) {
            const TextStyle s = card_text(l_, i).name;
            centred_lines(list_, fonts_, fonts_.cut(face.name, s, r.width - l_.px(24)), s, palette::kInk.faded(a),
                          r.centre_x(), r.centre_y(), r.width, 0);
            return;
        }
        name(card_text(l_, i), face, r, a);
    }

    void name(const CardText& text, const CardFace& face, const Rect& card, float a) {
        double y = card.y + text.name_baseline;
        std::vector<std::string> lines = face.lines;
        if (lines.empty()) lines = {fonts_.cut(face.name, text.name, text.most_px)};
        for (const std::string& line : lines) {
            list_.text(fonts_, line, text.name, palette::kInk.faded(a), card.x + text.x, y);
            y += kNameLineHeight * text.name.size_px;
        }
    }

    void best_text(const CardFace& face, float a) {
        const Rect& r = l_.cards[0];
        const CardText text = card_text(l_, 0);
        name(text, face, r, a);
        if (text.captioned && !face.caption.empty()) {
            list_.text(fonts_, fonts_.cut(face.caption, text.caption, text.most_px), text.caption,
                       palette::kMuted.faded(a), r.x + text.x, r.y + text.caption_baseline);
        }
        const double d = l_.px(l_.compact ? 26 : 32), pitch = l_.px(l_.compact ? 31 : 40);
        double cx = r.x + l_.px(l_.compact ? 16 : 22) + d / 2;
        const double cy = r.bottom() - l_.px(l_.compact ? 25 : 34);
        for (const int tag : face.tags) {
            const std::size_t c = static_cast<std::size_t>(tag);
            list_.box({cx - d / 2, cy - d / 2, d, d}, d / 2, palette::parts()[c].faded(a));
            list_.text(fonts_, std::to_string(tag + 1), type_.tag, palette::tag_text()[c].faded(a), cx,
                       cy + cap_drop(type_.tag), Align::Centre);
            cx += pitch;
        }
    }

    /// Two dots beside the pen: the widths of its line, the one in use at full strength.
    void pen_widths(bool chosen) {
        const Rect& r = l_.tools[0];
        const Colour colour = chosen ? palette::kSheet : palette::kInk;
        const auto dot = [&](double down, double size, bool used) {
            const double d = l_.px(size), x = r.right() - l_.px(14), y = r.y + l_.px(down);
            list_.box({x - d / 2, y - d / 2, d, d}, d / 2, colour.faded(used ? 1.0F : palette::kOffShare));
        };
        dot(17, 5, state_.fine_pen);
        dot(32, 10, !state_.fine_pen);
    }

    void tool(std::size_t i, Icon icon, const char* word, Control control, bool chosen, bool on) {
        const bool down = state_.pressed == control;
        const Rect r = down ? scaled(l_.tools[i], 0.97) : l_.tools[i];
        if (chosen) {
            list_.box(r, l_.px(20), palette::kInk);
        } else if (down) {
            list_.box(r, l_.px(20), palette::kWell);
        }
        const float a = on ? 1.0F : palette::kOffShare;
        const Colour icon_colour = (chosen ? palette::kSheet : palette::kInk).faded(a);
        const Colour text_colour = (chosen ? palette::kSheet : palette::kMuted).faded(a);
        const double size = l_.px(36 - (l_.compact ? 2 : 0));
        list_.icon(icon, r.centre_x(), r.y + l_.px(l_.compact ? 26 : 32), size, size / 32 * 2.2, icon_colour);
        TextStyle s = type_.tool;
        const double wide = fonts_.width_px(words_[word], s), room = r.width + l_.px(16);
        if (wide > room) s.size_px *= room / wide;
        list_.text(fonts_, words_[word], s, text_colour, r.centre_x(), r.y + l_.px(l_.compact ? 64 : 71),
                   Align::Centre);
    }

  public:
    static Rect undo_clear_rect(const FindLayout& l) {
        const Rect& best = l.cards[0];
        const double width = l.px(176), height = l.px(64);
        return {std::round(best.centre_x() - width / 2), std::round(best.centre_y() + l.px(2)), width, height};
    }

  private:
    DrawList& list_;
    const FontSet& fonts_;
    const Strings& words_;
    const FindState& state_;
    const FindLayout& l_;
    Type type_;
};

std::vector<Rect> language_segments(const FindLayout& layout, std::size_t count) {
    const Rect inner = layout.language.shrunk(layout.px(6));
    std::vector<Rect> segments;
    for (std::size_t i = 0; i < count; ++i) {
        const double width = inner.width / static_cast<double>(count);
        segments.push_back({inner.x + width * static_cast<double>(i), inner.y, width, inner.height});
    }
    return segments;
}

}  // namespace

std::optional<Intent> BoardTouch::press(const std::vector<Target>& targets, double x, double y) {
    held_.reset();
    acted_ = false;
    for (const Target& target : targets) {
        if (!target.rect.contains(x, y)) continue;
        held_ = target;
        inside_ = true;
        acted_ = target.control == Control::Undo || target.control == Control::Redo;
        return acted_ ? std::optional<Intent>({target.control, target.item}) : std::nullopt;
    }
    return std::nullopt;
}

void BoardTouch::move(double x, double y) {
    if (held_) inside_ = held_->rect.contains(x, y);
}

std::optional<Intent> BoardTouch::release() {
    std::optional<Intent> intent;
    if (held_ && inside_ && !acted_) intent = Intent{held_->control, held_->item};
    held_.reset();
    return intent;
}

std::optional<Control> BoardTouch::pressed() const {
    return held_ && inside_ ? std::optional<Control>(held_->control) : std::nullopt;
}

DrawList FindScreen::draw(const FindState& state, const FindLayout& layout) const {
    DrawList list;
    Drawer drawer(list, *fonts_, (*languages_)[state.language], state, layout);
    drawer.board();
    drawer.sheet();
    drawer.cards();
    drawer.tools();
    if (state.modes) {
        draw_mode_switch(list, *fonts_, layout.mode_switch, (*languages_)[state.language], false,
                         state.pressed == Control::Mode ? std::optional<std::size_t>(state.pressed_item) : std::nullopt,
                         layout.px(layout.compact ? 18 : 20));
    }
    draw_footer(list, *fonts_, *languages_, state.language, layout, state.pressed, state.pressed_item);
    drawer.pen();
    return list;
}

std::vector<BoardTouch::Target> FindScreen::targets(const FindState& state, const FindLayout& layout) const {
    std::vector<BoardTouch::Target> all = footer_targets(layout, languages_->size());
    all.push_back({Control::Pen, 0, layout.tools[0]});
    all.push_back({Control::Eraser, 0, layout.tools[1]});
    if (state.can_undo) all.push_back({Control::Undo, 0, layout.tools[2]});
    if (state.can_redo) all.push_back({Control::Redo, 0, layout.tools[3]});
    if (!state.sheet_empty) all.push_back({Control::New, 0, layout.tools[4]});
    for (std::size_t i = 0; i < kCardCount; ++i) {
        if (state.cards[i].now) all.push_back({Control::Card, i, layout.cards[i]});
    }
    if (state.modes) {
        for (const BoardTouch::Target& half : mode_targets(layout.mode_switch)) all.push_back(half);
    }
    if (state.sheet_cleared) all.push_back({Control::UndoClear, 0, Drawer::undo_clear_rect(layout)});
    return all;
}

void draw_wordmark(DrawList& list, const FontSet& fonts, const FindLayout& layout) {
    list.text(fonts, "Croquis", type_of(layout).wordmark, palette::kInk, layout.header.x, layout.wordmark_baseline);
}

void draw_footer(DrawList& list, const FontSet& fonts, const std::vector<Strings>& languages, std::size_t language,
                 const FindLayout& layout, std::optional<Control> pressed, std::size_t pressed_item) {
    const Type type = type_of(layout);
    list.box(layout.language, layout.language.height / 2, palette::kWell);
    const std::vector<Rect> segments = language_segments(layout, languages.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const bool chosen = i == language, down = pressed == Control::Language && pressed_item == i;
        const Rect pill = down ? scaled(segments[i], 0.97) : segments[i];
        if (chosen) {
            list.shadow(pill, pill.height / 2, layout.px(2), layout.px(5), palette::kShade.faded(1.4F));
            list.box(pill, pill.height / 2, palette::kSheet);
        } else if (down) {
            list.box(pill, pill.height / 2, palette::kLine);
        }
        const TextStyle& s = chosen ? type.chosen : type.switched;
        list.text(fonts, languages[i]["short"], s, chosen ? palette::kInk : palette::kMuted, pill.centre_x(),
                  pill.centre_y() + cap_drop(s), Align::Centre);
    }
    const bool down = pressed == Control::HandSwitch;
    const Rect hand = down ? scaled(layout.hand_switch, 0.97) : layout.hand_switch;
    list.box(hand, hand.height / 2, down ? palette::kLine : palette::kWell);
    const double icon = layout.px(32);
    list.icon(Icon::Hand, hand.x + layout.px(layout.compact ? 29 : 35), hand.centre_y(), icon, icon / 32 * 2.2,
              palette::kInk);
    const bool right = layout.hand == Hand::Right;
    const Strings& words = languages[language];
    const std::string& word = layout.compact ? words[right ? "hand_right_short" : "hand_left_short"]
                                             : words[right ? "hand_right" : "hand_left"];
    list.text(fonts, word, type.switched, palette::kInk, hand.x + layout.px(layout.compact ? 56 : 68),
              hand.centre_y() + cap_drop(type.switched));
}

std::vector<BoardTouch::Target> footer_targets(const FindLayout& layout, std::size_t language_count) {
    std::vector<BoardTouch::Target> all;
    const std::vector<Rect> segments = language_segments(layout, language_count);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Rect& s = segments[i];  // as high as the whole switch
        all.push_back({Control::Language, i, {s.x, layout.language.y, s.width, layout.language.height}});
    }
    all.push_back({Control::HandSwitch, 0, layout.hand_switch});
    return all;
}

}  // namespace ui
