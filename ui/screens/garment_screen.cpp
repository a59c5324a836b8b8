#include "ui/screens/garment_screen.hpp"

#include <algorithm>
#include <cmath>

#include "ui/screens/garment_parts.hpp"
#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

constexpr std::size_t kPerAction = 65536;
const Rect kEverywhere{0, 0, 1e6, 1e6};

struct ToolFace {
    Icon icon;
    const char* key;
};

ToolFace face_of(const GarmentIntent& slot) {
    static constexpr std::array<ToolFace, 15> kTools{{{Icon::OnPlane, "tool_on_plane"},
                                                      {Icon::OnBody, "tool_on_body"},
                                                      {Icon::TemporaryPlane, "tool_temporary"},
                                                      {Icon::Corner, "tool_corner"},
                                                      {Icon::Cut, "tool_cut"},
                                                      {Icon::Add, "tool_add"},
                                                      {Icon::Mirror, "tool_mirror"},
                                                      {Icon::Eraser, "tool_eraser"},
                                                      {Icon::Move, "tool_move"},
                                                      {Icon::Smooth, "tool_smooth"},
                                                      {Icon::Bump, "tool_bump"},
                                                      {Icon::Weld, "tool_weld"},
                                                      {Icon::Hole, "tool_hole"},
                                                      {Icon::Remove, "tool_remove"},
                                                      {Icon::Measure, "tool_measure"}}};
    switch (slot.action) {
        case GarmentAction::Tool:
            return kTools[slot.index];
        case GarmentAction::Quads:
            return {Icon::Quads, "tool_quads"};
        case GarmentAction::Drape:
            return {Icon::Drape, "tool_drape"};
        case GarmentAction::New:
            return {Icon::New, "tool_new"};
        case GarmentAction::Designs:
            return {Icon::Designs, "tool_designs"};
        default:
            return {Icon::Fabric, "tool_fabric"};
    }
}

bool can_be_pressed(const GarmentIntent& slot, const GarmentState& state) {
    if (slot.action == GarmentAction::New) return !state.empty;
    return slot.action != GarmentAction::Drape || state.can_hang;
}

bool draws_lines(GarmentTool t) {
    return t == GarmentTool::OnPlane || t == GarmentTool::OnBody || t == GarmentTool::TemporaryPlane;
}

GarmentIntent tool(GarmentTool t) {
    return {GarmentAction::Tool, static_cast<std::size_t>(t)};
}

class Drawer {
  public:
    Drawer(DrawList& list, const FontSet& fonts, const Strings& words, const GarmentState& state,
           const GarmentLayout& layout)
        : list_(list), fonts_(fonts), words_(words), state_(state), l_(layout), type_(garment_type(layout)) {}

    void sheet() {
        list_.box(l_.sheet, 0, palette::kSheet);
        list_.picture(state_.figure, l_.sheet);
        for (const SheetWash& wash : state_.washes) {
            list_.wash(wash.coverage, wash.rect, wash.colour.faded(palette::kWashShare), 1);
        }
        if (state_.axis_px) axis();
        if (state_.plane_px.size() > 2) plane();
        for (const SheetLine& line : state_.lines) {
            if (line.dimmed) draw_sheet_line(list_, line, l_.scale, l_.sheet);
        }
        for (const SheetLine& line : state_.lines) {
            if (!line.dimmed) draw_sheet_line(list_, line, l_.scale, l_.sheet);
        }
        for (const core::Point& p : state_.open_ends_px) draw_open_end(list_, p, l_.scale, l_.sheet);
        for (std::size_t i = 0; i < state_.handles_px.size(); ++i) {
            const core::Point& p = state_.handles_px[i];
            if (l_.sheet.contains(p.x, p.y)) draw_handle(list_, p, l_.scale, state_.held_handle == i);
        }
        if (state_.object) object(*state_.object);
        brush();
        names();
        for (const PlacedNote& note : state_.notes) placed_note(note);
        if (state_.eraser_px) ring(*state_.eraser_px, 24);
    }

