// Designs kept, found again in the gallery and taken away, all by touches on the screen.

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <thread>

#include "core/exchange/design_file.hpp"
#include "db/stores/design_store.hpp"
#include "tests/support/garment_hand.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using A = ui::GarmentAction;
using G = ui::GalleryAction;
constexpr ui::SizePx kSize{1280, 800};

app::GarmentOptions keeping_in(const support::TemporaryFolder& folder) {
    app::GarmentOptions options;
    options.designs = folder.path("designs.db");
    options.export_to = folder.path("taken");
    return options;
}

ui::GarmentState state(test::KioskStand& kiosk) {
    return kiosk.garment->state(kiosk.now_us);
}

std::size_t pieces(test::KioskStand& kiosk) {
    std::size_t count = 0;
    for (const core::NetworkRegion& region : kiosk.garment->desk().network().regions()) count += region.alive ? 1 : 0;
    return count;
}

void open_gallery(test::GarmentHand& hand, test::KioskStand& kiosk) {
    if (state(kiosk).page != 2) hand.press(A::Page, 2);
    hand.press(A::Designs);
    REQUIRE(kiosk.garment->gallery() != nullptr);
}

void press(test::KioskStand& kiosk, std::size_t item) {
    const app::GalleryDesk* gallery = kiosk.garment->gallery();
    REQUIRE(gallery != nullptr);
    for (const ui::BoardTouch::Target& target : gallery->page(kSize, std::nullopt).targets) {
        if (target.item != item) continue;
        kiosk.tap(target.rect);
        kiosk.wait(0.02);
        return;
    }
    FAIL("the gallery has no such control now");
}

void press(test::KioskStand& kiosk, G action, std::size_t index = 0) {
    press(kiosk, ui::gallery_item(action, index));
}

void write(test::KioskStand& kiosk, const std::string& name) {
    const auto key = [&](auto wanted) {
        const auto keys =
            ui::keyboard_layout(*kiosk.garment->gallery()->state().rename, kiosk.languages[0], kSize).keys;
        for (std::size_t k = 0; k < keys.size(); ++k)
            if (wanted(keys[k])) return press(kiosk, G::Key, k);
        FAIL("there is no such key");
    };
    for (const char letter : name) key([&](const ui::KeyboardKey& k) { return k.letter == std::string(1, letter); });
    key([](const ui::KeyboardKey& k) { return k.kind == ui::KeyboardKey::Kind::Save; });
}

std::vector<std::string> names(test::KioskStand& kiosk) {
    std::vector<std::string> out;
    for (const ui::GalleryCard& card : kiosk.garment->gallery()->state().cards) out.push_back(card.name);
    return out;
}

/// The first card whose name begins so.
std::size_t card(test::KioskStand& kiosk, const std::string& name) {
    const std::vector<std::string> all = names(kiosk);
    for (std::size_t k = 0; k < all.size(); ++k)
        if (all[k].rfind(name, 0) == 0) return k;
    FAIL("no design is called " + name);
    return 0;
}

/// A line and then a short one: two acts, quickly drawn.
void draw_lines(test::GarmentHand& hand) {
    hand.draw({{2, 106}, {10, 106.3}});
    hand.draw({{3, 120}, {9, 121}});
}

}  // namespace

TEST_CASE("a design that was drawn is in the gallery with its picture, and opens as it was left", "[garment keep]") {
    const support::TemporaryFolder folder;
    std::string drawn;
    {
        test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, keeping_in(folder));
        test::GarmentHand hand(kiosk);
        hand.enter();
        hand.skirt();
        kiosk.tap(kiosk.garment->layout().undo);  // one act can be done again
        drawn = core::design_text(kiosk.garment->design());
        kiosk.garment->settle(kiosk.now_us);
        kiosk.garment->wipe(0, ui::Hand::Right);
    }
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, keeping_in(folder));  // the next morning
    test::GarmentHand hand(kiosk);
    hand.enter();
    open_gallery(hand, kiosk);
    REQUIRE(names(kiosk).size() == 1);
    CHECK(kiosk.garment->gallery()->state().cards[0].picture);
    press(kiosk, G::Open, 0);
    CHECK(kiosk.garment->gallery() == nullptr);
    CHECK(core::design_text(kiosk.garment->design()) == drawn);
    CHECK(state(kiosk).can_redo);
    kiosk.tap(kiosk.garment->layout().redo);
    CHECK(pieces(kiosk) == 2);
}

