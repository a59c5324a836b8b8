// The pen at the garment desk: strokes become steps of the design.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/garment/desk/desk_notes.hpp"
#include "core/garment/desk/garment_desk.hpp"
#include "core/garment/desk/network_paths.hpp"
#include "core/garment/desk/pick.hpp"
#include "core/garment/desk/region_names.hpp"
#include "core/garment/desk/tape.hpp"
#include "core/mannequin/body_shape.hpp"

namespace core {
namespace {

using Kind = DesignStep::Kind;
using ToolKind = DrawingTool::Kind;

constexpr double kLeastStep_cm = 0.05;  // between samples of a stroke
// How far in depth an end is put to a vertex or a line that the pen met. A plane was chosen for its depth.
constexpr double kJoinVertex_cm = 20.0, kJoinLine_cm = 10.0, kJoinFromPlane_cm = 6.0;
constexpr double kHidden_cm = 2.0;  // this far behind the body and more nothing is met
constexpr double kTap_cm = 0.6;     // a stroke shorter than this is a tap
constexpr double kTapeStroke_cm = 3.0;
constexpr double kRayReach_cm = 800.0;

/// The view as a design file gives it back, bit for bit, and what its points are shifted by.
struct SettledView {
    DrawingView view;
    Point shift;
};

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

/// The axis that a view looks along: 0 x, 1 y, 2 z.
int axis_of(const DrawingView& view) {
    const std::array<double, 3> along{std::abs(view.toward.x), std::abs(view.toward.y), std::abs(view.toward.z)};
    int axis = 2;
    for (int k : {0, 1})
        if (along[static_cast<std::size_t>(k)] > along[static_cast<std::size_t>(axis)]) axis = k;
    return axis;
}

double coordinate(Vec3 p, int axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

DrawingTool plane_tool(int axis, double at) {
    return {axis == 0 ? ToolKind::PlaneYZ : axis == 1 ? ToolKind::PlaneXZ : ToolKind::PlaneXY, at};
}

bool takes_stroke(DeskTool tool) {
    return draws_line(tool) || tool == DeskTool::Cut || tool == DeskTool::Hole || tool == DeskTool::Tape;
}

/// Where the pen is on the plane through a place that faces the view.
Vec3 facing_place(const DrawingView& view, Point at, Vec3 through) {
    const DrawingView::Ray ray = view.ray(at);
    const double along = dot(through - ray.origin, view.toward) / dot(ray.direction, view.toward);
    return ray.origin + ray.direction * along;
}

DeskReply told(const char* key, const char* sentence, Vec3 place, std::string name = {}) {
    DeskReply reply;
    reply.notes.push_back({key, sentence, place, std::move(name), 0.0});
    return reply;
}

}  // namespace

// ---- while the stroke is open

void GarmentDesk::begin(const DrawingView& view, Point at) {
    if (!open_ || !open_->lifted) {
        cancel();
        open_.emplace();
        preview_ = {};
    }
    const bool first = open_->parts.empty() && open_->grabbed.kind == Pick::Kind::None;
    open_->lifted = false;
    const SettledView real = settled(view);
    at = at + real.shift;
    if (first) {
        open_->view = real.view;
        open_->first = at;
    }
    open_->last = at;
    preview_.tool = settings_.tool;
    preview_.cut = settings_.tool == DeskTool::Cut || settings_.tool == DeskTool::Hole;
    if (takes_stroke(settings_.tool)) {
        begin_part(real.view, at);
        add_sample(at);
        preview_stroke();
        return;
    }
    if (!first) return;
    Pick vertex = pick_vertex(network(), layer(), real.view, at, settings_.reach_cm);
    const bool of_line = settings_.tool == DeskTool::Smooth || settings_.tool == DeskTool::Bump;
    if (of_line || (settings_.tool == DeskTool::Move && vertex.kind == Pick::Kind::None))
        vertex = pick_line(network(), layer(), real.view, at, settings_.reach_cm);
    open_->grabbed = std::move(vertex);
    open_->to = open_->grabbed.place;
}

void GarmentDesk::extend(const DrawingView& view, Point at) {
    if (!open_ || open_->lifted) return;
    const SettledView real = settled(view);
    at = at + real.shift;
    open_->last = at;
    if (takes_stroke(settings_.tool)) {
        const bool changed = open_->parts.empty() || open_->tools.back() != settings_.tool ||
                             !same_view(open_->parts.back().view, real.view);
        if (changed) begin_part(real.view, at);
        add_sample(at);
        preview_stroke();
    } else if (settings_.tool == DeskTool::Move && open_->grabbed.kind != Pick::Kind::None) {
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
    if (settings_.tool == DeskTool::DrawTemporary && stroke.lifter->line().empty()) add_anchor(view, at);
    const DrawingTool tool = lifting_tool(view, at);
    stroke.parts.push_back({view, tool, {}});
    stroke.tools.push_back(settings_.tool);
    stroke.lifter->begin_part(view, tool);
    const int axis = axis_of(view);
    preview_.plane.reset();
    if (tool.kind == ToolKind::Temporary) {
        if (const std::optional<Vec3> anchor = stroke.lifter->anchor(); anchor)
            preview_.plane = StrokePreview::Plane{*anchor, view.right, view.toward * -1.0};
    } else if (settings_.tool == DeskTool::DrawOnPlane) {
        const Vec3 normal = axis == 0 ? Vec3{1, 0, 0} : axis == 1 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
        const Vec3 right = axis == 0 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, up = axis == 1 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
        preview_.plane = StrokePreview::Plane{normal * tool.offset, right, up};
    }
}

DrawingTool GarmentDesk::lifting_tool(const DrawingView& view, Point at) const {
    switch (settings_.tool) {
        case DeskTool::DrawTemporary:
            return {ToolKind::Temporary, 0.0};
        case DeskTool::DrawOnPlane: {
            const int axis = axis_of(view);
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
    const int axis = axis_of(view);
    const StrokePart anchor{view, plane_tool(axis, coordinate(vertex.place, axis)), {view.project(vertex.place)}};
    open_->parts.push_back(anchor);
    open_->tools.push_back(DeskTool::DrawOnPlane);
    open_->lifter->begin_part(view, anchor.tool);
    (void)open_->lifter->add(anchor.points.front());
}

void GarmentDesk::add_sample(Point at) {
    StrokePart& part = open_->parts.back();
    if (!part.points.empty() && distance(part.points.back(), at) < kLeastStep_cm) return;
    part.points.push_back(at);
    (void)open_->lifter->add(at);  // what cannot be lifted is told when the stroke ends
}

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

void GarmentDesk::preview_stroke() {
    const OpenStroke& stroke = *open_;
    preview_.line = stroke.lifter->line();
    if (preview_.line.empty() || !draws_line(settings_.tool)) return;
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
                                     ? plane_tool(axis_of(real.view), settings_.plane_cm.value_or(0.0))
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
    if (!moved.move(stroke.grabbed.place, stroke.to, settings_.move_radius_cm)) return;
    live_shown_ = live_ && live_->follow(moved);
    stroke.dragged = std::move(moved);
    preview_.line = {stroke.grabbed.place, stroke.to};
}

// ---- when it ends

DeskReply GarmentDesk::end() {
    if (!open_) return {};
    OpenStroke stroke = std::move(*open_);
    open_.reset();
    preview_ = {};
    const DeskTool tool = stroke.tools.empty() ? settings_.tool : stroke.tools.front();
    switch (tool) {
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
            return end_tap(stroke, tool);
    }
    return {};
}

/// A stroke sample by sample, with where each lies; what cannot be lifted is marked.
struct GarmentDesk::LiftedStroke {
    struct Sample {
        std::size_t part;
        Point drawn;
        std::optional<Vec3> place;
    };
    std::vector<Sample> samples;
    std::optional<Error> fault;  ///< of the first that cannot be lifted
    Vec3 fault_place;            ///< the last place before it

    LiftedStroke(const SketchStroke& stroke, const Obstacle& body, const QuadMesh* piece) {
        StrokeLifter lifter(body, piece);
        for (std::size_t k = 0; k < stroke.size(); ++k) {
            lifter.begin_part(stroke[k].view, stroke[k].tool);
            for (const Point at : stroke[k].points) {
                const std::size_t before = lifter.line().size();
                const Result<void> done = lifter.add(at);
                if (!done && !fault) {
                    fault = done.error();
                    if (!lifter.line().empty()) fault_place = lifter.line().back();
                }
                const bool lies = done && !lifter.line().empty() && (lifter.line().size() > before || before > 0);
                samples.push_back({k, at, lies ? std::optional<Vec3>(lifter.line().back()) : std::nullopt});
            }
        }
    }

    /// The parts with these samples alone.
    [[nodiscard]] SketchStroke stroke(const SketchStroke& like, std::size_t first, std::size_t end) const {
        SketchStroke out;
        std::size_t part = ~std::size_t{0};
        for (std::size_t k = first; k < end; ++k) {
            if (samples[k].part != part) {
                part = samples[k].part;
                out.push_back({like[part].view, like[part].tool, {}});
            }
            out.back().points.push_back(samples[k].drawn);
        }
        return out;
    }

    /// The longest run of samples for which `kept` holds: [first, end).
    template <typename Test>
    [[nodiscard]] std::pair<std::size_t, std::size_t> longest(const Test& kept) const {
        std::pair<std::size_t, std::size_t> best{0, 0};
        for (std::size_t k = 0; k < samples.size();) {
            std::size_t end = k;
            while (end < samples.size() && kept(samples[end])) ++end;
            if (end - k > best.second - best.first) best = {k, end};
            k = std::max(end, k + 1);
        }
        return best;
    }
};

namespace {

/// What is drawn beyond x = 0 is the image of the drawn half; a stroke across the middle keeps its longer side, up to
/// the middle itself.
template <typename Lifted>
SketchStroke on_drawn_half(const SketchStroke& stroke, const Obstacle& body, const QuadMesh* piece, double snap_cm) {
    SketchStroke own = stroke;
    Lifted lifted(own, body, piece);
    std::size_t beyond = 0, here = 0;
    for (const auto& sample : lifted.samples) {
        if (!sample.place) continue;
        beyond += sample.place->x < -0.5 * snap_cm ? 1U : 0U;
        here += sample.place->x > 0.5 * snap_cm ? 1U : 0U;
    }
    if (beyond == 0) return own;
    if (beyond > here) {
        for (StrokePart& part : own) part = mirrored_part(std::move(part));
        lifted = Lifted(own, body, piece);
    }
    const auto [first, end] = lifted.longest([](const auto& sample) { return sample.place && sample.place->x >= 0.0; });
    SketchStroke out = lifted.stroke(own, first, end);
    if (out.empty()) return own;
    const auto crossing = [&](const auto& inside, const auto& outside) -> std::optional<Point> {
        if (!outside.place || outside.part != inside.part) return std::nullopt;
        const double t = inside.place->x / (inside.place->x - outside.place->x);
        return inside.drawn + (outside.drawn - inside.drawn) * t;
    };
    if (first > 0)
        if (const auto at = crossing(lifted.samples[first], lifted.samples[first - 1]); at)
            out.front().points.insert(out.front().points.begin(), *at);
    if (end < lifted.samples.size())
        if (const auto at = crossing(lifted.samples[end - 1], lifted.samples[end]); at)
            out.back().points.push_back(*at);
    return out;
}

}  // namespace

/// A new line, and the regions that it closes. What leaves the body stays as far as it lay on it; a stroke wholly
/// beside it lies in the plane of its view.
DeskReply GarmentDesk::end_line(OpenStroke stroke) {
    std::vector<DeskNote> notes;
    const Obstacle& body = state().obstacle();
    const bool adds = stroke.tools.front() == DeskTool::Add;
    LiftedStroke lifted(stroke.parts, body, nullptr);
    if (lifted.fault) {
        const auto [first, end] = lifted.longest([](const LiftedStroke::Sample& s) { return s.place.has_value(); });
        DeskNote note = note_of(*lifted.fault, lifted.fault_place);
        if (end - first >= 2) {
            if (note.key == "off_body") note.sentence = "The line left the body here: what lay on it stays.";
            stroke.parts = lifted.stroke(stroke.parts, first, end);
        } else if (note.key == "off_body") {
            note.sentence = "This line passes the body: it lies in the plane of the view.";
            for (StrokePart& part : stroke.parts) part.tool = plane_tool(axis_of(part.view), 0.0);
        } else {
            return {false, {std::move(note)}, {}, {}};
        }
        notes.push_back(std::move(note));
    }
    if (state().look().mirror)
        stroke.parts = on_drawn_half<LiftedStroke>(stroke.parts, body, nullptr, settings_only_.network.snap_cm);
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
            if (settings_.to_landmarks) step = state().snapped(std::move(step));
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
        reply.notes.push_back(note_of(done.error(), ring_line(network(), *ring).front()));
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
    if (best == nullptr) return told("nothing_here", "There is no closed outline here to fill.", {});
    DesignStep region;
    region.kind = Kind::Region;
    region.name = name_for_region(network(), best->ring, state().obstacle());
    region.lines = names_of_ring(network(), layer(), best->ring);
    region.alpha = settings_.alpha;
    return act({region});
}

DeskReply GarmentDesk::end_cut(OpenStroke stroke, Kind kind) {
    SketchStroke& parts = stroke.parts;
    if (parts.empty() || parts.front().points.empty()) return {};
    const bool mirror = state().look().mirror;
    // the piece under the middle of the stroke
    const StrokePart& middle = parts[parts.size() / 2];
    const Point at = middle.points[middle.points.size() / 2];
    const Pick region = pick_region(network(), layer(), middle.view, at, mirror);
    if (region.kind == Pick::Kind::None)
        return told("no_region", "There is no piece here: begin and end the line at the edges of one.",
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
        return told("nothing_here", "There is no vertex under the pen to move.", {});
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
    if (stroke.grabbed.kind != Pick::Kind::Line) return told("nothing_here", "There is no line under the pen.", {});
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
        return told("nothing_here", "Draw from one vertex to another to join them.", stroke.grabbed.place);
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
        if (of == nullptr) return told("nothing_here", "There is no edge of a piece here.", {});
        step.kind = Kind::Corner;
        step.region = of->name;
        step.at = vertex.kind == Pick::Kind::Vertex ? vertex.place : line.place;
        step.on = vertex.kind != Pick::Kind::Vertex || of->corners.count(vertex.index) == 0;
        return act({step});
    }
    if (region.kind == Pick::Kind::None)
        return told("nothing_here", "There is nothing of this layer under the pen.", {});
    step.kind = Kind::Remove;
    step.region = region.name;
    return act({step});
}

// ---- the tape

/// Level round what the pen points at, across the arm at an arm; cloth where it is in front.
TapeReading GarmentDesk::girth_at(const DrawingView& view, Point at) const {
    const DrawingView::Ray ray = view.ray(at);
    const WornForm& worn = *state().worn();
    std::optional<Vec3> place = worn.obstacle.first_hit(ray.origin, ray.direction, 0.0, kRayReach_cm);
    const QuadMesh* mesh = &worn.obstacle.surfaces().front();
    for (const BuiltLayer& layer : cloth_) {
        const DesignLook::Layer& look = state().look().layers[static_cast<std::size_t>(layer.layer)];
        const std::optional<Vec3> on = look.shown ? first_on_mesh(layer.cloth->fitted.mesh, ray) : std::nullopt;
        if (!on || (place && view.depth(*on) <= view.depth(*place))) continue;
        place = on;
        mesh = &layer.cloth->fitted.mesh;
    }
    if (!place) return {};
    CutPlane plane{*place, {1, 0, 0}, {0, 0, -1}};
    const std::optional<PartPlace> part =
        worn.obstacle.parts().empty() ? std::nullopt : worn.obstacle.parts().nearest(*place, ~PartSet{0}, 30.0);
    if (part && worn.form.measures && (part->part == BodyPart::ArmLeft || part->part == BodyPart::ArmRight)) {
        Vec3 along = body_frame(*worn.form.measures).arm_direction;
        if (part->part == BodyPart::ArmRight) along.x = -along.x;
        plane.right = normalised(cross(along, {0, 0, 1}));
        plane.up = cross(along, plane.right);
    }
    plane.origin = plane.origin - worn.obstacle.sample(*place).gradient * 2.0;
    return girth_of(*mesh, plane);
}

DeskReply GarmentDesk::end_tape(const OpenStroke& stroke) {
    DeskReply reply;
    if (distance(stroke.first, stroke.last) < kTapeStroke_cm && stroke.lifter->line().size() < 8) {
        reply.tape = girth_at(stroke.view, stroke.first);
    } else {
        const Obstacle& body = state().worn()->obstacle;
        const auto beside = [&](Point at) {
            const DrawingView::Ray ray = stroke.view.ray(at);
            return !body.first_hit(ray.origin, ray.direction, 0.0, kRayReach_cm);
        };
        const Pick from = pick_line(network(), layer(), stroke.view, stroke.first, settings_.reach_cm),
                   to = pick_line(network(), layer(), stroke.view, stroke.last, settings_.reach_cm);
        if (from.kind == Pick::Kind::Line && from.index == to.index) {
            const SpaceLine& shape = network().lines()[static_cast<std::size_t>(from.index)].shape;
            reply.tape = length_of(stretch_between(shape, from.place, to.place));
        } else if (beside(stroke.first) && beside(stroke.last)) {  // right across: around the section
            const Point middle = midpoint(stroke.first, stroke.last);
            const DrawingView::Ray ray = stroke.view.ray(middle);
            const Vec3 right = normalised(stroke.view.right * (stroke.last.x - stroke.first.x) +
                                          stroke.view.up * (stroke.last.y - stroke.first.y));
            reply.tape = girth_of(body.surfaces().front(), {body.nearest_pass(ray.origin, ray.direction, kRayReach_cm),
                                                            right, stroke.view.toward});
        } else {
            reply.tape = length_of(stroke.lifter->line());
        }
    }
    if (reply.tape->tape.empty()) {
        reply.tape.reset();
        reply.notes.push_back({"nothing_here", "There is nothing here to measure.", {}, {}, 0.0});
    }
    return reply;
}

}  // namespace core