    /// Above all else: a pen that hovers over the board has its place there, too.
    void pen() {
        if (state_.pen_px && !state_.eraser_px) ring(*state_.pen_px, 10);
    }

    void board() {
        list_.box(l_.board, 0, palette::kBoard);
        edge();
        if (state_.drawer != GarmentDrawer::None) return;
        list_.text(fonts_, "Croquis", type_.wordmark, palette::kInk, l_.wordmark_x, l_.wordmark_baseline);
        draw_mode_switch(
            list_, fonts_, l_.mode_switch, words_, true,
            state_.pressed == Control::Mode ? std::optional<std::size_t>(state_.pressed_item) : std::nullopt,
            type_.switched.size_px);
        tools();
        draw_garment_stepper(list_, fonts_, words_, state_, l_);
        pages();
        tiles();
        draw_plane_traces(list_, state_, l_);
        if (!l_.upright) {
            draw_garment_list(list_, fonts_, words_, state_, l_);
            draw_garment_folds(list_, fonts_, words_, state_, l_);
        }
        footer();
    }

  private:
    [[nodiscard]] bool down(GarmentAction action, std::size_t index = 0) const {
        return state_.pressed == Control::Garment && state_.pressed_item == garment_item(action, index);
    }

    void edge() {
        const double reach = l_.px(32);
        if (l_.upright) {
            list_.shadow({-2 * reach, l_.board.bottom(), l_.board.width + 4 * reach, 2 * reach}, 0, 0, reach,
                         palette::kShade.faded(1.5F));
            list_.box({0, l_.board.bottom() - 1, l_.board.width, 1}, 0, palette::kEdge.faded(1.2F));
            return;
        }
        const bool right = l_.hand == Hand::Right;
        const double x = right ? l_.board.right() : l_.board.x;
        list_.shadow({right ? x : x - 2 * reach, -2 * reach, 2 * reach, l_.board.height + 4 * reach}, 0, 0, reach,
                     palette::kShade.faded(1.5F));
        list_.box({right ? x - 1 : x, 0, 1, l_.board.height}, 0, palette::kEdge.faded(1.2F));
    }

    void ring(core::Point at, double size) {
        const double side = l_.px(size);
        list_.box({at.x - side / 2, at.y - side / 2, side, side}, side / 2, palette::kNone, palette::kInk,
                  std::max(2.0, l_.px(2)));
    }

    void axis() {
        SheetLine line;
        line.kind = SheetLine::Kind::Mirrored;
        line.px = {(*state_.axis_px)[0], (*state_.axis_px)[1]};
        draw_sheet_line(list_, line, l_.scale, l_.sheet);
    }

    void plane() {
        draw_convex(list_, state_.plane_px, palette::kSanguine.faded(0.10F), l_.sheet);
        std::vector<InkPiece> edge;
        for (std::size_t i = 0; i < state_.plane_px.size(); ++i) {
            const core::Point a = state_.plane_px[i], b = state_.plane_px[(i + 1) % state_.plane_px.size()];
            const auto r = static_cast<float>(l_.px(1));
            edge.push_back({static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(b.x),
                            static_cast<float>(b.y), r, r});
        }
        list_.ink(std::move(edge), palette::kSanguine.faded(0.45F), l_.sheet);
    }

    /// A frame in the red of all that is live; its corners take hold.
    void object(const ObjectHandles& o) {
        SheetLine frame;
        frame.kind = SheetLine::Kind::Tape;
        frame.px = {{o.box.x, o.box.y},
                    {o.box.right(), o.box.y},
                    {o.box.right(), o.box.bottom()},
                    {o.box.x, o.box.bottom()},
                    {o.box.x, o.box.y}};
        draw_sheet_line(list_, frame, l_.scale, l_.sheet);
        if (l_.sheet.contains(o.scale.x, o.scale.y)) draw_handle(list_, o.scale, l_.scale, o.scaling);
        if (!l_.sheet.contains(o.turn.x, o.turn.y)) return;
        const double d = l_.px(o.turning ? 44 : 36), size = l_.px(22);
        list_.box({o.turn.x - d / 2, o.turn.y - d / 2, d, d}, d / 2, palette::kSheet, palette::kSanguine, l_.px(3));
        list_.icon(Icon::Turn, o.turn.x, o.turn.y, size, size / 32 * 3, palette::kSanguine);
    }

