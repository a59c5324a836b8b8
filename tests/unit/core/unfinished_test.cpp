#include "core/silhouette/unfinished.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace {

core::Drawing arc(double to_degrees) {
    core::Stroke stroke;
    for (int i = 0; i <= 60; ++i) {
        const double angle = to_degrees * i / 60 * std::numbers::pi / 180;
        stroke.samples.push_back({i * 1000, 50 * std::cos(angle), 50 * std::sin(angle), 1.0});
    }
    return {{stroke}};
}

std::optional<core::Silhouette> ahead(const core::Drawing& drawing) {
    const auto plain = core::find_silhouette(drawing, {});
    REQUIRE(plain);
    core::UnfinishedReading reading;
    return reading.look_ahead(drawing, *plain);
}

}  // namespace

TEST_CASE("an outline half drawn is seen as what it will enclose", "[unfinished]") {
    const auto seen = ahead(arc(200));
    REQUIRE(seen);
    const core::Point inside = seen->raster.to_raster({-10, 20});
    CHECK(seen->image.at(static_cast<int>(std::lround(inside.x)), static_cast<int>(std::lround(inside.y))) == 1);
}

TEST_CASE("a closed outline, and what closing would hardly change, stay as they are", "[unfinished]") {
    CHECK_FALSE(ahead(arc(360)));
    CHECK_FALSE(ahead(arc(350)));
    CHECK_FALSE(ahead({{{{{0, 0, 0, 1}, {1, 100, 0, 1}, {2, 200, 1, 1}}}}}));  // a line back and forth encloses nothing
}

TEST_CASE("a stroke that has only begun, and no stroke, have nothing to close", "[unfinished]") {
    core::Drawing drawing = arc(200);
    const auto plain = core::find_silhouette(drawing, {});
    core::UnfinishedReading reading;
    drawing.strokes.push_back({{{0, 0, 0, 1}}});
    CHECK_FALSE(reading.look_ahead(drawing, *plain));
    CHECK_FALSE(reading.look_ahead({}, *plain));
}
