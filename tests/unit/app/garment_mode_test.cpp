#include "firmware_like_app/kiosk/garment_mode.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <new>
#include <semaphore>

#include "core/exchange/design_file.hpp"
#include "tests/support/garment_hand.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using A = ui::GarmentAction;
using T = ui::GarmentTool;
using V = ui::GarmentView;
constexpr ui::SizePx kSize{1280, 800};

std::size_t pieces(test::KioskStand& kiosk) {
    std::size_t count = 0;
    for (const core::NetworkRegion& region : kiosk.garment->desk().network().regions()) count += region.alive ? 1 : 0;
    return count;
}

std::size_t quads(test::KioskStand& kiosk) {
    kiosk.garment->settle(kiosk.now_us);
    std::size_t count = 0;
    for (const core::BuiltLayer& layer : kiosk.garment->desk().cloth()) count += layer.cloth->fitted.mesh.quads.size();
    return count;
}

ui::GarmentState state(test::KioskStand& kiosk) {
    return kiosk.garment->state(kiosk.now_us);
}

}  // namespace

TEST_CASE("a skirt is drawn, filled, undone to the empty figure and drawn again", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    CHECK(state(kiosk).empty);
    hand.skirt();
    CHECK(pieces(kiosk) == 2);
    CHECK(quads(kiosk) > 50);
    CHECK(state(kiosk).folds_on);
    const std::string drawn = core::design_text(kiosk.garment->design());
    const ui::Rect undo = kiosk.garment->layout().undo, redo = kiosk.garment->layout().redo;
    int undone = 0;
    for (; state(kiosk).can_undo; ++undone) kiosk.tap(undo);
    CHECK(undone >= 4);
    CHECK(state(kiosk).empty);
    CHECK(quads(kiosk) == 0);
    while (state(kiosk).can_redo) kiosk.tap(redo);
    CHECK(core::design_text(kiosk.garment->design()) == drawn);
    CHECK(quads(kiosk) > 50);
}

TEST_CASE("what is recorded draws the same design again, pictures too", "[garment mode]") {
    const support::TemporaryFolder folder;
    std::string drawn;
    core::RgbaImage seen;
    {
        test::KioskStand kiosk(kSize, {}, {}, folder.path(""));
        test::GarmentHand hand(kiosk);
        hand.enter();
        hand.skirt();
        hand.view(V::Solid);
        hand.slide(kiosk.garment->layout().slider, 0.7);
        kiosk.stroke(1200, 300, 1230, 330);  // beside the figure: turns it
        drawn = core::design_text(kiosk.garment->design());
        seen = kiosk.picture();
        kiosk.garment->wipe(0, ui::Hand::Right);  // the visitor goes: the trace is closed
    }
    const std::filesystem::path file = folder.path("garment-0001.trace");
    const core::Result<input::Trace> trace = input::read_trace(file.string());
    REQUIRE(trace);
    REQUIRE(app::is_garment_trace(*trace));
    const core::Result<app::GarmentReplay> replay = app::garment_replay(*trace, "skirt");
    REQUIRE(replay);
    CHECK(replay->start == app::GarmentStart{kSize, "en", ui::Hand::Right});
    for (int run = 0; run < 2; ++run) {
        test::KioskStand kiosk(kSize);
        test::play(kiosk, *replay);
        CHECK(core::design_text(kiosk.garment->design()) == drawn);
        CHECK(kiosk.picture().pixels == seen.pixels);
    }
}

TEST_CASE("nothing moves the camera while a line is open", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.draw({{0, 106}, {6, 106}, {10, 106}}, false);
    const ui::FigureCamera before = kiosk.garment->views().camera();
    ui::WindowEvent wheel;
    wheel.kind = ui::WindowEvent::Kind::Zoom;
    wheel.zoom = 1;
    wheel.x = -1;
    wheel.time_us = kiosk.now_us;
    kiosk.shell->pointer(wheel);
    CHECK(kiosk.garment->views().camera() == before);
    kiosk.event(ui::WindowEvent::Kind::Up, 900, 400);
    kiosk.shell->pointer(wheel);
    CHECK(kiosk.garment->views().camera().scale_px == Approx(2 * before.scale_px));
}

