#include "firmware_like_app/kiosk/station.hpp"

#include <catch2/catch.hpp>

using app::CollectionState;
using app::Scene;
using app::Station;

namespace {

constexpr std::int64_t kSecond = 1'000'000;

/// A station on a clock that the test moves.
struct Stand {
    std::int64_t now = 5 * kSecond;
    Station station;

    explicit Stand(CollectionState collection = CollectionState::Ready, app::StationTimes times = {})
        : station(times, collection, 5 * kSecond) {}
    /// In steps of a tenth of a second, as frames come.
    void wait(double seconds) {
        const std::int64_t end = now + static_cast<std::int64_t>(seconds * 1e6);
        while (now < end) {
            now = std::min(now + kSecond / 10, end);
            station.tick(now);
        }
    }
    Scene scene() const { return station.scene(); }
    void draw() {
        station.wake(now);
        station.touched(now);
        station.set_has_work(true);
    }
};

}  // namespace

TEST_CASE("start goes home: attract, or what is missing", "[station]") {
    CHECK(Stand().scene() == Scene::Attract);
    for (const CollectionState state : {CollectionState::Building, CollectionState::Empty, CollectionState::Missing,
                                        CollectionState::Damaged, CollectionState::Stale}) {
        Stand stand(state);
        CHECK(stand.scene() == Scene::Notice);
        stand.station.leave_notice(stand.now);
        CHECK(stand.scene() == Scene::Work);
        stand.wait(31);
        CHECK(stand.scene() == Scene::Notice);
    }
}

TEST_CASE("attract stays for hours, and a tip or a near pen wakes it", "[station]") {
    Stand stand;
    stand.wait(3600);
    CHECK(stand.scene() == Scene::Attract);
    CHECK(stand.station.wipes() == 0);
    CHECK(stand.station.wake(stand.now));
    CHECK(stand.scene() == Scene::Work);
    CHECK_FALSE(stand.station.wake(stand.now));
}

TEST_CASE("an empty sheet goes to attract after 30 seconds without asking", "[station]") {
    Stand stand;
    stand.station.wake(stand.now);
    stand.wait(29.5);
    CHECK(stand.scene() == Scene::Work);
    stand.wait(0.6);
    CHECK(stand.scene() == Scene::Attract);
    CHECK(stand.station.wipes() == 1);
}

TEST_CASE("a drawing is asked about after 60 seconds and wiped after 20 more", "[station]") {
    for (const bool in_detail : {false, true}) {
        Stand stand;
        stand.draw();
        if (in_detail) stand.station.open_detail(stand.now);
        stand.wait(59.5);
        CHECK(stand.scene() == (in_detail ? Scene::Detail : Scene::Work));
        stand.wait(0.6);
        REQUIRE(stand.scene() == Scene::StillThere);
        CHECK(stand.station.behind() == (in_detail ? Scene::Detail : Scene::Work));
        CHECK(stand.station.left_us(stand.now) <= 20 * kSecond);
        stand.wait(19.5);
        CHECK(stand.scene() == Scene::StillThere);
        CHECK(stand.station.left_us(stand.now) > 0);
        stand.wait(0.6);
        CHECK(stand.scene() == Scene::Attract);
        CHECK(stand.station.wipes() == 1);
    }
}

TEST_CASE("answers to still there: keep drawing, start over", "[station]") {
    Stand stand;
    stand.draw();
    stand.station.open_detail(stand.now);
    stand.wait(61);
    stand.station.keep_drawing(stand.now);
    CHECK(stand.scene() == Scene::Detail);
    CHECK(stand.station.wipes() == 0);
    stand.wait(59);  // time begins anew
    CHECK(stand.scene() == Scene::Detail);
    stand.wait(2);
    REQUIRE(stand.scene() == Scene::StillThere);
    stand.station.start_over(stand.now);
    CHECK(stand.scene() == Scene::Attract);
    CHECK(stand.station.wipes() == 1);
}

TEST_CASE("Garment asks later", "[station]") {
    Stand stand;
    stand.draw();
    stand.station.set_garment(true);
    stand.wait(179);
    CHECK(stand.scene() == Scene::Work);
    stand.wait(1.2);
    CHECK(stand.scene() == Scene::StillThere);
}

TEST_CASE("input puts the question off; a pen that lies there does so for ten minutes", "[station]") {
    Stand stand;
    stand.draw();
    for (int i = 0; i < 10; ++i) {
        stand.wait(50);
        stand.station.touched(stand.now);
    }
    CHECK(stand.scene() == Scene::Work);
    double lain = 0;
    while (stand.scene() == Scene::Work && lain < 1000) {
        stand.station.pen_near(false, stand.now);
        stand.wait(1);
        ++lain;
    }
    CHECK(lain >= 600 + 59);
    CHECK(lain <= 600 + 62);
    CHECK(stand.scene() == Scene::StillThere);

    Stand moved;
    moved.draw();
    for (int i = 0; i < 1200; ++i) {
        moved.station.pen_near(true, moved.now);
        moved.wait(1);
    }
    CHECK(moved.scene() == Scene::Work);
}

TEST_CASE("detail opens from work and goes back to it", "[station]") {
    Stand stand;
    stand.station.open_detail(stand.now);
    CHECK(stand.scene() == Scene::Attract);
    stand.draw();
    stand.station.open_detail(stand.now);
    CHECK(stand.scene() == Scene::Detail);
    stand.station.keep_drawing(stand.now);
    CHECK(stand.scene() == Scene::Work);
    CHECK(stand.station.wipes() == 0);
}

