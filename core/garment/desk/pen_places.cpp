#include "core/garment/desk/pen_places.hpp"

namespace core {

SettledView settled(const DrawingView& view) {
    if (view.eye_distance > 0.0) {
        DrawingView out = view;
        for (int k = 0; k < 3; ++k)
            if (const auto next = perspective_view(out.centre + out.toward * out.eye_distance, out.centre); next)
                out = *next;
        return {out, {}};
    }
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
