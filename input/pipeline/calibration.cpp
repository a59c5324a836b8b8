#include "input/pipeline/calibration.hpp"

#include <algorithm>
#include <cassert>
#include <numbers>
#include <utility>

namespace input {
namespace {

double wrapped(double angle) {
    while (angle > std::numbers::pi) angle -= 2 * std::numbers::pi;
    while (angle < -std::numbers::pi) angle += 2 * std::numbers::pi;
    return angle;
}

/// One quarter turn clockwise of the tablet: what was its left edge is the sheet's top edge.
void turn_right(PenSample& s) {
    s.x = 1.0 - std::exchange(*s.y, *s.x);
    if (s.tilt_x_rad && s.tilt_y_rad) s.tilt_x_rad = -std::exchange(*s.tilt_y_rad, *s.tilt_x_rad);
    if (s.rotation_rad) s.rotation_rad = wrapped(*s.rotation_rad + std::numbers::pi / 2);
}

/// The area cut down around its middle until it is `aspect` times as wide as high.
std::array<double, 4> cut_to(std::array<double, 4> area, const TabletSize& size, double aspect) {
    const double shape = size.width_mm * (area[2] - area[0]) / (size.height_mm * (area[3] - area[1]));
    const bool too_wide = shape > aspect;
    double& low = too_wide ? area[0] : area[1];
    double& high = too_wide ? area[2] : area[3];
    const double middle = (low + high) / 2, half = (high - low) / 2 * (too_wide ? aspect / shape : shape / aspect);
    low = middle - half;
    high = middle + half;
    return area;
}

}  // namespace

Calibration::Calibration(const CalibrationOptions& options, std::optional<TabletSize> size)
    : area_(options.area),
      align_(options.align),
      turns_((static_cast<int>(options.turn) + (options.left_handed ? 2 : 0)) % 4) {
    assert(area_[0] < area_[2] && area_[1] < area_[3]);
    if (!size) return;
    if (options.keep_aspect) {
        area_ = cut_to(area_, *size, turns_ % 2 == 1 ? 1.0 / *options.keep_aspect : *options.keep_aspect);
    }
    sheet_ = TabletSize{size->width_mm * (area_[2] - area_[0]), size->height_mm * (area_[3] - area_[1])};
}

PenSample Calibration::apply(PenSample s) const {
    if (!s.x || !s.y) return s;
    s.x = (*s.x - area_[0]) / (area_[2] - area_[0]);
    s.y = (*s.y - area_[1]) / (area_[3] - area_[1]);
    for (int i = 0; i < turns_; ++i) turn_right(s);
    const double x = *s.x, y = *s.y;
    s.x = std::clamp(align_[0] * x + align_[1] * y + align_[2], 0.0, 1.0);
    s.y = std::clamp(align_[3] * x + align_[4] * y + align_[5], 0.0, 1.0);
    if (!sheet_) return s;
    const bool sideways = turns_ % 2 == 1;
    s.x_mm = *s.x * (sideways ? sheet_->height_mm : sheet_->width_mm);
    s.y_mm = *s.y * (sideways ? sheet_->width_mm : sheet_->height_mm);
    return s;
}

}  // namespace input