TEST_CASE("two fingers turn the figure, and what the first drew is taken back", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.view(V::Solid);
    const ui::Rect figure = kiosk.garment->layout().figure;
    ui::WindowEvent finger{ui::WindowEvent::Kind::Down, figure.centre_x(), figure.centre_y(), 1, kiosk.now_us, true};
    kiosk.shell->pointer(finger);
    finger.kind = ui::WindowEvent::Kind::Move;
    finger.x += 20;
    kiosk.shell->pointer(finger);
    const ui::FigureCamera before = kiosk.garment->views().camera();
    ui::WindowEvent both;
    both.kind = ui::WindowEvent::Kind::Zoom;
    both.finger = true;
    both.x = finger.x;
    both.y = finger.y;
    both.shift_x = 80;
    both.time_us = kiosk.now_us;
    kiosk.shell->pointer(both);
    CHECK_FALSE(kiosk.garment->views().camera() == before);
    finger.kind = ui::WindowEvent::Kind::Up;
    kiosk.shell->pointer(finger);
    CHECK(state(kiosk).empty);
    CHECK_FALSE(state(kiosk).can_undo);
}

TEST_CASE("a size of the drawer dresses another body; Reset goes back", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.open("skirt_flat");
    const double before = kiosk.garment->views().height_cm();
    hand.press(A::Body);
    CHECK(state(kiosk).body.size == std::optional<std::size_t>(1));
    hand.press(A::Size, 5);
    kiosk.garment->settle(kiosk.now_us);
    CHECK(kiosk.garment->views().height_cm() > before + 5);
    CHECK(state(kiosk).body.size == std::optional<std::size_t>(5));
    CHECK(quads(kiosk) > 50);
    hand.slide(kiosk.garment->layout().drawer_sliders[2], 0.9);
    CHECK(state(kiosk).body.size == std::nullopt);
    hand.press(A::ResetBody);
    CHECK(state(kiosk).body.size == std::optional<std::size_t>(5));
    hand.press(A::Done);
    CHECK(state(kiosk).drawer == ui::GarmentDrawer::None);
}

TEST_CASE("measures that fit no body are said, and the figure stays", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.press(A::Body);
    hand.slide(kiosk.garment->layout().drawer_sliders[1], 1.0);  // a waist as wide as it goes
    hand.slide(kiosk.garment->layout().drawer_sliders[6], 1.0);  // and as high
    CHECK(core::check_measures(*kiosk.garment->desk().state().worn()->form.measures));
}

TEST_CASE("layers: a new one on top, hidden and shown, moved below", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.open("skirt_flat");
    hand.press(A::AddLayer);
    ui::GarmentState s = state(kiosk);
    REQUIRE(s.rows.size() == 3);
    CHECK(s.rows[0].selected);
    CHECK(s.rows[2].body);
    hand.press(A::Eye, 1);
    CHECK_FALSE(state(kiosk).rows[1].shown);
    hand.press(A::Eye, 1);
    hand.press(A::RowDown, 0);
    CHECK(state(kiosk).rows[1].selected);
    hand.press(A::Row, 0);
    CHECK(state(kiosk).rows[0].selected);
    hand.press(A::ShowHistory);
    s = state(kiosk);
    REQUIRE(s.history.size() > 3);
    CHECK(s.history[0].current);
    CHECK(s.history.back().name == "Start");
    hand.press(A::Row, 2);  // two acts back
    CHECK(state(kiosk).history[0].undone);
    CHECK(state(kiosk).history[2].current);
}

TEST_CASE("New empties the figure and offers the way back", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.skirt();
    const std::string drawn = core::design_text(kiosk.garment->design());
    hand.press(A::Page, 2);
    hand.press(A::New);
    CHECK(state(kiosk).empty);
    CHECK(state(kiosk).cleared);
    hand.press(A::UndoNew);
    CHECK(core::design_text(kiosk.garment->design()) == drawn);
    hand.press(A::Page, 2);
    hand.press(A::New);
    kiosk.wait(9);
    CHECK_FALSE(state(kiosk).cleared);
    CHECK(kiosk.scene() == app::Scene::Work);
}

