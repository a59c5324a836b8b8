#include "firmware_like_app/kiosk/garment_body.hpp"

#include <catch2/catch.hpp>

#include "core/exchange/obj_writer.hpp"
#include "core/exchange/png_writer.hpp"
#include "core/mannequin/body_mesher.hpp"
#include "core/mannequin/body_shape.hpp"
#include "core/mesh/distance_grid.hpp"
#include "tests/support/garment_hand.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using A = ui::GarmentAction;
constexpr ui::SizePx kSize{1280, 800};

ui::GarmentState state(test::KioskStand& kiosk) {
    return kiosk.garment->state(kiosk.now_us);
}

void type(test::GarmentHand& hand, const std::string& number) {
    for (const char sign : number)
        hand.press(A::PadKey, sign == '.' ? ui::kPadPoint : static_cast<std::size_t>(sign - '0'));
}

/// A coarse mannequin as a user's file, in metres.
void write_body(const std::string& file) {
    core::TriangleMesh mesh =
        core::triangles_of(core::mesh_body(core::BodyShape(*core::measures_of_size("42"), core::BodyScales{}), 2.5));
    std::ofstream out(file);
    for (const core::Vec3& v : mesh.vertices)
        out << "v " << v.x * 0.01 << " " << v.y * 0.01 << " " << v.z * 0.01 << "\n";
    for (const auto& t : mesh.triangles) out << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
}

}  // namespace

TEST_CASE("a measure is written within what its slider reaches", "[garment body]") {
    app::GarmentBody body;
    CHECK(body.size() == std::optional<std::size_t>(1));
    const double under = body.measures()[core::Measure::UnderBust], bust = body.measures()[core::Measure::Bust];
    CHECK(body.write(0, 95.25));
    CHECK(body.measures()[core::Measure::Bust] == Approx(95.3));
    CHECK(body.measures()[core::Measure::UnderBust] == Approx(under * 95.3 / bust));
    CHECK(body.size() == std::nullopt);
    CHECK_FALSE(body.write(0, 20));
    CHECK_FALSE(body.write(0, 500));
    CHECK_FALSE(body.write(7, 100));
    CHECK(body.measures()[core::Measure::Bust] == Approx(95.3));
}

TEST_CASE("a number is typed on the pad and the figure has it", "[garment body]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.press(A::Body);
    hand.press(A::TypeMeasure, 2);  // the hip
    REQUIRE(state(kiosk).body.typed == std::optional<std::size_t>(2));
    CHECK(state(kiosk).body.number.fresh);
    type(hand, "9");
    hand.press(A::PadDone);  // nine centimetres
    CHECK(state(kiosk).body.number_wrong);
    CHECK(state(kiosk).body.typed);
    hand.press(A::PadKey, ui::kPadErase);
    CHECK_THROWS(hand.press(A::PadDone));  // nothing is written
    type(hand, "102.5");
    CHECK_FALSE(state(kiosk).body.number_wrong);
    hand.press(A::PadDone);
    CHECK_FALSE(state(kiosk).body.typed);
    CHECK((*kiosk.garment->desk().state().worn()->form.measures)[core::Measure::Hip] == Approx(102.5));
    CHECK(state(kiosk).can_undo);
    hand.press(A::TypeMeasure, 0);
    type(hand, "100");
    hand.press(A::PadCancel);
    CHECK_FALSE(state(kiosk).body.typed);
    CHECK_FALSE((*kiosk.garment->desk().state().worn()->form.measures)[core::Measure::Bust] == Approx(100));
    hand.press(A::Done);
    CHECK(state(kiosk).drawer == ui::GarmentDrawer::None);
}

