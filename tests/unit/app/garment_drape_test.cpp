#include "firmware_like_app/kiosk/garment_drape.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "core/exchange/design_file.hpp"
#include "core/garment/wardrobe.hpp"
#include "tests/support/garment_hand.hpp"

namespace {

using A = ui::GarmentAction;
using T = ui::GarmentTool;
using V = ui::GarmentView;
constexpr ui::SizePx kSize{1280, 800};

struct Dressed {
    std::vector<core::BuiltLayer> layers;
    std::shared_ptr<const core::WornForm> form;
};

/// A worked skirt, fitted.
const Dressed& skirt() {
    static const Dressed dressed = [] {
        const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
        core::GarmentDesk desk =
            *core::GarmentDesk::open(*core::wardrobe_design("skirt_flat", body), core::dress_form(body));
        desk.build_now();
        return Dressed{desk.cloth(), desk.state().worn()};
    }();
    return dressed;
}

ui::GarmentState state(test::KioskStand& kiosk) {
    return kiosk.garment->state(kiosk.now_us);
}

void press_drape(test::GarmentHand& hand, test::KioskStand& kiosk) {
    if (state(kiosk).page != 2) hand.press(A::Page, 2);
    hand.press(A::Drape);
}

}  // namespace

TEST_CASE("a drape without a thread hangs as far as its clock says", "[garment drape]") {
    app::GarmentDrape one(false), two(false);
    for (app::GarmentDrape* drape : {&one, &two}) {
        drape->start(skirt().layers, skirt().form, 1'000'000);
        CHECK(drape->on());
        CHECK(drape->hangs(skirt().layers));
        CHECK_FALSE(drape->take());
        drape->advance(1'010'000);
        CHECK_FALSE(drape->take());  // not yet a sixtieth of a second
    }
    one.advance(1'200'000);
    for (std::int64_t now_us = 1'020'000; now_us <= 1'200'000; now_us += 20'000) two.advance(now_us);
    const auto a = one.take(), b = two.take();
    REQUIRE(a);
    REQUIRE(b);
    CHECK(*a == *b);
    REQUIRE(a->size() == 1);
    const std::vector<core::Vec3>& drawn = skirt().layers[0].cloth->fitted.mesh.vertices;
    REQUIRE(a->begin()->second.size() == drawn.size());
    CHECK_FALSE(a->begin()->second == drawn);
    CHECK_FALSE(one.take());
    CHECK_FALSE(one.hangs({}));
    one.stop();
    CHECK_FALSE(one.on());
    CHECK_FALSE(one.moving());
    one.advance(2'000'000);
    CHECK_FALSE(one.take());
}

TEST_CASE("a drape with a thread makes the same places, at the pace of the clock", "[garment drape]") {
    app::GarmentDrape drape(true);
    for (int round = 0; round < 2; ++round) {  // stopped on its way, it begins from the drawn form again
        drape.start(skirt().layers, skirt().form, 0);
        std::optional<app::HangingPlaces> first;
        for (int k = 0; k < 2000 && !first; ++k) {
            first = drape.take();
            if (!first) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        REQUIRE(first);
        // after how many steps is not known; one of the first is the same as without a thread
        bool found = false;
        app::GarmentDrape same(false);
        same.start(skirt().layers, skirt().form, 0);
        for (int step = 1; step <= 40 && !found; ++step) {
            same.advance((step * 1'000'000 + 59) / 60);
            const auto places = same.take();
            found = places && *places == *first;
        }
        CHECK(found);
        CHECK(drape.moving());
        drape.stop();
        CHECK_FALSE(drape.take());
    }
}

TEST_CASE("nothing to hang comes to rest", "[garment drape]") {
    app::GarmentDrape drape(false);
    drape.start({}, skirt().form, 0);
    drape.advance(3'000'000);
    CHECK_FALSE(drape.moving());
}

TEST_CASE("Drape lets the garment hang and puts it back as it was drawn", "[garment drape]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.press(A::Page, 2);
    CHECK_FALSE(state(kiosk).can_hang);
    CHECK_THROWS(hand.press(A::Drape));  // there is no cloth
    hand.open("skirt_flat");
    const std::string design = core::design_text(kiosk.garment->design());
    const core::RgbaImage drawn = kiosk.picture();
    press_drape(hand, kiosk);
    CHECK(state(kiosk).hanging);
    CHECK(state(kiosk).lines.empty());
    kiosk.wait(0.4);
    const core::RgbaImage hung = kiosk.picture();
    const bool still_drawn = hung.pixels == drawn.pixels;
    CHECK_FALSE(still_drawn);
    hand.view(V::Side);  // the views and the tiles show it as well
    CHECK(state(kiosk).hanging);
    hand.view(V::Front);
    press_drape(hand, kiosk);
    CHECK_FALSE(state(kiosk).hanging);
    const bool as_drawn = kiosk.picture().pixels == drawn.pixels;
    CHECK(as_drawn);
    CHECK(core::design_text(kiosk.garment->design()) == design);
    CHECK(state(kiosk).can_undo);
}

TEST_CASE("in 3D the pen turns what hangs; in a flat view it draws, on the garment as drawn", "[garment drape]") {
    test::KioskStand kiosk(kSize);
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.open("skirt_flat");
    press_drape(hand, kiosk);
    hand.view(V::Solid);
    const ui::FigureCamera before = kiosk.garment->views().camera();
    const std::size_t acts = kiosk.garment->desk().history().size();
    hand.draw({{0, 20}, {8, 20}});  // from the middle of the figure
    CHECK_FALSE(kiosk.garment->views().camera() == before);
    CHECK(kiosk.garment->desk().history().size() == acts);
    CHECK(state(kiosk).hanging);
    hand.view(V::Front);
    hand.draw({{4, 130}, {9, 130}});
    CHECK_FALSE(state(kiosk).hanging);
    CHECK(kiosk.garment->desk().history().size() == acts + 1);
    press_drape(hand, kiosk);
    CHECK(state(kiosk).hanging);
    hand.tool(T::Cut);
    CHECK_FALSE(state(kiosk).hanging);
    press_drape(hand, kiosk);
    kiosk.garment->wipe(0, ui::Hand::Right);
    CHECK_FALSE(state(kiosk).hanging);
}

TEST_CASE("the same presses let it hang in the same pictures", "[garment drape]") {
    std::vector<core::RgbaImage> seen;
    for (int run = 0; run < 2; ++run) {
        test::KioskStand kiosk(kSize);
        test::GarmentHand hand(kiosk);
        hand.enter();
        hand.open("skirt_folds");
        press_drape(hand, kiosk);
        kiosk.wait(0.3);
        seen.push_back(kiosk.picture());
    }
    const bool same = seen[0].pixels == seen[1].pixels;
    CHECK(same);
}