TEST_CASE("Undo brings back what New put away, also when its offer is gone", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.skirt();
    const std::string drawn = core::design_text(kiosk.garment->design());
    hand.press(A::Page, 2);
    hand.press(A::New);
    kiosk.wait(9);
    CHECK_FALSE(state(kiosk).cleared);
    hand.draw({{0, 106}, {10, 106}});
    kiosk.tap(kiosk.garment->layout().undo);  // the line
    CHECK(state(kiosk).empty);
    REQUIRE(state(kiosk).can_undo);
    kiosk.tap(kiosk.garment->layout().undo);
    CHECK(core::design_text(kiosk.garment->design()) == drawn);
}

TEST_CASE("a line goes on from its end in another view, in a plane that the stepper puts", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.tool(T::OnPlane);
    CHECK(state(kiosk).stepper.of == ui::StepperOf::Depth);
    CHECK_FALSE(state(kiosk).stepper.cm.has_value());
    hand.number(-3.4);
    REQUIRE(state(kiosk).stepper.cm.has_value());
    CHECK(*state(kiosk).stepper.cm == Approx(-3.4));
    CHECK(state(kiosk).plane_traces.size() == 2);  // the side and the solid view; the back sees it as its sheet
    hand.draw({{30, 100}, {30, 80}});
    const core::Vec3 end = kiosk.garment->desk().network().lines()[0].shape.back();
    CHECK(end.z == Approx(-3.4));
    hand.tap({30, 80});
    CHECK(state(kiosk).line_goes_on);
    hand.view(V::Top);
    CHECK(state(kiosk).stepper.of == ui::StepperOf::Height);
    hand.number(70);
    hand.draw({hand.seen(end), {26, -8}, {20, -12}});
    CHECK(state(kiosk).line_goes_on);
    CHECK(kiosk.garment->desk().history().size() == 1);
    CHECK(kiosk.garment->design().steps.front().stroke.size() == 2);
    kiosk.tap(kiosk.garment->layout().undo);
    CHECK(kiosk.garment->design().steps.front().stroke.size() == 1);
    kiosk.tap(kiosk.garment->layout().redo);  // Finish
    CHECK_FALSE(state(kiosk).line_goes_on);
    // a tap on the number lets the plane go, another puts it back
    const ui::Rect& stepper = kiosk.garment->layout().stepper;
    kiosk.tap(stepper.centre_x(), stepper.centre_y());
    CHECK_FALSE(state(kiosk).stepper.cm.has_value());
    kiosk.tap(stepper.centre_x(), stepper.centre_y());
    CHECK(state(kiosk).stepper.cm == std::optional<double>(70.0));
    // another tool ends what goes on
    hand.tap({20, -12});
    hand.view(V::Front);
    hand.tap(hand.seen(kiosk.garment->desk().network().lines()[0].shape.front()));
    REQUIRE(state(kiosk).line_goes_on);
    hand.tool(T::Cut);
    CHECK_FALSE(state(kiosk).line_goes_on);
}

TEST_CASE("quads are chosen on the page of the design as a whole", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.press(A::Page, 2);
    CHECK(state(kiosk).stepper.of == ui::StepperOf::Quads);
    hand.number(1.6);
    CHECK(kiosk.garment->desk().network().options().edge_cm == Approx(1.6));
    kiosk.tap(kiosk.garment->layout().undo);
    CHECK(state(kiosk).stepper.cm == std::optional<double>(2.5));
}

TEST_CASE("a stroke off the figure says what to do, and nothing is lost", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.draw({{0, 106}, {10, 106}});
    hand.draw({{82, 20}, {88, 24}, {95, 30}});
    CHECK_FALSE(state(kiosk).problem.empty());
    CHECK(kiosk.garment->design().steps.front().name == "line 1");
    hand.draw({{0, 96}, {10, 96}});
    CHECK(state(kiosk).problem.empty());
}

TEST_CASE("the tape reads a girth", "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.tool(T::Measure);
    hand.tap({2, 104});
    const ui::GarmentState s = state(kiosk);
    REQUIRE(s.notes.size() == 1);
    CHECK(std::stod(s.notes[0].words) == Approx(72).margin(4));  // the waist of size 38
}

