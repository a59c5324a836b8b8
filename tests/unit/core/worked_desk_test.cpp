// The worked designs drawn by the pen at the desk, against the engine's own.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/exchange/design_file.hpp"
#include "core/garment/wardrobe.hpp"
#include "support/cloth_distance.hpp"
#include "support/desk_hand.hpp"

using core::DesignStep;
using core::DeskTool;
using Kind = DesignStep::Kind;

namespace {

const core::Mannequin& woman() {
    static const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    return body;
}
const core::DressForm& form() {
    static const core::DressForm made = core::dress_form(woman());
    return made;
}

/// The strokes of a design by the pen; regions close by themselves.
core::GarmentDesk drawn_at_desk(const core::Design& design) {
    core::Design start = design;
    start.steps.clear();
    auto desk = core::GarmentDesk::open(start, form());
    REQUIRE(desk);
    support::DeskHand hand(*desk);
    desk->settings().to_landmarks = false;
    desk->settings().cuts_on_body = true;
    for (const DesignStep& step : design.steps) {
        core::DeskReply reply;
        if (step.kind == Kind::Line)
            reply = hand.replay(step.stroke, DeskTool::DrawOnBody);
        else if (step.kind == Kind::Cut || step.kind == Kind::Hole)
            reply = hand.replay(step.stroke, step.kind == Kind::Cut ? DeskTool::Cut : DeskTool::Hole);
        else if (step.kind == Kind::Layer)
            reply = desk->new_layer();
        else
            continue;
        INFO(step.name << (reply.notes.empty() ? std::string() : ": " + reply.notes[0].sentence));
        CHECK(reply.changed);
        CHECK(reply.notes.empty());
    }
    return std::move(*desk);
}

/// With sanitizers one of them: the others take a minute there.
#ifdef __SANITIZE_ADDRESS__
constexpr std::array<const char*, 1> kWorked{"trousers"};
#else
constexpr std::array<const char*, 3> kWorked{"dress", "outfit", "jacket"};
#endif

}  // namespace

TEST_CASE("worked designs drawn by the pen are the engine's", "[worked_desk]") {
    for (const char* name : kWorked) {
        DYNAMIC_SECTION(name) {
            const core::Design design = *core::wardrobe_design(name, woman());
            const auto engine = core::make_garment(design, form());
            REQUIRE(engine);
            core::GarmentDesk desk = drawn_at_desk(design);
            desk.build_now();
            REQUIRE(desk.cloth().size() == engine->layers.size());
            for (std::size_t k = 0; k < engine->layers.size(); ++k) {
                const core::Cloth &own = desk.cloth()[k].cloth->fitted, &other = engine->layers[k].fitted;
                const auto quads = [](const core::Cloth& cloth) {
                    std::multiset<std::size_t> counts;
                    for (const core::ClothPiece& piece : cloth.pieces) counts.insert(piece.count);
                    return counts;
                };
                CHECK(quads(own) == quads(other));
                const double most = support::distance_between(own.mesh, other.mesh).largest;
                WARN(name << " layer " << k + 1 << ": " << own.pieces.size() << " pieces, " << own.mesh.quads.size()
                          << " quads, surfaces at most " << most << " cm apart");
                CHECK(most <= 0.5);
            }
        }
    }
}

namespace {

core::GarmentDesk desk_on_woman() {
    core::Design design;
    design.name = "measured";
    design.body = woman().measures;
    auto desk = core::GarmentDesk::open(design, form());
    REQUIRE(desk);
    return std::move(*desk);
}

}  // namespace

