// Every state of the Garment screen that was looked at, with the way to it.

#include "core/exchange/design_file.hpp"
#include "core/exchange/png_writer.hpp"
#include "db/stores/design_store.hpp"
#include "tests/support/garment_hand.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace test {

using A = ui::GarmentAction;
using T = ui::GarmentTool;
using V = ui::GarmentView;

namespace {

/// A worked design under the hand.
GarmentHand with(KioskStand& kiosk, const char* design) {
    GarmentHand hand(kiosk);
    hand.enter();
    hand.open(design);
    return hand;
}

NamedScene scene(const char* name, std::function<void(KioskStand&)> go, app::ShellOptions options = {}) {
    NamedScene made{name, std::move(options), std::move(go)};
    made.garment = true;
    return made;
}

/// What was drawn through the screen (tests/replay), a picture after each piece that was filled, cut or opened.
NamedScene steps_of(const std::string& name) {
    const auto design = std::make_shared<core::Design>();
    NamedScene made{"garment-steps-" + name, {}, [design, name](KioskStand& kiosk) {
                        GarmentHand(kiosk).enter();
                        core::Result<core::Design> read =
                            core::read_design(CROQUIS_SOURCE_DIR "/tests/replay/garment-" + name + "/design.json");
                        if (!read) throw std::runtime_error(read.error().sentence());
                        *design = std::move(*read);
                        if (!kiosk.garment->open(*design)) throw std::runtime_error("it does not open: " + name);
                    }};
    made.garment = true;
    made.step = [design](KioskStand& kiosk, std::size_t step) {
        using K = core::DesignStep::Kind;
        core::GarmentDesk& desk = kiosk.garment->desk();
        const std::vector<core::HistoryEntry> acts = desk.history();
        std::size_t from = 0, place = 0;
        for (const core::HistoryEntry& act : acts) {
            ++place;
            bool shows = false;
            for (; from < act.steps; ++from) {
                const K kind = design->steps[from].kind;
                shows = shows || kind == K::Region || kind == K::Cut || kind == K::Hole;
            }
            if (!shows || step-- > 0) continue;
            kiosk.garment->go_to(place, kiosk.now_us);
            return true;
        }
        return false;
    };
    return made;
}

/// A folder that stays until the program ends.
const support::TemporaryFolder& scratch() {
    static const support::TemporaryFolder folder;
    return folder;
}

/// Three designs in a file, made on a day that does not change, with pictures.
void fill_gallery(KioskStand& kiosk) {
    GarmentHand hand(kiosk);
    hand.enter();
    std::int64_t now_us = 1'760'000'000'000'000;
    const std::string file = scratch().path("designs.db");
    const auto tick = [&] { return now_us += 86'400'000'000; };
    auto store = db::DesignStore::open(file, db::OpenMode::Create, {.now_us = tick});
    if (!store) throw std::runtime_error(store.error().sentence());
    if (store->list()->empty()) {
        for (const char* name : {"skirt_folds", "dress", "jacket"}) {
            hand.open(name);
            const core::Result<std::int64_t> id = store->create(kiosk.garment->design());
            const auto png = core::png_bytes(kiosk.garment->views().thumbnail());
            if (!id || !png || !store->set_thumbnail(*id, *png)) throw std::runtime_error("no gallery");
        }
    }
    core::Design empty;
    empty.body = kiosk.garment->design().body;
    (void)kiosk.garment->open(empty);
    hand.press(A::Page, 2);
    hand.press(A::Designs);
    kiosk.wait(0.1);
}

/// The horse that was drawn, found, and put on the figure beside a dress.
void wear_horse(KioskStand& kiosk) {
    kiosk.shell->open_sheet(kiosk.now_us);
    kiosk.wait(0.1);
    kiosk.shell->open_garment(true, kiosk.now_us);
    GarmentHand(kiosk).open("dress");
    kiosk.shell->open_garment(false, kiosk.now_us);
    kiosk.draw_horse();
    kiosk.tap(kiosk.find->layout().cards[0]);
    kiosk.wait(0.5);
    kiosk.tap(kiosk.shell->detail().layout().wear);
    kiosk.wait(0.1);
}

app::ShellOptions in_french() {
    app::ShellOptions options;
    options.language = 1;
    return options;
}

app::ShellOptions left_in_german() {
    app::ShellOptions options;
    options.hand = ui::Hand::Left;
    options.language = 2;
    return options;
}

}  // namespace

std::vector<NamedScene> garment_scenes() {
    return {
        scene("garment-empty", [](KioskStand& k) { GarmentHand(k).enter(); }),
        scene("garment-skirt",
              [](KioskStand& k) {
                  GarmentHand hand(k);
                  hand.enter();
                  hand.skirt();
              }),
        scene("garment-front",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.press(A::AddLayer);
                  hand.tool(T::OnBody);
                  hand.draw({{3, 136}, {7, 135}, {13, 133}});
                  hand.draw({{13, 133}, {17, 126}, {19, 112}}, false);
              }),
        scene("garment-folds-3d",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "skirt_folds");
                  hand.view(V::Solid);
                  hand.slide(k.garment->layout().slider, 0.8, false);
              }),
        scene(
            "garment-skirt-left-de",
            [](KioskStand& k) {
                GarmentHand hand(k);
                hand.enter();
                hand.skirt();
            },
            left_in_german()),
        scene("garment-cut",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "skirt_flat");
                  hand.tool(T::Cut);
                  hand.draw({{-2, 80}, {8, 79}, {16, 80}, {30, 82}}, false);
              }),
        scene("garment-temporary-plane",
              [](KioskStand& k) {
                  GarmentHand hand(k);
                  hand.enter();
                  hand.draw({{0, 106}, {5, 106}, {10, 106.3}, {14, 106.8}});
                  hand.view(V::Solid);
                  hand.tool(T::TemporaryPlane);
                  const core::Point start = hand.seen(hand.vertex(0));
                  hand.draw({start, start + core::Point{-6, 4}, start + core::Point{-16, 4}}, false);
              }),
        scene("garment-open-outline",
              [](KioskStand& k) {
                  GarmentHand hand(k);
                  hand.enter();
                  hand.draw({{5, 106}, {8, 106}, {11, 106.3}});
                  hand.draw({{11, 106.3}, {13, 96}, {14, 86}});
                  hand.draw({{14, 86}, {9, 85}, {5, 85}});
                  hand.draw({{5, 85}, {4.8, 92}, {5, 101}});
              }),
        scene("garment-measure",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.tool(T::Measure);
                  hand.tap({4, 90});
              }),
        scene("garment-move",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.view(V::Side);
                  hand.tool(T::Move);
              }),
        scene("garment-fabric",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.press(A::Page, 2);
                  hand.press(A::Quads);
                  hand.press(A::Fabrics);
                  hand.press(A::Fabric, 4);
                  hand.press(A::Colour, 6);
              }),
        scene(
            "garment-history-fr",
            [](KioskStand& k) {
                GarmentHand hand = with(k, "trousers");
                hand.press(A::ShowHistory);
                hand.press(A::Row, 2);
            },
            in_french()),
        scene("garment-export",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "outfit");
                  hand.view(V::Back);
                  hand.press(A::Export);
              }),
        scene("garment-corner",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.tool(T::Corner);
              }),
        scene("garment-add",
              [](KioskStand& k) {
                  GarmentHand hand(k);
                  hand.enter();
                  hand.draw({{0, 106}, {5, 106}, {10, 106.3}, {14, 106.8}});
                  hand.tool(T::Add);
                  hand.draw({{14, 106.8}, {15, 96}, {14, 84}, {0, 83}}, false);
              }),
        scene("garment-smooth",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "skirt_folds");
                  hand.tool(T::Smooth);
                  hand.draw({{3, 47.5}, {14, 47.5}, {27, 47.5}}, false);
              }),
        scene("garment-bump",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "skirt_flat");
                  hand.tool(T::Bump);
                  hand.draw({{3, 47.5}, {14, 47.5}, {27, 47.5}}, false);
              }),
        scene("garment-weld",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.tool(T::Weld);
                  const core::Point start = hand.seen(hand.vertex(2));
                  hand.draw({start, start + core::Point{6, -6}}, false);
              }),
        scene("garment-hole",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.tool(T::Hole);
                  hand.draw({{4, 90}, {9, 90}, {9.5, 84}, {4, 83.5}, {3.8, 88}}, false);
              }),
        scene("garment-remove",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "outfit");
                  hand.tool(T::Remove);
                  hand.tap({8, 128});
              }),
        scene("garment-mirror",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.tool(T::Mirror);
              }),
        scene("garment-layers",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "outfit");
                  hand.view(V::Solid);
                  hand.press(A::AddLayer);
                  hand.press(A::Eye, 2);
              }),
        scene("garment-drape",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.view(V::Solid);
                  hand.press(A::Page, 2);
                  hand.press(A::Drape);
                  k.wait(1.0);
              }),
        scene("garment-object", wear_horse),
        scene("garment-number",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.press(A::Body);
                  hand.press(A::TypeMeasure, 1);
                  for (const std::size_t key : {7U, 4U, 10U, 5U}) hand.press(A::PadKey, key);
              }),
        [] {
            NamedScene made = scene(
                "garment-own-body-de",
                [](KioskStand& k) {
                    GarmentHand hand = with(k, "dress");
                    hand.press(A::Body);
                    hand.press(A::OwnBody);
                    hand.press(A::BodyFile, 1);
                },
                left_in_german());
            made.garment_options = [] {
                app::GarmentOptions options;
                for (const char* name : {"bodies/Archiv/x.obj", "bodies/Anna.obj", "bodies/Ben.ply", "bodies/Carla.obj",
                                         "bodies/Dora.stl", "bodies/Emil.obj", "bodies/Fritz.off"})
                    (void)scratch().write(name, "");
                options.bodies = scratch().path("bodies");
                return options;
            };
            return made;
        }(),
        [] {
            NamedScene made = scene("garment-gallery", fill_gallery);
            made.upright = true;
            made.garment_options = [] {
                app::GarmentOptions options;
                options.designs = scratch().path("designs.db");
                return options;
            };
            return made;
        }(),
        steps_of("dress"),
        steps_of("outfit"),
        steps_of("jacket"),
        scene("garment-body",
              [](KioskStand& k) {
                  GarmentHand hand = with(k, "dress");
                  hand.view(V::Solid);
                  hand.press(A::Body);
                  hand.slide(k.garment->layout().drawer_sliders[2], 0.75);
              }),
    };
}

}  // namespace test
