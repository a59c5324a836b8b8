#include "input/pen_axes.hpp"

#include <algorithm>
#include <numbers>

namespace input {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kWidestTilt_rad = 60.0 * kDegree;

double clamped(std::int32_t value, const AxisRange& range) {
    return static_cast<double>(std::clamp(value, range.min, range.max));
}

std::optional<double> share(const std::optional<std::int32_t>& value, const std::optional<AxisRange>& range) {
    if (!value || !range || range->max <= range->min) return std::nullopt;
    return (clamped(*value, *range) - range->min) / range->span();
}

std::optional<double> length_mm(const std::optional<std::int32_t>& value, const std::optional<AxisRange>& range) {
    if (!value || !range || range->per_unit <= 0.0) return std::nullopt;
    return (clamped(*value, *range) - range->min) / range->per_unit;
}

/// An angle whose `widest` is reached at the ends of a range without resolution. Zero is zero where the range holds it,
/// else the middle.
std::optional<double> angle_rad(const std::optional<std::int32_t>& value, const std::optional<AxisRange>& range,
                                double widest) {
    if (!value || !range || range->max <= range->min) return std::nullopt;
    const bool centred = range->min < 0;
    const double zero = centred ? 0.0 : (static_cast<double>(range->min) + range->max) / 2.0;
    const double offset = clamped(*value, *range) - zero;
    if (range->per_unit > 0.0) return offset / range->per_unit;
    if (range->span() <= 360.0) return offset * kDegree;
    return offset / (range->span() / 2.0) * widest;
}

}  // namespace

PenSample to_sample(const PenReport& report, const PenAxes& axes, std::int64_t time_ns, std::uint32_t device) {
    PenSample s;
    s.time_ns = time_ns;
    s.device = device;
    if (!report.in_range) return s;
    s.in_range = true;
    s.x = share(report.x, axes.x);
    s.y = share(report.y, axes.y);
    s.x_mm = length_mm(report.x, axes.x);
    s.y_mm = length_mm(report.y, axes.y);
    s.pressure = share(report.pressure, axes.pressure);
    s.tilt_x_rad = angle_rad(report.tilt_x, axes.tilt_x, kWidestTilt_rad);
    s.tilt_y_rad = angle_rad(report.tilt_y, axes.tilt_y, kWidestTilt_rad);
    s.rotation_rad = angle_rad(report.rotation, axes.rotation, std::numbers::pi);
    s.distance = share(report.distance, axes.distance);
    s.wheel = share(report.wheel, axes.wheel);
    s.tool = report.tool;
    s.serial = report.serial;
    s.tool_id = report.tool_id;
    s.tip = report.tip;
    s.buttons = report.buttons;
    return s;
}

}  // namespace input
