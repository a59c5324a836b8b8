// What lines the pen draws become: steps, and the pieces that they close.

#include <algorithm>
#include <utility>

#include "core/garment/desk/desk_notes.hpp"
#include "core/garment/desk/garment_desk.hpp"
#include "core/garment/desk/lifted_stroke.hpp"
#include "core/garment/desk/network_paths.hpp"
#include "core/garment/desk/pen_places.hpp"
#include "core/garment/desk/pick.hpp"
#include "core/garment/desk/region_names.hpp"

namespace core {
namespace {

using Kind = DesignStep::Kind;
using ToolKind = DrawingTool::Kind;

// How far in depth an end is put to a vertex or a line that the pen met. A plane was chosen for its depth.
constexpr double kJoinVertex_cm = 20.0, kJoinLine_cm = 10.0, kJoinFromPlane_cm = 6.0;
constexpr double kHidden_cm = 2.0;  // this far behind the body and more nothing is met

}  // namespace

/// The vertex, or place on a line, that the pen met with an end of its stroke that lies elsewhere in depth.
std::optional<Vec3> GarmentDesk::joined(const StrokePart& part, Point at, Vec3 end) const {
    const DrawingView& view = part.view;
    const bool free = part.tool.kind == ToolKind::Body || part.tool.kind == ToolKind::Temporary;
    if (!settings_.joins_in_view) return std::nullopt;
    const SnapTarget by_itself = snap_target(network(), layer(), {}, end, settings_only_.network.snap_cm, false);
    if (by_itself.kind == SnapTarget::Kind::Vertex) return std::nullopt;
    const auto is_seen = [&](Vec3 place) {
        const DrawingView::Ray ray = view.ray(view.project(place));
        const std::optional<Vec3> hit = state().obstacle().first_hit(ray.origin, ray.direction, 0.0, kRayReach_cm);
        return !hit || view.depth(place) > view.depth(*hit) - kHidden_cm;
    };
    std::optional<Vec3> best;
    double least = free ? kJoinVertex_cm : kJoinFromPlane_cm;
    for (const NetworkVertex& vertex : network().vertices()) {
        if (!vertex.alive || vertex.layer != layer()) continue;
        if (!(distance(view.project(vertex.place), at) <= settings_.reach_cm)) continue;
        if (const double away = length(vertex.place - end); away < least && is_seen(vertex.place))
            least = away, best = vertex.place;
    }
    if (best || by_itself.kind == SnapTarget::Kind::Line) return best;
    least = std::min(least, kJoinLine_cm);
    for (const NetworkLine& line : network().lines()) {
        if (!line.alive || line.layer != layer()) continue;
        for (const Vec3& p : line.shape)
            if (const double away = length(p - end);
                away < least && distance(view.project(p), at) <= settings_.reach_cm && is_seen(p))
                least = away, best = p;
    }
    return best;
}

/// Ends of a line at landmarks that the pen met, by what it could aim at in its view.
DesignStep GarmentDesk::at_landmarks(DesignStep step, const OpenStroke& stroke) const {
    DesignStep put = state().snapped(step, std::min(settings_only_.network.snap_cm, settings_.reach_cm));
    if (stroke.hands.front().placed) put.starts_at.clear();
    if (stroke.hands.back().placed) put.ends_at.clear();
    return put;
}

/// A new line, and the regions that it closes. What leaves the body stays as far as it lay on it; a stroke wholly
/// beside it lies in the plane of its view.
DeskReply GarmentDesk::end_line(OpenStroke stroke) {
    std::vector<DeskNote> notes;
    const Obstacle& body = state().obstacle();
    const bool adds = stroke.tool == DeskTool::Add;
    LiftedStroke lifted(stroke.parts, body);
    if (lifted.fault) {
        const auto [first, end] = lifted.longest([](const LiftedStroke::Sample& s) { return s.place.has_value(); });
        DeskNote note = note_of_lift(stroke.parts[lifted.fault_part], *lifted.fault, lifted.fault_place);
        if (end - first >= 2) {
            if (note.key == DeskNote::Key::OffBody)
                note.sentence = "The line left the body here: what lay on it stays.";
            stroke.parts = lifted.stroke(stroke.parts, first, end);
        } else if (note.key == DeskNote::Key::OffBody) {
            note.sentence = "This line passes the body: it lies in the plane of the view.";
            for (StrokePart& part : stroke.parts) part.tool = plane_tool(axis_toward(part.view), 0.0);
        } else {
            return {false, {std::move(note)}, {}, {}};
        }
        notes.push_back(std::move(note));
    }
    if (state().look().mirror) stroke.parts = on_drawn_half(stroke.parts, body, settings_only_.network.snap_cm);
    DesignStep step;
    step.name = free_line_name(network());
    step.stroke = std::move(stroke.parts);
    if (const Result<SpaceLine> line = state().drawn_line(step); line) {
        const StrokePart &first = step.stroke.front(), &last = step.stroke.back();
        const bool closed = length(line->front() - line->back()) < settings_only_.network.snap_cm;
        if (!closed) {
            step.starts_to = joined(first, first.points.front(), line->front());
            step.ends_to = joined(last, last.points.back(), line->back());
            if (step.starts_to && step.ends_to && *step.starts_to == *step.ends_to) step.ends_to.reset();
            if (settings_.to_landmarks) step = at_landmarks(std::move(step), stroke);
        }
    }
    DeskReply reply = adds ? add_between_ends(step) : act({step}, true);
    for (DeskNote& note : reply.notes)
        if (note.place == Vec3{} && !lifted.samples.empty() && lifted.samples.front().place)
            note.place = *lifted.samples.front().place;
    reply.notes.insert(reply.notes.begin(), notes.begin(), notes.end());
    return reply;
}

/// A line from edge to edge, and the region between it and the shortest way along lines there are.
DeskReply GarmentDesk::add_between_ends(const DesignStep& line) {
    DeskReply reply = act({line}, true);
    if (!reply.changed || history_.act(history_.place() - 1).size() > 1) return reply;
    const std::optional<std::vector<LineUse>> ring = ring_with_line(network(), layer(), line.name);
    if (!ring) return reply;
    DesignStep region;
    region.kind = Kind::Region;
    region.name = name_for_region(network(), *ring, state().obstacle());
    region.lines = names_of_ring(network(), layer(), *ring);
    region.alpha = settings_.alpha;
    DesignRunner next = state();
    Result<DesignStep> done = next.take(region);
    if (!done) {
        reply.notes.push_back(note_of_step(region, state(), done.error(), ring_line(network(), *ring).front()));
        return reply;
    }
    // one act with its line: the two are undone together
    std::vector<DesignStep> steps = history_.act(history_.place() - 1);
    steps.push_back(std::move(*done));
    steps.back().with_last = true;
    history_.go_to(history_.place() - 1);
    journal_.back().steps = steps;
    history_.push(std::move(steps), std::move(next));
    return reply;
}

/// Fills the outline under the pen, also one that was emptied before.
DeskReply GarmentDesk::fill_at(const DrawingView& view, Point at) {
    const NetworkFace* best = nullptr;
    SeenOutline seen_best;
    const std::vector<NetworkFace> faces = find_faces(network(), layer(), state().obstacle());
    for (const NetworkFace& face : faces) {
        const bool filled =
            std::any_of(network().regions().begin(), network().regions().end(), [&](const NetworkRegion& region) {
                return region.alive && region.layer == layer() &&
                       std::any_of(face.ring.begin(), face.ring.end(), [&](LineUse use) {
                           return std::find(region.ring.begin(), region.ring.end(), use) != region.ring.end();
                       });
            });
        const SeenOutline seen = see_outline(ring_line(network(), face.ring), view, at);
        if (filled || !face.is_cloth() || !seen.around) continue;
        if (best != nullptr &&
            std::make_pair(seen.outside, seen.depth) <= std::make_pair(seen_best.outside, seen_best.depth))
            continue;
        best = &face;
        seen_best = seen;
    }
    if (best == nullptr) return told(DeskNote::Key::NothingHere, "There is no closed outline here to fill.", {});
    DesignStep region;
    region.kind = Kind::Region;
    region.name = name_for_region(network(), best->ring, state().obstacle());
    region.lines = names_of_ring(network(), layer(), best->ring);
    region.alpha = settings_.alpha;
    return act({region});
}

}  // namespace core
