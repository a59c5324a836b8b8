#include "firmware_like_app/kiosk/shell.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

#include "firmware_like_app/kiosk/input_fault.hpp"
#include "tests/support/kiosk_stand.hpp"
#include "tests/support/temporary_folder.hpp"

using app::CollectionState;
using app::Scene;
using Kind = ui::WindowEvent::Kind;

namespace {

constexpr ui::SizePx kSize{1280, 800};

std::size_t strokes(const test::KioskStand& kiosk) {
    return kiosk.find->sketch().drawing().strokes.size();
}

app::ShellOptions with(CollectionState state) {
    app::ShellOptions options;
    options.collection = state;
    return options;
}

}  // namespace

TEST_CASE("the first tip wakes without drawing, the second draws", "[shell]") {
    test::KioskStand kiosk(kSize);
    REQUIRE(kiosk.scene() == Scene::Attract);
    kiosk.stroke(800, 300, 1000, 400);
    CHECK(kiosk.scene() == Scene::Work);
    CHECK(strokes(kiosk) == 0);
    kiosk.stroke(800, 300, 1000, 400);
    CHECK(strokes(kiosk) == 1);
}

TEST_CASE("a near pen wakes, and its tip then draws", "[shell]") {
    test::KioskStand kiosk(kSize);
    kiosk.shell->pen_near(true, kiosk.now_us);
    CHECK(kiosk.scene() == Scene::Work);
    kiosk.stroke(800, 300, 1000, 400);
    CHECK(strokes(kiosk) == 1);
}

TEST_CASE("the language switch of attract chooses and does not wake; a wipe takes it back", "[shell]") {
    test::KioskStand kiosk(kSize);
    const ui::AttractLayout layout = ui::attract_layout(kSize, kiosk.languages.size());
    kiosk.tap(ui::switch_segments(layout.language, kiosk.languages.size())[2]);
    CHECK(kiosk.scene() == Scene::Attract);
    CHECK(kiosk.find->language() == 2);
    kiosk.wait(31);
    CHECK(kiosk.find->language() == 0);
}

TEST_CASE("attract draws, forms and goes on to the next drawing, and never shows a visitor's", "[shell]") {
    test::KioskStand kiosk(kSize);
    kiosk.wait(1);
    const auto one = kiosk.picture().pixels;
    kiosk.wait(1);
    const auto two = kiosk.picture().pixels;
    const bool moved = one != two;
    CHECK(moved);
    kiosk.wait(5.5);
    const auto formed = kiosk.picture().pixels;
    const bool has_form = formed != two;
    CHECK(has_form);
    CHECK(kiosk.find->sketch().empty());
    kiosk.wait(6.2);
    const bool went_on = kiosk.picture().pixels != formed;
    CHECK(went_on);
}

TEST_CASE("after an idle wipe the screen shows exactly what it showed to the first visitor", "[shell]") {
    // pixels are compared as a whole: a million numbers in a message help nobody
    const auto empty_sheet = [](test::KioskStand& kiosk) {
        kiosk.tap(900, 400);
        kiosk.wait(0.5);
        return kiosk.picture().pixels;
    };
    const std::vector<std::uint8_t> expected = [&] {
        test::KioskStand fresh(kSize);
        return empty_sheet(fresh);
    }();
    test::KioskStand used(kSize);
    used.tap(900, 400);
    used.draw_horse();
    used.tap(used.find->layout().hand_switch);
    used.find->set_language(1);
    REQUIRE(strokes(used) > 0);
    used.wait(82);
    REQUIRE(used.scene() == Scene::Attract);
    CHECK(strokes(used) == 0);
    CHECK_FALSE(used.find->sketch().can_undo());
    const bool same = empty_sheet(used) == expected;
    CHECK(same);
}

