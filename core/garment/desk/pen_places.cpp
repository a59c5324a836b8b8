#include "core/garment/desk/pen_places.hpp"

namespace core {
namespace {

/// A view in perspective is written as where its eye is and what it looks at. Read back and written again these differ
/// in their last digits, mostly no more after two or three times; one view in a hundred goes to and fro for ever, and
/// does not from an eye some millionths of a centimetre beside.
DrawingView settled_in_perspective(const DrawingView& view) {
    constexpr double kBeside_cm = 0x1p-20;
    constexpr int kMostReads = 8, kMostBeside = 64;
    const Vec3 eye = view.centre + view.toward * view.eye_distance;
    for (int beside = 0; beside < kMostBeside; ++beside) {
        Result<DrawingView> out = perspective_view(eye + Vec3{beside * kBeside_cm, 0.0, 0.0}, view.centre);
        for (int k = 0; out && k < kMostReads; ++k) {
            const Result<DrawingView> next =
                perspective_view(out->centre + out->toward * out->eye_distance, out->centre);
            if (next && same_view(*next, *out)) return *out;
            out = next;
        }
    }
    return view;
}

}  // namespace

SettledView settled(const DrawingView& view) {
    if (view.eye_distance > 0.0) return {settled_in_perspective(view), {}};
    const Point shift{dot(view.centre, view.right), dot(view.centre, view.up)};
    for (const char* name : {"front", "back", "left", "right", "top"})
        if (const DrawingView known = *named_view(name); known.right == view.right && known.up == view.up)
            return {known, shift};
    DrawingView out{{}, view.right, view.up, cross(view.right, view.up)};
    return {out, shift};
}

bool same_view(const DrawingView& a, const DrawingView& b) {
    return a.centre == b.centre && a.right == b.right && a.up == b.up && a.toward == b.toward &&
           a.eye_distance == b.eye_distance;
}

double coordinate(Vec3 p, int axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

DrawingTool plane_tool(int axis, double at) {
    using ToolKind = DrawingTool::Kind;
    return {axis == 0 ? ToolKind::PlaneYZ : axis == 1 ? ToolKind::PlaneXZ : ToolKind::PlaneXY, at};
}

Vec3 facing_place(const DrawingView& view, Point at, Vec3 through) {
    const DrawingView::Ray ray = view.ray(at);
    const double along = dot(through - ray.origin, view.toward) / dot(ray.direction, view.toward);
    return ray.origin + ray.direction * along;
}

}  // namespace core
