#include "firmware_like_app/kiosk/operator_desk.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "tests/support/kiosk_stand.hpp"
#include "tests/support/temporary_folder.hpp"

using app::Scene;
using Kind = ui::WindowEvent::Kind;
using ui::StationAction;

namespace {

constexpr ui::SizePx kSize{1920, 1080};

void hold_corner(test::KioskStand& kiosk) {
    kiosk.event(Kind::Down, 20, 20);
    kiosk.wait(3.1);
    kiosk.event(Kind::Up, 20, 20);
}

void open_station(test::KioskStand& kiosk) {
    hold_corner(kiosk);
    REQUIRE(kiosk.scene() == Scene::Pin);
    kiosk.type("000000");
    REQUIRE(kiosk.scene() == Scene::Operator);
    kiosk.wait(0.05);
}

bool shows(const ui::StationPage& page, const std::string& words) {
    for (const ui::DrawCommand& command : page.list.commands) {
        const auto* text = std::get_if<ui::TextCommand>(&command);
        if (text != nullptr && text->text.find(words) != std::string::npos) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("the corner held for three seconds opens the PIN page, shorter or elsewhere does not", "[operator]") {
    test::KioskStand kiosk(kSize);
    kiosk.shell->open_sheet(kiosk.now_us);
    kiosk.event(Kind::Down, 20, 20);
    kiosk.wait(2.5);
    kiosk.event(Kind::Up, 20, 20);
    kiosk.wait(1);
    CHECK(kiosk.scene() == Scene::Work);
    kiosk.event(Kind::Down, 1500, 500);
    kiosk.wait(4);
    kiosk.event(Kind::Up, 1500, 500);
    CHECK(kiosk.scene() == Scene::Work);
    hold_corner(kiosk);
    CHECK(kiosk.scene() == Scene::Pin);
}

TEST_CASE("the corner works on attract, on notices and in detail, and the drawing is still there after cancel",
          "[operator]") {
    test::KioskStand attract(kSize);
    hold_corner(attract);
    CHECK(attract.scene() == Scene::Pin);
    app::ShellOptions empty;
    empty.collection = app::CollectionState::Empty;
    test::KioskStand notice(kSize, empty);
    hold_corner(notice);
    CHECK(notice.scene() == Scene::Pin);
    test::KioskStand detail(kSize);
    detail.shell->open_sheet(detail.now_us);
    detail.draw_horse();
    detail.tap(detail.find->layout().cards[0]);
    REQUIRE(detail.scene() == Scene::Detail);
    hold_corner(detail);
    REQUIRE(detail.scene() == Scene::Pin);
    detail.wait(21);
    CHECK(detail.scene() == Scene::Detail);
    CHECK_FALSE(detail.find->sketch().empty());
}

TEST_CASE("wrong PINs wait, the right one opens the page", "[operator]") {
    test::KioskStand kiosk(kSize);
    hold_corner(kiosk);
    kiosk.type("123456");
    kiosk.type("123456");
    kiosk.type("123456");
    CHECK(kiosk.scene() == Scene::Pin);
    kiosk.type("000000");
    CHECK(kiosk.scene() == Scene::Pin);  // it waits
    for (int i = 0; i < 3; ++i) {
        kiosk.wait(15);
        if (kiosk.scene() != Scene::Pin) hold_corner(kiosk);
    }
    kiosk.type("000000");
    CHECK(kiosk.scene() == Scene::Operator);
}

TEST_CASE("closing wipes what the visitor left; the page closes by itself, but not during an import", "[operator]") {
    test::KioskStand kiosk(kSize);
    kiosk.shell->open_sheet(kiosk.now_us);
    kiosk.stroke(1000, 300, 1200, 400);
    open_station(kiosk);
    kiosk.press_station(StationAction::Close);
    CHECK(kiosk.scene() == Scene::Attract);
    CHECK(kiosk.find->sketch().empty());

    open_station(kiosk);
    app::CollectionStatus status;
    status.importing = true;
    kiosk.collection.set_status(status);
    kiosk.wait(300);
    CHECK(kiosk.scene() == Scene::Operator);
    kiosk.collection.set_status({});
    kiosk.wait(125);
    CHECK(kiosk.scene() == Scene::Attract);
}

TEST_CASE("settings take effect, are kept in the file, and hold for the next visitor", "[operator]") {
    const support::TemporaryFolder folder;
    app::ShellOptions options;
    options.station.config_file = folder.path("croquis.toml");
    std::string told;
    options.station.changed = [&told](const app::Config& config) { told = config.tablet.pressure; };
    test::KioskStand kiosk(kSize, options);
    open_station(kiosk);
    kiosk.press_station(StationAction::More, 0);
    kiosk.press_station(StationAction::More, 0);
    kiosk.press_station(StationAction::Less, 1);
    kiosk.press_station(StationAction::Language, 2);
    kiosk.press_station(StationAction::Hand, 0);
    kiosk.press_station(StationAction::Curve, 0);
    CHECK(told == "soft");
    const auto config = app::read_config(folder.path("croquis.toml"));
    REQUIRE(config);
    CHECK(config->idle.ask_s == 70);
    CHECK(config->idle.countdown_s == 15);
    CHECK(config->visitors.language == "de");
    CHECK(config->visitors.hand == "left");
    CHECK(config->tablet.pressure == "soft");
    CHECK(kiosk.shell->station().times().ask == 70'000'000);
    kiosk.press_station(StationAction::Close);
    CHECK(kiosk.find->language() == 2);
    CHECK(kiosk.find->hand() == ui::Hand::Left);
}

TEST_CASE("how the tablet is turned, the shadow and the colours of parts are set on the page", "[operator]") {
    const support::TemporaryFolder folder;
    app::ShellOptions options;
    options.station.config_file = folder.path("croquis.toml");
    options.station.config.tablet.align = {1, 0, 0.01, 0, 1, 0};
    app::Config told;
    options.station.changed = [&told](const app::Config& config) { told = config; };
    test::KioskStand kiosk(kSize, options);
    kiosk.shell->open_sheet(kiosk.now_us);
    kiosk.draw_horse();
    CHECK_FALSE(kiosk.find->state(kiosk.now_us).shadows.empty());
    const core::RgbaImage soft = kiosk.picture();
    open_station(kiosk);
    kiosk.press_station(StationAction::Turn, 2);
    CHECK(told.tablet.turn == "half");
    CHECK(told.tablet.align.empty());  // it was found the other way
    kiosk.press_station(StationAction::Shadow, 0);
    kiosk.press_station(StationAction::Colours, 1);
    const auto config = app::read_config(folder.path("croquis.toml"));
    REQUIRE(config);
    CHECK(config->tablet.turn == "half");
    CHECK_FALSE(config->visitors.shadow);
    CHECK(config->visitors.part_colours == "strong");
    CHECK(kiosk.shell->station_page(kiosk.now_us).list.commands.size() > 10);
    kiosk.press_station(StationAction::Close);
    kiosk.shell->open_sheet(kiosk.now_us);
    kiosk.draw_horse();
    CHECK(kiosk.find->state(kiosk.now_us).shadows.empty());
    const bool other_colours = kiosk.picture().pixels != soft.pixels;
    CHECK(other_colours);
    CHECK(ui::palette::chosen_parts() == ui::palette::PartPalette::Strong);
    ui::palette::choose_parts(ui::palette::PartPalette::Soft);
}

TEST_CASE("a folder is chosen and added, an import is shown and stopped, problems are listed", "[operator]") {
    const support::TemporaryFolder folder;
    (void)folder.write("sticks/animals/horse.off", "OFF\n");
    (void)folder.write("sticks/animals/wild/lion.OBJ", "");
    (void)folder.write("sticks/letters/readme.txt", "");
    app::ShellOptions options;
    options.station.media = folder.path("sticks");
    test::KioskStand kiosk(kSize, options);
    app::CollectionStatus status;
    status.can_add = true;
    status.problems = {"bad.off: it has no faces"};
    kiosk.collection.set_status(status);
    open_station(kiosk);
    kiosk.press_station(StationAction::Add);
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), "animals"));
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), "letters"));
    kiosk.press_station(StationAction::Folder, 1);
    CHECK_THROWS(kiosk.press_station(StationAction::AddThese));  // no models there
    kiosk.press_station(StationAction::FolderUp);
    kiosk.press_station(StationAction::Folder, 0);
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), "2 model files"));
    kiosk.press_station(StationAction::AddThese);
    REQUIRE(kiosk.collection.added.size() == 1);
    CHECK(kiosk.collection.added[0] == folder.path("sticks/animals"));

    status.importing = true;
    status.done = 26;
    status.total = 40;
    status.minutes_left = 3;
    kiosk.collection.set_status(status);
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), "26 done, 0 not readable, about 3 min left"));
    kiosk.press_station(StationAction::Stop);
    CHECK(kiosk.collection.stops == 1);
    kiosk.press_station(StationAction::Problems);
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), "bad.off"));
    kiosk.press_station(StationAction::LeaveList);
    CHECK_FALSE(shows(kiosk.shell->station_page(kiosk.now_us), "bad.off"));
}

