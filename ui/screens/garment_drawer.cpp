// What covers the board of Garment for a while: the body's measures, fabrics, export, and upright the layers.

#include <algorithm>
#include <cmath>

#include "ui/screens/garment_parts.hpp"
#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

constexpr int kFabricColumns = 3, kColourColumns = 5;
constexpr std::array<const char*, 3> kExports{"export_model", "export_print", "export_cut"};

Rect export_rect(const GarmentLayout& l, std::size_t i) {
    const double high = std::max(64.0, l.px(72)), gap = l.px(16);
    return {l.drawer_list.x, l.drawer_list.y + l.px(16) + static_cast<double>(i) * (high + gap), l.drawer_list.width,
            high};
}

/// Where a measure's number is pressed to be written: at the end of its name's line.
Rect number_rect(const GarmentLayout& l, std::size_t i) {
    const Rect& slider = l.drawer_sliders[i];
    const double wide = l.px(190), top = l.drawer_label_baselines[i] - l.px(l.compact ? 24 : 34);
    const double high = std::max(l.px(l.compact ? 34 : 46), 40.0);
    return {slider.right() - wide, top, wide, high};
}

/// The number pad takes the place of the sliders.
Rect pad_area(const GarmentLayout& l) {
    const double top = l.drawer_sizes.bottom() + l.px(l.compact ? 8 : 24);
    const double width = l.upright ? std::min(l.drawer_list.width, l.px(600)) : l.drawer_list.width;
    return {l.drawer_list.x, l.upright ? l.drawer_sizes.y : top, width,
            l.drawer_left.y - l.px(16) - (l.upright ? l.drawer_sizes.y : top)};
}

struct FilePlaces {
    Rect up, earlier, later;
    std::array<Rect, BodyFiles::kRows> rows;
};
FilePlaces file_places(const GarmentLayout& l) {
    const double high = std::max(64.0, l.px(72)), gap = l.px(10);
    const Rect& area = l.drawer_list;
    FilePlaces at;
    at.up = {area.x, area.y, std::max(64.0, l.px(72)), high};
    const double end = l.drawer_left.y - high - gap * 2;
    const double pitch = std::min(high + gap, (end - at.up.bottom() - gap) / static_cast<double>(BodyFiles::kRows));
    for (std::size_t i = 0; i < at.rows.size(); ++i) {
        at.rows[i] = {area.x, at.up.bottom() + gap + pitch * static_cast<double>(i), area.width,
                      std::min(high, pitch - l.px(4))};
    }
    at.earlier = {area.x, end, high, high};
    at.later = {area.x + high + gap, end, high, high};
    return at;
}

class Drawer {
  public:
    Drawer(DrawList& list, const FontSet& fonts, const std::vector<Strings>& languages, const GarmentState& state,
           const GarmentLayout& layout)
        : list_(list),
          fonts_(fonts),
          languages_(languages),
          words_(languages[state.language]),
          state_(state),
          l_(layout),
          type_(garment_type(layout)) {}

    void head(const std::string& title) {
        draw_fitted(list_, fonts_, title, type_.title, palette::kInk, l_.drawer_left.x, l_.drawer_title_baseline,
                    l_.drawer_close.x - l_.drawer_left.x - l_.px(16), Align::Left);
        const bool pressed = down(GarmentAction::CloseDrawer);
        const Rect r = pressed ? scaled(l_.drawer_close, 0.97) : l_.drawer_close;
        list_.box(r, r.height / 2, pressed ? palette::kLine : palette::kWell);
        const double size = l_.px(30);
        list_.icon(Icon::Close, r.centre_x(), r.centre_y(), size, size / 32 * 2.4, palette::kInk);
    }

