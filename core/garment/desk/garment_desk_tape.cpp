// The tape in the hand: girths where it taps, lengths along what it draws.

#include "core/garment/desk/desk_notes.hpp"
#include "core/garment/desk/garment_desk.hpp"
#include "core/garment/desk/network_paths.hpp"
#include "core/garment/desk/pen_places.hpp"
#include "core/garment/desk/pick.hpp"
#include "core/garment/desk/tape.hpp"
#include "core/mannequin/body_shape.hpp"

namespace core {
namespace {

constexpr double kTapeStroke_cm = 3.0;  // a shorter one is a tap

}  // namespace

/// Level round what the pen points at, across the arm at an arm; cloth where it is in front.
TapeReading GarmentDesk::girth_at(const DrawingView& view, Point at) const {
    const DrawingView::Ray ray = view.ray(at);
    const WornForm& worn = *state().worn();
    std::optional<Vec3> place = worn.obstacle.first_hit(ray.origin, ray.direction, 0.0, kRayReach_cm);
    const QuadMesh* mesh = &worn.obstacle.surfaces().front();
    for (const BuiltLayer& layer : cloth_) {
        const std::vector<DesignLook::Layer>& looks = state().look().layers;
        const auto number = static_cast<std::size_t>(layer.layer);  // cloth may be of a layer that was undone
        const std::optional<Vec3> on =
            number < looks.size() && looks[number].shown ? first_on_mesh(layer.cloth->fitted.mesh, ray) : std::nullopt;
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
        reply.notes.push_back({DeskNote::Key::NothingHere, "There is nothing here to measure.", {}, {}, 0.0});
    }
    return reply;
}

}  // namespace core
