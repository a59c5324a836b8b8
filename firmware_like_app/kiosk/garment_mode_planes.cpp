// Where lines lie: the stepper's number, and the plane that is drawn in as the views show it.

#include <algorithm>
#include <array>
#include <cmath>

#include "firmware_like_app/kiosk/garment_mode.hpp"

namespace app {
namespace {

constexpr double kPlaneHalf_cm = 38;
constexpr double kEdgeOn = 0.02;  // cosine: such a plane is seen as a line

/// Along an axis: 0 x, 1 y, 2 z.
double along(core::Vec3 p, int axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

}  // namespace

ui::StepperOf GarmentMode::stepper_of() const {
    if (page_ + 1 == ui::kGarmentPages) return ui::StepperOf::Quads;
    return GarmentStepper::of(tool_, views_.camera().view);
}

/// Where the last line ends: a plane that was nowhere is stepped from there.
double GarmentMode::last_place_cm(ui::StepperOf what) const {
    if (!desk_ || !ui::is_plane(what)) return 0;
    const int axis = core::axis_toward(views_.camera().view);
    if (const core::LineGoingOn* going = desk_->line_going_on(); going != nullptr) return along(going->end, axis);
    const std::vector<core::NetworkLine>& lines = desk_->network().lines();
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        if (line->alive && line->layer == desk_->layer()) return along(line->shape.back(), axis);
    }
    return 0;
}

void GarmentMode::step_number(int direction) {
    const ui::StepperOf what = stepper_of();
    stepper_.step(what, direction * GarmentStepper::tenths_of_step(what, repeats_), last_place_cm(what));
}

/// What the stepper made of the quads, when it is let go.
void GarmentMode::keep_quads(std::int64_t now_us) {
    const std::optional<double> cm = stepper_.cm(ui::StepperOf::Quads);
    if (desk_ && cm && *cm != desk_->network().options().edge_cm) take_reply(desk_->set_edge(*cm), now_us);
}

/// The plane of the stroke; before it, the one that the stepper put. Over the figure where it is seen from above or
/// below, in the small views as a line or a frame.
void GarmentMode::fill_planes(ui::GarmentState& state) const {
    std::optional<core::StrokePreview::Plane> plane;
    if (hold_ == Hold::Drawing) {
        plane = desk_->preview().plane;
        const core::SpaceLine& line = desk_->preview().line;
        if (plane && !line.empty()) {  // its frame about the line
            const core::Vec3 normal = core::cross(plane->right, plane->up);
            plane->origin = line.front() + normal * core::dot(plane->origin - line.front(), normal);
        }
    } else if (ui::is_plane(state.stepper.of) && state.stepper.cm) {
        const int axis = core::axis_toward(views_.camera().view);
        plane = core::plane_across(axis, *state.stepper.cm);
        if (axis != 1) plane->origin.y = 0.5 * views_.height_cm();
    }
    if (!plane) return;
    const core::Vec3 normal = core::cross(plane->right, plane->up);
    const auto turned = [&](const ui::FigureCamera& camera) {  // neither edge-on nor the sheet itself
        const double facing = std::abs(core::dot(normal, camera.view.toward));
        return camera.view.eye_distance > 0 || (facing > kEdgeOn && facing < 1 - kEdgeOn);
    };
    const auto edge_on = [&](const ui::FigureCamera& camera) {
        return std::abs(core::dot(normal, camera.view.toward)) <= kEdgeOn;
    };
    if (turned(views_.camera()) || tool_ == ui::GarmentTool::TemporaryPlane)
        state.plane_px = projected_plane(*plane, views_.camera(), kPlaneHalf_cm);
    // in the small views as tall as the figure
    const double half = std::abs(normal.y) > 0.5 ? kPlaneHalf_cm : 0.5 * views_.height_cm();
    core::StrokePreview::Plane whole = *plane;
    if (std::abs(plane->up.y) > 0.99) whole.origin.y = 0.5 * views_.height_cm();
    for (std::size_t i = 0; i < ui::kGarmentTiles; ++i) {
        if (i == ui::tile_of(views_.view())) continue;
        const ui::FigureCamera camera = views_.tile_camera(i);
        if (!turned(camera) && !edge_on(camera)) continue;
        ui::PlaneTrace trace{i, projected_plane(whole, camera, turned(camera) ? 0.9 * half : half)};
        trace.px.push_back(trace.px.front());
        state.plane_traces.push_back(std::move(trace));
    }
}

}  // namespace app
