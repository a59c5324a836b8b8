// The pen at the garment desk while a stroke is open, and what ends it.

#include <algorithm>
#include <utility>

#include "core/garment/desk/desk_notes.hpp"
#include "core/garment/desk/garment_desk.hpp"
#include "core/garment/desk/pen_places.hpp"
#include "core/garment/desk/pick.hpp"

namespace core {
namespace {

using Kind = DesignStep::Kind;
using ToolKind = DrawingTool::Kind;

}  // namespace

/// The tool in use: that which the pen came down with, but lines change from one of their tools to another.
DeskTool GarmentDesk::hand() const {
    const bool other = goes_on_with(open_->tool) && goes_on_with(settings_.tool);
    return other ? settings_.tool : open_->tool;
}

void GarmentDesk::begin(const DrawingView& view, Point at) {
    const bool first = !open_ || !open_->lifted;
    if (first) {
        cancel();
        open_.emplace();
        open_->tool = settings_.tool;
        if (!goes_on_with(settings_.tool)) finish_line();
        resume();
    }
    open_->lifted = false;
    const SettledView real = settled(view);
    at = at + real.shift;
    if (first) {
        open_->view = real.view;
        open_->first = at;
    }
    open_->last = at;
    preview_.tool = hand();
    preview_.cut = hand() == DeskTool::Cut || hand() == DeskTool::Hole;
    if (takes_stroke(hand())) {
        begin_part(real.view, at);
        add_sample(at);
        preview_stroke();
        return;
    }
    if (!first) return;
    Pick vertex = pick_vertex(network(), layer(), real.view, at, settings_.reach_cm);
    const bool of_line = hand() == DeskTool::Smooth || hand() == DeskTool::Bump;
    if (of_line || (hand() == DeskTool::Move && vertex.kind == Pick::Kind::None))
        vertex = pick_line(network(), layer(), real.view, at, settings_.reach_cm);
    open_->grabbed = std::move(vertex);
    open_->to = open_->grabbed.place;
}

void GarmentDesk::extend(const DrawingView& view, Point at) {
    if (!open_ || open_->lifted) return;
    const SettledView real = settled(view);
    at = at + real.shift;
    open_->last = at;
    if (takes_stroke(hand())) {
        const bool changed = open_->parts.empty() || open_->hands.back().tool != hand() ||
                             !same_view(open_->parts.back().view, real.view);
        if (changed) begin_part(real.view, at);
        add_sample(at);
        preview_stroke();
    } else if (hand() == DeskTool::Move && open_->grabbed.kind != Pick::Kind::None) {
        drag(real.view, at);
    } else if (open_->grabbed.kind != Pick::Kind::None) {
        preview_.line = {open_->grabbed.place, facing_place(real.view, at, open_->grabbed.place)};
    }
}

void GarmentDesk::pause() {
    if (open_ && !open_->parts.empty()) open_->lifted = true;
}

void GarmentDesk::cancel() {
    if (open_ && open_->dragged) drop_live();
    open_.reset();
    preview_ = {};
}

DeskReply GarmentDesk::tap(const DrawingView& view, Point at) {
    begin(view, at);
    return end();
}

/// A part of the stroke in this view, with the tool in use.
void GarmentDesk::begin_part(const DrawingView& view, Point at) {
    OpenStroke& stroke = *open_;
    if (!stroke.lifter) {
        if (preview_.cut && !settings_.cuts_on_body) {
            const Pick under = pick_region(network(), layer(), view, at, false);
            const NetworkRegion* region = network().find_region(under.name);
            const Result<RegionBoundary> boundary =
                region != nullptr ? network().boundary(*region) : unexpected(ErrorCode::BadArgument, "none");
            const Result<FilledRegion> filled =
                boundary ? fill_region(boundary->outline, region->alpha) : unexpected(boundary.error());
            if (filled) stroke.piece = std::make_unique<QuadMesh>(filled->mesh);
        }
        stroke.lifter = std::make_unique<StrokeLifter>(state().obstacle(), stroke.piece.get());
    }
    if (hand() == DeskTool::DrawTemporary && stroke.lifter->line().empty()) add_anchor(view, at);
    const DrawingTool tool = lifting_tool(view, at);
    stroke.parts.push_back({view, tool, {}});
    stroke.hands.push_back({hand(), hand() == DeskTool::DrawOnPlane && settings_.plane_cm.has_value()});
    stroke.lifter->begin_part(view, tool);
    preview_.plane.reset();
    if (tool.kind == ToolKind::Temporary) {
        if (const std::optional<Vec3> anchor = stroke.lifter->anchor(); anchor)
            preview_.plane = StrokePreview::Plane{*anchor + view.up * tool.offset, view.right, view.toward * -1.0};
    } else if (hand() == DeskTool::DrawOnPlane) {
        preview_.plane = plane_across(axis_toward(view), tool.offset);
    }
}

StrokePreview::Plane plane_across(int axis, double at) {
    const Vec3 normal = axis == 0 ? Vec3{1, 0, 0} : axis == 1 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 right = axis == 0 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, up = axis == 1 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
    return {normal * at, right, up};
}

DrawingTool GarmentDesk::lifting_tool(const DrawingView& view, Point at) const {
    switch (hand()) {
        case DeskTool::DrawTemporary:
            return {ToolKind::Temporary, settings_.temporary_cm};
        case DeskTool::DrawOnPlane: {
            const int axis = axis_toward(view);
            return plane_tool(axis, settings_.plane_cm ? *settings_.plane_cm : plane_through_start(view, at, axis));
        }
        case DeskTool::Cut:
        case DeskTool::Hole:
            if (open_->piece) return {ToolKind::Piece, 0.0};
            break;
        case DeskTool::Tape:
            return {ToolKind::Body, 0.0};
        default:
            break;
    }
    return {ToolKind::Body, settings_.offset_cm};
}

/// Where the plane lies that no setting puts: through the last point, or what the pen came down on.
double GarmentDesk::plane_through_start(const DrawingView& view, Point at, int axis) const {
    if (open_ && open_->lifter && !open_->lifter->line().empty()) return coordinate(open_->lifter->line().back(), axis);
    for (const Pick& pick : {pick_vertex(network(), layer(), view, at, settings_.reach_cm),
                             pick_line(network(), layer(), view, at, settings_.reach_cm)})
        if (pick.kind != Pick::Kind::None) return coordinate(pick.place, axis);
    return 0.0;
}

/// The temporary plane hangs on a point drawn before: the vertex under the pen, or the end of the last line.
void GarmentDesk::add_anchor(const DrawingView& view, Point at) {
    Pick vertex = pick_vertex(network(), layer(), view, at, settings_.reach_cm);
    if (vertex.kind == Pick::Kind::None) {
        for (auto line = network().lines().rbegin(); line != network().lines().rend(); ++line) {
            if (!line->alive || line->layer != layer()) continue;
            vertex.place = line->shape.back();
            vertex.kind = Pick::Kind::Vertex;
            break;
        }
    }
    if (vertex.kind == Pick::Kind::None) return;  // the stroke then says what it lacks
    const int axis = axis_toward(view);
    const StrokePart anchor{view, plane_tool(axis, coordinate(vertex.place, axis)), {view.project(vertex.place)}};
    open_->parts.push_back(anchor);
    open_->hands.push_back({DeskTool::DrawOnPlane, true});
    open_->lifter->begin_part(view, anchor.tool);
    (void)open_->lifter->add(anchor.points.front());
}

void GarmentDesk::add_sample(Point at) {
    StrokePart& part = open_->parts.back();
    if (!part.points.empty() && distance(part.points.back(), at) < kLeastStep_cm) return;
    part.points.push_back(at);
    (void)open_->lifter->add(at);  // what cannot be lifted is told when the stroke ends
}

void GarmentDesk::preview_stroke() {
    const OpenStroke& stroke = *open_;
    preview_.line = stroke.lifter->line();
    if (preview_.line.empty() || !draws_line(hand())) return;
    const double reach = settings_only_.network.snap_cm;
    const auto target = [&](const StrokePart& part, Point at, Vec3 end) {
        if (const std::optional<Vec3> met = joined(part, at, end); met)
            return SnapTarget{SnapTarget::Kind::Vertex, *met, {}};
        const std::vector<Landmark> none;
        return snap_target(network(), layer(), settings_.to_landmarks ? state().landmarks() : none, end, reach,
                           state().look().mirror);
    };
    preview_.start = target(stroke.parts.front(), stroke.parts.front().points.front(), preview_.line.front());
    preview_.end = target(stroke.parts.back(), stroke.parts.back().points.back(), preview_.line.back());
}

Pick GarmentDesk::pick(const DrawingView& view, Point at) const {
    const SettledView real = settled(view);
    at = at + real.shift;
    Pick found = pick_vertex(network(), layer(), real.view, at, settings_.reach_cm);
    if (found.kind == Pick::Kind::None) found = pick_line(network(), layer(), real.view, at, settings_.reach_cm);
    if (found.kind == Pick::Kind::None) found = pick_region(network(), layer(), real.view, at, state().look().mirror);
    return found;
}

SnapTarget GarmentDesk::snap(const DrawingView& view, Point at) const {
    const SettledView real = settled(view);
    at = at + real.shift;
    for (const Pick& pick : {pick_vertex(network(), layer(), real.view, at, settings_.reach_cm),
                             pick_line(network(), layer(), real.view, at, settings_.reach_cm)}) {
        if (pick.kind == Pick::Kind::Vertex) return {SnapTarget::Kind::Vertex, pick.place, {}};
        if (pick.kind == Pick::Kind::Line) return {SnapTarget::Kind::Line, pick.place, pick.name};
    }
    StrokeLifter lifter(state().obstacle());
    lifter.begin_part(real.view, settings_.tool == DeskTool::DrawOnPlane
                                     ? plane_tool(axis_toward(real.view), settings_.plane_cm.value_or(0.0))
                                     : DrawingTool{ToolKind::Body, settings_.offset_cm});
    if (!lifter.add(at) || lifter.line().empty()) return {};
    const std::vector<Landmark> none;
    return snap_target(network(), layer(), settings_.to_landmarks ? state().landmarks() : none, lifter.line().front(),
                       settings_only_.network.snap_cm, state().look().mirror);
}

/// A vertex under the pen, with what follows it.
void GarmentDesk::drag(const DrawingView& view, Point at) {
    OpenStroke& stroke = *open_;
    stroke.to = facing_place(view, at, stroke.grabbed.place);
    if (state().look().mirror && stroke.grabbed.place.x == 0.0) stroke.to.x = 0.0;
    if (!stroke.dragged) (void)ready_live(layer());
    Network moved = network();
    if (!moved.move(stroke.grabbed.place, stroke.to, settings_.move_radius_cm, state().look().mirror)) return;
    live_shown_ = live_ && live_->follow(moved);
    stroke.dragged = std::move(moved);
    preview_.line = {stroke.grabbed.place, stroke.to};
}

DeskReply GarmentDesk::end() {
    if (!open_) return {};
    OpenStroke stroke = std::move(*open_);
    open_.reset();
    preview_ = {};
    if (going_) return lengthen(std::move(stroke));
    switch (stroke.tool) {
        case DeskTool::DrawOnPlane:
        case DeskTool::DrawOnBody:
        case DeskTool::DrawTemporary:
            return end_line(std::move(stroke));
        case DeskTool::Add:
            if (distance(stroke.first, stroke.last) < kTap_cm && stroke.lifter->line().size() < 4)
                return fill_at(stroke.view, stroke.first);
            return end_line(std::move(stroke));
        case DeskTool::Cut:
            return end_cut(std::move(stroke), Kind::Cut);
        case DeskTool::Hole:
            return end_cut(std::move(stroke), Kind::Hole);
        case DeskTool::Move:
            return end_move(stroke);
        case DeskTool::Smooth:
            return end_along(stroke, Kind::Smooth);
        case DeskTool::Bump:
            return end_along(stroke, Kind::Bump);
        case DeskTool::Weld:
            return end_weld(stroke);
        case DeskTool::Tape:
            return end_tape(stroke);
        case DeskTool::Select:
        case DeskTool::RemoveRegion:
        case DeskTool::Corner:
        case DeskTool::Erase:
            return end_tap(stroke, stroke.tool);
    }
    return {};
}

}  // namespace core
