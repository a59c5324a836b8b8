#include "tests/support/scenes.hpp"

namespace test {
namespace {

using app::CollectionState;

app::ShellOptions with(CollectionState state) {
    app::ShellOptions options;
    options.collection = state;
    return options;
}

/// Strong colours of parts, no shadow.
app::ShellOptions strong_and_plain() {
    app::ShellOptions options;
    options.station.config.visitors.part_colours = "strong";
    options.station.config.visitors.shadow = false;
    return options;
}

app::ShellOptions in_language(std::size_t language) {
    app::ShellOptions options;
    options.language = language;
    return options;
}

void to_sheet(KioskStand& kiosk) {
    kiosk.shell->open_sheet(kiosk.now_us);
    kiosk.wait(0.1);
}

void to_drawing(KioskStand& kiosk) {
    to_sheet(kiosk);
    kiosk.draw_horse();
}

/// So much of the ink is there, the pen is down.
void to_share(KioskStand& kiosk, double share) {
    to_sheet(kiosk);
    kiosk.draw_horse(share);
}

/// Holds the corner.
void to_pin(KioskStand& kiosk) {
    to_sheet(kiosk);
    kiosk.event(ui::WindowEvent::Kind::Down, 20, 20);
    kiosk.wait(3.1);
    kiosk.event(ui::WindowEvent::Kind::Up, 20, 20);
}

app::CollectionStatus adding() {
    app::CollectionStatus status;
    status.models = 1258;
    status.views = 2516;
    status.median_search_ms = 74;
    status.can_add = status.importing = true;
    status.done = 26;
    status.total = 40;
    status.minutes_left = 3;
    return status;
}

/// What a station could tell of itself, the same in every picture.
app::StationFacts steady_facts() {
    app::StationFacts facts;
    facts.running_s = (12 * 24 + 4) * 3600;
    facts.worst_frame_ms = 17.1;
    facts.memory_mb = 214;
    facts.free_disk_gb = 41;
    return facts;
}

void to_station(KioskStand& kiosk) {
    to_pin(kiosk);
    kiosk.shell->set_facts(steady_facts());
    kiosk.type("000000");
    kiosk.wait(0.1);
}

void nothing(KioskStand& kiosk) {
    kiosk.wait(0.05);
}

}  // namespace

namespace {

std::vector<NamedScene> make_scenes() {
    app::ShellOptions left;
    left.hand = ui::Hand::Left;
    return {
        {"attract-line", {}, [](KioskStand& k) { k.wait(2.6); }},
        {"attract-form", {}, [](KioskStand& k) { k.wait(5.0); }},
        {"attract-formed-fr", in_language(1), [](KioskStand& k) { k.wait(7.0); }},
        {"sheet-empty", {}, to_sheet},
        {"drawing-25", {}, [](KioskStand& k) { to_share(k, 0.25); }},
        {"drawing-50", {}, [](KioskStand& k) { to_share(k, 0.5); }},
        {"drawing-75", {}, [](KioskStand& k) { to_share(k, 0.75); }},
        {"drawing", {}, to_drawing},
        {"drawing-strong-plain", strong_and_plain(), to_drawing},
        {"drawing-left-de",
         [&] {
             auto o = left;
             o.language = 2;
             return o;
         }(),
         to_drawing},
        {"detail-opening",
         {},
         [](KioskStand& k) {
             to_drawing(k);
             k.tap(k.find->layout().cards[0]);
             k.wait(0.1);
         }},
        {"detail",
         {},
         [](KioskStand& k) {
             to_drawing(k);
             k.tap(k.find->layout().cards[0]);
             k.wait(6);
         }},
        {"detail-turned-left", left,
         [](KioskStand& k) {
             to_drawing(k);
             k.tap(k.find->layout().cards[2]);
             k.wait(1);
             const ui::Rect s = k.shell->detail().layout().sheet;
             k.stroke(s.centre_x(), s.centre_y(), s.centre_x() + s.width * 0.2, s.centre_y() + s.height * 0.06);
             k.wait(0.1);
         }},
        {"pin",
         {},
         [](KioskStand& k) {
             to_pin(k);
             k.type("135");
         }},
        {"pin-wrong-fr", in_language(1),
         [](KioskStand& k) {
             to_pin(k);
             for (int i = 0; i < 3; ++i) k.type("135791");
         }},
        {"station", {}, to_station},
        {"station-adding-de", in_language(2),
         [](KioskStand& k) {
             k.collection.set_status(adding());
             to_station(k);
         }},
        {"station-align-de", in_language(2),
         [](KioskStand& k) {
             to_station(k);
             app::StationFacts with_tablet = steady_facts();
             with_tablet.tablets = {"Huion Kamvas Pro 16"};
             k.shell->set_facts(with_tablet);
             k.press_station(ui::StationAction::Align);
             k.wait(0.1);
         }},
        {"cleaning",
         {},
         [](KioskStand& k) {
             to_pin(k);
             k.type("000000");
             k.wait(0.1);
             k.press_station(ui::StationAction::Clean);
             k.wait(4);
         }},
        {"still-there",
         {},
         [](KioskStand& k) {
             to_drawing(k);
             k.wait(66.2);
         }},
        {"still-there-de", in_language(2),
         [](KioskStand& k) {
             to_drawing(k);
             k.wait(71);
         }},
        {"no-tablet",
         {},
         [](KioskStand& k) {
             k.shell->expect_tablet(k.now_us);
             k.wait(0.05);
         }},
        {"no-input-de", in_language(2),
         [](KioskStand& k) {
             k.shell->set_no_input("I2", k.now_us);
             k.wait(0.05);
         }},
        {"no-models", with(CollectionState::Empty), nothing},
        {"missing", with(CollectionState::Missing), nothing},
        {"damaged", with(CollectionState::Damaged), nothing},
        {"stale", with(CollectionState::Stale), nothing},
        {"building", with(CollectionState::Building),
         [](KioskStand& k) {
             k.shell->set_collection(CollectionState::Building, {412, 1258, 6}, k.now_us);
             k.wait(0.05);
         }},
    };
}

}  // namespace

std::vector<NamedScene> all_scenes() {
    std::vector<NamedScene> scenes = make_scenes();
    for (NamedScene& scene : scenes) {
        scene.large = !scene.name.ends_with("-fr") && !scene.name.ends_with("-de");
    }
    for (NamedScene& scene : garment_scenes()) scenes.push_back(std::move(scene));
    return scenes;
}

std::vector<ui::SizePx> all_sizes() {
    return {{1920, 1080}, {1280, 800}, {3840, 2160}, {1080, 1920}};
}

std::unique_ptr<KioskStand> stand_for(const NamedScene& scene, ui::SizePx size, std::shared_ptr<StandBase> base) {
    return std::make_unique<KioskStand>(size, scene.options, app::FindOptions{}, std::filesystem::path{},
                                        std::move(base),
                                        scene.garment_options ? scene.garment_options() : app::GarmentOptions{});
}

std::vector<core::RgbaImage> pictures_of(const NamedScene& scene, ui::SizePx size,
                                         const std::shared_ptr<StandBase>& base) {
    const std::unique_ptr<KioskStand> kiosk = stand_for(scene, size, base);
    scene.go(*kiosk);
    std::vector<core::RgbaImage> pictures;
    if (!scene.step) {
        pictures.push_back(kiosk->picture());
        return pictures;
    }
    for (std::size_t k = 0; scene.step(*kiosk, k); ++k) pictures.push_back(kiosk->picture());
    return pictures;
}

bool is_kept_at(const NamedScene& scene, ui::SizePx size) {
    if (scene.upright && size == ui::SizePx{1080, 1920}) return true;
    if (scene.garment) return size == ui::SizePx{1920, 1080} || size == ui::SizePx{1280, 800};
    return size.width <= 2000 || scene.large;
}

}  // namespace test
