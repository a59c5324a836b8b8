#include "firmware_like_app/kiosk/garment_objects.hpp"

#include <catch2/catch.hpp>

#include "core/exchange/design_file.hpp"
#include "core/geometry/turn.hpp"
#include "tests/support/garment_hand.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using A = ui::GarmentAction;
using Kind = ui::WindowEvent::Kind;
using V = ui::GarmentView;
constexpr ui::SizePx kSize{1280, 800};

ui::GarmentState state(test::KioskStand& kiosk) {
    return kiosk.garment->state(kiosk.now_us);
}

const std::vector<core::PlacedObject>& objects(test::KioskStand& kiosk) {
    return kiosk.garment->desk().state().look().objects;
}

/// Draws the horse, opens the best result and puts it on the figure.
void wear_a_horse(test::KioskStand& kiosk) {
    kiosk.shell->open_sheet(kiosk.now_us);
    kiosk.wait(0.1);
    kiosk.draw_horse();
    kiosk.tap(kiosk.find->layout().cards[0]);
    kiosk.wait(0.5);
    REQUIRE(kiosk.scene() == app::Scene::Detail);
    REQUIRE(kiosk.shell->detail().state(0, kiosk.now_us).wear);
    kiosk.tap(kiosk.shell->detail().layout().wear);
    kiosk.wait(0.1);
}

void drag(test::KioskStand& kiosk, core::Point from, core::Point to) {
    kiosk.event(Kind::Down, from.x, from.y);
    for (int i = 1; i <= 5; ++i) {
        const core::Point at = from + (to - from) * (i / 5.0);
        kiosk.event(Kind::Move, at.x, at.y);
    }
    kiosk.event(Kind::Up, to.x, to.y);
    kiosk.wait(0.02);
}

}  // namespace

TEST_CASE("a result is worn: it is on the figure, chosen, in the design; its sheet waits in Find",
          "[garment objects]") {
    test::KioskStand kiosk(kSize);
    wear_a_horse(kiosk);
    CHECK(kiosk.shell->in_garment());
    REQUIRE(objects(kiosk).size() == 1);
    const ui::GarmentState s = state(kiosk);
    REQUIRE(s.rows.size() == 3);  // the object, a layer, the body
    CHECK(s.rows[0].object);
    CHECK(s.rows[0].selected);
    CHECK(s.object);
    CHECK(s.can_undo);
    CHECK_FALSE(s.empty);
    CHECK(core::design_text(kiosk.garment->design()).find("\"place\"") != std::string::npos);
    CHECK_FALSE(kiosk.find->sketch().empty());
    kiosk.shell->open_garment(false, kiosk.now_us);
    kiosk.wait(0.1);
    CHECK(kiosk.scene() == app::Scene::Work);  // the drawing, not the result
}

TEST_CASE("an object is moved, scaled and turned by its handles, each one act", "[garment objects]") {
    test::KioskStand kiosk(kSize);
    wear_a_horse(kiosk);
    const core::PlacedObject before = objects(kiosk)[0];
    const double scale_px = kiosk.garment->views().camera().scale_px;
    ui::ObjectHandles h = *state(kiosk).object;
    const core::Point middle{h.box.centre_x(), h.box.centre_y()};
    drag(kiosk, middle, middle + core::Point{-60, -40});
    const core::PlacedObject moved = objects(kiosk)[0];
    CHECK(moved.at.x - before.at.x == Approx(-60 / scale_px));
    CHECK(moved.at.y - before.at.y == Approx(40 / scale_px));
    CHECK(moved.at.z == before.at.z);
    CHECK(moved.scale == before.scale);

    h = *state(kiosk).object;
    const core::Point centre = kiosk.garment->views().camera().to_px(moved.at);
    drag(kiosk, h.scale, centre + (h.scale - centre) * 1.5);
    CHECK(objects(kiosk)[0].scale / moved.scale == Approx(1.5).epsilon(0.01));
    CHECK(objects(kiosk)[0].at == moved.at);

    h = *state(kiosk).object;
    const core::Point arm = h.turn - centre;
    drag(kiosk, h.turn, centre + core::Point{arm.y, -arm.x});  // a quarter turn against the clock
    const core::Vec3 x = core::turned({1, 0, 0}, objects(kiosk)[0].turn), was = core::turned({1, 0, 0}, moved.turn);
    CHECK(x.x == Approx(-was.y).margin(1e-3));  // pointers are whole 64ths of a pixel
    CHECK(x.y == Approx(was.x).margin(1e-3));
    CHECK(kiosk.garment->desk().history().size() == 4);

    kiosk.tap(kiosk.garment->layout().undo);
    kiosk.tap(kiosk.garment->layout().undo);
    CHECK(objects(kiosk)[0] == moved);
    test::GarmentHand hand(kiosk);
    hand.view(V::Side);
    const core::Point side{state(kiosk).object->box.centre_x(), state(kiosk).object->box.centre_y()};
    drag(kiosk, side, side + core::Point{30, 0});
    CHECK(objects(kiosk)[0].at.x == Approx(moved.at.x));
    CHECK_FALSE(objects(kiosk)[0].at.z == moved.at.z);
}

