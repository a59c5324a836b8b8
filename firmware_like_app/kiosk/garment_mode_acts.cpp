// What the board's controls do.

#include <map>
#include <utility>

#include "firmware_like_app/kiosk/garment_mode.hpp"

namespace app {

void GarmentMode::act(const ui::Intent& intent, std::int64_t now_us) {
    switch (intent.control) {
        case ui::Control::Mode:
            find_wanted_ = intent.item == 0;
            break;
        case ui::Control::Undo:
            if (desk_) undo(now_us);
            break;
        case ui::Control::Redo:
            if (desk_ && desk_->goes_on())
                finish_line();
            else if (desk_)
                take_reply(desk_->redo(), now_us);
            break;
        case ui::Control::Language:
            options_.language = intent.item;
            break;
        case ui::Control::HandSwitch:
            set_hand(options_.hand == ui::Hand::Right ? ui::Hand::Left : ui::Hand::Right);
            break;
        case ui::Control::Garment:
            if (desk_) act(ui::garment_intent(intent.item), now_us);
            break;
        default:
            break;  // of other screens
    }
}

void GarmentMode::act(const ui::GarmentIntent& intent, std::int64_t now_us) {
    using A = ui::GarmentAction;
    switch (intent.action) {
        case A::Tool:
            choose_tool(static_cast<ui::GarmentTool>(intent.index), now_us);
            break;
        case A::Page:
            page_ = intent.index;
            break;
        case A::View:
            choose_view(intent.index);
            break;
        case A::Less:
        case A::More:
            repeats_ = 0;
            if (!repeated_) step_number(intent.action == A::More ? 1 : -1);  // held, it has repeated
            break;
        case A::ShowLayers:
        case A::ShowHistory:
            history_shown_ = intent.action == A::ShowHistory;
            scroll_px_ = 0;
            break;
        case A::Row:
            press_row(intent.index, now_us);
            break;
        case A::Eye:
            press_eye(intent.index, now_us);
            break;
        case A::RowUp:
        case A::RowDown:
            move_row(intent.index, intent.action == A::RowUp ? 1 : -1, now_us);
            break;
        case A::Unplace:
            unplace_row(intent.index, now_us);
            break;
        case A::AddLayer:
            take_reply(desk_->new_layer(), now_us);
            scroll_px_ = 0;
            break;
        case A::Swatch:
            press_row(intent.index, now_us);
            open_drawer(ui::GarmentDrawer::Fabric);
            break;
        case A::Fabrics:
            open_drawer(ui::GarmentDrawer::Fabric);
            break;
        case A::Body:
            body_.set(desk_->state().worn()->form.measures.value_or(body_.measures()));
            open_drawer(ui::GarmentDrawer::Body);
            break;
        case A::Export:
            export_no_place_ = false;
            open_drawer(ui::GarmentDrawer::Export);
            break;
        case A::Layers:
            open_drawer(ui::GarmentDrawer::Layers);
            break;
        case A::CloseDrawer:
        case A::Done:  // from the list of bodies back to the measures
            open_drawer(drawer_ == ui::GarmentDrawer::OwnBody ? ui::GarmentDrawer::Body : ui::GarmentDrawer::None);
            break;
        case A::Quads:
            quads_ = !quads_;
            views_.set_quads(quads_);
            break;
        case A::Drape:
            press_drape();
            break;
        case A::ExportAs:
            export_as(intent.index);
            break;
        case A::Designs:
            open_gallery();
            break;
        case A::New:
            clear_design(now_us);
            break;
        case A::UndoNew:
            undo_new();
            break;
        case A::Size:
            body_.choose_size(intent.index);
            keep_body(now_us);
            break;
        case A::ResetBody:
            body_.reset();
            keep_body(now_us);
            break;
        case A::TypeMeasure:
        case A::PadKey:
        case A::PadCancel:
        case A::PadDone:
        case A::OwnBody:
        case A::BodyFile:
        case A::BodyUp:
        case A::BodyEarlier:
        case A::BodyLater:
            act_on_body(intent, now_us);
            break;
        case A::Fabric:
            choose_fabric(intent.index, now_us);
            break;
        case A::Colour:
            choose_colour(intent.index, now_us);
            break;
        default:
            break;
    }
}

void GarmentMode::choose_tool(ui::GarmentTool tool, std::int64_t now_us) {
    problem_.clear();
    notes_.clear();
    tape_.reset();
    put_back();
    objects_.choose("");
    drawing_due_ = true;
    if (tool == ui::GarmentTool::Mirror) {  // a switch, not a pen
        take_reply(desk_->set_mirror(!desk_->state().look().mirror), now_us);
        return;
    }
    tool_ = tool;
    if (!core::goes_on_with(desk_tool())) finish_line();
}

/// The next stroke is another line.
void GarmentMode::finish_line() {
    desk_->finish_line();
    drawing_due_ = true;
}

void GarmentMode::choose_view(std::size_t tile) {
    using V = ui::GarmentView;
    V view = views_.tiles()[tile];
    if (view == views_.view()) {  // again: its other side
        if (view == V::Side || view == V::OtherSide) view = view == V::Side ? V::OtherSide : V::Side;
        if (view == V::Solid || view == V::Top) view = view == V::Solid ? V::Top : V::Solid;
    }
    views_.show(view);
    drawing_due_ = true;
}

std::optional<std::size_t> GarmentMode::layer_of_row(std::size_t row) const {
    const std::size_t above = objects().size(), count = desk_->layers().size();
    if (row < above) return std::nullopt;
    row -= above;
    if (row >= count) return std::nullopt;  // the body
    return count - 1 - row;
}

void GarmentMode::press_row(std::size_t row, std::int64_t now_us) {
    if (history_shown_) {  // from the newest down to the start
        const std::size_t acts = desk_->history().size();
        if (row <= acts) take_reply(desk_->go_to(acts - row), now_us);
        return;
    }
    if (row < objects().size()) return press_object_row(row);
    const std::optional<std::size_t> place = layer_of_row(row);
    if (!place) return;
    objects_.choose("");
    const core::LayerRow layer = desk_->layers()[*place];
    piece_ = layer.regions.empty() ? "" : layer.regions.back();
    line_.clear();
    if (!layer.worked_on) take_reply(desk_->work_on(layer.layer), now_us);
}

void GarmentMode::press_eye(std::size_t row, std::int64_t now_us) {
    const std::optional<std::size_t> place = layer_of_row(row);
    if (!place) {
        body_shown_ = !body_shown_;
        show_cloth();
        return;
    }
    const core::LayerRow layer = desk_->layers()[*place];
    take_reply(desk_->show_layer(layer.layer, !layer.shown), now_us);
}

void GarmentMode::move_row(std::size_t row, int by, std::int64_t now_us) {
    const std::optional<std::size_t> place = layer_of_row(row);
    if (place) take_reply(desk_->move_layer(desk_->layers()[*place].layer, by), now_us);
}

void GarmentMode::open_drawer(ui::GarmentDrawer drawer) {
    drawer_ = drawer;
    typed_.reset();
    body_problem_.clear();
    scroll_px_ = 0;
}

/// At the start of a design that came by New, what was there before comes back.
void GarmentMode::undo(std::int64_t now_us) {
    if (!desk_->can_undo() && !desk_->goes_on() && put_away_) return undo_new();
    take_reply(desk_->undo(), now_us);
}

void GarmentMode::undo_new() {
    if (!put_away_) return;
    const core::Design back = *std::exchange(put_away_, std::nullopt);
    cleared_ = false;
    if (put_away_id_ != 0) {
        open_kept(std::exchange(put_away_id_, 0));
    } else if (const core::Result<void> opened = open(back); !opened) {
        problem_ = opened.error().sentence();
    }
}

/// All pieces of the layer that is worked on.
std::vector<std::string> GarmentMode::pieces_to_dye() const {
    std::vector<std::string> pieces;
    for (const core::NetworkRegion& region : desk_->network().regions()) {
        if (region.alive && region.layer == desk_->layer()) pieces.push_back(region.name);
    }
    return pieces;
}

/// What the pieces of the layer that is worked on are made of, changed for all of them as one act.
void GarmentMode::dye(const std::function<void(core::ClothMaterial&)>& change, std::int64_t now_us) {
    std::vector<std::pair<std::string, core::ClothMaterial>> dyed;
    const auto& materials = desk_->state().look().materials;
    for (const std::string& piece : pieces_to_dye()) {
        const auto found = materials.find(piece);
        dyed.emplace_back(piece, found != materials.end() ? found->second : core::ClothMaterial{});
        change(dyed.back().second);
    }
    take_reply(desk_->set_materials(dyed), now_us);
}

void GarmentMode::choose_fabric(std::size_t fabric, std::int64_t now_us) {
    if (fabric >= ui::kFabricCount) {
        const std::size_t own = fabric - ui::kFabricCount;
        if (own >= own_fabrics_.fabrics.size()) return;
        const std::string picture = own_fabrics_.fabrics[own].picture;
        return dye([&](core::ClothMaterial& material) { material.fabric = picture; }, now_us);
    }
    const auto chosen = static_cast<ui::Fabric>(fabric);
    const std::string name = chosen == ui::Fabric::Plain ? "" : std::string(ui::fabric_name(chosen));
    dye([&](core::ClothMaterial& material) { material.fabric = name; }, now_us);
}

void GarmentMode::choose_colour(std::size_t colour, std::int64_t now_us) {
    if (colour >= ui::kSwatches.size()) return;
    const std::string hex = ui::hex_of(ui::Colour::hex(ui::kSwatches[colour]));
    dye([&](core::ClothMaterial& material) { material.colour = hex; }, now_us);
}

/// While a slider moves: the figure and the garment follow, the design stays as it is.
void GarmentMode::try_body() {
    if (const core::Result<void> fits = core::check_measures(body_.measures()); !fits) {
        body_problem_ = words()["body_unfit"];
        return;
    }
    body_problem_.clear();
    builder_.submit({desk_->try_body(body_.measures()), woven_layers()});
}

void GarmentMode::keep_body(std::int64_t now_us) {
    body_due_ = false;
    if (const core::Result<void> fits = core::check_measures(body_.measures()); !fits) {
        body_problem_ = words()["body_unfit"];
        body_.set(desk_->state().worn()->form.measures.value_or(body_.measures()));
        return;
    }
    body_problem_.clear();
    take_reply(desk_->set_body(body_.measures()), now_us);
}

void GarmentMode::clear_design(std::int64_t now_us) {
    core::Design before = desk_->design();
    keep_picture();
    put_away_id_ = keeper_.end().value_or(0);
    core::Design empty;
    empty.body = before.body;
    if (const core::Result<void> opened = open(empty); !opened) {
        problem_ = opened.error().sentence();
        return;
    }
    put_away_ = std::move(before);
    cleared_ = true;
    cleared_us_ = now_us;
    tool_ = ui::GarmentTool::OnBody;
    page_ = 0;
}

}  // namespace app
