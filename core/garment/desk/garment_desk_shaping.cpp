// Tools that change what there is: cutting, moving, rubbing, joining, taking away.

#include <algorithm>
#include <limits>
#include <utility>

#include "core/garment/desk/desk_notes.hpp"
#include "core/garment/desk/garment_desk.hpp"
#include "core/garment/desk/network_paths.hpp"
#include "core/garment/desk/pen_places.hpp"
#include "core/garment/desk/pick.hpp"
#include "core/garment/desk/region_names.hpp"

namespace core {
namespace {

using Kind = DesignStep::Kind;
using ToolKind = DrawingTool::Kind;

}  // namespace

DeskReply GarmentDesk::end_cut(OpenStroke stroke, Kind kind) {
    SketchStroke& parts = stroke.parts;
    if (parts.empty() || parts.front().points.empty()) return {};
    const bool mirror = state().look().mirror;
    // the piece under the middle of the stroke
    const StrokePart& middle = parts[parts.size() / 2];
    const Point at = middle.points[middle.points.size() / 2];
    const Pick region = pick_region(network(), layer(), middle.view, at, mirror);
    if (region.kind == Pick::Kind::None)
        return told(DeskNote::Key::NoRegion, "There is no piece here: begin and end the line at the edges of one.",
                    stroke.lifter->line().empty() ? Vec3{} : stroke.lifter->line().front());
    if (mirror && region.place.x < -0.5)
        for (StrokePart& part : parts) part = mirrored_part(std::move(part));
    if (!settings_.cuts_on_body)
        for (StrokePart& part : parts) part.tool = {ToolKind::Piece, 0.0};
    DesignStep step;
    step.kind = kind;
    step.region = region.name;
    step.name = free_region_name(network(), region.name);
    step.stroke = std::move(parts);
    DeskReply reply = act({step});
    for (DeskNote& note : reply.notes) note.place = region.place, note.name = region.name;
    return reply;
}

DeskReply GarmentDesk::end_move(const OpenStroke& stroke) {
    if (stroke.grabbed.kind == Pick::Kind::None)
        return told(DeskNote::Key::NothingHere, "There is no vertex under the pen to move.", {});
    if (length(stroke.to - stroke.grabbed.place) < kLeastStep_cm) return {};
    DesignStep step;
    step.kind = Kind::Move;
    step.at = stroke.grabbed.place;
    step.to = stroke.to;
    step.radius = settings_.move_radius_cm;
    return act({step}, true);
}

/// Smooth and Bump: from where the pen came down to the place of the same line nearest to where it was lifted.
DeskReply GarmentDesk::end_along(const OpenStroke& stroke, Kind kind) {
    if (stroke.grabbed.kind != Pick::Kind::Line)
        return told(DeskNote::Key::NothingHere, "There is no line under the pen.", {});
    const SpaceLine& shape = network().lines()[static_cast<std::size_t>(stroke.grabbed.index)].shape;
    DesignStep step;
    step.kind = kind;
    step.lines = {stroke.grabbed.name};
    step.at = stroke.grabbed.place;
    step.to = shape.front();
    double least = std::numeric_limits<double>::max();
    for (const Vec3& p : shape)
        if (const double away = distance(stroke.view.project(p), stroke.last); away < least) least = away, step.to = p;
    if (distance(stroke.first, stroke.last) < kTap_cm) {  // a tap: the whole line
        step.at = shape.front();
        step.to = shape.back();
    }
    if (kind == Kind::Bump) {
        step.radius = settings_.wave_cm;
        step.depth = settings_.wave_depth_cm;
    }
    DeskReply reply = act({step});
    for (DeskNote& note : reply.notes) note.place = stroke.grabbed.place;
    return reply;
}

DeskReply GarmentDesk::end_weld(const OpenStroke& stroke) {
    const Pick onto = pick_vertex(network(), layer(), stroke.view, stroke.last, settings_.reach_cm);
    if (stroke.grabbed.kind != Pick::Kind::Vertex || onto.kind != Pick::Kind::Vertex ||
        onto.index == stroke.grabbed.index)
        return told(DeskNote::Key::NothingHere, "Draw from one vertex to another to join them.", stroke.grabbed.place);
    DesignStep step;
    step.kind = Kind::Weld;
    step.at = onto.place;
    step.to = stroke.grabbed.place;
    DeskReply reply = act({step}, true);
    for (DeskNote& note : reply.notes) note.place = onto.place;
    return reply;
}

DeskReply GarmentDesk::end_tap(const OpenStroke& stroke, DeskTool tool) {
    const bool mirror = state().look().mirror;
    const Pick line = pick_line(network(), layer(), stroke.view, stroke.first, settings_.reach_cm);
    const Pick region = pick_region(network(), layer(), stroke.view, stroke.first, mirror);
    if (tool == DeskTool::Select) {
        DeskReply reply;
        reply.pick = pick_vertex(network(), layer(), stroke.view, stroke.first, settings_.reach_cm);
        if (reply.pick.kind == Pick::Kind::None) reply.pick = line;
        if (reply.pick.kind == Pick::Kind::None) reply.pick = region;
        return reply;
    }
    DesignStep step;
    if (tool == DeskTool::Erase && line.kind == Pick::Kind::Line) {
        step.kind = Kind::Erase;
        step.lines = {line.name};
        return act({step}, true);
    }
    if (tool == DeskTool::Corner) {
        const Pick vertex = pick_vertex(network(), layer(), stroke.view, stroke.first, settings_.reach_cm);
        const NetworkRegion* of = region_at_corner(network(), layer(), vertex, line, region);
        if (of == nullptr) return told(DeskNote::Key::NothingHere, "There is no edge of a piece here.", {});
        step.kind = Kind::Corner;
        step.region = of->name;
        step.at = vertex.kind == Pick::Kind::Vertex ? vertex.place : line.place;
        step.on = vertex.kind != Pick::Kind::Vertex || of->corners.count(vertex.index) == 0;
        return act({step});
    }
    if (region.kind == Pick::Kind::None)
        return told(DeskNote::Key::NothingHere, "There is nothing of this layer under the pen.", {});
    step.kind = Kind::Remove;
    step.region = region.name;
    return act({step});
}

}  // namespace core