    void brush() {
        if (state_.brush_px.size() < 3) return;
        SheetLine line;
        line.kind = SheetLine::Kind::Tape;
        line.px = state_.brush_px;
        line.px.push_back(line.px.front());
        draw_sheet_line(list_, line, l_.scale, l_.sheet);
    }

    [[nodiscard]] std::string where() const {
        const std::string view = words_[view_key(state_.view)];
        if (state_.object && state_.tool != GarmentTool::Measure) return words_["object_hint"];
        if (state_.hanging) return words_[state_.view == GarmentView::Solid ? "hangs_solid" : "hangs_flat"];
        if (state_.line_goes_on) return words_["line_goes_on"];
        const bool draws = state_.tool == GarmentTool::OnPlane || state_.tool == GarmentTool::OnBody;
        if (state_.view == GarmentView::Solid && (draws || state_.drawer != GarmentDrawer::None)) {
            return words_["drag_beside"];
        }
        switch (state_.tool) {
            case GarmentTool::OnPlane:
                if (is_plane(state_.stepper.of) && state_.stepper.cm)
                    return filled_in(words_["lines_plane_at"],
                                     {{"view", view}, {"x", stepper_number(words_, state_.stepper)}});
                return filled_in(words_["lines_plane"], {{"view", view}});
            case GarmentTool::OnBody:
                return filled_in(words_["lines_body"], {{"x", tenths_in(words_, state_.offset_cm)}});
            case GarmentTool::TemporaryPlane:
                return words_["lines_temporary"];
            case GarmentTool::Mirror:
                return words_["drag_beside"];
            default:
                return words_[std::string("how_") + face_of(tool(state_.tool)).key];
        }
    }

    /// The view's name; below it where lines lie, or what went wrong and how to go on.
    void names() {
        list_.text(fonts_, words_[view_key(state_.view)], type_.view, palette::kInk, l_.name_x, l_.name_baseline);
        const double width = l_.upright ? l_.sheet.width - l_.px(80) : l_.sheet.width * 0.36;
        double y = l_.where_baseline;
        const std::string& words = state_.problem.empty() ? where() : state_.problem;
        const Colour colour = state_.problem.empty() ? palette::kMuted : palette::kSanguine;
        for (const std::string& line : fonts_.wrap(words, type_.where, width)) {
            list_.text(fonts_, line, type_.where, colour, l_.name_x, y);
            y += type_.where.size_px * 1.4;
        }
        const bool can_go_on = !state_.open_ends_px.empty() && !state_.line_goes_on && draws_lines(state_.tool);
        if ((state_.empty || can_go_on) && state_.problem.empty() && !state_.line_open) {
            const char* hint = state_.empty ? "garment_hint" : "hint_go_on";
            for (const std::string& line : fonts_.wrap(words_[hint], type_.where, width)) {
                list_.text(fonts_, line, type_.where, palette::kMuted, l_.name_x, y + l_.px(10));
                y += type_.where.size_px * 1.4;
            }
        }
    }

    void placed_note(const PlacedNote& note) {
        const TextStyle& s = type_.note;
        const double wide = fonts_.width_px(note.words, s) + l_.px(28), high = s.size_px * 2;
        Rect r{note.at_px.x + l_.px(20), note.at_px.y - high - l_.px(10), wide, high};
        if (r.right() > l_.sheet.right() - l_.px(8)) r.x = note.at_px.x - l_.px(20) - wide;
        r.x = std::max(r.x, l_.sheet.x + l_.px(8));
        r.y = std::clamp(r.y, l_.sheet.y + l_.px(8), l_.sheet.bottom() - high - l_.px(8));
        list_.box(r, high / 2, palette::kSheet, note.warning ? palette::kSanguine : palette::kInk, l_.px(2));
        list_.text(fonts_, note.words, s, note.warning ? palette::kSanguine : palette::kInk, r.centre_x(),
                   r.centre_y() + cap_drop(s), Align::Centre);
    }