TEST_CASE("the pen is tested: what is drawn is seen, with its pressure, and is no drawing", "[operator]") {
    test::KioskStand kiosk(kSize);
    open_station(kiosk);
    const auto before = kiosk.picture().pixels;
    const ui::Rect area = kiosk.shell->station_page(kiosk.now_us).test_area;
    kiosk.shell->pointer({Kind::Down, area.x + 20, area.y + 20, 0.3, kiosk.now_us, false});
    kiosk.shell->pointer({Kind::Move, area.x + 200, area.y + 90, 0.62, kiosk.now_us + 8000, false});
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), "62 %"));
    kiosk.shell->pointer({Kind::Up, area.x + 200, area.y + 90, 0.62, kiosk.now_us + 9000, false});
    const bool drawn = kiosk.picture().pixels != before;
    CHECK(drawn);
    CHECK(kiosk.find->sketch().empty());
}

TEST_CASE("exit must be held for a second; restart is a tap", "[operator]") {
    test::KioskStand kiosk(kSize);
    open_station(kiosk);
    kiosk.press_station(StationAction::Exit);
    kiosk.wait(1.5);
    CHECK_FALSE(kiosk.shell->exit_wanted());
    ui::Rect exit;
    for (const auto& target : kiosk.shell->station_page(kiosk.now_us).targets) {
        if (target.item == ui::station_item(StationAction::Exit)) exit = target.rect;
    }
    kiosk.event(Kind::Down, exit.centre_x(), exit.centre_y());
    kiosk.wait(0.9);
    CHECK_FALSE(kiosk.shell->exit_wanted());
    kiosk.wait(0.2);
    CHECK(kiosk.shell->exit_wanted());
    kiosk.event(Kind::Up, exit.centre_x(), exit.centre_y());
    CHECK_FALSE(kiosk.shell->restart_wanted());
    kiosk.press_station(StationAction::Restart);
    CHECK(kiosk.shell->restart_wanted());
}

