#include "firmware_like_app/kiosk/shadow_shape.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/support/figures.hpp"

namespace {

core::Polygon box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

core::Polygon laid(const core::Polygon& ring, const app::ViewPlace& place) {
    core::Polygon out;
    for (const core::Point& p : ring) out.push_back(place.to_drawing(p));
    return out;
}

/// A model whose parts lie on the drawing where that place has them.
app::FoundModel model_at(const app::ViewPlace& place) {
    app::FoundModel model;
    model.mirrored = place.mirrored;
    for (const core::Polygon& ring : {box(-0.6, -0.2, 0.5, 0.2), box(0.5, 0, 0.9, 0.6), box(-0.5, -0.8, -0.3, -0.2)}) {
        app::FoundPart part;
        part.colour = 0;
        part.on_view = ring;
        part.on_drawing = laid(ring, place);
        model.parts.push_back(part);
    }
    return model;
}

}  // namespace

TEST_CASE("a view is placed where its parts lie on the drawing, turned and flipped", "[shadow]") {
    for (const bool mirrored : {false, true}) {
        for (const double turn : {0.0, 0.3, 2.0, -1.2}) {
            const app::ViewPlace wanted{140, turn, {320, 210}, mirrored};
            const std::optional<app::ViewPlace> place = app::place_of_view(model_at(wanted));
            REQUIRE(place);
            CHECK(place->scale == Approx(140));
            CHECK(place->turn_rad == Approx(turn).margin(1e-9));
            for (const core::Point p : {core::Point{0.3, -0.7}, core::Point{-1, 1}}) {
                CHECK(core::distance(place->to_drawing(p), wanted.to_drawing(p)) < 1e-6);
                CHECK(core::distance(place->to_plane(place->to_drawing(p)), p) < 1e-9);
            }
        }
    }
}

TEST_CASE("parts that do not say so plainly turn nothing, and none place nothing", "[shadow]") {
    app::FoundModel model = model_at({100, 0, {0, 0}, false});
    for (app::FoundPart& part : model.parts) part.on_drawing = box(0, 0, 40, 40);  // all in one place
    const std::optional<app::ViewPlace> place = app::place_of_view(model);
    REQUIRE(place);
    CHECK(place->turn_rad == 0);
    model.parts.resize(1);
    CHECK(app::place_of_view(model));
    model.parts[0].on_drawing = {{1, 1}, {2, 2}, {3, 3}};
    CHECK_FALSE(app::place_of_view(model));
    model.parts.clear();
    CHECK_FALSE(app::place_of_view(model));
    CHECK(app::shadow_shape(model, {}).coverage.pixels.empty());
}

TEST_CASE("the shadow of a figure covers the drawing that its parts were laid over", "[shadow]") {
    test::FigureSearcher searcher(test::make_animals());
    const core::Drawing horse = test::make_horse_drawing();
    const app::SearchAnswer answer = searcher.search(horse, {});
    REQUIRE_FALSE(answer.best.empty());
    const app::ShadowShape shape = app::shadow_shape(answer.best.front(), app::extent_of(horse));
    REQUIRE_FALSE(shape.coverage.pixels.empty());
    CHECK(shape.coverage.width <= 400);
    CHECK(shape.coverage.height <= 400);
    int under = 0, all = 0;
    for (const core::Stroke& stroke : horse.strokes) {
        for (const core::PenSample& s : stroke.samples) {
            const int x = static_cast<int>((s.x - shape.left) / shape.width * shape.coverage.width);
            const int y = static_cast<int>((s.y - shape.top) / shape.height * shape.coverage.height);
            const bool inside = x >= 0 && y >= 0 && x < shape.coverage.width && y < shape.coverage.height;
            under += inside ? 1 : 0;
            ++all;
        }
    }
    CHECK(under > all * 0.8);
    double covered = 0;
    for (const std::uint8_t v : shape.coverage.pixels) covered += v / 255.0;
    CHECK(covered > 0.15 * static_cast<double>(shape.coverage.pixels.size()));
    CHECK(covered < 0.9 * static_cast<double>(shape.coverage.pixels.size()));
}

TEST_CASE("parts that would put the shadow elsewhere do not: it lies over the drawing, as large as that", "[shadow]") {
    test::FigureSearcher searcher(test::make_animals());
    const core::Drawing horse = test::make_horse_drawing();
    const app::Extent extent = app::extent_of(horse);
    app::FoundModel model = searcher.search(horse, {}).best.front();
    model.parts.resize(1);
    for (core::Point& p : model.parts[0].on_drawing) p = p * 0.1 + core::Point{900, 700};
    const app::ShadowShape shape = app::shadow_shape(model, extent);
    REQUIRE_FALSE(shape.coverage.pixels.empty());
    CHECK(shape.left + shape.width / 2 == Approx((extent.left + extent.right) / 2).margin(3));
    CHECK(shape.top + shape.height / 2 == Approx((extent.top + extent.bottom) / 2).margin(3));
    CHECK(std::hypot(shape.width, shape.height) == Approx(std::hypot(extent.width(), extent.height())).epsilon(0.03));
}