    void tool_button(const Rect& rect, Icon icon, const std::string& word, Control control, std::size_t item,
                     bool chosen, bool on) {
        const bool pressed = state_.pressed == control && state_.pressed_item == item;
        const Rect r = pressed ? scaled(rect, 0.97) : rect;
        if (chosen || pressed) list_.box(r, l_.px(20), chosen ? palette::kInk : palette::kWell);
        const float a = on ? 1.0F : palette::kOffShare;
        const double size = l_.px(l_.compact ? 32 : 36);
        list_.icon(icon, r.centre_x(), r.y + r.height * (l_.compact ? 0.35 : 0.38), size, size / 32 * 2.2,
                   (chosen ? palette::kSheet : palette::kInk).faded(a));
        draw_fitted(list_, fonts_, word, type_.tool, (chosen ? palette::kSheet : palette::kMuted).faded(a),
                    r.centre_x(), r.y + r.height * (l_.compact ? 0.86 : 0.77),
                    r.width + (chosen ? -l_.px(8) : l_.px(3)), Align::Centre);
    }

    void tools() {
        for (const Rect& d : l_.dividers) list_.box(d, 0, palette::kLine);
        const auto slots = tools_of_page(state_.page);
        for (std::size_t i = 0; i < kGarmentSlots; ++i) {
            if (!slots[i] || (slots[i]->action == GarmentAction::Designs && !state_.designs_kept)) continue;
            const ToolFace face = face_of(*slots[i]);
            const bool on = can_be_pressed(*slots[i], state_);
            tool_button(l_.tools[i], face.icon, words_[face.key], Control::Garment,
                        garment_item(slots[i]->action, slots[i]->index), chosen(*slots[i]), on);
        }
        tool_button(l_.undo, Icon::Undo, words_["tool_undo"], Control::Undo, 0, false, state_.can_undo);
        if (state_.line_goes_on)  // live, and so marked
            tool_button(l_.redo, Icon::Check, words_["tool_finish"], Control::Redo, 0, true, true);
        else
            tool_button(l_.redo, Icon::Redo, words_["tool_redo"], Control::Redo, 0, false, state_.can_redo);
    }

    [[nodiscard]] bool chosen(const GarmentIntent& slot) const {
        if (slot.action == GarmentAction::Quads) return state_.quads;
        if (slot.action == GarmentAction::Drape) return state_.hanging;
        if (slot.action != GarmentAction::Tool) return false;
        if (slot.index == static_cast<std::size_t>(GarmentTool::Mirror)) return state_.mirror;
        return slot.index == static_cast<std::size_t>(state_.tool);
    }

    void pages() {
        const Rect& r = l_.pages;
        list_.box(r, r.height / 2, palette::kWell);
        const std::vector<Rect> segments = switch_segments(r, kGarmentPages);
        const std::array<Icon, kGarmentPages> icons{Icon::Pen, Icon::Move, Icon::Layers};
        const double inset = std::round(r.height / 12);
        for (std::size_t i = 0; i < kGarmentPages; ++i) {
            Rect pill{segments[i].x, r.y + inset, segments[i].width, r.height - 2 * inset};
            if (down(GarmentAction::Page, i)) pill = scaled(pill, 0.97);
            if (i == state_.page) {
                const double unit = r.height / 36;
                list_.shadow(pill, pill.height / 2, unit, 2.5 * unit, palette::kShade.faded(1.4F));
                list_.box(pill, pill.height / 2, palette::kSheet);
            } else if (down(GarmentAction::Page, i)) {
                list_.box(pill, pill.height / 2, palette::kLine);
            }
            const double size = l_.px(28);
            list_.icon(icons[i], pill.centre_x(), pill.centre_y(), size, size / 32 * 2.2,
                       i == state_.page ? palette::kInk : palette::kMuted);
        }
    }