TEST_CASE("still there: its buttons work, and the stroke that answers is drawn", "[shell]") {
    test::KioskStand kiosk(kSize);
    kiosk.tap(900, 400);
    kiosk.stroke(800, 300, 1000, 400);
    kiosk.wait(61);
    REQUIRE(kiosk.scene() == Scene::StillThere);
    kiosk.stroke(800, 200, 1000, 250);
    CHECK(kiosk.scene() == Scene::Work);
    CHECK(strokes(kiosk) == 2);

    kiosk.wait(61);
    REQUIRE(kiosk.scene() == Scene::StillThere);
    kiosk.tap(560, 580);  // keep drawing
    CHECK(kiosk.scene() == Scene::Work);
    CHECK(strokes(kiosk) == 2);

    kiosk.wait(61);
    REQUIRE(kiosk.scene() == Scene::StillThere);
    kiosk.tap(750, 580);  // start over
    CHECK(kiosk.scene() == Scene::Attract);
    CHECK(strokes(kiosk) == 0);
}

TEST_CASE("a tip that is held down is somebody", "[shell]") {
    test::KioskStand kiosk(kSize);
    kiosk.tap(900, 400);
    kiosk.event(Kind::Down, 900, 400);
    kiosk.wait(300);
    CHECK(kiosk.scene() == Scene::Work);
    kiosk.event(Kind::Up, 900, 400);
    kiosk.wait(61);
    CHECK(kiosk.scene() == Scene::StillThere);
}

TEST_CASE("a mouse that only moves wakes nobody and is nobody", "[shell]") {
    test::KioskStand kiosk(kSize);
    kiosk.event(Kind::Move, 900, 400);
    CHECK(kiosk.scene() == Scene::Attract);
}

TEST_CASE("notices: each has a way to the sheet, and the board then says what is missing", "[shell]") {
    test::KioskStand ready(kSize);
    for (const CollectionState state :
         {CollectionState::Empty, CollectionState::Missing, CollectionState::Damaged, CollectionState::Stale}) {
        test::KioskStand kiosk(kSize, with(state));
        REQUIRE(kiosk.scene() == Scene::Notice);
        kiosk.stroke(900, 200, 1000, 250);
        CHECK(kiosk.scene() == Scene::Notice);
        kiosk.tap(640, 540);
        CHECK(kiosk.scene() == Scene::Work);
        CHECK(kiosk.shell->in_garment() == (state == CollectionState::Empty));  // that needs no collection
        kiosk.shell->open_garment(false, kiosk.now_us);
        CHECK(kiosk.find->state(kiosk.now_us).board_message != ready.find->state(ready.now_us).board_message);
        kiosk.stroke(900, 200, 1000, 250);
        CHECK(strokes(kiosk) == 1);
        kiosk.wait(82);
        CHECK(kiosk.scene() == Scene::Notice);
    }
}

TEST_CASE("the switch goes to Garment and back, with language and hand; each keeps its work until a wipe", "[shell]") {
    test::KioskStand kiosk(kSize);
    kiosk.shell->open_sheet(kiosk.now_us);
    kiosk.stroke(900, 200, 1000, 250);
    kiosk.find->set_language(1);
    kiosk.find->set_hand(ui::Hand::Left);
    const ui::Rect modes = kiosk.find->layout().mode_switch;
    kiosk.tap(modes.x + modes.width * 0.75, modes.centre_y());
    REQUIRE(kiosk.shell->in_garment());
    CHECK(kiosk.garment->language() == 1);
    CHECK(kiosk.garment->hand() == ui::Hand::Left);
    const ui::Rect sheet = kiosk.garment->layout().sheet;
    CHECK(kiosk.shell->sheet() == sheet);
    const double y = sheet.y + sheet.height * 0.45;
    kiosk.stroke(sheet.centre_x() + 4, y, sheet.centre_x() + 50, y);
    CHECK(kiosk.garment->has_work());
    const ui::Rect back = kiosk.garment->layout().mode_switch;
    kiosk.tap(back.x + back.width * 0.25, back.centre_y());
    CHECK_FALSE(kiosk.shell->in_garment());
    CHECK(strokes(kiosk) == 1);
    kiosk.shell->open_garment(true, kiosk.now_us);
    kiosk.wait(175);  // people think longer here
    CHECK(kiosk.scene() == Scene::Work);
    kiosk.wait(30);
    CHECK(kiosk.scene() == Scene::Attract);
    CHECK_FALSE(kiosk.shell->in_garment());
    CHECK_FALSE(kiosk.garment->has_work());
    CHECK(strokes(kiosk) == 0);
}

