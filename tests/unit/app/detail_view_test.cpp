#include "firmware_like_app/kiosk/detail_view.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <thread>

#include "tests/support/kiosk_stand.hpp"

using app::Scene;
using Kind = ui::WindowEvent::Kind;

namespace {

constexpr ui::SizePx kSize{1280, 800};

/// A stand with the card at a place on the rail opened.
std::unique_ptr<test::KioskStand> opened(std::size_t card) {
    auto kiosk = std::make_unique<test::KioskStand>(kSize);
    kiosk->shell->open_sheet(kiosk->now_us);
    kiosk->draw_horse();
    kiosk->tap(kiosk->find->layout().cards[card]);
    REQUIRE(kiosk->scene() == Scene::Detail);
    return kiosk;
}

ui::DetailState state(test::KioskStand& kiosk) {
    return kiosk.shell->detail().state(0, kiosk.now_us);
}

/// Frames and the time between them, until the model itself is shown.
void wait_for_model(test::KioskStand& kiosk) {
    for (int i = 0; i < 2000 && state(kiosk).model == ui::PictureId{}; ++i) {
        kiosk.wait(1.0 / 60);
        kiosk.shell->update_ink();
        kiosk.shell->use_spare_time();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    REQUIRE(state(kiosk).model != ui::PictureId{});
}

/// Mean of 0 ... 255 over the model's place, the second picture moved right by so many pixels.
double difference(const core::RgbaImage& a, const core::RgbaImage& b, const ui::Rect& place, int moved) {
    double sum = 0;
    int count = 0;
    for (int y = static_cast<int>(place.y); y < place.bottom(); ++y) {
        for (int x = static_cast<int>(place.x); x + moved < place.right(); ++x, ++count) {
            const auto at = [&](const core::RgbaImage& image, int column) {
                return int{image.pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                         static_cast<std::size_t>(column)) *
                                        4]};
            };
            sum += std::abs(at(a, x) - at(b, x + moved));
        }
    }
    return sum / std::max(count, 1);
}

}  // namespace

TEST_CASE("no frame waits for a model: its still picture grows to its place, and the model takes over there",
          "[detail]") {
    const auto kiosk = opened(0);
    kiosk->tap(kiosk->shell->detail().layout().back);
    kiosk->shell->detail().set_frames_are_seen(true);
    kiosk->tap(kiosk->find->layout().cards[0]);
    CHECK(state(*kiosk).model == ui::PictureId{});
    CHECK(state(*kiosk).still_opacity == 1);
    const double small = state(*kiosk).still_rect.width;
    kiosk->wait(0.33);  // without a step between frames: the still picture is in its place
    REQUIRE(state(*kiosk).opened == 1);
    CHECK(state(*kiosk).still_rect.width > 1.5 * small);
    CHECK(state(*kiosk).model_tags.empty());
    const core::RgbaImage still = kiosk->picture();
    const ui::DetailLayout layout = kiosk->shell->detail().layout();
    kiosk->tap(layout.sheet.right() - 30, layout.sheet.y + 100);  // no greeting
    wait_for_model(*kiosk);
    CHECK_FALSE(state(*kiosk).model_tags.empty());
    kiosk->wait(0.5);
    CHECK(state(*kiosk).still_opacity == 0);
    const core::RgbaImage model = kiosk->picture();
    const double as_shown = difference(still, model, layout.model, 0);
    CHECK(as_shown < 12);
    CHECK(difference(still, model, layout.model, 12) > 1.3 * as_shown);
}

TEST_CASE("a model that was made ready beside the frames is the one that is made at once", "[detail]") {
    const auto picture = [](bool beside) {
        const auto kiosk = opened(1);
        kiosk->tap(kiosk->shell->detail().layout().back);
        kiosk->shell->detail().set_frames_are_seen(beside);
        kiosk->tap(kiosk->find->layout().cards[1]);
        if (beside) wait_for_model(*kiosk);
        kiosk->wait(6);
        for (int i = 0; i < 16; ++i) kiosk->shell->update_ink();     // on a slow machine it comes to rest in pieces
        for (int i = 0; i < 8; ++i) kiosk->shell->use_spare_time();  // the other models' pictures
        return kiosk->picture().pixels;
    };
    const bool same = picture(true) == picture(false);
    CHECK(same);
}