    void tiles() {
        for (std::size_t i = 0; i < kGarmentTiles; ++i) {
            const bool large = tile_of(state_.view) == i, pressed = down(GarmentAction::View, i);
            const Rect r = pressed ? scaled(l_.tiles[i], 0.97) : l_.tiles[i];
            list_.shadow(r, l_.px(20), 1, 2, palette::kEdge);
            list_.box(r, l_.px(20), pressed ? palette::kWell : palette::kSheet,
                      large ? palette::kSanguine : palette::kEdge, large ? std::max(3.0, l_.px(3)) : 1);
            list_.picture(state_.tile_pictures[i], l_.tile_pictures[i]);
            list_.text(fonts_, words_[view_key(state_.tiles[i])], type_.tile, palette::kInk, r.x + l_.px(14),
                       r.y + l_.px(l_.compact ? 22 : 28));
            // what another tap on the large one turns it to
            const bool turns = large && (i == 1 || i == 3);
            if (turns) {
                const double size = l_.px(24);
                list_.icon(Icon::Turn, r.right() - l_.px(22), r.y + l_.px(l_.compact ? 18 : 22), size, size / 32 * 2.4,
                           palette::kMuted);
            }
        }
    }

    void footer() {
        const auto button = [&](const Rect& rect, Icon icon, const std::string& word, GarmentAction action,
                                bool primary) {
            if (rect.width <= 0) return;
            const Rect r = down(action) ? scaled(rect, 0.97) : rect;
            const Colour ground = primary ? palette::kInk : palette::kSheet;
            list_.box(r, r.height / 2, down(action) && !primary ? palette::kWell : ground,
                      primary ? palette::kInk : palette::kLine, l_.px(2));
            const Colour colour = primary ? palette::kSheet : palette::kInk;
            const double size = l_.px(28);
            TextStyle style = type_.button;
            const double room = r.width - size - l_.px(48), wide = fonts_.width_px(word, style);
            if (wide > room) style.size_px *= room / wide;
            const double whole = size + l_.px(14) + std::min(wide, room), x = r.centre_x() - whole / 2;
            list_.icon(icon, x + size / 2, r.centre_y(), size, size / 32 * 2.4, colour);
            list_.text(fonts_, word, style, colour, x + size + l_.px(14), r.centre_y() + cap_drop(style));
        };
        button(l_.body, Icon::Tape, words_["body"], GarmentAction::Body, false);
        button(l_.layers_button, Icon::Layers, words_["layers"], GarmentAction::Layers, false);
        button(l_.export_button, Icon::Export, words_["export"], GarmentAction::Export, true);
    }

    DrawList& list_;
    const FontSet& fonts_;
    const Strings& words_;
    const GarmentState& state_;
    const GarmentLayout& l_;
    GarmentType type_;
};

}  // namespace

std::size_t tile_of(GarmentView view) {
    if (view == GarmentView::OtherSide) return 1;
    return view == GarmentView::Top ? 3 : static_cast<std::size_t>(view);
}

const char* view_key(GarmentView view) {
    static constexpr std::array<const char*, 6> kKeys{"view_front", "view_side",       "view_back",
                                                      "view_solid", "view_other_side", "view_top"};
    return kKeys[static_cast<std::size_t>(view)];
}

std::size_t garment_item(GarmentAction action, std::size_t index) {
    return static_cast<std::size_t>(action) * kPerAction + std::min(index, kPerAction - 1);
}

GarmentIntent garment_intent(std::size_t item) {
    return {static_cast<GarmentAction>(item / kPerAction), item % kPerAction};
}

double slider_share(const Rect& slider, double x, double scale) {
    const double reach = 24 * scale;  // the knob stays within the line's ends
    return std::clamp((x - slider.x - reach) / std::max(slider.width - 2 * reach, 1.0), 0.0, 1.0);
}