TEST_CASE("cleaning takes no touch and comes back to the page", "[operator]") {
    test::KioskStand kiosk(kSize);
    open_station(kiosk);
    kiosk.press_station(StationAction::Clean);
    REQUIRE(kiosk.scene() == Scene::Cleaning);
    for (int i = 0; i < 5; ++i) {
        kiosk.stroke(100, 100 + i * 80, 1800, 150 + i * 80);
        kiosk.wait(2);
    }
    CHECK(kiosk.scene() == Scene::Cleaning);
    kiosk.wait(31);
    CHECK(kiosk.scene() == Scene::Operator);
    CHECK_FALSE(kiosk.shell->exit_wanted());
}

TEST_CASE("the self test and the report say what they found", "[operator]") {
    const support::TemporaryFolder folder;
    app::ShellOptions options;
    options.station.config.station.report_folder = folder.path("");
    options.station.config.station.place = "Room 4, west wall";
    test::KioskStand kiosk(kSize, options);
    open_station(kiosk);
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), "Room 4"));
    kiosk.press_station(StationAction::SelfTest);
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), "to look at"));  // no database is set
    kiosk.press_station(StationAction::SaveReport);
    std::string text;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path(""))) {
        std::ifstream in(entry.path());
        text.assign(std::istreambuf_iterator<char>(in), {});
    }
    CHECK(text.find("place: Room 4, west wall") != std::string::npos);
    CHECK(text.find("database: look at") != std::string::npos);
}

TEST_CASE("on every size and in every language the page holds its controls apart, and all can be reached",
          "[operator]") {
    test::KioskStand kiosk(kSize);
    const auto fonts = *ui::FontSet::load();
    const ui::StationScreen screen(fonts, kiosk.languages);
    for (const ui::SizePx size : {kSize, ui::SizePx{1280, 800}, ui::SizePx{3840, 2160}, ui::SizePx{1080, 1920}}) {
        for (std::size_t language = 0; language < kiosk.languages.size(); ++language) {
            ui::StationState state;
            state.language = language;
            const ui::StationPage page = screen.build(state, size);
            for (std::size_t i = 0; i < page.targets.size(); ++i) {
                const ui::Rect& a = page.targets[i].rect;
                CHECK(a.height >= 64);
                CHECK(a.x >= 0);
                CHECK(a.right() <= size.width);
                CHECK(a.bottom() <= size.height + page.most_scroll);
                for (std::size_t k = i + 1; k < page.targets.size(); ++k) {
                    const ui::Rect& b = page.targets[k].rect;
                    const bool apart = a.right() <= b.x + 0.01 || b.right() <= a.x + 0.01 || a.bottom() <= b.y + 0.01 ||
                                       b.bottom() <= a.y + 0.01;
                    CHECK(apart);
                }
            }
        }
    }
}