    void body() {
        head(words_["body"]);
        const BodyDrawer& b = state_.body;
        std::vector<std::string> sizes = b.sizes;
        if (!sizes.empty()) sizes.back() = words_["men_m"];
        if (b.typed && *b.typed < b.measures.size()) return pad(*b.typed);
        std::optional<std::size_t> pressed = pressed_index(GarmentAction::Size);
        const std::size_t own = sizes.size();
        if (b.own_bodies || b.own_body) {
            sizes.push_back(words_["own_body"]);
            if (down(GarmentAction::OwnBody)) pressed = own;
        }
        draw_switch(list_, fonts_, l_.drawer_sizes, sizes, b.own_body ? own : b.size.value_or(sizes.size()), pressed,
                    type_.switched.size_px);
        for (std::size_t i = 0; i < b.measures.size(); ++i) measure(i);
        language_and_hand();
        const std::string size = b.last_size < sizes.size() ? sizes[b.last_size] : "";
        draw_button(list_, fonts_, l_.drawer_left, filled_in(words_["reset_to"], {{"s", size}}), type_.button,
                    ButtonKind::Quiet, down(GarmentAction::ResetBody), l_.px(2));
        draw_button(list_, fonts_, l_.drawer_right, words_["done"], type_.button, ButtonKind::Primary,
                    down(GarmentAction::Done), l_.px(2));
    }

    /// A measure to be written.
    void pad(std::size_t i) {
        const MeasureSlider& m = state_.body.measures[i];
        const std::string range =
            filled_in(words_["from_to"], {{"a", tenths_in(words_, m.least)}, {"b", tenths_in(words_, m.most)}});
        draw_number_pad(list_, fonts_, words_, state_.body.number, words_[m.key], range, state_.body.number_wrong,
                        number_pad_layout(pad_area(l_), l_.scale), l_.scale, pressed_index(GarmentAction::PadKey));
        draw_button(list_, fonts_, l_.drawer_left, words_["cancel"], type_.button, ButtonKind::Quiet,
                    down(GarmentAction::PadCancel), l_.px(2));
        draw_button(list_, fonts_, l_.drawer_right, words_["done"], type_.button, ButtonKind::Primary,
                    down(GarmentAction::PadDone), l_.px(2), state_.body.number.value().has_value());
    }

    void body_files() {
        head(words_["own_body_title"]);
        const BodyFiles& files = state_.body_files;
        const FilePlaces at = file_places(l_);
        const double size = l_.px(28);
        if (files.up) {
            list_.box(at.up, at.up.height / 2, down(GarmentAction::BodyUp) ? palette::kLine : palette::kWell);
            list_.icon(Icon::Back, at.up.centre_x(), at.up.centre_y(), size, size / 32 * 2.4, palette::kInk);
        }
        const double x = at.up.x + (files.up ? at.up.width + l_.px(16) : 0.0);
        draw_fitted(list_, fonts_, files.title, type_.row, palette::kMuted, x, at.up.centre_y() + cap_drop(type_.row),
                    l_.drawer_list.right() - x, Align::Left);
        for (std::size_t i = 0; i < std::min(files.rows.size(), at.rows.size()); ++i) {
            const bool pressed = down(GarmentAction::BodyFile, i);
            const Rect r = pressed ? scaled(at.rows[i], 0.97) : at.rows[i];
            list_.box(r, l_.px(16), pressed ? palette::kWell : palette::kSheet, palette::kLine,
                      std::max(1.0, l_.px(1)));
            list_.icon(files.rows[i].folder ? Icon::Collection : Icon::OnBody, r.x + l_.px(38), r.centre_y(), size,
                       size / 32 * 2.2, palette::kInk);
            list_.text(fonts_, fonts_.cut(files.rows[i].name, type_.row, r.width - l_.px(90)), type_.row, palette::kInk,
                       r.x + l_.px(70), r.centre_y() + cap_drop(type_.row));
        }
        if (files.all > BodyFiles::kRows) {
            arrow(at.earlier, Icon::Up, GarmentAction::BodyEarlier, files.first > 0);
            arrow(at.later, Icon::Down, GarmentAction::BodyLater, files.first + BodyFiles::kRows < files.all);
        }
        const std::string message = files.reading                             ? words_["own_body_reading"]
                                    : files.problem.empty() && files.all == 0 ? words_["own_body_none"]
                                                                              : files.problem;
        double y = at.earlier.y + type_.row.size_px;
        const double left = files.all > BodyFiles::kRows ? at.later.right() + l_.px(20) : at.earlier.x;
        for (const std::string& line : fonts_.wrap(message, type_.caption, l_.drawer_list.right() - left)) {
            list_.text(fonts_, line, type_.caption, files.problem.empty() ? palette::kMuted : palette::kSanguine, left,
                       y);
            y += type_.caption.size_px * 1.4;
        }
        done();
    }