TEST_CASE("the tape finds the body's measures and the length of lines", "[worked_desk]") {
    core::GarmentDesk desk = desk_on_woman();
    support::DeskHand hand(desk);
    const core::BodyFrame frame = core::body_frame(woman().measures);
    const auto girth = [&](const char* view, core::Point at) {
        const core::DeskReply reply = hand.tap(DeskTool::Tape, view, at);
        REQUIRE(reply.tape);
        CHECK(reply.tape->girth);
        CHECK_FALSE(reply.changed);
        return reply.tape->cm;
    };
    CHECK(girth("front", {2, frame.waist}) == Approx(woman().measures[core::Measure::Waist]).margin(0.5));
    CHECK(girth("back", {5, frame.hip}) == Approx(woman().measures[core::Measure::Hip]).margin(0.5));
    const core::Vec3 wrist = frame.arm_root + frame.arm_direction * frame.wrist;
    CHECK(girth("front", {wrist.x, wrist.y}) == Approx(woman().measures[core::Measure::Wrist]).margin(0.7));
    CHECK(girth("back", {wrist.x, wrist.y}) == Approx(woman().measures[core::Measure::Wrist]).margin(0.7));
    // a stroke right across the waist is the section there; one on the body a length
    const core::DeskReply across = hand.draw(DeskTool::Tape, "front", {{-25, frame.waist}, {25, frame.waist}});
    REQUIRE(across.tape);
    CHECK(across.tape->cm == Approx(woman().measures[core::Measure::Waist]).margin(0.5));
    const core::DeskReply along = hand.draw(DeskTool::Tape, "front", {{0, frame.waist}, {0, frame.waist + 10}});
    REQUIRE(along.tape);
    CHECK_FALSE(along.tape->girth);
    CHECK(along.tape->cm > 9.9);
    CHECK(along.tape->cm < 13.0);
    CHECK_FALSE(hand.tap(DeskTool::Tape, "front", {90, 20}).tape);
    CHECK(desk.design().steps.empty());
}

TEST_CASE("a drawn garment is carried to another body, and drawn on there", "[worked_desk]") {
    core::GarmentDesk desk = drawn_at_desk(*core::wardrobe_design("skirt_flat", woman()));
    desk.settings().to_landmarks = false;
    core::BodyMeasures larger = woman().measures;
    larger[core::Measure::Waist] += 8;
    larger[core::Measure::Hip] += 8;
    const core::Vec3 before = desk.network().lines()[1].shape.back();
    const core::BuildResult tried = core::build(desk.try_body(larger), {});
    CHECK(tried.trial);
    CHECK(tried.form->measures->cm == larger.cm);
    CHECK(desk.accept(tried));
    CHECK_FALSE(desk.cloth_is_current());
    REQUIRE(desk.set_body(larger).changed);
    CHECK(desk.network().lines()[1].shape.back().x != before.x);
    desk.build_now();
    CHECK(desk.cloth_faults().empty());
    CHECK(desk.cloth()[0].cloth->report.deepest_after_cm == 0.0);
    CHECK(desk.form()->measures->cm == larger.cm);
    support::DeskHand hand(desk);
    const double y = core::body_frame(larger).hip;
    REQUIRE(hand.draw(DeskTool::Cut, "front", {{0, y}, {10, y}, {22, y}}).changed);
    const std::string text = core::design_text(desk.design());
    const auto read = core::parse_design(text);
    REQUIRE(read);
    CHECK(core::design_text(*read) == text);
    // on that body the file makes the same garment
    const auto garment = core::make_garment(*read, core::dress_form(*core::make_mannequin(larger)));
    REQUIRE(garment);
    CHECK(garment->faults.empty());
    CHECK_FALSE(garment->carried);
    desk.build_now();
    CHECK(garment->layers[0].fitted.mesh.vertices == desk.cloth()[0].cloth->fitted.mesh.vertices);
    core::BodyMeasures none = larger;
    none[core::Measure::Waist] = 500;
    const core::DeskReply refused = desk.set_body(none);
    CHECK_FALSE(refused.changed);
    REQUIRE(refused.notes.size() == 1);
    CHECK(refused.notes[0].key == core::DeskNote::Key::BodyUnfit);
    CHECK_FALSE(desk.set_own_body("nobody.obj").changed);
    REQUIRE(desk.undo().changed);
    REQUIRE(desk.undo().changed);
    CHECK(desk.network().lines()[1].shape.back() == before);
}