TEST_CASE("after a wipe nothing of the last garment is seen until the next figure is there", "[garment mode]") {
    std::counting_semaphore<> made{1};
    app::GarmentOptions options;
    options.first_desk = [&](const std::string& size) {
        made.acquire();
        const core::Mannequin body = *core::make_mannequin(*core::measures_of_size(size));
        core::Design design;
        design.body = body.measures;
        return core::GarmentDesk::open(std::move(design), core::dress_form(body));
    };
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, options);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.open("skirt_flat");
    const auto seen = [&] {
        for (int k = 0; k < 8; ++k) kiosk.shell->update_ink();
        ui::Target target(kSize, ui::PixelFormat::Colour);
        target.bind();
        kiosk.shell->draw(kiosk.now_us, false);
        return target.read_back();
    };
    const core::RgbaImage dressed = seen();
    kiosk.garment->wipe(0, ui::Hand::Right);
    const core::RgbaImage waiting = seen();
    const ui::Rect sheet = kiosk.garment->layout().sheet, figure = kiosk.garment->layout().figure;
    const auto pixel = [&](double x, double y) {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(dressed.width) + static_cast<std::size_t>(x)) *
               4;
    };
    const std::size_t ground = pixel(sheet.x + 5, 5);
    std::size_t own = 0, left = 0;  // pixels about the figure's middle that are not the sheet's
    for (double y = figure.y + 150; y < figure.bottom() - 20; y += 1) {
        for (double x = figure.centre_x() - 80; x < figure.centre_x() + 80; x += 1) {
            const auto is_ground = [&](const core::RgbaImage& image) {
                const std::size_t at = pixel(x, y);
                return std::abs(image.pixels[at] - dressed.pixels[ground]) +
                           std::abs(image.pixels[at + 2] - dressed.pixels[ground + 2]) <
                       24;
            };
            own += is_ground(dressed) ? 0 : 1;
            left += is_ground(waiting) ? 0 : 1;
        }
    }
    CHECK(own > 10'000);
    CHECK(left == 0);
    made.release();
}

TEST_CASE("a figure that there is no memory for is said, and the program goes on", "[garment mode]") {
    app::GarmentOptions options;
    options.first_desk = [](const std::string&) -> core::Result<core::GarmentDesk> { throw std::bad_alloc(); };
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, options);
    test::GarmentHand(kiosk).enter();
    kiosk.tap(kiosk.garment->layout().figure);
    CHECK_FALSE(state(kiosk).problem.empty());
}

TEST_CASE("what a palm did to the stepper is taken back; an eraser that is cancelled erases no more",
          "[garment mode]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    const double before = state(kiosk).offset_cm;
    const ui::GarmentScreen screen(kiosk.fonts(), kiosk.languages);
    ui::Rect number;
    for (const auto& target : screen.targets(state(kiosk), kiosk.garment->layout()))
        if (target.control == ui::Control::Garment && target.item == ui::garment_item(A::Number)) number = target.rect;
    REQUIRE(number.width > 0);
    kiosk.event(ui::WindowEvent::Kind::Down, number.centre_x(), number.centre_y());
    kiosk.event(ui::WindowEvent::Kind::Move, number.centre_x() + 60, number.centre_y());
    CHECK(state(kiosk).offset_cm > before);
    kiosk.event(ui::WindowEvent::Kind::TakeBack, number.centre_x() + 60, number.centre_y());
    CHECK(state(kiosk).offset_cm == before);

    const ui::Rect figure = kiosk.garment->layout().figure;
    ui::WindowEvent pen{ui::WindowEvent::Kind::Down, figure.centre_x(), figure.centre_y(), 1, kiosk.now_us, false};
    pen.pen = pen.eraser = true;
    kiosk.shell->pointer(pen);
    CHECK(state(kiosk).eraser_px);
    kiosk.shell->cancel_pointer(kiosk.now_us);  // the window lost the focus
    pen.eraser = false;
    pen.kind = ui::WindowEvent::Kind::Move;
    kiosk.shell->pointer(pen);
    CHECK_FALSE(state(kiosk).eraser_px);
}
