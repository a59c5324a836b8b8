// What the figure wears or carries beside cloth.

#include <utility>

#include "firmware_like_app/garment/worn_object.hpp"
#include "firmware_like_app/kiosk/card_pictures.hpp"
#include "firmware_like_app/kiosk/garment_mode.hpp"
#include "ui/screens/widgets.hpp"

namespace app {
namespace {

constexpr double kFrame_px = 14;  // of the design: between an object and its frame
constexpr double kGrip_px = 32;   // half of what a handle takes
constexpr std::uint32_t kLeather = 0x8F7F6B;

}  // namespace

void GarmentMode::wear(const FoundModel& found, std::int64_t now_us) {
    ready_desk();
    if (!desk_ || !found.mesh) return;
    FoundObject object{readable_name(found.name), found.source.empty() ? found.name : found.source, found.class_name,
                       found.camera};
    objects_.keep(object.model, found.mesh);
    place(put_on(object, *found.mesh, *desk_->form(), objects()), now_us);
}

void GarmentMode::place(const core::PlacedObject& object, std::int64_t now_us) {
    ready_desk();
    if (!desk_) return;
    drop_hold(now_us);
    if (ready_recorder(now_us)) recorder_->place(object, now_us);
    put_back();
    finish_line();
    if (drawer_ != ui::GarmentDrawer::None) open_drawer(ui::GarmentDrawer::None);
    history_shown_ = false;
    scroll_px_ = 0;
    take_reply(desk_->place(object), now_us);
    objects_.choose(object.name);
}

/// In the picture, where they are now.
void GarmentMode::show_objects() {
    views_.set_objects(objects_.shown(objects()));
}

std::optional<ui::ObjectHandles> GarmentMode::object_handles() const {
    return objects_.handles(objects(), views_.camera(), layout_.px(kFrame_px),
                            layout_.sheet.shrunk(layout_.px(kFrame_px) * 2));
}

/// The pen comes down on the chosen object or one of its handles.
bool GarmentMode::hold_object(const ui::WindowEvent& event) {
    const std::optional<ui::ObjectHandles> handles = object_handles();
    if (!handles || event.button) return false;
    const core::Point px{event.x, event.y};
    const GarmentObjects::Grip grip = GarmentObjects::grip_at(*handles, px, layout_.px(kGrip_px));
    if (grip == GarmentObjects::Grip::None) {
        objects_.choose("");
        return false;
    }
    finish_line();
    objects_.hold(grip, px, objects(), views_.camera());
    hold_ = Hold::Object;
    problem_.clear();
    return true;
}

void GarmentMode::let_object_go(std::int64_t now_us) {
    if (const std::optional<core::PlacedObject> moved = objects_.let_go()) {
        take_reply(desk_->place(*moved), now_us);
        objects_.choose(moved->name);
    }
    show_objects();
}

/// Chosen; pressed again it is not.
void GarmentMode::press_object_row(std::size_t row) {
    const std::string& name = objects()[row].name;
    objects_.choose(objects_.chosen() == name ? "" : name);
}

void GarmentMode::unplace_row(std::size_t row, std::int64_t now_us) {
    if (row >= objects().size()) return;
    const std::string name = objects()[row].name;
    objects_.choose("");
    take_reply(desk_->unplace(name), now_us);
}

void GarmentMode::fill_object_rows(ui::GarmentState& state) const {
    for (const core::PlacedObject& object : objects()) {
        ui::LayerRow row;
        row.name = object.name;
        row.swatch = ui::Colour::hex(kLeather);
        row.object = true;
        row.selected = objects_.chosen() == object.name;
        state.rows.push_back(std::move(row));
    }
}

}  // namespace app