TEST_CASE("without Garment there is no switch, and nothing leads there", "[shell]") {
    app::ShellOptions options;
    options.garment_offered = false;
    test::KioskStand kiosk(kSize, options);
    kiosk.shell->open_sheet(kiosk.now_us);
    const ui::Rect modes = kiosk.find->layout().mode_switch;
    kiosk.tap(modes.x + modes.width * 0.75, modes.centre_y());
    CHECK_FALSE(kiosk.shell->in_garment());
    CHECK_FALSE(kiosk.find->state(kiosk.now_us).modes);
}

TEST_CASE("while the collection is read visitors draw, and its page goes when it is ready", "[shell]") {
    test::KioskStand kiosk(kSize, with(CollectionState::Building));
    kiosk.shell->set_collection(CollectionState::Building, {3, 10, {}}, kiosk.now_us);
    const auto before = kiosk.picture().pixels;
    kiosk.shell->set_collection(CollectionState::Building, {9, 10, 1}, kiosk.now_us);
    CHECK(kiosk.shell->changed(kiosk.now_us));
    const bool counted = kiosk.picture().pixels != before;
    CHECK(counted);
    kiosk.tap(640, 555);
    CHECK(kiosk.scene() == Scene::Work);
    kiosk.wait(31);
    CHECK(kiosk.scene() == Scene::Notice);
    kiosk.shell->set_collection(CollectionState::Ready, {}, kiosk.now_us);
    CHECK(kiosk.scene() == Scene::Attract);
}

TEST_CASE("a lost tablet is a note on the board, and a page only at home", "[shell]") {
    test::KioskStand kiosk(kSize);
    kiosk.shell->set_tablet(true, kiosk.now_us);
    kiosk.tap(900, 400);
    const std::string before = kiosk.find->state(kiosk.now_us).board_message;
    kiosk.shell->set_tablet(false, kiosk.now_us);
    CHECK(kiosk.scene() == Scene::Work);
    CHECK(kiosk.find->state(kiosk.now_us).board_message != before);
    kiosk.wait(31);
    CHECK(kiosk.scene() == Scene::Notice);
    kiosk.shell->set_tablet(true, kiosk.now_us);
    CHECK(kiosk.scene() == Scene::Attract);
}

TEST_CASE("without attract the empty sheet is home", "[shell]") {
    app::ShellOptions options;
    options.attract = false;
    test::KioskStand kiosk(kSize, options);
    CHECK(kiosk.scene() == Scene::Work);
    kiosk.stroke(800, 300, 1000, 400);
    CHECK(strokes(kiosk) == 1);
    kiosk.wait(82);
    CHECK(kiosk.scene() == Scene::Work);
    CHECK(strokes(kiosk) == 0);
}

TEST_CASE("a resize on attract, on a notice and under the question keeps the scene", "[shell]") {
    test::KioskStand kiosk(kSize);
    kiosk.wait(1);
    for (const ui::SizePx size : {ui::SizePx{800, 600}, ui::SizePx{1080, 1920}, kSize}) {
        kiosk.size = size;
        kiosk.shell->resize(size, kiosk.now_us);
        kiosk.wait(0.5);
        CHECK(kiosk.scene() == Scene::Attract);
        CHECK(kiosk.picture().width == size.width);
    }
    kiosk.tap(900, 400);
    kiosk.stroke(800, 300, 1000, 400);
    kiosk.wait(61);
    kiosk.size = {1080, 1920};
    kiosk.shell->resize(kiosk.size, kiosk.now_us);
    CHECK(kiosk.scene() == Scene::StillThere);
    CHECK(strokes(kiosk) == 1);
    CHECK(kiosk.picture().height == 1920);
}

TEST_CASE("a screen that nothing can control says so, until something comes", "[shell]") {
    test::KioskStand kiosk(kSize);
    kiosk.shell->set_no_input("I2", kiosk.now_us);
    CHECK(kiosk.scene() == Scene::Notice);
    kiosk.wait(100);
    CHECK(kiosk.scene() == Scene::Notice);
    kiosk.shell->set_no_input("", kiosk.now_us);
    CHECK(kiosk.scene() == Scene::Attract);
    kiosk.shell->set_no_input("I1", kiosk.now_us);
    kiosk.tap(600, 400);  // something came after all
    kiosk.wait(0.1);
    CHECK(kiosk.scene() != Scene::Notice);
}

