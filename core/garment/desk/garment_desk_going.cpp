// Lines that go on from stroke to stroke: each stroke of the pen draws the whole line anew, in place of the act before.

#include <limits>
#include <utility>

#include "core/garment/desk/garment_desk.hpp"
#include "core/garment/desk/pen_places.hpp"
#include "core/garment/desk/pick.hpp"

namespace core {
namespace {

using Kind = DesignStep::Kind;
using ToolKind = DrawingTool::Kind;

DeskTool hand_of(const StrokePart& part) {
    return part.tool.kind == ToolKind::Body        ? DeskTool::DrawOnBody
           : part.tool.kind == ToolKind::Temporary ? DeskTool::DrawTemporary
                                                   : DeskTool::DrawOnPlane;
}

/// A single point of a stroke at a place: in the plane through it that faces the view.
StrokePart point_at(const DrawingView& view, Vec3 place) {
    const int axis = axis_toward(view);
    return {view, plane_tool(axis, coordinate(place, axis)), {view.project(place)}};
}

/// The vertex that a line has at the end that was drawn last.
Vec3 end_of(const Network& network, const std::string& name, const SpaceLine& drawn) {
    Vec3 end = drawn.back();
    double least = std::numeric_limits<double>::max();
    for (const NetworkLine& piece : network.lines()) {
        if (!piece.alive || piece.name != name) continue;
        for (const Vec3& p : {piece.shape.front(), piece.shape.back()})
            if (const double away = length(p - drawn.back()); away < least) least = away, end = p;
    }
    return end;
}

}  // namespace

bool GarmentDesk::go_on(const DrawingView& view, Point at) {
    cancel();
    const SettledView real = settled(view);
    const Pick vertex = pick_vertex(network(), layer(), real.view, at + real.shift, settings_.reach_cm);
    if (vertex.kind == Pick::Kind::None) return false;
    going_ = last_line_from(vertex.index);
    if (going_) return true;
    going_.emplace();
    going_->parts = {point_at(real.view, vertex.place)};
    going_->hands = {{DeskTool::DrawOnPlane, true}};
    going_->strokes = {1};
    going_->place = history_.place();
    going_->from = going_->end = vertex.place;
    return true;
}

/// The line of the last act, if that did nothing else and this is its loose end.
std::optional<LineGoingOn> GarmentDesk::last_line_from(int vertex) const {
    if (history_.place() == 0) return std::nullopt;
    const std::vector<DesignStep>& act = history_.act(history_.place() - 1);
    if (act.size() != 1 || act.front().kind != Kind::Line) return std::nullopt;
    const DesignStep& step = act.front();
    int ends = 0;
    bool own = false;
    for (const NetworkLine& line : network().lines()) {
        if (!line.alive) continue;
        ends += (line.from == vertex ? 1 : 0) + (line.to == vertex ? 1 : 0);
        own = own || (line.to == vertex && line.name == step.name);
    }
    if (ends != 1 || !own) return std::nullopt;
    LineGoingOn line;
    line.parts = step.stroke;
    for (const StrokePart& part : step.stroke) line.hands.push_back({hand_of(part), step.starts_at.empty()});
    line.strokes = {line.parts.size()};
    line.name = step.name;
    line.place = history_.place() - 1;
    line.end = network().vertices()[static_cast<std::size_t>(vertex)].place;
    return line;
}

void GarmentDesk::finish_line() {
    going_.reset();
}

/// The stroke that begins goes on with what there is of the line.
void GarmentDesk::resume() {
    if (!going_) return;
    open_->parts = going_->parts;
    open_->hands = going_->hands;
    open_->lifter = std::make_unique<StrokeLifter>(state().obstacle());
    for (const StrokePart& part : open_->parts) {
        open_->lifter->begin_part(part.view, part.tool);
        for (const Point at : part.points) (void)open_->lifter->add(at);
    }
}

DeskReply GarmentDesk::lengthen(OpenStroke stroke) {
    LineGoingOn line = *going_;
    line.parts = std::move(stroke.parts);
    line.hands = std::move(stroke.hands);
    line.strokes.push_back(line.parts.size());
    return draw_anew(std::move(line));
}

/// The line in place of what there was of it; where that fails all stays as it was.
DeskReply GarmentDesk::draw_anew(LineGoingOn line) {
    const std::optional<LineGoingOn> before = std::exchange(going_, std::nullopt);
    const std::size_t was = history_.place();
    if (was != line.place) (void)go_to(line.place);
    OpenStroke whole;
    whole.tool = line.hands.front().tool;
    whole.parts = line.parts;
    whole.hands = line.hands;
    DeskReply reply = end_line(std::move(whole));
    if (!reply.changed) {
        if (was != history_.place()) (void)go_to(was);
        going_ = before;
        return reply;
    }
    const DesignStep& step = history_.act(line.place).front();
    line.name = step.name;
    if (const Result<SpaceLine> drawn = state().drawn_line(step); drawn)
        line.end = end_of(network(), step.name, *drawn);
    going_ = std::move(line);
    return reply;
}

/// The last stroke of the line that goes on; where there is none of it yet the line does not go on any more.
DeskReply GarmentDesk::take_back_stroke() {
    cancel();
    LineGoingOn line = *going_;
    if (line.strokes.size() < 2) {
        finish_line();
        return {};
    }
    line.strokes.pop_back();
    line.parts.resize(line.strokes.back());
    line.hands.resize(line.strokes.back());
    if (line.parts.size() > 1 || line.parts.front().points.size() > 1) return draw_anew(std::move(line));
    DeskReply reply = go_to(line.place);
    line.name.clear();
    line.end = line.from;
    going_ = std::move(line);
    return reply;
}

DeskReply GarmentDesk::end_tapped() {
    if (!open_ || !going_) return end();
    OpenStroke stroke = std::move(*open_);
    cancel();
    const DrawingView view = stroke.parts.back().view;
    const Pick vertex = pick_vertex(network(), layer(), view, stroke.last, settings_.reach_cm);
    if (vertex.kind == Pick::Kind::None) return lengthen(std::move(stroke));
    if (vertex.place == going_->end) {
        finish_line();
        return {};
    }
    stroke.parts.back() = point_at(view, vertex.place);
    stroke.hands.back() = {DeskTool::DrawOnPlane, true};
    DeskReply reply = lengthen(std::move(stroke));
    if (reply.changed) finish_line();
    return reply;
}

}  // namespace core