    void fabrics() {
        head(words_["fabric"]);
        const FabricPlaces at = fabric_places(l_, state_.fabrics.size());
        for (std::size_t i = 0; i < state_.fabrics.size(); ++i) {
            const FabricTile& f = state_.fabrics[i];
            const Rect r = down(GarmentAction::Fabric, i) ? scaled(at.fabrics[i], 0.97) : at.fabrics[i];
            list_.box(r, l_.px(16), palette::kSheet, f.chosen ? palette::kSanguine : palette::kEdge,
                      f.chosen ? std::max(3.0, l_.px(3)) : 1);
            const Rect inner = r.shrunk(l_.px(7));
            const double label = l_.px(34);
            PictureCommand cut;  // as wide as the card; a low one shows less of the tile
            cut.picture = f.picture;
            cut.rect = {inner.x, inner.y, inner.width, inner.height - label};
            cut.source = {0, 0, 1, cut.rect.height / cut.rect.width};
            list_.commands.emplace_back(cut);
            draw_fitted(list_, fonts_, f.name, type_.caption, palette::kInk, r.centre_x(), r.bottom() - l_.px(15),
                        r.width - l_.px(12), Align::Centre);
        }
        for (std::size_t i = 0; i < at.colours.size(); ++i) {
            const Rect r = down(GarmentAction::Colour, i) ? scaled(at.colours[i], 0.97) : at.colours[i];
            list_.box(r, l_.px(16), Colour::hex(kSwatches[i]), state_.colour == i ? palette::kSanguine : palette::kEdge,
                      state_.colour == i ? std::max(3.0, l_.px(3)) : 1);
        }
        if (!state_.fabric_problem.empty()) {
            const double wide = l_.drawer_right.x - l_.drawer_left.x - l_.px(16);
            double y = l_.drawer_left.y + type_.caption.size_px;
            for (const std::string& line : fonts_.wrap(state_.fabric_problem, type_.caption, wide)) {
                list_.text(fonts_, line, type_.caption, palette::kSanguine, l_.drawer_left.x, y);
                y += type_.caption.size_px * 1.3;
            }
        }
        done();
    }

    void layers() {
        head("");
        draw_garment_list(list_, fonts_, words_, state_, l_);
        draw_garment_folds(list_, fonts_, words_, state_, l_);
        done();
    }

    void exports() {
        head(words_["export"]);
        for (std::size_t i = 0; i < kExports.size(); ++i) {
            draw_button(list_, fonts_, export_rect(l_, i), words_[kExports[i]], type_.button, ButtonKind::Plain,
                        down(GarmentAction::ExportAs, i), l_.px(2), !state_.empty && !state_.export_busy);
        }
        const Rect last = export_rect(l_, kExports.size());
        if (state_.export_busy) {
            draw_bar(list_, {last.x, last.y + l_.px(8), last.width, l_.px(8)}, state_.export_share, palette::kSanguine,
                     palette::kWell);
        }
        double y = last.y + l_.px(52);
        const std::string message = state_.empty ? words_["export_nothing"] : state_.export_message;
        for (const std::string& line : fonts_.wrap(message, type_.row, last.width)) {
            list_.text(fonts_, line, type_.row, palette::kInk, last.x, y);
            y += type_.row.size_px * 1.4;
        }
        done();
    }

  private:
    [[nodiscard]] bool down(GarmentAction action, std::size_t index = 0) const {
        return state_.pressed == Control::Garment && state_.pressed_item == garment_item(action, index);
    }
    [[nodiscard]] std::optional<std::size_t> pressed_index(GarmentAction action) const {
        if (state_.pressed != Control::Garment) return std::nullopt;
        const GarmentIntent intent = garment_intent(state_.pressed_item);
        return intent.action == action ? std::optional<std::size_t>(intent.index) : std::nullopt;
    }

    void done() {
        draw_button(list_, fonts_, l_.drawer_right, words_["done"], type_.button, ButtonKind::Primary,
                    down(GarmentAction::Done), l_.px(2));
    }

    void arrow(const Rect& r, Icon icon, GarmentAction action, bool on) {
        const double size = l_.px(28);
        list_.box(r, r.height / 2, down(action) ? palette::kLine : palette::kWell);
        list_.icon(icon, r.centre_x(), r.centre_y(), size, size / 32 * 2.4,
                   palette::kInk.faded(on ? 1.0F : palette::kOffShare));
    }