namespace {

app::StationFacts facts_with_tablet() {
    app::StationFacts facts;
    facts.tablets = {"Test tablet"};
    return facts;
}

/// A pen that says `place` of each cross, down and up.
void touch_crosses(test::KioskStand& kiosk, const std::function<core::Point(core::Point)>& place) {
    for (std::size_t i = 0; i < app::kCrossCount; ++i) {
        const core::Point p = place(app::cross_at(i));
        for (const Kind kind : {Kind::Down, Kind::Move, Kind::Up, Kind::Leave}) {
            ui::WindowEvent event{kind, p.x * kSize.width, p.y * kSize.height, 0.6, kiosk.now_us += 8'000, false};
            event.pen = true;
            kiosk.shell->pointer(event);
        }
    }
}

}  // namespace

TEST_CASE("pen and screen are aligned by touching nine crosses, and the file keeps it", "[operator]") {
    const support::TemporaryFolder folder;
    const std::string file = folder.path("croquis.toml");
    std::vector<std::vector<double>> told;
    app::ShellOptions options;
    options.station.config_file = file;
    options.station.config.tablet.align = {1, 0, 0.3, 0, 1, 0};
    options.station.changed = [&](const app::Config& config) { told.push_back(config.tablet.align); };
    test::KioskStand kiosk(kSize, options);
    open_station(kiosk);
    CHECK_THROWS(kiosk.press_station(StationAction::Align));  // there is no tablet
    kiosk.shell->set_facts(facts_with_tablet());
    kiosk.press_station(StationAction::Align);
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), kiosk.languages[0]["align_title"]));
    REQUIRE(told.size() == 1);
    CHECK(told[0].empty());  // while it lasts the pen is where the tablet says
    touch_crosses(kiosk, [](core::Point p) { return core::Point{p.x * 0.98 + 0.03, p.y * 1.01 - 0.02}; });
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), kiosk.languages[0]["align_done"]));
    REQUIRE(told.size() == 2);
    REQUIRE(told[1].size() == 6);
    CHECK(told[1][0] == Approx(1 / 0.98).margin(1e-5));
    CHECK(told[1][2] == Approx(-0.03 / 0.98).margin(1e-5));
    const auto kept = app::read_config(file);
    REQUIRE(kept);
    REQUIRE(kept->tablet.align.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) CHECK(kept->tablet.align[i] == Approx(told[1][i]).margin(1e-5));
}

TEST_CASE("an alignment that missed, was cancelled or was left is refused in words and changes nothing", "[operator]") {
    std::vector<std::vector<double>> told;
    app::ShellOptions options;
    options.station.config.tablet.align = {1, 0, 0.1, 0, 1, 0};
    options.station.changed = [&](const app::Config& config) { told.push_back(config.tablet.align); };
    test::KioskStand kiosk(kSize, options);
    open_station(kiosk);
    kiosk.shell->set_facts(facts_with_tablet());
    kiosk.press_station(StationAction::Align);
    int n = 0;
    touch_crosses(kiosk, [&](core::Point p) { return core::Point{p.x + (++n == 3 ? 0.09 : 0), p.y}; });
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), "not hit well enough"));
    CHECK(told.back() == options.station.config.tablet.align);
    kiosk.press_station(StationAction::Align);
    touch_crosses(kiosk, [](core::Point p) { return core::Point{p.x * 0.6 + 0.2, p.y * 0.6 + 0.2}; });
    CHECK(shows(kiosk.shell->station_page(kiosk.now_us), "seems to lie otherwise"));
    CHECK(told.back() == options.station.config.tablet.align);
    kiosk.press_station(StationAction::Align);
    CHECK(told.back().empty());
    kiosk.press_station(StationAction::LeaveAlign);
    CHECK(told.back() == options.station.config.tablet.align);
    kiosk.press_station(StationAction::Align);
    kiosk.wait(125);  // the page closes by itself
    CHECK(kiosk.scene() != Scene::Operator);
    CHECK(told.back() == options.station.config.tablet.align);
}

