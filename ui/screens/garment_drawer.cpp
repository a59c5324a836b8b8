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

/// Own mannequins are offered beside the sizes' end.
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
        const std::optional<std::size_t> pressed = pressed_index(GarmentAction::Size);
        draw_switch(list_, fonts_, l_.drawer_sizes, sizes, b.size.value_or(sizes.size()), pressed,
                    type_.switched.size_px);
        for (std::size_t i = 0; i < b.measures.size(); ++i) measure(i);
        language_and_hand();
        const std::string size = b.last_size < sizes.size() ? sizes[b.last_size] : "";
        draw_button(list_, fonts_, l_.drawer_left, filled_in(words_["reset_to"], {{"s", size}}), type_.button,
                    ButtonKind::Quiet, down(GarmentAction::ResetBody), l_.px(2));
        draw_button(list_, fonts_, l_.drawer_right, words_["done"], type_.button, ButtonKind::Primary,
                    down(GarmentAction::Done), l_.px(2));
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

    void measure(std::size_t i) {
        const MeasureSlider& m = state_.body.measures[i];
        const Rect& r = l_.drawer_sliders[i];
        const float a = state_.body.own_body ? palette::kOffShare : 1.0F;
        const double y = l_.drawer_label_baselines[i];
        TextStyle name = type_.row;
        name.face = Face::Medium;
        list_.text(fonts_, words_[m.key], name, palette::kInk.faded(a), r.x, y);
        const std::string unit = " cm";
        const double wide = fonts_.width_px(unit, name);
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
    add(A::CloseDrawer, 0, layout.drawer_close);
    add(A::Done, 0, layout.drawer_right);
    if (state.drawer == GarmentDrawer::Body) {
        const std::vector<Rect> sizes = switch_segments(layout.drawer_sizes, state.body.sizes.size());
        for (std::size_t i = 0; i < sizes.size(); ++i) add(A::Size, i, sizes[i]);
        for (std::size_t i = 0; i < kBodySliders && !state.body.own_body; ++i) {
            add(A::Measure, i, layout.drawer_sliders[i]);
        }
        const std::vector<Rect> languages = switch_segments(layout.drawer_language, language_count);
        for (std::size_t i = 0; i < languages.size(); ++i) all.push_back({Control::Language, i, languages[i]});
        all.push_back({Control::HandSwitch, 0, layout.drawer_hand});
        add(A::ResetBody, 0, layout.drawer_left);
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