    void measure(std::size_t i) {
        const MeasureSlider& m = state_.body.measures[i];
        const Rect& r = l_.drawer_sliders[i];
        const float a = state_.body.own_body ? palette::kOffShare : 1.0F;
        const double y = l_.drawer_label_baselines[i];
        TextStyle name = type_.row;
        name.face = Face::Medium;
        list_.text(fonts_, words_[m.key], name, palette::kInk.faded(a), r.x, y);
        const std::string unit = " cm";
        const double wide = fonts_.width_px(unit, name) + l_.px(12);
        const Rect box = number_rect(l_, i);  // it can be pressed
        if (!state_.body.own_body) {
            list_.box(box, box.height / 2, down(GarmentAction::TypeMeasure, i) ? palette::kLine : palette::kWell);
        }
        list_.text(fonts_, unit, name, palette::kMuted.faded(a), r.right() - wide, y);
        list_.text(fonts_, tenths_in(words_, m.cm), type_.value, palette::kInk.faded(a), r.right() - wide, y,
                   Align::Right);
        const double share = std::clamp((m.cm - m.least) / std::max(m.most - m.least, 1e-6), 0.0, 1.0);
        // knobs smaller than those of folds where lines are close
        draw_slider(list_, r, share, state_.body.held == i, !state_.body.own_body, false,
                    l_.scale * (l_.compact ? 0.62 : 0.84));
    }

    void language_and_hand() {
        std::vector<std::string> codes;
        for (const Strings& language : languages_) codes.push_back(language["short"]);
        const std::optional<std::size_t> pressed =
            state_.pressed == Control::Language ? std::optional<std::size_t>(state_.pressed_item) : std::nullopt;
        draw_switch(list_, fonts_, l_.drawer_language, codes, state_.language, pressed, type_.switched.size_px);
        const bool held = state_.pressed == Control::HandSwitch;
        const Rect r = held ? scaled(l_.drawer_hand, 0.97) : l_.drawer_hand;
        list_.box(r, r.height / 2, held ? palette::kLine : palette::kWell);
        const double size = l_.px(30);
        list_.icon(Icon::Hand, r.x + l_.px(38), r.centre_y(), size, size / 32 * 2.2, palette::kInk);
        const bool right = l_.hand == Hand::Right;
        draw_fitted(list_, fonts_, words_[right ? "hand_right" : "hand_left"], type_.switched, palette::kInk,
                    r.x + l_.px(68), r.centre_y() + cap_drop(type_.switched), r.width - l_.px(88), Align::Left);
    }

    DrawList& list_;
    const FontSet& fonts_;
    const std::vector<Strings>& languages_;
    const Strings& words_;
    const GarmentState& state_;
    const GarmentLayout& l_;
    GarmentType type_;
};

}  // namespace

FabricPlaces fabric_places(const GarmentLayout& l, std::size_t fabrics) {
    FabricPlaces at;
    const double gap = l.px(16), columns = l.upright ? 2.0 * kFabricColumns : kFabricColumns;
    const double wide = std::floor((l.drawer_list.width - (columns - 1) * gap) / columns);
    const auto per_row = static_cast<std::size_t>(columns);
    const std::size_t rows = (fabrics + per_row - 1) / std::max<std::size_t>(per_row, 1);
    const double swatch = std::max(64.0, l.px(64));
    const double colour_columns = l.upright ? 2.0 * kColourColumns : kColourColumns;
    const double colour_rows = std::ceil(static_cast<double>(kSwatches.size()) / colour_columns);
    const double room = l.drawer_list.height - colour_rows * (swatch + gap) - l.px(12);
    const double high =
        std::min(wide, std::floor((room - static_cast<double>(rows) * gap) / std::max(1.0, static_cast<double>(rows))));
    for (std::size_t i = 0; i < fabrics; ++i) {
        const double column = static_cast<double>(i % per_row);
        const std::size_t row_index = i / per_row;
        at.fabrics.push_back({l.drawer_list.x + column * (wide + gap),
                              l.drawer_list.y + static_cast<double>(row_index) * (high + gap), wide, high});
    }
    const double top = l.drawer_list.y + static_cast<double>(rows) * (high + gap) + l.px(12);
    const double side = std::floor((l.drawer_list.width - (colour_columns - 1) * gap) / colour_columns);
    for (std::size_t i = 0; i < kSwatches.size(); ++i) {
        const auto n = static_cast<std::size_t>(colour_columns);
        const std::size_t row_index = i / n;
        at.colours.push_back({l.drawer_list.x + static_cast<double>(i % n) * (side + gap),
                              top + static_cast<double>(row_index) * (swatch + gap), side, swatch});
    }
    return at;
}

