#include "ui/draw/ink_layer.hpp"

#include "tests/unit/ui/gl_fixture.hpp"

namespace {

core::Stroke line(double x0, double y0, double x1, double y1, int count, double pressure = 1.0) {
    core::Stroke stroke;
    for (int i = 0; i < count; ++i) {
        const double t = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        stroke.samples.push_back({i * 8000, x0 + (x1 - x0) * t, y0 + (y1 - y0) * t, pressure});
    }
    return stroke;
}

ui::InkLayer make_layer() {
    core::Result<ui::InkLayer> layer = ui::InkLayer::create({200, 120});
    REQUIRE(layer);
    return std::move(*layer);
}

int ink_at(const core::RgbaImage& image, int x, int y) {
    return test::pixel(image, x, y).r;
}

}  // namespace

TEST_CASE("ink appears where the pen went and nowhere else", "[ink]") {
    const auto context = test::gl();
    ui::InkLayer layer = make_layer();
    const std::vector<core::Stroke> strokes{line(20, 30, 180, 30, 20)};
    layer.update({strokes, false, 0, {}, 8.0});
    const core::RgbaImage image = layer.read_back();
    for (int x = 20; x < 180; x += 7) {
        CHECK(ink_at(image, x, 30) == 255);
        CHECK(ink_at(image, x, 27) == 255);
        CHECK(ink_at(image, x, 36) == 0);
        CHECK(ink_at(image, x, 24) == 0);
    }
    CHECK(ink_at(image, 17, 30) == 255);  // the round end
    CHECK(ink_at(image, 14, 30) == 0);
    CHECK(layer.inked().y >= 24);
    CHECK(layer.inked().bottom() <= 36);
}

TEST_CASE("a tip that only touches leaves a dot", "[ink]") {
    const auto context = test::gl();
    ui::InkLayer layer = make_layer();
    const std::vector<core::Stroke> strokes{line(100, 60, 100, 60, 1)};
    layer.update({strokes, false, 0, {}, 8.0});
    CHECK(ink_at(layer.read_back(), 100, 60) == 255);
    CHECK(ink_at(layer.read_back(), 107, 60) == 0);
}

TEST_CASE("a light hand draws a thinner line", "[ink]") {
    const auto context = test::gl();
    ui::InkLayer firm = make_layer(), light = make_layer();
    const std::vector<core::Stroke> hard{line(20, 60, 180, 60, 20, 1.0)}, soft{line(20, 60, 180, 60, 20, 0.1)};
    firm.update({hard, false, 0, {}, 12.0});
    light.update({soft, false, 0, {}, 12.0});
    CHECK(ink_at(firm.read_back(), 100, 56) == 255);
    CHECK(ink_at(light.read_back(), 100, 56) == 0);
    CHECK(ink_at(light.read_back(), 100, 60) > 200);
}

TEST_CASE("an update draws only what is new, however much is there", "[ink]") {
    const auto context = test::gl();
    ui::InkLayer layer = make_layer();
    std::vector<core::Stroke> strokes;
    for (int i = 0; i < 200; ++i) strokes.push_back(line(10, i % 100 + 10, 190, i % 90 + 15, 50));
    CHECK(layer.update({strokes, false, 0, {}, 4.0}) >= 200 * 49);
    CHECK(layer.update({strokes, false, 0, {}, 4.0}) == 0);
    strokes.push_back(line(10, 10, 14, 10, 2));
    CHECK(layer.update({strokes, true, 0, {}, 4.0}) == 0);  // its only span may still bend
    for (int i = 1; i <= 20; ++i) {
        strokes.back().samples.push_back({i, 14.0 + i * 4, 10, 1.0});
        CHECK(layer.update({strokes, true, 0, {}, 4.0}) == 1);
    }
}

TEST_CASE("drawing sample by sample gives the picture of drawing all at once", "[ink]") {
    const auto context = test::gl();
    core::Stroke bent;
    for (int i = 0; i < 60; ++i) {
        bent.samples.push_back({i, 20 + i * 2.6, 60 + 35 * std::sin(i * 0.3), 0.4 + 0.6 * std::abs(std::sin(i * 0.1))});
    }
    const std::vector<core::Stroke> whole{bent};
    ui::InkLayer at_once = make_layer(), growing = make_layer();
    at_once.update({whole, false, 0, {}, 7.0});
    std::vector<core::Stroke> part(1);
    for (const core::PenSample& s : bent.samples) {
        part[0].samples.push_back(s);
        growing.update({part, true, 0, {}, 7.0});
    }
    growing.update({part, false, 0, {}, 7.0});
    CHECK(growing.read_back().pixels == at_once.read_back().pixels);
}

TEST_CASE("the wet end is what the layer leaves out", "[ink]") {
    const std::vector<core::Stroke> open{line(20, 60, 100, 60, 3)};
    CHECK(ui::InkLayer::wet_end({open, true, 0, {}, 7.0}).size() == 1);
    CHECK(ui::InkLayer::wet_end({open, false, 0, {}, 7.0}).empty());
}

TEST_CASE("corners stay and bends are smooth", "[ink]") {
    // a square turn keeps its straight sides; a gentle turn leaves the chord
    const std::vector<core::PenSample> corner{{0, 0, 0, 1}, {1, 50, 0, 1}, {2, 50, 50, 1}};
    std::vector<ui::InkPiece> pieces;
    ui::append_ink_span(corner, 0, {}, 6, pieces);
    REQUIRE(pieces.size() == 1);
    const std::vector<core::PenSample> gentle{{0, 0, 0, 1}, {1, 50, 0, 1}, {2, 95, 20, 1}};
    pieces.clear();
    ui::append_ink_span(gentle, 1, {}, 6, pieces);
    REQUIRE(pieces.size() > 4);
    const ui::InkPiece& middle = pieces[pieces.size() / 2];
    const double chord_y = 20.0 * (middle.x0 - 50) / 45;
    CHECK(std::abs(middle.y0 - chord_y) > 0.3);
    CHECK(pieces.back().x1 == Approx(95));
    CHECK(pieces.back().y1 == Approx(20));
}