TEST_CASE("the pen test shows tilt and place, and how long the pen took to the screen", "[operator]") {
    test::KioskStand kiosk(kSize);
    open_station(kiosk);
    app::StationFacts facts = facts_with_tablet();
    facts.pen_to_screen_ms = 11.6;
    kiosk.shell->set_facts(facts);
    const ui::Rect area = kiosk.shell->station_page(kiosk.now_us).test_area;
    ui::WindowEvent event{Kind::Down, area.centre_x(), area.centre_y(), 0.5, kiosk.now_us, false};
    event.pen = true;
    event.tilt_rad = 0.5;
    kiosk.shell->pointer(event);
    const ui::StationPage page = kiosk.shell->station_page(kiosk.now_us);
    CHECK(shows(page, "29°"));
    CHECK(shows(page, "12 ms"));
    CHECK(shows(page, "50 %"));
}

TEST_CASE("more folders than fit are shown page by page", "[operator]") {
    const support::TemporaryFolder folder;
    for (int i = 0; i < 14; ++i) std::filesystem::create_directories(folder.path("f" + std::to_string(10 + i) + "/in"));
    app::ShellOptions options;
    options.station.media = std::filesystem::path(folder.path("x")).parent_path();
    test::KioskStand kiosk(kSize, options);
    app::CollectionStatus status;
    status.can_add = true;
    kiosk.collection.set_status(status);
    open_station(kiosk);
    kiosk.press_station(StationAction::Add);
    const auto page = [&] { return kiosk.shell->station_page(kiosk.now_us); };
    CHECK(shows(page(), "1–6 / 14"));
    CHECK(shows(page(), "f15"));
    CHECK_FALSE(shows(page(), "f16"));
    CHECK_THROWS(kiosk.press_station(StationAction::Earlier));
    kiosk.press_station(StationAction::Later);
    kiosk.press_station(StationAction::Later);
    CHECK(shows(page(), "13–14 / 14"));
    CHECK_THROWS(kiosk.press_station(StationAction::Later));
    kiosk.press_station(StationAction::Folder, 1);
    CHECK(shows(page(), "f23"));
    CHECK(shows(page(), "in"));
    kiosk.press_station(StationAction::FolderUp);
    CHECK(shows(page(), "1–6 / 14"));
}

TEST_CASE("while models are added the page says how many, how fast and how many could not be read", "[operator]") {
    test::KioskStand kiosk(kSize);
    app::CollectionStatus status;
    status.can_add = status.importing = true;
    status.total = 400;
    status.done = 20;
    kiosk.collection.set_status(status);
    open_station(kiosk);
    kiosk.wait(2.5);
    status.done = 60;
    status.unreadable = 1;
    status.minutes_left = 3;
    kiosk.collection.set_status(status);
    kiosk.wait(4);
    const ui::StationPage page = kiosk.shell->station_page(kiosk.now_us);
    CHECK(shows(page, "60 done, 1 not readable"));
    CHECK(shows(page, "a minute"));
    CHECK(shows(page, "3 min left"));
}

TEST_CASE("a tip that rests on the test area for long leaves a trail of bounded length", "[operator]") {
    test::KioskStand kiosk(kSize);
    kiosk.shell->open_sheet(kiosk.now_us);
    open_station(kiosk);
    app::OperatorDesk desk(kiosk.fonts(), kiosk.languages, {});
    desk.open();
    const ui::Rect area = desk.build(desk.state(0, kiosk.now_us), kSize).test_area;
    ui::WindowEvent pen{Kind::Down, area.centre_x(), area.centre_y(), 0.5, kiosk.now_us, false};
    pen.pen = true;
    const ui::StationState state = desk.state(0, kiosk.now_us);
    desk.pointer(pen, state, kSize);
    pen.kind = Kind::Move;
    for (int k = 0; k < 9000; ++k) {
        pen.time_us += 5'000;
        pen.x = area.centre_x() + k % 40;
        desk.pointer(pen, state, kSize);
    }
    const std::vector<ui::InkPiece> trail = desk.state(0, pen.time_us).trail;
    CHECK(trail.size() > 1000);
    CHECK(trail.size() <= 4000);
    CHECK(trail.back().x1 == static_cast<float>(pen.x));
}