TEST_CASE("a result that is left before its model is ready is not shown by the next", "[detail]") {
    const auto kiosk = opened(0);
    kiosk->tap(kiosk->shell->detail().layout().back);
    kiosk->shell->detail().set_frames_are_seen(true);
    kiosk->tap(kiosk->find->layout().cards[0]);
    kiosk->tap(kiosk->shell->detail().layout().similar[2]);  // while the first is on its way
    const std::string name = state(*kiosk).name;
    wait_for_model(*kiosk);
    CHECK(state(*kiosk).name == name);
    kiosk->tap(kiosk->shell->detail().layout().back);
    CHECK_FALSE(kiosk->shell->detail().is_open());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    kiosk->wait(0.1);
    kiosk->shell->use_spare_time();
    CHECK(kiosk->scene() == Scene::Work);
}

TEST_CASE("a card opens its model, and keep drawing gives the drawing back as it was", "[detail]") {
    test::KioskStand kiosk(kSize);
    kiosk.shell->open_sheet(kiosk.now_us);
    kiosk.draw_horse();
    const auto before = kiosk.picture().pixels;
    const std::uint64_t revision = kiosk.find->sketch().revision();
    kiosk.tap(kiosk.find->layout().cards[3]);
    REQUIRE(kiosk.scene() == Scene::Detail);
    CHECK(kiosk.shell->detail().index() == 3);
    kiosk.wait(0.5);
    const bool another = kiosk.picture().pixels != before;
    CHECK(another);
    kiosk.tap(kiosk.shell->detail().layout().back);
    CHECK(kiosk.scene() == Scene::Work);
    CHECK_FALSE(kiosk.shell->detail().is_open());
    CHECK(kiosk.find->sketch().revision() == revision);
    const bool same = kiosk.picture().pixels == before;
    CHECK(same);
}

TEST_CASE("numbers stand on drawing and model alike, and six others are shown", "[detail]") {
    const auto kiosk = opened(0);
    kiosk->wait(0.5);
    const ui::DetailState s = state(*kiosk);
    REQUIRE_FALSE(s.drawing_tags.empty());
    REQUIRE(s.model_tags.size() == s.drawing_tags.size());
    for (std::size_t i = 0; i < s.model_tags.size(); ++i) CHECK(s.model_tags[i].colour == s.drawing_tags[i].colour);
    CHECK(s.similar.size() == 6);
    for (const ui::SimilarCard& card : s.similar) CHECK(card.name != s.name);
}

TEST_CASE("the greeting turns once by 24 degrees and back, and ends with a touch", "[detail]") {
    const auto kiosk = opened(0);
    double most = 0;
    for (int i = 0; i < 45; ++i) {
        kiosk->wait(0.1);
        most = std::max(most, std::abs(state(*kiosk).azimuth));
    }
    CHECK(most == Approx(24 * 3.14159 / 180).epsilon(0.01));
    CHECK(state(*kiosk).azimuth == Approx(0).margin(1e-6));
    const std::uint64_t view = state(*kiosk).view;
    kiosk->wait(2);
    CHECK(state(*kiosk).view == view);  // a still picture is not drawn again

    const auto touched = opened(1);
    touched->wait(1);
    const ui::Rect sheet = touched->shell->detail().layout().sheet;
    touched->stroke(sheet.centre_x(), sheet.centre_y(), sheet.centre_x() + 100, sheet.centre_y());
    const double azimuth = state(*touched).azimuth;
    touched->wait(2);
    CHECK(state(*touched).azimuth == azimuth);
}

TEST_CASE("dragging turns, the wheel and the buttons zoom within bounds, and nothing turns by itself then",
          "[detail]") {
    const auto kiosk = opened(0);
    kiosk->wait(1);
    const ui::DetailLayout layout = kiosk->shell->detail().layout();
    kiosk->stroke(layout.sheet.centre_x(), layout.sheet.centre_y(), layout.sheet.centre_x() + 120,
                  layout.sheet.centre_y() + 40);
    const ui::DetailState turned = state(*kiosk);
    CHECK(turned.azimuth < -0.3);  // the knob follows the hand to the right
    CHECK(turned.elevation > 0.25);
    const auto at_rest = [&] {
        kiosk->wait(0.05);
        return kiosk->picture().pixels;
    };
    const auto first = at_rest();
    kiosk->tap(layout.larger);
    const auto larger = at_rest();
    CHECK((larger != first));
    kiosk->tap(layout.smaller);
    const bool same = at_rest() == first;
    CHECK(same);
    const auto turn_wheel = [&](double doublings) {
        ui::WindowEvent wheel;
        wheel.kind = Kind::Zoom;
        wheel.zoom = doublings;
        wheel.time_us = kiosk->now_us;
        kiosk->shell->pointer(wheel);
    };
    turn_wheel(-50);
    const auto least = at_rest();
    turn_wheel(-1);
    const bool bounded = at_rest() == least;
    CHECK(bounded);
    const double azimuth = state(*kiosk).azimuth;
    kiosk->wait(40);
    CHECK(state(*kiosk).azimuth == azimuth);
}

