#include "ui/screens/garment_parts.hpp"

#include <algorithm>
#include <cmath>

#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

TextStyle style(Face face, double px, double tracking = 0) {
    return {face, px, tracking};
}

/// Row `i` of the list as scrolled; without height where none of it is seen.
Rect row_rect(const GarmentLayout& l, std::size_t i, double scroll_px) {
    Rect r = l.rows[0];
    r.y += static_cast<double>(i) * l.row_pitch - scroll_px;
    if (r.bottom() <= l.list.y + 1 || r.y >= l.list.bottom() - 1) r.height = 0;
    return r;
}

/// Whole rows only are drawn and touched: a list that is dragged snaps to rows.
bool whole(const GarmentLayout& l, const Rect& r) {
    return r.height > 0 && r.y >= l.list.y - 2 && r.bottom() <= l.list.bottom() + 2;
}

struct RowPlaces {
    Rect swatch, eye, up, down;
};

RowPlaces places_of(const GarmentLayout& l, const Rect& r) {
    const double side = std::max(64.0, l.px(64));
    RowPlaces at;
    at.swatch = {r.x, r.y, side, r.height};
    at.eye = {r.right() - side, r.y, side, r.height};
    at.down = {at.eye.x - side, r.y, side, r.height};
    at.up = {at.down.x - side, r.y, side, r.height};
    return at;
}

class ListDrawer {
  public:
    ListDrawer(DrawList& list, const FontSet& fonts, const Strings& words, const GarmentState& state,
               const GarmentLayout& layout)
        : list_(list), fonts_(fonts), words_(words), state_(state), l_(layout), type_(garment_type(layout)) {}

    void heads() {
        const double y = l_.list_head.centre_y() + cap_drop(type_.head);
        const auto head = [&](const std::string& word, double x, bool chosen) {
            list_.text(fonts_, word, type_.head, chosen ? palette::kInk : palette::kMuted.faded(0.75F), x, y);
        };
        const double first = fonts_.width_px(words_["layers"], type_.head);
        head(words_["layers"], l_.list_head.x, !state_.history_shown);
        head(words_["history"], l_.list_head.x + first + l_.px(28), state_.history_shown);
        if (state_.history_shown) return;
        const double size = l_.px(28);
        if (down(GarmentAction::AddLayer)) list_.box(l_.add_layer, l_.px(20), palette::kWell);
        list_.icon(Icon::Plus, l_.add_layer.centre_x(), l_.add_layer.centre_y(), size, size / 32 * 2.6, palette::kInk);
    }

    void layers() {
        for (std::size_t i = 0; i < state_.rows.size(); ++i) {
            const Rect r = row_rect(l_, i, state_.scroll_px);
            if (whole(l_, r)) layer(i, r);
        }
    }

    void history() {
        for (std::size_t i = 0; i < state_.history.size(); ++i) {
            const Rect r = row_rect(l_, i, state_.scroll_px);
            if (!whole(l_, r)) continue;
            const HistoryRow& row = state_.history[i];
            if (row.current) list_.box(r, l_.px(16), palette::kSheet, palette::kInk, l_.px(2));
            if (down(GarmentAction::Row, i) && !row.current) list_.box(r, l_.px(16), palette::kWell);
            const double d = l_.px(12);
            const Colour dot = row.undone ? palette::kNone : palette::kInk;
            list_.box({r.x + l_.px(26) - d / 2, r.centre_y() - d / 2, d, d}, d / 2, dot,
                      row.undone ? palette::kMuted : palette::kInk, l_.px(2));
            list_.text(fonts_, fonts_.cut(row.name, type_.row, r.width - l_.px(76)), type_.row,
                       row.undone ? palette::kMuted : palette::kInk, r.x + l_.px(52),
                       r.centre_y() + cap_drop(type_.row));
        }
    }

  private:
    [[nodiscard]] bool down(GarmentAction action, std::size_t index = 0) const {
        return state_.pressed == Control::Garment && state_.pressed_item == garment_item(action, index);
    }