TEST_CASE("input devices that are not there or may not be read have a code", "[shell]") {
    const support::TemporaryFolder folder;
    CHECK(app::input_fault(folder.path("none")) == "I1");
    const std::string file = folder.write("input/event3", "");
    CHECK(app::input_fault(folder.path("input")).empty());
    CHECK(app::input_fault(folder.path("")) == "I1");  // nothing there that is an event device
    std::filesystem::remove(file);
    std::filesystem::create_symlink(folder.path("gone"), file);
    CHECK(app::input_fault(folder.path("input")) == "I2");
}

TEST_CASE("a picture that is kept from frame to frame is right through all scenes", "[shell]") {
    test::KioskStand kiosk(kSize);
    ui::Target kept(kSize, ui::PixelFormat::Colour);
    bool drawn = false;
    const auto look = [&] {
        kiosk.shell->update_ink();
        kept.bind();
        kiosk.shell->draw(kiosk.now_us, false, std::exchange(drawn, true));
        const auto seen = kept.read_back().pixels;
        CHECK(seen == kiosk.picture().pixels);
    };
    for (int i = 0; i < 7; ++i) {  // the line, and its form
        look();
        kiosk.wait(0.9);
    }
    kiosk.shell->open_sheet(kiosk.now_us);
    look();
    kiosk.stroke(800, 300, 1000, 400);
    look();
    kiosk.draw_horse();
    look();
    kiosk.tap(kiosk.find->layout().cards[0]);
    kiosk.wait(0.1);
    REQUIRE(kiosk.scene() == Scene::Detail);
    for (int i = 0; i < 3; ++i) {  // it opens and turns
        look();
        kiosk.wait(0.3);
    }
    kiosk.wait(65);
    REQUIRE(kiosk.scene() == Scene::StillThere);
    look();
    kiosk.wait(1);
    look();
    kiosk.tap(kiosk.shell->detail().layout().sheet.right() - 20, 20);
    REQUIRE(kiosk.scene() == Scene::Detail);
    look();
    kiosk.tap(kiosk.shell->detail().layout().back);
    REQUIRE(kiosk.scene() == Scene::Work);
    look();
    kiosk.wait(70);
    REQUIRE(kiosk.scene() == Scene::StillThere);
    look();
    kiosk.stroke(800, 350, 1000, 450);
    look();
    kiosk.wait(100);
    REQUIRE(kiosk.scene() == Scene::Attract);
    look();
    kiosk.event(Kind::Down, 20, 20);
    kiosk.wait(3.2);
    kiosk.event(Kind::Up, 20, 20);
    look();
    kiosk.type("000000");
    look();
    kiosk.wait(1);
    look();
}

TEST_CASE("attract shows the drawings of a folder, in their own rhythm without long lifts", "[shell]") {
    const support::TemporaryFolder folder;
    folder.write("notes.txt", "no drawing");
    CHECK(app::attract_drawings(folder.path("")).has_value() == false);
    CHECK(app::attract_drawings(folder.path("gone")).error().code == core::ErrorCode::FileMissing);
    // a second of drawing, a minute of thinking, a second of drawing
    folder.write("b.ndjson",
                 R"({"drawing":[[[0,50,90],[0,30,0],[0,500,1000]],[[90,40,0],[10,60,10],[61000,61500,62000]]]})");
    folder.write("a.ndjson", R"({"drawing":[[[0,80],[0,0],[0,1000]]]})");
    const auto drawings = app::attract_drawings(folder.path(""));
    REQUIRE(drawings.has_value());
    REQUIRE(drawings->size() == 2);
    CHECK((*drawings)[0].name == "a");

    app::ShellOptions options;
    options.attract_folder = folder.path("");
    test::KioskStand kiosk(kSize, options);
    kiosk.wait(9.0 + 2.6);  // the second drawing, 1 + 0.5 + 1 s long made 4 s: its second stroke begins at 2.4 s
    const auto early = kiosk.picture().pixels;
    kiosk.wait(0.8);  // and grows at 3.2 s
    CHECK((kiosk.picture().pixels != early));
}
