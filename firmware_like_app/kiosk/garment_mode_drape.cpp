// The garment under gravity, and back as it was drawn.

#include <algorithm>
#include <utility>

#include "firmware_like_app/kiosk/garment_mode.hpp"

namespace app {

bool GarmentMode::can_hang() const {
    const std::vector<core::BuiltLayer>& layers = desk_->cloth();
    return std::any_of(layers.begin(), layers.end(), [](const core::BuiltLayer& layer) {
        return layer.cloth && !layer.cloth->fitted.mesh.quads.empty();
    });
}

void GarmentMode::press_drape() {
    problem_.clear();
    notes_.clear();
    tape_.reset();
    if (hanging_wanted_) {
        put_back();
    } else if (can_hang()) {
        finish_line();
        hanging_wanted_ = true;
        drawing_due_ = true;
    }
}

/// As drawn. Every stroke and every tool begins with this.
void GarmentMode::put_back() {
    if (!hanging_wanted_) return;
    hanging_wanted_ = false;
    drape_.stop();
    hanging_.clear();
    views_.set_places({});
    drawing_due_ = live_due_ = true;
}

/// Other cloth than that which hangs, after an undo or on another body, begins to hang anew.
void GarmentMode::follow_drape(std::int64_t now_us) {
    if (!hanging_wanted_) return;
    if (desk_->cloth_is_current() && !(drape_.on() && drape_.hangs(desk_->cloth()))) {
        hanging_.clear();
        views_.set_places({});
        drape_.start(desk_->cloth(), desk_->state().worn(), now_us);
    }
    drape_.advance(now_us);
    if (std::optional<HangingPlaces> newest = drape_.take()) {
        hanging_ = std::move(*newest);
        views_.set_places(hanging_);
    }
}

}  // namespace app
