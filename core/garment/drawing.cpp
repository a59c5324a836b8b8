#include "core/garment/drawing.hpp"

#include <array>
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

int axis_toward(const DrawingView& view) {
    const std::array<double, 3> along{std::abs(view.toward.x), std::abs(view.toward.y), std::abs(view.toward.z)};
    int axis = 2;
    for (int k : {0, 1})
        if (along[static_cast<std::size_t>(k)] > along[static_cast<std::size_t>(axis)]) axis = k;
    return axis;
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

std::optional<Vec3> first_on_mesh(const QuadMesh& mesh, const DrawingView::Ray& ray) {
    double nearest = kReach;
    const auto meet = [&](Vec3 a, Vec3 b, Vec3 c) {  // Moeller and Trumbore 1997, both sides
        const Vec3 ab = b - a, ac = c - a, across = cross(ray.direction, ac);
        const double det = dot(ab, across);
        if (std::abs(det) < 1e-12) return;
        const Vec3 from = ray.origin - a, turned = cross(from, ab);
        const double u = dot(from, across) / det, v = dot(ray.direction, turned) / det;
        if (u < -1e-9 || v < -1e-9 || u + v > 1.0 + 1e-9) return;
        const double at = dot(ac, turned) / det;
        if (at > 0.0 && at < nearest) nearest = at;
    };
    for (const Quad& q : mesh.quads) {
        const auto& v = mesh.vertices;
        meet(v[q[0]], v[q[1]], v[q[2]]);
        if (q[3] != q[2]) meet(v[q[0]], v[q[2]], v[q[3]]);
    }
    if (nearest >= kReach) return std::nullopt;
    return ray.origin + ray.direction * nearest;
}

StrokePart mirrored_part(StrokePart part) {
    const auto image = [](Vec3 v) { return Vec3{-v.x, v.y, v.z}; };
    part.view.centre = image(part.view.centre);
    part.view.toward = image(part.view.toward);
    part.view.up = image(part.view.up);
    part.view.right = image(part.view.right) * -1.0;  // so that right, up and toward turn as before
    for (Point& p : part.points) p.x = -p.x;
    if (part.tool.kind == DrawingTool::Kind::PlaneYZ) part.tool.offset = -part.tool.offset;
    return part;
}

void StrokeLifter::begin_part(const DrawingView& view, DrawingTool tool) {
    view_ = view;
    tool_ = tool;
    part_is_new_ = true;
    if (tool.kind != DrawingTool::Kind::Temporary && anchor_ && !line_.empty()) anchor_->place = line_.back();
}

std::optional<Vec3> StrokeLifter::anchor() const {
    return anchor_ ? std::optional<Vec3>(anchor_->place) : std::nullopt;
}

Result<std::optional<Vec3>> StrokeLifter::lift(Point at) const {
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return bad(number_of(number_) + "is no finite number.");
    const DrawingView::Ray ray = view_.ray(at);
    const auto place = [](Result<Vec3> p) -> Result<std::optional<Vec3>> {
        if (!p) return unexpected(p.error());
        return std::optional<Vec3>(*p);
    };
    switch (tool_.kind) {
        case DrawingTool::Kind::Body:
            return place(on_body(ray, tool_.offset, body_, number_));
        case DrawingTool::Kind::PlaneXY:
            return place(on_plane(ray, {0, 0, 1}, tool_.offset, number_));
        case DrawingTool::Kind::PlaneXZ:
            return place(on_plane(ray, {0, 1, 0}, tool_.offset, number_));
        case DrawingTool::Kind::PlaneYZ:
            return place(on_plane(ray, {1, 0, 0}, tool_.offset, number_));
        case DrawingTool::Kind::Piece:
            if (piece_ == nullptr) return bad("A stroke on a piece can only cut it.");
            return first_on_mesh(*piece_, ray);
        case DrawingTool::Kind::Temporary:
            break;
    }
    if (!anchor_)
        return bad("The stroke begins in the temporary plane, which passes through the last point drawn before.");
    const Point moved = at - anchor_->drawn;
    return std::optional<Vec3>(anchor_->place + view_.right * moved.x - view_.toward * moved.y +
                               view_.up * tool_.offset);
}

Result<void> StrokeLifter::add(Point at) {
    const bool temporary = tool_.kind == DrawingTool::Kind::Temporary;
    if (part_is_new_ && temporary && anchor_) {  // the view may have changed: the drawing goes on from where the pen is
        anchor_->drawn = at;
        if (!line_.empty()) anchor_->place = line_.back();
    }
    part_is_new_ = false;
    const Result<std::optional<Vec3>> place = lift(at);
    ++number_;
    if (!place) return unexpected(place.error());
    if (!*place) return {};
    if (line_.empty() || length(**place - line_.back()) > 0.01) line_.push_back(**place);
    if (!temporary) anchor_ = Anchor{line_.back(), at};
    return {};
}

Result<std::vector<Vec3>> lift_stroke(const SketchStroke& stroke, const Obstacle& body, const QuadMesh* piece) {
    StrokeLifter lifter(body, piece);
    for (const StrokePart& part : stroke) {
        lifter.begin_part(part.view, part.tool);
        for (const Point& at : part.points)
            if (const Result<void> done = lifter.add(at); !done) return unexpected(done.error());
    }
    if (lifter.line().size() < 2) return bad("The stroke has fewer than two different points: draw it longer.");
    return lifter.line();
}

}  // namespace core
