#include "core/garment/drawing.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace core {
namespace {

constexpr double kFarAway = 400.0;  // where rays of parallel views start, from the view's plane
constexpr double kReach = 800.0;    // of a ray
constexpr double kEdgeOn = 0.02;    // cosine below which a plane counts as seen edge-on

Unexpected bad(std::string what) {
    return unexpected(ErrorCode::BadArgument, std::move(what));
}

std::string number_of(std::size_t point) {
    return "Point " + std::to_string(point + 1) + " of the stroke ";
}

Result<Vec3> on_body(const DrawingView::Ray& ray, double offset, const Obstacle& body, std::size_t number) {
    if (const std::optional<Vec3> hit = body.first_hit(ray.origin, ray.direction, offset, kReach)) return *hit;
    const Vec3 pass = body.nearest_pass(ray.origin, ray.direction, kReach);
    if (body.distance(pass) > kBodyToolReach_cm)
        return bad(number_of(number) + "passes the body too far away: draw nearer, or in a plane.");
    return pass;
}

Result<Vec3> on_plane(const DrawingView::Ray& ray, Vec3 normal, double offset, std::size_t number) {
    const double along = dot(ray.direction, normal);
    if (std::abs(along) < kEdgeOn)
        return bad(number_of(number) +
                   "lies in a plane that this view sees edge-on: turn the view or change the plane.");
    return ray.origin + ray.direction * ((offset - dot(ray.origin, normal)) / along);
}

/// `anchor`: the last point before the temporary plane, with its place in the drawing.
struct Anchor {
    Vec3 place;
    Point drawn;
};

Result<Vec3> lift(const StrokePart& part, Point at, const std::optional<Anchor>& anchor, const Obstacle& body,
                  std::size_t number) {
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return bad(number_of(number) + "is no finite number.");
    const double offset = part.tool.offset;
    switch (part.tool.kind) {
        case DrawingTool::Kind::Body:
            return on_body(part.view.ray(at), offset, body, number);
        case DrawingTool::Kind::PlaneXY:
            return on_plane(part.view.ray(at), {0, 0, 1}, offset, number);
        case DrawingTool::Kind::PlaneXZ:
            return on_plane(part.view.ray(at), {0, 1, 0}, offset, number);
        case DrawingTool::Kind::PlaneYZ:
            return on_plane(part.view.ray(at), {1, 0, 0}, offset, number);
        case DrawingTool::Kind::Temporary:
            break;
    }
    if (!anchor)
        return bad("The stroke begins in the temporary plane, which passes through the last point drawn before.");
    const Point moved = at - anchor->drawn;
    return anchor->place + part.view.right * moved.x - part.view.toward * moved.y;
}

}  // namespace

DrawingView::Ray DrawingView::ray(Point at) const {
    const Vec3 place = centre + right * at.x + up * at.y;
    if (eye_distance <= 0.0) return {place + toward * kFarAway, toward * -1.0};
    const Vec3 eye = centre + toward * eye_distance;
    return {eye, normalised(place - eye)};
}

Point DrawingView::project(Vec3 place) const {
    const Vec3 from = place - centre;
    const Point flat{dot(from, right), dot(from, up)};
    if (eye_distance <= 0.0) return flat;
    const double before = eye_distance - depth(place);
    return before > 0.0 ? flat * (eye_distance / before) : Point{NAN, NAN};
}

Result<DrawingView> named_view(std::string_view name) {
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    if (name == "front") return DrawingView{{}, x, y, z};
    if (name == "back") return DrawingView{{}, x * -1.0, y, z * -1.0};
    if (name == "left") return DrawingView{{}, z * -1.0, y, x};
    if (name == "right") return DrawingView{{}, z, y, x * -1.0};
    if (name == "top") return DrawingView{{}, x, z * -1.0, y};
    return bad("There is no view \"" + std::string(name) + "\"; there are front, back, left, right, top.");
}

Result<DrawingView> perspective_view(Vec3 eye, Vec3 target) {
    DrawingView view;
    view.centre = target;
    view.eye_distance = length(eye - target);
    view.toward = normalised(eye - target);
    const Vec3 beside = cross({0, 1, 0}, view.toward);
    if (!(view.eye_distance > 1e-6)) return bad("The eye of the view is where it looks: move it away.");
    view.right = length(beside) > 1e-6 ? normalised(beside) : Vec3{1, 0, 0};
    view.up = cross(view.toward, view.right);
    return view;
}

Result<std::vector<Vec3>> lift_stroke(const SketchStroke& stroke, const Obstacle& body) {
    std::vector<Vec3> line;
    std::optional<Anchor> anchor;
    std::size_t number = 0;
    for (const StrokePart& part : stroke) {
        if (part.tool.kind == DrawingTool::Kind::Temporary && anchor && !part.points.empty())
            anchor->drawn =
                part.points.front();  // the view may have changed: the drawing goes on from where the pen is
        for (const Point& at : part.points) {
            const Result<Vec3> place = lift(part, at, anchor, body, number++);
            if (!place) return unexpected(place.error());
            if (line.empty() || length(*place - line.back()) > 0.01) line.push_back(*place);
            if (part.tool.kind != DrawingTool::Kind::Temporary) anchor = Anchor{line.back(), at};
        }
        if (part.tool.kind == DrawingTool::Kind::Temporary && !line.empty() && !part.points.empty())
            anchor = Anchor{line.back(), part.points.back()};
    }
    if (line.size() < 2) return bad("The stroke has fewer than two different points: draw it longer.");
    return line;
}

}  // namespace core
