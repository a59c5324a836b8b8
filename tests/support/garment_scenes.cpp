// Every state of the Garment screen that was looked at, with the way to it.

#include "tests/support/garment_hand.hpp"
#include "tests/support/scenes.hpp"

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