TEST_CASE("designs are renamed, copied, deleted and put back by touch", "[garment keep]") {
    const support::TemporaryFolder folder;
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, keeping_in(folder));
    test::GarmentHand hand(kiosk);
    hand.enter();
    draw_lines(hand);
    const std::string first = core::design_text(kiosk.garment->design());
    hand.press(A::Page, 2);
    hand.press(A::New);
    hand.draw({{2, 90}, {9, 90}});
    open_gallery(hand, kiosk);
    REQUIRE(names(kiosk).size() == 2);
    CHECK(kiosk.garment->gallery()->state().cards[0].open);  // the newest, on the sheet
    press(kiosk, G::Rename, 1);
    write(kiosk, "Gown");
    press(kiosk, G::Duplicate, card(kiosk, "Gown"));
    REQUIRE(names(kiosk).size() == 3);
    press(kiosk, G::Delete, card(kiosk, "Gown – "));  // the copy
    CHECK(names(kiosk).size() == 2);
    CHECK_FALSE(kiosk.garment->gallery()->state().deleted.empty());
    press(kiosk, G::Shelf, 1);
    REQUIRE(names(kiosk).size() == 1);
    press(kiosk, G::Restore, 0);
    CHECK(names(kiosk).empty());
    press(kiosk, G::Shelf, 0);
    CHECK(names(kiosk).size() == 3);
    CHECK(card(kiosk, "Gown – ") < 3);
    const std::vector<std::string> all = names(kiosk);
    press(kiosk, G::Open, static_cast<std::size_t>(std::find(all.begin(), all.end(), "Gown") - all.begin()));
    core::Design opened = kiosk.garment->design();
    CHECK(opened.name == "Gown");
    opened.name = core::parse_design(first)->name;
    CHECK(core::design_text(opened) == first);
}

TEST_CASE("the design on the sheet is renamed while it is drawn on", "[garment keep]") {
    const support::TemporaryFolder folder;
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, keeping_in(folder));
    test::GarmentHand hand(kiosk);
    hand.enter();
    draw_lines(hand);
    open_gallery(hand, kiosk);
    press(kiosk, G::Rename, 0);
    write(kiosk, "Coat");
    press(kiosk, G::Close);
    hand.draw({{4, 90}, {9, 90}});
    kiosk.garment->wipe(0, ui::Hand::Right);
    const auto store = db::DesignStore::open(folder.path("designs.db"), db::OpenMode::ReadOnly);
    REQUIRE(store);
    const auto kept = store->list(db::Shelf::Kept);
    REQUIRE(kept);
    REQUIRE(kept->size() == 1);
    CHECK(kept->front().name == "Coat");
    const auto whole = store->load(kept->front().id);
    REQUIRE(whole);
    CHECK(whole->state.design.steps.size() == 3);
}

TEST_CASE("a wipe leaves nothing of a visitor on the screen, and what was drawn in the file", "[garment keep]") {
    core::RgbaImage empty;
    {
        const support::TemporaryFolder folder;
        test::KioskStand fresh(kSize, {}, {}, {}, nullptr, keeping_in(folder));
        test::GarmentHand(fresh).enter();
        empty = fresh.picture();
    }
    const support::TemporaryFolder own;
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, keeping_in(own));
    test::GarmentHand hand(kiosk);
    hand.enter();
    draw_lines(hand);
    open_gallery(hand, kiosk);
    press(kiosk, G::Rename, 0);
    write(kiosk, "Anna");
    kiosk.garment->wipe(0, ui::Hand::Right);  // with the gallery open
    CHECK(kiosk.garment->gallery() == nullptr);
    CHECK_FALSE(kiosk.garment->has_work());
    CHECK(kiosk.garment->design().name.empty());
    CHECK(state(kiosk).history.empty());
    CHECK(state(kiosk).rows.size() == 2);
    const bool same = kiosk.picture().pixels == empty.pixels;
    CHECK(same);
    const auto store = db::DesignStore::open(own.path("designs.db"), db::OpenMode::ReadOnly);
    REQUIRE(store);
    CHECK(store->list(db::Shelf::Kept)->size() == 1);
}

TEST_CASE("a garment is exported to a folder by two presses", "[garment keep]") {
    const support::TemporaryFolder folder;
    std::filesystem::create_directories(folder.path("taken"));
    test::KioskStand kiosk(kSize, {}, {}, {}, nullptr, keeping_in(folder));
    test::GarmentHand hand(kiosk);
    hand.enter();
    hand.press(A::Export);
    CHECK_THROWS(hand.press(A::ExportAs, 2));  // nothing is drawn
    hand.press(A::Done);
    hand.open("skirt_flat");
    hand.press(A::Export);
    hand.press(A::ExportAs, 2);  // a pattern for cutting
    for (int k = 0; k < 6000 && kiosk.garment->export_state().stage != app::ExportState::Stage::Saved; ++k) {
        REQUIRE(kiosk.garment->export_state().stage != app::ExportState::Stage::Failed);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    const app::ExportState done = kiosk.garment->export_state();
    REQUIRE(done.stage == app::ExportState::Stage::Saved);
    CHECK(state(kiosk).export_message.find(done.folder.string()) != std::string::npos);
    std::size_t dxf = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(done.folder))
        dxf += entry.path().extension() == ".dxf" ? 1 : 0;
    CHECK(dxf == 1);
    hand.press(A::Done);
    kiosk.garment->wipe(0, ui::Hand::Right);  // the next visitor reads nothing of it
    hand.enter();
    hand.press(A::Export);
    CHECK(state(kiosk).export_message.empty());
}