TEST_CASE("a result greets with one turn of 24 degrees and back in 4 s, which a touch ends", "[detail]") {
    const auto kiosk = opened(0);
    kiosk->wait(0.32 + 2);
    CHECK(std::abs(state(*kiosk).azimuth) == Approx(24 * 3.14159265 / 180).margin(0.005));
    kiosk->wait(2);
    CHECK(state(*kiosk).azimuth == Approx(0).margin(1e-3));
    kiosk->wait(45);  // and never again
    CHECK(state(*kiosk).azimuth == Approx(0).margin(1e-3));

    const auto touched = opened(0);
    touched->wait(1);
    const ui::Rect sheet = touched->shell->detail().layout().sheet;
    touched->tap(sheet.centre_x(), sheet.centre_y());
    const double azimuth = state(*touched).azimuth;
    CHECK(std::abs(azimuth) > 0.01);
    touched->wait(3);
    CHECK(state(*touched).azimuth == azimuth);
}

TEST_CASE("holding a number dims the others until it is let go", "[detail]") {
    const auto kiosk = opened(0);
    kiosk->wait(5);
    const ui::DetailTag tag = state(*kiosk).drawing_tags.at(1);
    kiosk->event(Kind::Down, tag.place.x, tag.place.y);
    CHECK(state(*kiosk).focus == std::optional<int>(tag.colour));
    kiosk->event(Kind::Up, tag.place.x, tag.place.y);
    CHECK_FALSE(state(*kiosk).focus);
    CHECK(kiosk->scene() == Scene::Detail);
}

TEST_CASE("another close model opens in place of the first", "[detail]") {
    const auto kiosk = opened(2);
    kiosk->wait(0.5);
    const std::string name = state(*kiosk).similar[0].name;
    kiosk->tap(kiosk->shell->detail().layout().similar[0]);
    CHECK(kiosk->scene() == Scene::Detail);
    CHECK(state(*kiosk).name == name);
    CHECK(state(*kiosk).similar.size() == 6);
}

TEST_CASE("turned to the back, parts that are behind others say so", "[detail]") {
    const auto kiosk = opened(0);
    kiosk->wait(5);
    const auto hidden = [&] {
        const std::vector<ui::DetailTag> tags = state(*kiosk).model_tags;
        return std::count_if(tags.begin(), tags.end(), [](const ui::DetailTag& t) { return t.hidden; });
    };
    const auto at_first = hidden();
    const ui::DetailLayout layout = kiosk->shell->detail().layout();
    const double half_turn_px = layout.ring_radius * 3.14159 / 2;
    for (int i = 0; i < 2; ++i) {
        const double x = layout.sheet.centre_x() - half_turn_px / 2, y = layout.sheet.centre_y();
        kiosk->stroke(x, y, x + half_turn_px, y);
    }
    kiosk->wait(0.1);
    CHECK(hidden() > at_first + 3);
}

TEST_CASE("no two lines of numbers cross, however the model is turned", "[detail]") {
    const auto kiosk = opened(0);
    const auto side = [](core::Point p, core::Point q, core::Point r) { return core::cross(q - p, r - p) > 0; };
    const ui::Rect sheet = kiosk->shell->detail().layout().sheet;
    for (int step = 0; step < 12; ++step) {
        kiosk->stroke(sheet.centre_x(), sheet.centre_y(), sheet.centre_x() + 130,
                      sheet.centre_y() + (step % 2 ? 10 : -10));
        const std::vector<ui::DetailTag> tags = state(*kiosk).model_tags;
        for (std::size_t i = 0; i < tags.size(); ++i) {
            for (std::size_t k = i + 1; k < tags.size(); ++k) {
                const auto &a = tags[i], &b = tags[k];
                const bool cross = side(a.anchor, a.place, b.anchor) != side(a.anchor, a.place, b.place) &&
                                   side(b.anchor, b.place, a.anchor) != side(b.anchor, b.place, a.place);
                CHECK_FALSE(cross);
            }
        }
    }
}

TEST_CASE("detail is asked about like a drawing, and comes back after keep drawing", "[detail]") {
    const auto kiosk = opened(0);
    kiosk->wait(67);
    REQUIRE(kiosk->scene() == Scene::StillThere);
    (void)kiosk->picture();
    kiosk->tap(560, 580);
    CHECK(kiosk->scene() == Scene::Detail);
    CHECK(kiosk->shell->detail().is_open());
    kiosk->wait(82);
    CHECK(kiosk->scene() == Scene::Attract);
    CHECK_FALSE(kiosk->shell->detail().is_open());
    CHECK(kiosk->find->sketch().empty());
}
