// What the screen shows, out of what the mode holds.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "firmware_like_app/garment/design_faults.hpp"
#include "firmware_like_app/kiosk/card_pictures.hpp"
#include "firmware_like_app/kiosk/garment_mode.hpp"
#include "ui/draw/coverage.hpp"
#include "ui/screens/garment_names.hpp"
#include "ui/screens/garment_parts.hpp"
#include "ui/screens/widgets.hpp"

namespace app {
namespace {

constexpr int kFirstFabric = 20, kFirstWash = 40;
constexpr double kAxisAbove_cm = 4;
constexpr double kNotedGap_cm = 15;  // wider ones are lines still to come, not mistakes

const char* key_of(core::DesignStep::Kind kind) {
    using K = core::DesignStep::Kind;
    switch (kind) {
        case K::Line:
            return "step_line";
        case K::Region:
            return "step_piece";
        case K::Cut:
            return "tool_cut";
        case K::Hole:
            return "tool_hole";
        case K::Remove:
            return "tool_remove";
        case K::Corner:
            return "tool_corner";
        case K::Alpha:
            return "folds";
        case K::Move:
            return "tool_move";
        case K::Weld:
            return "tool_weld";
        case K::Layer:
            return "step_new_layer";
        case K::Erase:
            return "tool_eraser";
        case K::Smooth:
            return "tool_smooth";
        case K::Bump:
            return "tool_bump";
        case K::Material:
            return "fabric";
        case K::Mirror:
            return "tool_mirror";
        case K::Body:
            return "body";
        case K::Place:
            return "step_object";
        case K::Unplace:
            return "step_object_off";
        case K::Edges:
            return "quads_size";
        default:
            return "step_other";
    }
}

}  // namespace

std::string GarmentMode::piece_for_folds() const {
    const core::NetworkRegion* region = desk_->network().find_region(piece_);
    return region != nullptr && region->alive && region->layer == desk_->layer() ? piece_ : "";
}

void GarmentMode::fill_rows(ui::GarmentState& state) const {
    fill_object_rows(state);
    const std::vector<core::LayerRow> layers = desk_->layers();
    for (std::size_t k = layers.size(); k-- > 0;) {
        const core::LayerRow& layer = layers[k];
        ui::LayerRow row;
        row.name = layer.name.empty() ? ui::filled_in(words()["layer_n"], {{"n", std::to_string(layer.layer + 1)}})
                                      : layer.name;
        row.swatch = layer.regions.empty() ? ui::Colour::hex(ui::kSwatches[static_cast<std::size_t>(layer.layer) % 5])
                                           : look_of(layer.regions.front(), layer.layer).colour;
        row.shown = layer.shown;
        row.selected = layer.worked_on;
        row.clashing = !layer.clash.empty();
        row.can_up = k + 1 < layers.size();
        row.can_down = k > 0;
        state.rows.push_back(std::move(row));
    }
    ui::LayerRow body;
    body.name = words()["body"];
    body.swatch = ui::palette::kClay;
    body.shown = body_shown_;
    body.body = true;
    state.rows.push_back(std::move(body));
}

void GarmentMode::fill_history(ui::GarmentState& state) const {
    const std::vector<core::HistoryEntry> entries = desk_->history();
    for (std::size_t k = entries.size(); k-- > 0;) {
        ui::HistoryRow row;
        row.name = words()[key_of(entries[k].kind)];
        if (const std::string& name = entries[k].name; !name.empty()) {
            row.name =
                ui::filled_in(words()["step_named"], {{"step", row.name}, {"name", ui::shown_name(words(), name)}});
        }
        row.undone = k >= desk_->history_place();
        row.current = k + 1 == desk_->history_place();
        state.history.push_back(std::move(row));
    }
    state.history.push_back({words()["history_start"], false, desk_->history_place() == 0});
}

/// The open stroke: under the pen as it was drawn; what is dragged as it will be.
void GarmentMode::fill_stroke(ui::GarmentState& state) const {
    using T = core::DeskTool;
    const ui::FigureCamera& camera = views_.camera();
    if (hold_ == Hold::Drawing && !stroke_px_.empty()) {
        const core::StrokePreview& preview = desk_->preview();
        const T tool = desk_->settings().tool;
        ui::SheetLine line;
        line.px = stroke_px_;
        if (line.px.size() == 1) line.px.push_back(line.px.front() + core::Point{0.01, 0});
        line.kind = tool == T::DrawTemporary                  ? ui::SheetLine::Kind::Temporary
                    : tool == T::DrawOnBody || tool == T::Add ? ui::SheetLine::Kind::Body
                    : tool == T::Cut || tool == T::Hole       ? ui::SheetLine::Kind::Cut
                    : tool == T::DrawOnPlane                  ? ui::SheetLine::Kind::Plane
                                                              : ui::SheetLine::Kind::Tape;
        const bool rubs = tool == T::Erase || tool == T::RemoveRegion || tool == T::Move || tool == T::Weld;
        if (!rubs) state.lines.push_back(std::move(line));
        if (tool == T::Move || tool == T::Weld) {
            ui::SheetLine dragged;
            dragged.kind = tool == T::Weld ? ui::SheetLine::Kind::Tape : ui::SheetLine::Kind::Plane;
            for (const core::Vec3& place : preview.line) dragged.px.push_back(camera.to_px(place));
            if (dragged.px.size() > 1) state.lines.push_back(std::move(dragged));
            state.handles_px.push_back(stroke_px_.back());
            state.held_handle = state.handles_px.size() - 1;
        }
        for (const core::SnapTarget* snap : {&preview.start, &preview.end}) {
            if (snap->kind == core::SnapTarget::Kind::None || !core::draws_line(tool)) continue;
            state.handles_px.push_back(camera.to_px(snap->place));
        }
    }
    if (tape_) {
        ui::SheetLine line;
        line.kind = ui::SheetLine::Kind::Tape;
        for (const core::Vec3& place : tape_->tape) line.px.push_back(camera.to_px(place));
        if (tape_->girth && !line.px.empty()) line.px.push_back(line.px.front());
        core::Point at = line.px.empty() ? core::Point{layout_.figure.centre_x(), layout_.figure.centre_y()}
                                         : line.px[line.px.size() / 2];
        if (tape_->girth) {  // beside its right end
            for (const core::Point& p : line.px) at = p.x > at.x ? p : at;
        }
        state.lines.push_back(std::move(line));
        state.notes.push_back({ui::tenths_in(words(), tape_->cm) + " cm", at, false});
    }
}

void GarmentMode::fill_drawer(ui::GarmentState& state) const {
    state.drawer = drawer_;
    if (drawer_ == ui::GarmentDrawer::Body) {
        state.body = body_.drawer();
        if (hold_ == Hold::Measure) state.body.held = slider_;
        state.body.problem = body_problem_;
        state.body.own_bodies = body_files_.offered();
        state.body.own_body = desk_ && !desk_->state().worn()->form.measures;
        if (state.body.own_body) state.body.size.reset();
        state.body.typed = typed_;
        state.body.number = number_;
        state.body.number_wrong = number_wrong_;
    }
    if (drawer_ == ui::GarmentDrawer::OwnBody) state.body_files = body_files_.state();
    if (drawer_ != ui::GarmentDrawer::Fabric || !desk_) return;
    const std::vector<std::string> pieces = pieces_to_dye();
    const ui::FabricLook look = pieces.empty() ? ui::FabricLook{} : look_of(pieces.back(), desk_->layer());
    for (int i = 0; i < ui::kFabricCount; ++i) {
        const auto fabric = static_cast<ui::Fabric>(i);
        state.fabrics.push_back({words()["fabric_" + std::string(ui::fabric_name(fabric))],
                                 ui::PictureId{kFirstFabric + i},
                                 !pieces.empty() && look.picture.empty() && look.fabric == fabric});
    }
    for (std::size_t i = 0; i < own_fabrics_.fabrics.size(); ++i) {
        const OwnFabric& own = own_fabrics_.fabrics[i];
        state.fabrics.push_back({own.name, ui::PictureId{kFirstFabric + ui::kFabricCount + static_cast<int>(i)},
                                 !pieces.empty() && look.picture == own.picture});
    }
    state.fabric_problem = own_fabrics_.problem;
    state.colour = ui::kSwatches.size();
    for (std::size_t i = 0; i < ui::kSwatches.size(); ++i) {
        if (look.colour == ui::Colour::hex(ui::kSwatches[i])) state.colour = i;
    }
}

ui::GarmentState GarmentMode::state(std::int64_t now_us) const {
    (void)now_us;
    ui::GarmentState state;
    state.language = options_.language;
    state.tool = tool_;
    state.page = page_;
    state.view = views_.view();
    state.tiles = views_.tiles();
    for (std::size_t i = 0; i < state.tile_pictures.size(); ++i) state.tile_pictures[i] = FigureViews::tile_picture(i);
    state.offset_cm = stepper_.offset_cm();
    state.stepper = stepper_.shown(stepper_of());
    state.stepper.held = hold_ == Hold::Number && moved_;
    state.quads = quads_;
    state.cleared = cleared_;
    state.history_shown = history_shown_;
    state.scroll_px = scroll_px_;
    state.figure = FigureViews::kFigure;
    state.figure_revision = views_.revision();
    state.problem = !body_problem_.empty() ? body_problem_ : problem_;
    if (state.problem.empty())
        if (const auto fault = keeper_.problem()) state.problem = design_fault_words(*fault, words());
    if (state.problem.empty()) state.problem = objects_.problem();
    state.line_open = hold_ == Hold::Drawing;
    fill_drawer(state);
    fill_export(state);
    state.designs_kept = keeper_.keeps();
    if (touch_.pressed()) {
        state.pressed = touch_.pressed();
        state.pressed_item = touch_.pressed_item();
    }
    if (pen_hovers_) state.pen_px = pointer_px_;
    const bool erases = erasing_ || eraser_near_ || tool_ == ui::GarmentTool::Eraser;
    if (erases && pointer_px_ && layout_.sheet.contains(pointer_px_->x, pointer_px_->y)) state.eraser_px = pointer_px_;
    if (!desk_) {
        state.problem = failure_;
        return state;
    }
    state.line_goes_on = desk_->goes_on();
    state.can_undo = desk_->can_undo() || state.line_goes_on || put_away_;
    state.can_redo = desk_->can_redo();
    state.empty = desk_->network().lines().empty() && objects().empty();
    state.mirror = desk_->state().look().mirror;
    state.hanging = hanging_wanted_;
    state.can_hang = can_hang();
    state.object = object_handles();
    fill_rows(state);
    if (history_shown_) fill_history(state);
    state.folds_name = "";
    const std::string piece = hold_ == Hold::Folds ? folds_piece_ : piece_for_folds();
    if (const core::NetworkRegion* region = desk_->network().find_region(piece); !piece.empty() && region != nullptr) {
        state.folds_on = true;
        state.folds_held = hold_ == Hold::Folds;
        state.folds = state.folds_held ? folds_ : std::clamp(region->alpha / core::kClosedFlowAlpha, 0.0, 1.0);
        state.folds_name = readable_name(ui::shown_name(words(), piece));
    }
    for (std::size_t i = 0; i < washes_.size(); ++i) {
        state.washes.push_back({ui::PictureId{kFirstWash + static_cast<int>(i)}, washes_[i].rect, washes_[i].colour});
    }
    if (hanging_wanted_) {  // lines lie where the cloth was drawn
        fill_stroke(state);
        state.scroll_px = std::min(state.scroll_px, ui::GarmentScreen::most_scroll_px(state, layout_));
        return state;
    }
    state.lines = drawing_.lines;
    state.handles_px = drawing_.handles_px;
    state.open_ends_px = drawing_.open_ends_px;
    for (const auto& [note, key] : notes_) {
        if (note.key == core::DeskNote::Key::OutlineOpen && (note.gap_cm <= 0 || note.gap_cm > kNotedGap_cm)) continue;
        state.notes.push_back({words()[key], views_.camera().to_px(note.place), true});
    }
    // two ends on the middle can be joined by a tap on one of them
    if (drawing_.open_middle && hold_ == Hold::None && !state.line_goes_on && state.notes.empty()) {
        state.notes.push_back({words()["note_middle"], views_.camera().to_px(*drawing_.open_middle), true});
    }
    if (notes_.empty() && desk_->cloth_is_current()) {
        for (const core::DeskNote& fault : desk_->cloth_faults()) {
            if (fault.key == core::DeskNote::Key::NotFilled)
                state.notes.push_back({words()["note_not_filled"], views_.camera().to_px(fault.place), true});
        }
    }
    const bool level = views_.view() == ui::GarmentView::Front || views_.view() == ui::GarmentView::Back;
    if (state.mirror && level) {
        state.axis_px = {views_.camera().to_px({0, views_.height_cm() + kAxisAbove_cm, 0}),
                         views_.camera().to_px({0, -kAxisAbove_cm, 0})};
    }
    if (const core::LineGoingOn* going = desk_->line_going_on(); going != nullptr && hold_ != Hold::Drawing) {
        state.handles_px.push_back(views_.camera().to_px(going->end));
        state.held_handle = state.handles_px.size() - 1;
    }
    fill_stroke(state);
    fill_planes(state);
    // rows may have become fewer since the list was scrolled
    state.scroll_px = std::min(state.scroll_px, ui::GarmentScreen::most_scroll_px(state, layout_));
    return state;
}

void GarmentMode::drop_washes() {
    for (std::size_t i = 0; i < washes_.size(); ++i) {
        painter_.set_picture(ui::PictureId{kFirstWash + static_cast<int>(i)}, nullptr);
    }
    washes_.clear();
}

/// Closed outlines whose cloth is still being made.
void GarmentMode::make_washes() {
    drop_washes();
    if (desk_->cloth_is_current()) return;
    const int width = std::max(1, static_cast<int>(layout_.sheet.width));
    const int height = std::max(1, static_cast<int>(layout_.sheet.height));
    for (const WaitingRegion& region : waiting_regions(*desk_, views_)) {
        core::Polygon ring;
        for (const core::Point& p : region.outline_px)
            ring.push_back(p - core::Point{layout_.sheet.x, layout_.sheet.y});
        const ui::CoverageImage fill = ui::fill_polygon(ring, width, height);
        if (fill.coverage.pixels.empty()) continue;
        ui::Texture texture({fill.coverage.width, fill.coverage.height}, ui::PixelFormat::Coverage);
        texture.upload(0, 0, texture.size(), fill.coverage.pixels);
        washes_.push_back({std::move(texture),
                           {layout_.sheet.x + fill.x, layout_.sheet.y + fill.y,
                            static_cast<double>(fill.coverage.width), static_cast<double>(fill.coverage.height)},
                           look_of(region.name, desk_->layer()).colour});
    }
    for (std::size_t i = 0; i < washes_.size(); ++i) {
        painter_.set_picture(ui::PictureId{kFirstWash + static_cast<int>(i)}, &washes_[i].coverage);
    }
}

void GarmentMode::make_fabric_tiles() {
    for (int i = 0; i < ui::kFabricCount; ++i) {
        ui::FabricLook look;
        look.fabric = static_cast<ui::Fabric>(i);
        look.colour = ui::Colour::hex(ui::kSwatches[1]);
        painter_.set_picture(ui::PictureId{kFirstFabric + i}, &views_.fabric_tile(look));
    }
    for (std::size_t i = 0; i < own_fabrics_.fabrics.size(); ++i) {
        const OwnFabric& own = own_fabrics_.fabrics[i];
        views_.set_own_fabric(own.picture, own.tile);
        ui::FabricLook look;
        look.picture = own.picture;
        painter_.set_picture(ui::PictureId{kFirstFabric + ui::kFabricCount + static_cast<int>(i)},
                             &views_.fabric_tile(look));
    }
}

}  // namespace app
