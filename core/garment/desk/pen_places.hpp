#pragma once
// Views, planes and tools as the pen of the garment desk needs them.

#include "core/garment/desk/desk_tool.hpp"

namespace core {

inline constexpr double kLeastStep_cm = 0.05;  ///< between samples of a stroke
inline constexpr double kTap_cm = 0.6;         ///< a stroke shorter than this is a tap
inline constexpr double kRayReach_cm = 800.0;

/// The view as a design file gives it back, bit for bit, and what its points are shifted by.
struct SettledView {
    DrawingView view;
    Point shift;
};
[[nodiscard]] SettledView settled(const DrawingView& view);

[[nodiscard]] bool same_view(const DrawingView& a, const DrawingView& b);

/// Along an axis: 0 x, 1 y, 2 z.
[[nodiscard]] double coordinate(Vec3 p, int axis);
/// The tool that draws in the plane across an axis.
[[nodiscard]] DrawingTool plane_tool(int axis, double at);

/// Whether a tool is given the pen's whole way.
[[nodiscard]] constexpr bool takes_stroke(DeskTool tool) {
    return draws_line(tool) || tool == DeskTool::Cut || tool == DeskTool::Hole || tool == DeskTool::Tape;
}

/// Where the pen is on the plane through a place that faces the view.
[[nodiscard]] Vec3 facing_place(const DrawingView& view, Point at, Vec3 through);

}  // namespace core