    void layer(std::size_t i, const Rect& r) {
        const LayerRow& row = state_.rows[i];
        if (row.selected) {
            // the layer that is worked on; in red the object that is held by its frame
            list_.box(r, l_.px(16), palette::kSheet, row.object ? palette::kSanguine : palette::kInk, l_.px(2));
        } else if (down(GarmentAction::Row, i)) {
            list_.box(r, l_.px(16), palette::kWell);
        }
        const RowPlaces at = places_of(l_, r);
        const double swatch = l_.px(28);
        list_.box({r.x + l_.px(18), r.centre_y() - swatch / 2, swatch, swatch}, l_.px(8), row.swatch, palette::kEdge,
                  1);
        const double size = l_.px(28);
        const auto icon = [&](const Rect& rect, Icon which, GarmentAction action, Colour colour) {
            if (down(action, i)) list_.box(rect.shrunk(l_.px(6)), l_.px(16), palette::kWell);
            list_.icon(which, rect.centre_x(), rect.centre_y(), size, size / 32 * 2.2, colour);
        };
        if (row.object) {
            icon(at.eye, Icon::Close, GarmentAction::Unplace, palette::kInk);
        } else {
            icon(at.eye, row.shown ? Icon::Eye : Icon::EyeShut, GarmentAction::Eye,
                 row.shown ? palette::kInk : palette::kMuted);
        }
        double right = at.eye.x;
        if (row.selected && !row.body && !row.object && (row.can_up || row.can_down)) {
            icon(at.down, Icon::Down, GarmentAction::RowDown,
                 palette::kInk.faded(row.can_down ? 1.0F : palette::kOffShare));
            icon(at.up, Icon::Up, GarmentAction::RowUp, palette::kInk.faded(row.can_up ? 1.0F : palette::kOffShare));
            right = at.up.x;
        }
        const double x = r.x + l_.px(62);
        double room = right - x - l_.px(8);
        if (row.clashing) {  // a mark and a word
            const double mark = l_.px(24);
            list_.icon(Icon::Warning, right - l_.px(18), r.centre_y(), mark, mark / 32 * 2.4, palette::kSanguine);
            room -= l_.px(40);
        }
        TextStyle name = type_.row;
        if (row.selected) name.face = Face::SemiBold;
        const double y = r.centre_y() + cap_drop(name) - (row.clashing ? l_.px(10) : 0.0);
        list_.text(fonts_, fonts_.cut(row.name, name, room), name, row.shown ? palette::kInk : palette::kMuted, x, y);
        if (row.clashing) {
            draw_fitted(list_, fonts_, words_["note_touch"], type_.caption, palette::kSanguine, x, y + l_.px(23), room,
                        Align::Left);
        }
    }

    DrawList& list_;
    const FontSet& fonts_;
    const Strings& words_;
    const GarmentState& state_;
    const GarmentLayout& l_;
    GarmentType type_;
};

}  // namespace

GarmentType garment_type(const GarmentLayout& l) {
    const auto px = [&](double design) { return l.px(design); };
    const double c = l.compact ? 1 : 0;
    GarmentType t;
    t.wordmark = style(Face::DisplaySemiBold, px(36 - 8 * c), -0.03);
    t.view = style(Face::SemiBold, px(30 - 6 * c), -0.02);
    t.where = style(Face::Medium, px(18 - 1 * c));
    t.tool = style(Face::Medium, px(16));
    t.tile = style(Face::SemiBold, px(17 - 1 * c));
    t.caption = style(Face::Medium, px(17 - 1 * c));
    t.number = style(Face::SemiBold, px(18 - 2 * c));
    t.head = style(Face::SemiBold, px(22 - 3 * c), -0.01);
    t.row = style(Face::Medium, px(20 - 2 * c));
    t.button = style(Face::SemiBold, px(20 - 2 * c));
    t.switched = style(Face::Medium, px(20 - 2 * c));
    t.note = style(Face::Medium, px(17 - 1 * c));
    t.title = style(Face::DisplaySemiBold, px(40 - 10 * c), -0.015);
    t.value = style(Face::SemiBold, px(22 - 5 * c));
    return t;
}

void draw_slider(DrawList& list, const Rect& rect, double share, bool held, bool on, bool grips, double scale) {
    const float a = on ? 1.0F : palette::kOffShare;
    const double line = 8 * scale, reach = 24 * scale;
    const double y = rect.centre_y(), x = rect.x + reach + (rect.width - 2 * reach) * share;
    list.box({rect.x, y - line / 2, rect.width, line}, line / 2, palette::kLine.faded(a));
    list.box({rect.x, y - line / 2, x - rect.x, line}, line / 2, palette::kInk.faded(a));
    const double d = (held ? 60 : 48) * scale;
    list.box({x - d / 2, y - d / 2, d, d}, d / 2, palette::kSheet);
    list.box({x - d / 2, y - d / 2, d, d}, d / 2, palette::kNone, (held ? palette::kSanguine : palette::kInk).faded(a),
             3 * scale);
    if (!grips) return;
    for (const double side : {-4.5, 4.5}) {
        list.box({x + side * scale - scale, y - 9 * scale, 2 * scale, 18 * scale}, scale, palette::kInk.faded(a));
    }
}