TEST_CASE("a body of the studio's own is chosen by its file; a bad one is told in a sentence", "[garment body]") {
    const support::TemporaryFolder folder;
    (void)folder.write("more/.hidden.obj", "");
    write_body(folder.path("more/mara.obj"));
    (void)folder.write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    (void)folder.write("notes.txt", "no body");
    app::GarmentOptions options;
    options.bodies = folder.path("");
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, options);
    test::GarmentHand hand(kiosk);
    hand.enter();
    const double before = kiosk.garment->views().height_cm();
    hand.press(A::Body);
    hand.press(A::OwnBody);
    ui::GarmentState s = state(kiosk);
    REQUIRE(s.drawer == ui::GarmentDrawer::OwnBody);
    REQUIRE(s.body_files.rows.size() == 2);
    CHECK(s.body_files.rows[0].folder);
    CHECK(s.body_files.rows[1].name == "broken.obj");
    CHECK_FALSE(s.body_files.up);
    hand.press(A::BodyFile, 1);
    s = state(kiosk);
    CHECK(s.drawer == ui::GarmentDrawer::OwnBody);
    CHECK(s.body_files.problem.find("broken.obj") != std::string::npos);
    CHECK(kiosk.garment->views().height_cm() == before);
    hand.press(A::BodyFile, 0);  // the folder
    s = state(kiosk);
    REQUIRE(s.body_files.rows.size() == 1);
    CHECK(s.body_files.up);
    CHECK(s.body_files.problem.empty());
    hand.press(A::BodyFile, 0);
    kiosk.garment->settle(kiosk.now_us);
    s = state(kiosk);
    CHECK(s.drawer == ui::GarmentDrawer::Body);
    CHECK(s.body.own_body);
    CHECK_FALSE(s.body.size);
    CHECK_THROWS(hand.press(A::TypeMeasure, 0));
    CHECK_FALSE(kiosk.garment->views().height_cm() == before);
    hand.press(A::Size, 1);
    kiosk.garment->settle(kiosk.now_us);
    CHECK_FALSE(state(kiosk).body.own_body);
    CHECK(kiosk.garment->views().height_cm() == Approx(before));
    // a design on an own body opens again
    kiosk.tap(kiosk.garment->layout().drawer_right);
    kiosk.tap(kiosk.garment->layout().undo);
    const core::Design design = kiosk.garment->design();
    kiosk.garment->wipe(0, ui::Hand::Right);
    REQUIRE(kiosk.garment->open(design));
    CHECK_FALSE(kiosk.garment->desk().state().worn()->form.measures);
}

TEST_CASE("a list of bodies longer than its rows is leafed through", "[garment body]") {
    const support::TemporaryFolder folder;
    for (int k = 0; k < 8; ++k) (void)folder.write("body" + std::to_string(k) + ".off", "");
    app::GarmentBodyFiles files(folder.path(""), false);
    CHECK(files.offered());
    files.open();
    CHECK(files.state().all == 8);
    CHECK(files.state().rows.size() == ui::BodyFiles::kRows);
    files.later();
    REQUIRE(files.state().rows.size() == 2);
    CHECK(files.state().rows[1].name == "body7.off");
    files.later();
    CHECK(files.state().first == ui::BodyFiles::kRows);
    files.choose(1);
    CHECK_FALSE(files.take());  // an empty file
    CHECK(files.state().problem.find("body7.off") != std::string::npos);
    files.choose(1);
    files.forget();
    CHECK_FALSE(files.take());
    CHECK(files.state().problem.empty());
    files.earlier();
    CHECK(files.state().first == 0);
    files.up();  // nothing is above
    CHECK_FALSE(files.state().up);
    CHECK_FALSE(app::GarmentBodyFiles({}, false).offered());
    app::GarmentBodyFiles none(folder.path("gone"), false);
    none.open();
    CHECK_FALSE(none.state().problem.empty());
}

TEST_CASE("pictures of a folder are fabrics; a bad one is one sentence", "[garment body]") {
    const support::TemporaryFolder folder;
    core::RgbaImage tartan;
    tartan.width = 300;
    tartan.height = 200;
    for (int i = 0; i < 300 * 200; ++i) {
        const bool red = i % 300 < 150;
        for (const int c : {red ? 200 : 20, 20, red ? 20 : 200, 255})
            tartan.pixels.push_back(static_cast<std::uint8_t>(c));
    }
    REQUIRE(core::write_png(folder.path("tartan.PNG"), tartan));
    (void)folder.write("bad.png", "no picture");
    (void)folder.write("readme.txt", "");
    const app::OwnFabrics own = app::read_own_fabrics(folder.path(""));
    REQUIRE(own.fabrics.size() == 1);
    CHECK(own.fabrics[0].name == "tartan");
    CHECK(own.fabrics[0].tile.width == 200);  // the square in the middle
    CHECK(own.fabrics[0].tile.height == 200);
    CHECK(own.fabrics[0].tile.pixels[0] == 200);
    CHECK(own.problem.find("bad.png") != std::string::npos);
    CHECK(app::read_own_fabrics({}).problem.empty());
    CHECK_FALSE(app::read_own_fabrics(folder.path("gone")).problem.empty());

    app::GarmentOptions options;
    options.fabrics = folder.path("");
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, options);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.open("skirt_flat");
    const core::RgbaImage plain = kiosk.picture();
    hand.press(A::Page, 2);
    hand.press(A::Fabrics);
    ui::GarmentState s = state(kiosk);
    REQUIRE(s.fabrics.size() == ui::kFabricCount + 1);
    CHECK(s.fabrics.back().name == "tartan");
    CHECK(s.fabric_problem.find("bad.png") != std::string::npos);
    hand.press(A::Fabric, ui::kFabricCount);
    CHECK(state(kiosk).fabrics.back().chosen);
    hand.press(A::Done);
    hand.press(A::Page, 0);
    const bool same = kiosk.picture().pixels == plain.pixels;
    CHECK_FALSE(same);
    CHECK(kiosk.garment->desk().state().look().materials.begin()->second.fabric == own.fabrics[0].picture);
}
