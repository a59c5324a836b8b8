// The stepper below the tools: its number, its two knobs, and where its plane lies in the small views.

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/screens/garment_parts.hpp"
#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

struct Words {
    const char *label, *none;
};

Words words_of(StepperOf what) {
    static constexpr std::array<Words, 6> kWords{{{"offset_from_body", ""},
                                                  {"plane_depth", "plane_by_line"},
                                                  {"plane_across", "plane_by_line"},
                                                  {"plane_height", "plane_by_line"},
                                                  {"plane_above_point", ""},
                                                  {"quads_size", ""}}};
    return kWords[static_cast<std::size_t>(what)];
}

}  // namespace

std::string stepper_number(const Strings& words, const Stepper& stepper) {
    if (!stepper.cm) return words[words_of(stepper.of).none];
    return tenths_in(words, *stepper.cm) + " cm";
}

void draw_garment_stepper(DrawList& list, const FontSet& fonts, const Strings& words, const GarmentState& state,
                          const GarmentLayout& layout) {
    const GarmentType type = garment_type(layout);
    const Rect& r = layout.stepper;
    draw_fitted(list, fonts, words[words_of(state.stepper.of).label], type.caption, palette::kMuted, r.x,
                layout.offset_label_baseline, r.width, Align::Left);
    const auto down = [&](GarmentAction action) {
        return state.pressed == Control::Garment && state.pressed_item == garment_item(action);
    };
    list.box(r, r.height / 2, palette::kWell);
    // small screens: knobs are drawn smaller than what they take, so that the number has room
    const double d = layout.compact ? layout.px(44) : r.height - 2 * std::round(r.height / 18);
    const double inset = layout.compact ? layout.px(6) : std::round(r.height / 18);
    const auto knob = [&](double x, Icon icon, GarmentAction action, bool on) {
        Rect k{x, r.centre_y() - d / 2, d, d};
        if (down(action)) k = scaled(k, 0.94);
        list.box(k, d / 2, down(action) ? palette::kLine : palette::kSheet);
        const double size = layout.px(layout.compact ? 24 : 28);
        list.icon(icon, k.centre_x(), k.centre_y(), size, size / 32 * 3,
                  palette::kInk.faded(on ? 1.0F : palette::kOffShare));
    };
    knob(r.x + inset, Icon::Minus, GarmentAction::Less, state.stepper.less);
    knob(r.right() - inset - d, Icon::Plus, GarmentAction::More, state.stepper.more);
    const std::string number = stepper_number(words, state.stepper);
    const double room = r.width - 2 * d - (layout.compact ? 2 : 4) * inset;
    std::vector<std::string> lines{number};
    if (!state.stepper.cm && fonts.width_px(number, type.number) > room) lines = fonts.wrap(number, type.number, room);
    const double line = type.number.size_px * 1.15;
    double y = r.centre_y() + cap_drop(type.number) - line * (static_cast<double>(lines.size()) - 1) / 2;
    for (const std::string& text : lines) {
        draw_fitted(list, fonts, text, type.number, state.stepper.held ? palette::kSanguine : palette::kInk,
                    r.centre_x(), y, room, Align::Centre);
        y += line;
    }
}

void add_stepper_targets(std::vector<BoardTouch::Target>& all, const GarmentLayout& layout) {
    const Rect& s = layout.stepper;
    const double knob = std::max(64.0, s.height);
    const auto add = [&](GarmentAction action, const Rect& rect) {
        all.push_back({Control::Garment, garment_item(action), rect});
    };
    add(GarmentAction::Less, {s.x, s.y, knob, s.height});
    add(GarmentAction::More, {s.right() - knob, s.y, knob, s.height});
    if (s.width - 2 * knob > 8) add(GarmentAction::Number, {s.x + knob, s.y, s.width - 2 * knob, s.height});
}

void draw_plane_traces(DrawList& list, const GarmentState& state, const GarmentLayout& layout) {
    const auto width = static_cast<float>(std::max(1.0, layout.px(1)));
    for (const PlaneTrace& trace : state.plane_traces) {
        std::vector<InkPiece> pieces;
        for (std::size_t i = 0; i + 1 < trace.px.size(); ++i) {
            const core::Point a = trace.px[i], b = trace.px[i + 1];
            pieces.push_back({static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(b.x),
                              static_cast<float>(b.y), width, width});
        }
        list.ink(std::move(pieces), palette::kSanguine, layout.tile_pictures[trace.tile]);
    }
}

}  // namespace ui