TEST_CASE("a language chosen on attract goes when nobody stays", "[station]") {
    Stand stand;
    stand.station.touched(stand.now);
    stand.wait(29);
    CHECK(stand.station.wipes() == 0);
    stand.wait(1.2);
    CHECK(stand.station.wipes() == 1);
    CHECK(stand.scene() == Scene::Attract);
    stand.wait(100);
    CHECK(stand.station.wipes() == 1);
}

TEST_CASE("a missing tablet changes home only, and its page goes by itself", "[station]") {
    Stand stand;
    stand.station.set_tablet(false, stand.now);
    CHECK(stand.scene() == Scene::Attract);  // none was ever there, none is expected
    stand.station.set_tablet(true, stand.now);
    stand.station.set_tablet(false, stand.now);
    CHECK(stand.scene() == Scene::Notice);
    stand.station.set_tablet(true, stand.now);
    CHECK(stand.scene() == Scene::Attract);
    stand.draw();
    stand.station.set_tablet(false, stand.now);
    CHECK(stand.scene() == Scene::Work);
    CHECK(stand.station.tablet_is_missed());
    stand.wait(90);
    CHECK(stand.scene() == Scene::Notice);
    stand.station.leave_notice(stand.now);
    CHECK(stand.scene() == Scene::Work);

    Stand expected;
    expected.station.expect_tablet(expected.now);
    CHECK(expected.scene() == Scene::Notice);
}

TEST_CASE("the collection gets ready while its page is shown, or while someone draws", "[station]") {
    Stand waiting(CollectionState::Building);
    waiting.station.set_collection(CollectionState::Ready, waiting.now);
    CHECK(waiting.scene() == Scene::Attract);

    Stand drawing(CollectionState::Building);
    drawing.station.leave_notice(drawing.now);
    drawing.draw();
    drawing.station.set_collection(CollectionState::Ready, drawing.now);
    CHECK(drawing.scene() == Scene::Work);
    drawing.wait(81);
    CHECK(drawing.scene() == Scene::Attract);
}

TEST_CASE("the PIN page opens from every visitor's screen and goes back to it", "[station]") {
    const auto back_from = [](Stand& stand, Scene expected) {
        stand.station.open_pin(stand.now);
        REQUIRE(stand.scene() == Scene::Pin);
        stand.station.leave_pin(stand.now);
        CHECK(stand.scene() == expected);
        stand.station.open_pin(stand.now);
        stand.wait(21);
        CHECK(stand.scene() == expected);
        CHECK(stand.station.wipes() == 0);
    };
    Stand attract, work, detail, empty(CollectionState::Empty), asked;
    back_from(attract, Scene::Attract);
    work.draw();
    back_from(work, Scene::Work);
    detail.draw();
    detail.station.open_detail(detail.now);
    back_from(detail, Scene::Detail);
    back_from(empty, Scene::Notice);
    asked.draw();
    asked.wait(61);
    back_from(asked, Scene::Work);  // somebody is there
}

TEST_CASE("behind the PIN page the collection may have got ready", "[station]") {
    Stand stand(CollectionState::Building);
    stand.station.open_pin(stand.now);
    stand.station.set_collection(CollectionState::Ready, stand.now);
    CHECK(stand.scene() == Scene::Pin);
    stand.station.leave_pin(stand.now);
    CHECK(stand.scene() == Scene::Attract);
}

TEST_CASE("the operator's page needs the PIN page, closes when left, and not while it works", "[station]") {
    Stand stand;
    stand.station.open_operator(stand.now);
    CHECK(stand.scene() == Scene::Attract);
    stand.draw();
    stand.station.open_pin(stand.now);
    stand.station.open_operator(stand.now);
    REQUIRE(stand.scene() == Scene::Operator);
    stand.station.set_busy(true);
    stand.wait(400);
    CHECK(stand.scene() == Scene::Operator);
    stand.station.set_busy(false);
    stand.wait(119);
    CHECK(stand.scene() == Scene::Operator);
    stand.wait(1.2);
    CHECK(stand.scene() == Scene::Attract);
    CHECK(stand.station.wipes() == 1);  // no visitor's drawing outlives the operator's visit

    stand.station.open_pin(stand.now);
    stand.station.open_operator(stand.now);
    stand.station.close_operator(stand.now);
    CHECK(stand.scene() == Scene::Attract);
}

TEST_CASE("cleaning ends 30 seconds after the last touch, back on the operator's page", "[station]") {
    Stand stand;
    stand.station.clean_screen(stand.now);
    CHECK(stand.scene() == Scene::Attract);
    stand.station.open_pin(stand.now);
    stand.station.open_operator(stand.now);
    stand.station.clean_screen(stand.now);
    REQUIRE(stand.scene() == Scene::Cleaning);
    stand.wait(20);
    stand.station.touched(stand.now);
    stand.wait(29);
    CHECK(stand.scene() == Scene::Cleaning);
    CHECK(stand.station.left_us(stand.now) <= kSecond);
    stand.wait(1.2);
    CHECK(stand.scene() == Scene::Operator);
    stand.station.open_pin(stand.now);  // no way back from inside
    CHECK(stand.scene() == Scene::Operator);
}

TEST_CASE("calls that do not fit the scene change nothing", "[station]") {
    Stand stand;
    stand.station.keep_drawing(stand.now);
    stand.station.start_over(stand.now);
    stand.station.leave_pin(stand.now);
    stand.station.close_operator(stand.now);
    stand.station.leave_notice(stand.now);
    CHECK(stand.scene() == Scene::Attract);
    CHECK(stand.station.wipes() == 0);
}