std::array<std::optional<GarmentIntent>, kGarmentSlots> tools_of_page(std::size_t page) {
    using T = GarmentTool;
    using A = GarmentAction;
    if (page == 0) {
        return {tool(T::OnPlane), tool(T::OnBody), tool(T::TemporaryPlane), tool(T::Corner),
                tool(T::Cut),     tool(T::Add),    tool(T::Mirror),         tool(T::Eraser)};
    }
    if (page == 1) {
        return {tool(T::Move), tool(T::Smooth), tool(T::Bump),    tool(T::Weld),
                tool(T::Hole), tool(T::Remove), tool(T::Measure), tool(T::Eraser)};
    }
    return {GarmentIntent{A::New},
            GarmentIntent{A::Designs},
            GarmentIntent{A::Fabrics},
            GarmentIntent{A::Quads},
            tool(T::Measure),
            GarmentIntent{A::Drape},
            std::nullopt,
            std::nullopt};
}

void draw_mode_switch(DrawList& list, const FontSet& fonts, const Rect& rect, const Strings& words, bool garment,
                      std::optional<std::size_t> pressed, double size_px) {
    draw_switch(list, fonts, rect, {words["mode_find"], words["mode_garment"]}, garment ? 1 : 0, pressed, size_px);
}

std::vector<BoardTouch::Target> mode_targets(const Rect& rect) {
    const std::vector<Rect> halves = switch_segments(rect, 2);
    return {{Control::Mode, 0, halves[0]}, {Control::Mode, 1, halves[1]}};
}

DrawList GarmentScreen::draw(const GarmentState& state, const GarmentLayout& layout) const {
    DrawList list;
    Drawer drawer(list, *fonts_, (*languages_)[state.language], state, layout);
    drawer.board();
    if (state.drawer != GarmentDrawer::None) draw_garment_drawer(list, *fonts_, *languages_, state, layout);
    drawer.sheet();
    drawer.pen();
    return list;
}

std::vector<BoardTouch::Target> GarmentScreen::targets(const GarmentState& state, const GarmentLayout& layout) const {
    using A = GarmentAction;
    std::vector<BoardTouch::Target> all;
    const auto add = [&](A action, std::size_t index, const Rect& rect) {
        all.push_back({Control::Garment, garment_item(action, index), rect});
    };
    if (state.drawer != GarmentDrawer::None) {
        add_drawer_targets(all, state, layout, languages_->size());
        return all;
    }
    all = mode_targets(layout.mode_switch);
    const auto slots = tools_of_page(state.page);
    for (std::size_t i = 0; i < kGarmentSlots; ++i) {
        if (!slots[i] || !can_be_pressed(*slots[i], state)) continue;
        if (slots[i]->action == A::Designs && !state.designs_kept) continue;
        add(slots[i]->action, slots[i]->index, layout.tools[i]);
    }
    if (state.can_undo) all.push_back({Control::Undo, 0, layout.undo});
    if (state.can_redo || state.line_goes_on) all.push_back({Control::Redo, 0, layout.redo});
    add_stepper_targets(all, layout);
    const std::vector<Rect> pages = switch_segments(layout.pages, kGarmentPages);
    for (std::size_t i = 0; i < kGarmentPages; ++i) add(A::Page, i, pages[i]);
    for (std::size_t i = 0; i < kGarmentTiles; ++i) add(A::View, i, layout.tiles[i]);
    if (!layout.upright) add_list_targets(all, state, layout);
    add(A::Body, 0, layout.body);
    if (layout.layers_button.width > 0) add(A::Layers, 0, layout.layers_button);
    add(A::Export, 0, layout.export_button);
    return all;
}

double GarmentScreen::most_scroll_px(const GarmentState& state, const GarmentLayout& layout) {
    const std::size_t rows = state.history_shown ? state.history.size() : state.rows.size();
    return std::max(0.0, (static_cast<double>(rows) - kGarmentRows) * layout.row_pitch);
}

}  // namespace ui
