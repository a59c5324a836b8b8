#include "core/silhouette/drawing_readings.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace {

using core::Drawing;
using core::Point;

core::Stroke stroke(const std::vector<Point>& points) {
    core::Stroke out;
    for (const Point& p : points) {
        core::PenSample sample;
        sample.x = p.x;
        sample.y = p.y;
        out.samples.push_back(sample);
    }
    return out;
}

/// Part of a circle of radius 50, degrees.
core::Stroke arc(double from_deg, double to_deg) {
    std::vector<Point> points;
    for (int k = 0; k <= 100; ++k) {
        const double angle = (from_deg + (to_deg - from_deg) * k / 100.0) * std::numbers::pi / 180.0;
        points.push_back({50.0 * std::cos(angle), 50.0 * std::sin(angle)});
    }
    return stroke(points);
}

bool covers(const core::Silhouette& silhouette, Point p) {
    const Point at = silhouette.raster.to_raster(p);
    return silhouette.image.at(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))) != 0;
}

}  // namespace

TEST_CASE("a drawing whose outline is half open has two readings, the plain one first", "[readings]") {
    const Drawing open{{arc(25, 335)}};
    const auto readings = core::drawing_readings(open);
    REQUIRE(readings);
    REQUIRE(readings->size() == 2);
    CHECK((*readings)[0].image.pixels == core::silhouette_of(open)->pixels);
    CHECK_FALSE(covers(readings->front(), {0, 0}));
    CHECK(covers(readings->back(), {0, 0}));
}

TEST_CASE("a closed outline, a thin line and a solid picture have one reading", "[readings]") {
    CHECK(core::drawing_readings(Drawing{{arc(0, 360)}})->size() == 1);
    CHECK(core::drawing_readings(Drawing{{stroke({{0, 0}, {90, 20}})}})->size() == 1);
    core::GrayImage page(120, 80, 255);
    for (int y = 20; y < 60; ++y) {
        for (int x = 20; x < 100; ++x) page.at(x, y) = 0;
    }
    CHECK(core::drawing_readings(page)->size() == 1);
}

TEST_CASE("two parallel limbs are joined by no reading that is searched for", "[readings]") {
    // A long U whose legs stand apart by an eighth of their length.
    const Drawing legs{{stroke({{0, 0}, {0, 100}}), stroke({{12, 0}, {12, 100}})}};
    const auto readings = core::drawing_readings(legs);
    REQUIRE(readings);
    for (const core::Silhouette& s : *readings) CHECK_FALSE(covers(s, {6, 50}));
}

TEST_CASE("a drawing has the same readings at every step of its making", "[readings]") {
    core::LiveReadings live;
    Drawing drawing{{core::Stroke{}}};
    const core::Stroke whole = arc(25, 335);
    for (std::size_t k = 0; k < whole.samples.size(); ++k) {
        drawing.strokes[0].samples.push_back(whole.samples[k]);
        const auto plain = live.plain(drawing);
        if (k % 10 != 0 && k + 1 != whole.samples.size()) continue;
        const auto followed = live.all(drawing), in_one_go = core::drawing_readings(drawing);
        REQUIRE(followed.has_value() == in_one_go.has_value());
        REQUIRE(plain.has_value() == in_one_go.has_value());
        if (plain) CHECK((plain->image.pixels == in_one_go->front().image.pixels));
        if (!followed) continue;
        REQUIRE(followed->size() == in_one_go->size());
        for (std::size_t r = 0; r < followed->size(); ++r) {
            CHECK(((*followed)[r].image.pixels == (*in_one_go)[r].image.pixels));
        }
    }
}

TEST_CASE("readings are doubtful from one per cent of the object on", "[readings]") {
    core::Silhouette plain{core::BinaryImage(40, 30), {}};
    std::fill_n(plain.image.pixels.begin(), 1000, std::uint8_t{1});
    core::Silhouette wide = plain;
    CHECK_FALSE(core::is_doubtful(plain, wide));
    std::fill_n(wide.image.pixels.begin() + 1000, 10, std::uint8_t{1});
    CHECK_FALSE(core::is_doubtful(plain, wide));
    wide.image.pixels[1010] = 1;
    CHECK(core::is_doubtful(plain, wide));
    wide = plain;
    wide.raster.scale = 2.0;
    CHECK(core::is_doubtful(plain, wide));
    wide = plain;
    wide.raster.offset.x += 0.5;
    CHECK(core::is_doubtful(plain, wide));
}

TEST_CASE("readings with different margins are laid over each other", "[readings]") {
    core::Silhouette plain{core::BinaryImage(40, 30), {}}, wide{core::BinaryImage(50, 33), {}};
    wide.raster.offset = {7.0, 2.0};
    for (int y = 5; y < 25; ++y) {
        for (int x = 5; x < 35; ++x) {
            plain.image.at(x, y) = 1;
            wide.image.at(x + 7, y + 2) = 1;
        }
    }
    CHECK_FALSE(core::is_doubtful(plain, wide));
    CHECK_FALSE(core::is_doubtful(wide, plain));
    for (int y = 10; y < 18; ++y) wide.image.at(49, y) = 1;  // beyond the plain one's raster
    CHECK(core::is_doubtful(plain, wide));
    wide.raster.offset = {8.0, 2.0};
    CHECK(core::is_doubtful(plain, wide));
}

TEST_CASE("what has no silhouette has no readings", "[readings]") {
    CHECK(core::drawing_readings(Drawing{}).error().code == core::ErrorCode::EmptyDrawing);
    CHECK(core::drawing_readings(core::GrayImage(20, 20, 255)).error().code == core::ErrorCode::EmptyDrawing);
}
