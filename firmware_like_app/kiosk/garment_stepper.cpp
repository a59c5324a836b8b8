#include "firmware_like_app/kiosk/garment_stepper.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using Of = ui::StepperOf;

struct Range {
    double least, most;
};

Range range_of(Of what) {
    switch (what) {
        case Of::Offset:
            return {0, 20};
        case Of::Height:
            return {-10, 220};
        case Of::Quads:
            return {1, 6};
        case Of::Across:
        case Of::Depth:
        case Of::AbovePoint:
            break;
    }
    return {-120, 120};
}

std::size_t axis_of(Of what) {
    return what == Of::Across ? 0 : what == Of::Height ? 1 : 2;
}

double tenths(double cm) {
    return std::round(cm * 10) / 10;
}

}  // namespace

Of GarmentStepper::of(ui::GarmentTool tool, const core::DrawingView& view) {
    if (tool == ui::GarmentTool::TemporaryPlane) return Of::AbovePoint;
    if (tool != ui::GarmentTool::OnPlane) return Of::Offset;
    const int axis = core::axis_toward(view);
    return axis == 0 ? Of::Across : axis == 1 ? Of::Height : Of::Depth;
}

std::optional<double>& GarmentStepper::plane(Of what) {
    return planes_cm_[axis_of(what)];
}

std::optional<double> GarmentStepper::cm(Of what) const {
    if (what == Of::Offset) return offset_cm_;
    if (what == Of::AbovePoint) return temporary_cm_;
    if (what == Of::Quads) return quads_cm_;
    return planes_cm_[axis_of(what)];
}

ui::Stepper GarmentStepper::shown(Of what) const {
    const std::optional<double> now = cm(what);
    const Range range = range_of(what);
    return {what, now, !now || *now > range.least, !now || *now < range.most};
}

void GarmentStepper::set(core::DeskSettings& settings, const core::DrawingView& view) const {
    settings.offset_cm = offset_cm_;
    settings.temporary_cm = temporary_cm_;
    settings.plane_cm = planes_cm_[static_cast<std::size_t>(core::axis_toward(view))];
}

void GarmentStepper::put(Of what, double cm) {
    const Range range = range_of(what);
    const double value = std::clamp(tenths(cm), range.least, range.most);
    if (what == Of::Offset)
        offset_cm_ = value;
    else if (what == Of::AbovePoint)
        temporary_cm_ = value;
    else if (what == Of::Quads)
        quads_cm_ = value;
    else
        plane(what) = value;
}

void GarmentStepper::step(Of what, int by, double start_cm) {
    put(what, tenths(cm(what).value_or(start_cm)) + by * 0.1);
}

int GarmentStepper::tenths_of_step(Of what, int repeats) {
    if (what == Of::Offset || what == Of::Quads) return 1;
    return repeats < 10 ? 1 : repeats < 25 ? 5 : 10;
}

void GarmentStepper::drag(Of what, double from_cm, double design_px) {
    const double far = std::abs(design_px);
    put(what, tenths(from_cm) + std::copysign(0.0125 * far + 0.0004 * far * far, design_px));
}

void GarmentStepper::toggle(Of what, double start_cm) {
    if (what == Of::AbovePoint) temporary_cm_ = 0.0;
    if (!ui::is_plane(what)) return;
    std::optional<double>& other = put_aside_[axis_of(what)];
    if (std::optional<double>& now = plane(what); now) {
        other = now;
        now.reset();
    } else {
        put(what, other.value_or(start_cm));
    }
}

}  // namespace app