TEST_CASE("handles stay within reach of the pen wherever the object is", "[garment objects]") {
    test::KioskStand kiosk(kSize);
    wear_a_horse(kiosk);
    const ui::Rect sheet = kiosk.garment->layout().sheet;
    for (const core::Vec3 at : {core::Vec3{300, 90, 0}, core::Vec3{-300, 500, 0}, core::Vec3{0, -200, 0}}) {
        core::PlacedObject far = objects(kiosk)[0];
        far.at = at;
        kiosk.garment->place(far, kiosk.now_us);
        const ui::ObjectHandles h = *state(kiosk).object;
        for (const core::Point p : {h.turn, h.scale, core::Point{h.box.x, h.box.y}}) CHECK(sheet.contains(p.x, p.y));
        CHECK(core::distance(h.turn, h.scale) > 30);
    }
    CHECK(objects(kiosk).size() == 1);
}

TEST_CASE("an object is let go beside it, chosen again by a tap or its row, and taken off", "[garment objects]") {
    test::KioskStand kiosk(kSize);
    wear_a_horse(kiosk);
    test::GarmentHand hand(kiosk);
    const ui::Rect box = state(kiosk).object->box;
    hand.tap({0, 120});  // on the body, not on the object
    CHECK_FALSE(state(kiosk).object);
    kiosk.tap(box.centre_x(), box.centre_y());
    CHECK(state(kiosk).object);
    hand.press(A::Row, 0);
    CHECK_FALSE(state(kiosk).object);
    hand.press(A::Row, 0);
    CHECK(state(kiosk).object);
    hand.tool(ui::GarmentTool::OnPlane);
    CHECK_FALSE(state(kiosk).object);
    hand.press(A::Unplace, 0);
    CHECK(objects(kiosk).empty());
    CHECK(state(kiosk).rows.size() == 2);
    kiosk.tap(kiosk.garment->layout().undo);
    CHECK(objects(kiosk).size() == 1);
    // rows of layers are counted below it
    hand.press(A::AddLayer);
    CHECK(state(kiosk).rows.size() == 4);
    CHECK(state(kiosk).rows[1].selected);
    hand.press(A::Row, 2);
    CHECK(state(kiosk).rows[2].selected);
}

TEST_CASE("a wipe takes objects along, and a model that is gone is said", "[garment objects]") {
    app::GarmentOptions options;
    options.model_source = [](const std::string& model) -> core::Result<core::TriangleMesh> {
        return core::unexpected(core::ErrorCode::FileMissing, "the model \"" + model + "\" is not in the collection");
    };
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, options);
    wear_a_horse(kiosk);
    const core::Design design = kiosk.garment->design();
    const core::RgbaImage worn = kiosk.picture();
    kiosk.garment->wipe(0, ui::Hand::Right);
    kiosk.garment->settle(kiosk.now_us);
    CHECK(objects(kiosk).empty());
    CHECK(state(kiosk).problem.empty());
    REQUIRE(kiosk.garment->open(design));
    kiosk.garment->settle(kiosk.now_us);
    CHECK(state(kiosk).problem.find("is not in the collection") != std::string::npos);
    CHECK(objects(kiosk).size() == 1);  // it stays in the design
    test::GarmentHand(kiosk).press(A::Row, 0);
    CHECK_FALSE(state(kiosk).object);  // nothing to take hold of
    const bool same = kiosk.picture().pixels == worn.pixels;
    CHECK_FALSE(same);
}

TEST_CASE("what was worn and moved is recorded and drawn again", "[garment objects]") {
    const support::TemporaryFolder folder;
    std::string drawn;
    core::RgbaImage seen;
    std::shared_ptr<const core::TriangleMesh> mesh;
    {
        test::KioskStand kiosk(kSize, {}, {}, folder.path(""));
        wear_a_horse(kiosk);
        for (const app::FoundModel& found : kiosk.find->ranking()->answer.best)
            if (found.name == objects(kiosk)[0].model) mesh = found.mesh;
        const ui::Rect box = state(kiosk).object->box;
        drag(kiosk, {box.centre_x(), box.centre_y()}, {box.centre_x() - 50, box.centre_y() - 30});
        drawn = core::design_text(kiosk.garment->design());
        seen = kiosk.picture();
        kiosk.garment->wipe(0, ui::Hand::Right);
    }
    REQUIRE(mesh);
    const core::Result<input::Trace> trace = input::read_trace(folder.path("garment-0001.trace"));
    REQUIRE(trace);
    const core::Result<app::GarmentReplay> replay = app::garment_replay(*trace, "worn");
    REQUIRE(replay);
    REQUIRE(replay->placed.size() == 1);
    CHECK(replay->placed[0].before == 0);
    app::GarmentOptions options;
    options.model_source = [&](const std::string&) { return core::Result<core::TriangleMesh>(*mesh); };
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, options);
    test::play(kiosk, *replay);
    CHECK(core::design_text(kiosk.garment->design()) == drawn);
    const bool same = kiosk.picture().pixels == seen.pixels;
    CHECK(same);
}
