#include "ui/draw/figure_camera.hpp"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

constexpr double kHalfWidth_cm = 62, kHalfDepth_cm = 40;  // arms held away, a wide skirt
constexpr double kEye_cm = 560;
constexpr double kFar_px = 1e6;

}  // namespace

core::Point FigureCamera::to_px(core::Vec3 place) const {
    const core::Vec3 from = place - view.centre;
    double x = core::dot(view.right, from), y = core::dot(view.up, from);
    if (view.eye_distance > 0) {
        const double ahead = view.eye_distance - core::dot(view.toward, from);
        if (ahead < 1e-3) return {kFar_px, kFar_px};
        x *= view.eye_distance / ahead;
        y *= view.eye_distance / ahead;
    }
    return {centre_px.x + x * scale_px, centre_px.y - y * scale_px};
}

core::Point FigureCamera::to_drawing(core::Point px) const {
    return {(px.x - centre_px.x) / scale_px, (centre_px.y - px.y) / scale_px};
}

FigureCamera framed(const core::DrawingView& view, const Rect& box, double height_cm) {
    FigureCamera camera{view, 1, {0, 0}};
    // a view in perspective is for looking: the figure as large as it goes, hands may come near the edge
    const double half_width = view.eye_distance > 0 ? 30 : kHalfWidth_cm;
    const double half_depth = view.eye_distance > 0 ? 14 : kHalfDepth_cm;
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (int corner = 0; corner < 8; ++corner) {
        const core::Point p =
            camera.to_px({(corner & 1) != 0 ? half_width : -half_width, (corner & 2) != 0 ? height_cm : 0.0,
                          (corner & 4) != 0 ? half_depth : -half_depth});
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    camera.scale_px = std::min(box.width / (right - left), box.height / (bottom - top));
    camera.centre_px = {box.centre_x() - (left + right) / 2 * camera.scale_px,
                        box.centre_y() - (top + bottom) / 2 * camera.scale_px};
    return camera;
}

core::DrawingView solid_view(double azimuth_rad, double elevation_rad, double height_cm) {
    const core::Vec3 target{0, height_cm * 0.5, 0};
    const double level = kEye_cm * std::cos(elevation_rad);
    const core::Vec3 eye = target + core::Vec3{level * std::sin(azimuth_rad), kEye_cm * std::sin(elevation_rad),
                                               level * std::cos(azimuth_rad)};
    return *core::perspective_view(eye, target);  // the eye is never at the target
}

}  // namespace ui
