#include "core/garment/desk/desk_notes.hpp"

namespace core {
namespace {

using Key = DeskNote::Key;
using Kind = DesignStep::Kind;

Key key_of(const DesignStep& step, const DesignRunner& state) {
    switch (step.kind) {
        case Kind::Line:
        case Kind::Smooth:
        case Kind::Bump:
            return Key::TooShort;
        case Kind::Cut:
        case Kind::Hole:
            if (state.network().find_region(step.region) == nullptr) return Key::NoRegion;
            if (step.kind == Kind::Hole || !state.drawn_line(step)) return Key::TooShort;
            return Key::NotAcross;
        case Kind::Region:
            return Key::NotFilled;
        case Kind::Remove:
        case Kind::Move:
        case Kind::Weld:
        case Kind::Erase:
        case Kind::Join:
        case Kind::Meet:
            return Key::NothingHere;
        case Kind::Body:
            return Key::BodyUnfit;
        default:
            return Key::Refused;
    }
}

}  // namespace

DeskNote note_of_lift(const StrokePart& part, const Error& error, Vec3 place) {
    const Key key = part.tool.kind == DrawingTool::Kind::Body        ? Key::OffBody
                    : part.tool.kind == DrawingTool::Kind::Temporary ? Key::NoPoint
                                                                     : Key::PlaneEdgeOn;
    return {key, error.message, place, {}, 0.0};
}

DeskNote note_of_step(const DesignStep& step, const DesignRunner& state, const Error& error, Vec3 place) {
    return {key_of(step, state), error.message, place, {}, 0.0};
}

DeskReply told(DeskNote::Key key, const char* sentence, Vec3 place) {
    DeskReply reply;
    reply.notes.push_back({key, sentence, place, {}, 0.0});
    return reply;
}

}  // namespace core