void draw_garment_drawer(DrawList& list, const FontSet& fonts, const std::vector<Strings>& languages,
                         const GarmentState& state, const GarmentLayout& layout) {
    Drawer drawer(list, fonts, languages, state, layout);
    switch (state.drawer) {
        case GarmentDrawer::Body:
            drawer.body();
            break;
        case GarmentDrawer::OwnBody:
            drawer.body_files();
            break;
        case GarmentDrawer::Fabric:
            drawer.fabrics();
            break;
        case GarmentDrawer::Layers:
            drawer.layers();
            break;
        case GarmentDrawer::Export:
            drawer.exports();
            break;
        case GarmentDrawer::None:
            break;
    }
}

void add_drawer_targets(std::vector<BoardTouch::Target>& all, const GarmentState& state, const GarmentLayout& layout,
                        std::size_t language_count) {
    using A = GarmentAction;
    const auto add = [&](A action, std::size_t index, const Rect& rect) {
        all.push_back({Control::Garment, garment_item(action, index), rect});
    };
    if (state.drawer == GarmentDrawer::Body && state.body.typed) {
        const NumberPadLayout pad = number_pad_layout(pad_area(layout), layout.scale);
        for (std::size_t i = 0; i < kPadKeys; ++i) add(A::PadKey, i, pad.keys[i]);
        add(A::PadCancel, 0, layout.drawer_left);
        if (state.body.number.value()) add(A::PadDone, 0, layout.drawer_right);
        return;
    }
    add(A::CloseDrawer, 0, layout.drawer_close);
    add(A::Done, 0, layout.drawer_right);
    if (state.drawer == GarmentDrawer::Body) {
        const bool own = state.body.own_bodies || state.body.own_body;
        const std::size_t count = state.body.sizes.size();
        const std::vector<Rect> sizes = switch_segments(layout.drawer_sizes, count + (own ? 1 : 0));
        for (std::size_t i = 0; i < count; ++i) add(A::Size, i, sizes[i]);
        if (own && state.body.own_bodies) add(A::OwnBody, 0, sizes[count]);
        for (std::size_t i = 0; i < kBodySliders && !state.body.own_body; ++i) {
            add(A::TypeMeasure, i, number_rect(layout, i));
        }
        for (std::size_t i = 0; i < kBodySliders && !state.body.own_body; ++i) {
            add(A::Measure, i, layout.drawer_sliders[i]);
        }
        const std::vector<Rect> languages = switch_segments(layout.drawer_language, language_count);
        for (std::size_t i = 0; i < languages.size(); ++i) all.push_back({Control::Language, i, languages[i]});
        all.push_back({Control::HandSwitch, 0, layout.drawer_hand});
        add(A::ResetBody, 0, layout.drawer_left);
    } else if (state.drawer == GarmentDrawer::OwnBody) {
        const BodyFiles& files = state.body_files;
        const FilePlaces at = file_places(layout);
        if (files.up) add(A::BodyUp, 0, at.up);
        for (std::size_t i = 0; i < std::min(files.rows.size(), at.rows.size()) && !files.reading; ++i) {
            add(A::BodyFile, i, at.rows[i]);
        }
        if (files.first > 0) add(A::BodyEarlier, 0, at.earlier);
        if (files.first + BodyFiles::kRows < files.all) add(A::BodyLater, 0, at.later);
    } else if (state.drawer == GarmentDrawer::Fabric) {
        const FabricPlaces at = fabric_places(layout, state.fabrics.size());
        for (std::size_t i = 0; i < at.fabrics.size(); ++i) add(A::Fabric, i, at.fabrics[i]);
        for (std::size_t i = 0; i < at.colours.size(); ++i) add(A::Colour, i, at.colours[i]);
    } else if (state.drawer == GarmentDrawer::Export) {
        for (std::size_t i = 0; i < kExports.size() && !state.empty && !state.export_busy; ++i) {
            add(A::ExportAs, i, export_rect(layout, i));
        }
    } else if (state.drawer == GarmentDrawer::Layers) {
        add_list_targets(all, state, layout);
    }
}

}  // namespace ui
