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
        scene("garment-skirt-left-de",
              [](KioskStand& k) {
                  GarmentHand hand(k);
                  hand.enter();
                  hand.skirt();
              },
              left_in_german()),
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