void draw_garment_list(DrawList& list, const FontSet& fonts, const Strings& words, const GarmentState& state,
                       const GarmentLayout& layout) {
    ListDrawer drawer(list, fonts, words, state, layout);
    drawer.heads();
    if (state.history_shown) {
        drawer.history();
    } else {
        drawer.layers();
    }
    // more than fits: a thin bar beside the rows says how far down they are
    const double most = GarmentScreen::most_scroll_px(state, layout);
    if (most <= 0) return;
    const Rect& area = layout.list;
    const double whole = area.height + most, width = layout.px(4);
    const double x = layout.hand == Hand::Right ? area.right() + layout.px(8) : area.x - layout.px(8) - width;
    list.box({x, area.y + area.height * state.scroll_px / whole, width, area.height * area.height / whole}, width / 2,
             palette::kMuted.faded(0.5F));
}

void draw_garment_folds(DrawList& list, const FontSet& fonts, const Strings& words, const GarmentState& state,
                        const GarmentLayout& layout) {
    const GarmentType type = garment_type(layout);
    if (state.cleared) {
        list.text(fonts, words["design_cleared"], type.row, palette::kInk, layout.slider.x,
                  layout.slider.centre_y() + cap_drop(type.row));
        const double width = std::round(layout.slider.width * 0.42);
        const bool pressed =
            state.pressed == Control::Garment && state.pressed_item == garment_item(GarmentAction::UndoNew);
        draw_button(list, fonts, {layout.slider.right() - width, layout.slider.y, width, layout.slider.height},
                    words["tool_undo"], type.button, ButtonKind::Plain, pressed, layout.px(2));
        return;
    }
    const float a = state.folds_on ? 1.0F : palette::kOffShare;
    const double half = layout.slider.width * 0.62;
    list.text(fonts, words["folds"], type.head, palette::kInk.faded(a), layout.slider.x, layout.folds_label_baseline);
    if (state.folds_on) {
        const char* word = state.folds < 1.0 / 3 ? "folds_flat" : (state.folds < 2.0 / 3 ? "folds_soft" : "folds_deep");
        const std::string text = state.folds_name.empty() ? words[word] : state.folds_name + ", " + words[word];
        list.text(fonts, fonts.cut(text, type.caption, half), type.caption, palette::kMuted, layout.slider.right(),
                  layout.folds_label_baseline, Align::Right);
    }
    draw_slider(list, layout.slider, state.folds, state.folds_held, state.folds_on, true, layout.scale);
}

void add_list_targets(std::vector<BoardTouch::Target>& all, const GarmentState& state, const GarmentLayout& layout) {
    using A = GarmentAction;
    const auto add = [&](A action, std::size_t index, const Rect& rect) {
        all.push_back({Control::Garment, garment_item(action, index), rect});
    };
    const Rect& head = layout.list_head;
    if (!state.history_shown) add(A::AddLayer, 0, layout.add_layer);
    const double half = std::round((head.width - layout.add_layer.width) * 0.42);
    add(A::ShowLayers, 0, {head.x, head.y, half, head.height});
    add(A::ShowHistory, 0, {head.x + half, head.y, half, head.height});
    const std::size_t rows = state.history_shown ? state.history.size() : state.rows.size();
    for (std::size_t i = 0; i < rows; ++i) {
        const Rect r = row_rect(layout, i, state.scroll_px);
        if (!whole(layout, r)) continue;
        if (!state.history_shown) {
            const RowPlaces at = places_of(layout, r);
            const LayerRow& row = state.rows[i];
            add(row.object ? A::Unplace : A::Eye, i, at.eye);
            if (row.selected && row.can_down) add(A::RowDown, i, at.down);
            if (row.selected && row.can_up) add(A::RowUp, i, at.up);
            if (!row.body && !row.object) add(A::Swatch, i, at.swatch);
        }
        add(A::Row, i, r);
    }
    if (state.cleared) {
        add(A::UndoNew, 0,
            {layout.slider.x + layout.slider.width * 0.58, layout.slider.y, layout.slider.width * 0.42,
             layout.slider.height});
    } else if (state.folds_on) {
        add(A::Folds, 0, layout.slider);
    }
}

}  // namespace ui
