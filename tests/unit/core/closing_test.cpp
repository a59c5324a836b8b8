#include "core/silhouette/closing.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using core::BinaryImage;
using core::Drawing;
using core::GrayImage;
using core::Point;
using core::Stroke;

namespace {

Stroke stroke(const std::vector<Point>& points) {
    Stroke result;
    for (const Point p : points) result.samples.push_back({0, p.x, p.y, 1.0});
    return result;
}

/// An arc of a circle, from and to in degrees.
Stroke arc(Point centre, double radius, double from, double to) {
    std::vector<Point> points;
    for (int i = 0; i <= 90; ++i) {
        const double angle = (from + (to - from) * i / 90.0) * std::numbers::pi / 180.0;
        points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return stroke(points);
}

core::Silhouette silhouette(const Drawing& drawing) {
    auto found = core::find_silhouette(drawing, {});
    REQUIRE(found);
    return *found;
}

bool covers(const core::Silhouette& s, Point p) {
    const Point q = s.raster.to_raster(p);
    const int x = static_cast<int>(std::lround(q.x)), y = static_cast<int>(std::lround(q.y));
    return x >= 0 && y >= 0 && x < s.image.width && y < s.image.height && s.image.at(x, y) == 1;
}

/// Area in the drawing's square units.
double area(const core::Silhouette& s) {
    double pixels = 0;
    for (const auto value : s.image.pixels) pixels += value;
    return pixels / (s.raster.scale * s.raster.scale);
}

/// Pieces (8-connected) and holes (4-connected paper that is not the outside), by flooding.
std::pair<int, int> pieces_and_holes(BinaryImage image) {
    const auto flood = [&image](int x0, int y0, bool diagonal) {
        const std::uint8_t value = image.at(x0, y0);
        std::vector<std::pair<int, int>> open{{x0, y0}};
        image.at(x0, y0) = 9;
        while (!open.empty()) {
            const auto [x, y] = open.back();
            open.pop_back();
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    if (!diagonal && dx != 0 && dy != 0) continue;
                    const int u = x + dx, v = y + dy;
                    if (u < 0 || v < 0 || u >= image.width || v >= image.height || image.at(u, v) != value) continue;
                    image.at(u, v) = 9;
                    open.emplace_back(u, v);
                }
            }
        }
    };
    int pieces = 0, papers = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.at(x, y) == 9) continue;
            const bool object = image.at(x, y) == 1;
            ++(object ? pieces : papers);
            flood(x, y, object);
        }
    }
    return {pieces, papers - 1};
}

GrayImage page_with(const Drawing& drawing, int size, std::uint8_t paper, std::uint8_t ink) {
    GrayImage page(size, size, paper);
    for (const Stroke& s : drawing.strokes) {
        for (std::size_t i = 1; i < s.samples.size(); ++i) {
            const Point a{s.samples[i - 1].x, s.samples[i - 1].y}, b{s.samples[i].x, s.samples[i].y};
            for (double t = 0; t <= 1.0; t += 0.02) {
                const Point p = a + (b - a) * t;
                page.at(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))) = ink;
            }
        }
    }
    return page;
}

const Drawing kOpenCircle{{arc({100, 100}, 50, 10, 350)}};

}  // namespace

TEST_CASE("a closed outline is filled", "[closing]") {
    const core::Silhouette s = silhouette({{stroke({{0, 0}, {100, 0}, {100, 60}, {0, 60}, {0, 0}})}});
    CHECK(covers(s, {50, 30}));
    CHECK_FALSE(covers(s, {-5, 30}));
    CHECK(area(s) == Approx(6000).epsilon(0.06));
    CHECK(pieces_and_holes(s.image) == std::pair{1, 0});
}

TEST_CASE("a small gap in an outline is closed, whatever the drawing's units", "[closing]") {
    for (const double unit : {0.001, 1.0, 10'000.0}) {
        const core::Silhouette s = silhouette({{arc({0, 0}, 50 * unit, 10, 350)}});
        CHECK(covers(s, {0, 0}));
        CHECK(area(s) / (unit * unit) == Approx(std::numbers::pi * 2500).epsilon(0.06));
        CHECK(pieces_and_holes(s.image) == std::pair{1, 0});
    }
}

TEST_CASE("a wide opening stays open", "[closing]") {
    const core::Silhouette s = silhouette({{arc({0, 0}, 50, 60, 300)}});
    CHECK_FALSE(covers(s, {0, 0}));
    CHECK(covers(s, {-50, 0}));
}

TEST_CASE("the space between parallel limbs is not filled, however narrow", "[closing]") {
    // A body with two legs that are single lines, 6 apart where the diagonal is 140.
    const core::Silhouette s = silhouette({{stroke({{0, 0}, {100, 0}, {100, 40}, {0, 40}, {0, 0}}),
                                            stroke({{47, 40}, {47, 100}}), stroke({{53, 40}, {53, 100}})}});
    CHECK(covers(s, {47, 80}));
    CHECK(covers(s, {53, 80}));
    CHECK_FALSE(covers(s, {50, 80}));
    CHECK(covers(s, {20, 20}));
}

TEST_CASE("a thin closed limb with a tiny gap is filled too", "[closing]") {
    const core::Silhouette s = silhouette({{stroke({{0, 0}, {100, 0}, {100, 40}, {0, 40}, {0, 0}}),
                                            stroke({{46, 40}, {46, 100}, {52.5, 100}}), stroke({{54, 99}, {54, 40}})}});
    CHECK(covers(s, {50, 80}));
}

TEST_CASE("stray marks are dropped and near pieces joined", "[closing]") {
    const Drawing drawing{{arc({0, 0}, 50, 0, 360), stroke({{53, 0}, {90, 0}}), stroke({{0, 80}, {2, 80}})}};
    const core::Silhouette s = silhouette(drawing);
    CHECK(covers(s, {0, 0}));
    CHECK(covers(s, {85, 0}));
    CHECK_FALSE(covers(s, {1, 80}));
    CHECK(pieces_and_holes(s.image) == std::pair{1, 0});
}

TEST_CASE("a stray mark far off does not change what small means", "[closing]") {
    Drawing drawing = kOpenCircle;
    drawing.strokes.push_back(stroke({{1000, 1000}, {1010, 1010}}));
    const core::Silhouette s = silhouette(drawing);
    CHECK(covers(s, {100, 100}));
    CHECK_FALSE(covers(s, {1005, 1005}));
    CHECK(area(s) == Approx(std::numbers::pi * 2500).epsilon(0.06));
}

TEST_CASE("strokes that enclose nothing stay as lines", "[closing]") {
    const core::Silhouette s = silhouette({{stroke({{0, 0}, {100, 0}})}});
    CHECK(covers(s, {50, 0}));
    CHECK(area(s) < 200);
    CHECK(pieces_and_holes(s.image) == std::pair{1, 0});
}

TEST_CASE("nothing and a dot are answered with a sentence", "[closing]") {
    CHECK(core::silhouette_of(Drawing{}).error().code == core::ErrorCode::EmptyDrawing);
    CHECK(core::silhouette_of(Drawing{}).error().message == "there is nothing drawn on the page; draw something");
    const auto dot = core::silhouette_of(Drawing{{stroke({{5, 5}, {5, 5}})}});
    CHECK(dot.error().code == core::ErrorCode::TooSmall);
    CHECK(dot.error().message == "the drawing is only a dot; draw something larger");
    core::SilhouetteOptions options;
    options.ink.least_diagonal = 3.0;
    CHECK(core::silhouette_of(Drawing{{stroke({{5, 5}, {6, 6}})}}, options).error().code == core::ErrorCode::TooSmall);

    CHECK(core::silhouette_of(GrayImage()).error().code == core::ErrorCode::EmptyDrawing);
    CHECK(core::silhouette_of(GrayImage(100, 100, 255)).error().code == core::ErrorCode::EmptyDrawing);
    CHECK(core::silhouette_of(GrayImage(1, 1, 0)).error().code == core::ErrorCode::EmptyDrawing);
    GrayImage speck(100, 100, 255);
    speck.at(50, 50) = 0;
    CHECK(core::silhouette_of(speck).error().code == core::ErrorCode::TooSmall);
}

TEST_CASE("line art is read in either polarity and when it is faint", "[closing]") {
    for (const auto& [paper, ink] : {std::pair{255, 0}, {0, 255}, {250, 200}, {40, 90}}) {
        DYNAMIC_SECTION("paper " << paper << ", ink " << ink) {
            const GrayImage page =
                page_with(kOpenCircle, 200, static_cast<std::uint8_t>(paper), static_cast<std::uint8_t>(ink));
            const auto s = core::find_silhouette(page, {});
            REQUIRE(s);
            CHECK(covers(*s, {100, 100}));
            CHECK(area(*s) == Approx(std::numbers::pi * 2500).epsilon(0.08));
            CHECK(pieces_and_holes(s->image) == std::pair{1, 0});
        }
    }
}

TEST_CASE("large pages keep their thin strokes", "[closing]") {
    const Drawing big{{arc({1500, 1500}, 1400, 5, 355)}};
    Drawing dense = big;
    for (auto& sample : dense.strokes[0].samples) sample.time_us = 0;
    GrayImage page(3000, 3000, 255);
    for (int i = 0; i < 200'000; ++i) {
        const double angle = (5 + 350.0 * i / 200'000) * std::numbers::pi / 180.0;
        page.at(static_cast<int>(1500 + 1400 * std::cos(angle)), static_cast<int>(1500 + 1400 * std::sin(angle))) = 0;
    }
    const auto s = core::find_silhouette(page, {});
    REQUIRE(s);
    CHECK(covers(*s, {1500, 1500}));
    CHECK(area(*s) == Approx(std::numbers::pi * 1400 * 1400).epsilon(0.06));
}

TEST_CASE("a picture that is a silhouette already keeps its shape and loses holes and lesser pieces", "[closing]") {
    for (const bool dark : {true, false}) {
        const std::uint8_t paper = dark ? 255 : 0, ink = dark ? 0 : 255;
        GrayImage page(120, 100, paper);
        for (int y = 20; y < 80; ++y) {
            for (int x = 10; x < 100; ++x) {
                const bool slot = x >= 50 && x < 53 && y < 60;  // a narrow notch that closing would lose
                const bool hole = x > 70 && x < 80 && y > 40 && y < 50;
                if (!slot && !hole) page.at(x, y) = ink;
            }
        }
        page.at(115, 5) = ink;
        const auto s = core::find_silhouette(page, {});
        REQUIRE(s);
        CHECK(s->raster.scale == 1.0);
        CHECK(area(*s) == 90 * 60 - 3 * 40);
        CHECK(covers(*s, {75, 45}));
        CHECK_FALSE(covers(*s, {51, 30}));
        CHECK_FALSE(covers(*s, {115, 5}));
    }
}

TEST_CASE("the raster maps to the drawing and back", "[closing]") {
    const core::Silhouette s = silhouette({{stroke({{-7, 3}, {13, 3}, {13, 43}, {-7, 3}})}});
    const Point there = s.raster.to_drawing(s.raster.to_raster({5, 6}));
    CHECK(there.x == Approx(5));
    CHECK(there.y == Approx(6));
    CHECK(s.raster.to_raster({-7, 3}).x >= core::InkOptions{}.margin_px);
    CHECK(s.raster.to_raster({13, 43}).x <= s.image.width - 1 - core::InkOptions{}.margin_px);
}

TEST_CASE("a drawing that is moved, or twice as large, has the same silhouette", "[closing]") {
    const core::Silhouette s = silhouette(kOpenCircle);
    for (const auto& [factor, shift] : {std::pair{1.0, 1024.0}, {2.0, 0.0}, {0.5, -512.0}}) {
        Drawing other = kOpenCircle;
        for (auto& sample : other.strokes[0].samples) {
            sample.x = sample.x * factor + shift;
            sample.y = sample.y * factor - shift;
        }
        CHECK(silhouette(other).image.pixels == s.image.pixels);
    }
}

TEST_CASE("a drawing that grows keeps its pixels between two steps of the scale", "[closing]") {
    Drawing drawing{{stroke({{0, 0}, {100, 0}, {100, 60}, {0, 60}, {0, 0}})}};
    const core::Silhouette before = silhouette(drawing);
    drawing.strokes.push_back(stroke({{100, 60}, {104, 64}}));
    const core::Silhouette after = silhouette(drawing);
    REQUIRE(before.raster.scale == after.raster.scale);
    CHECK(before.raster.offset == after.raster.offset);
    int differing = 0;
    for (int y = 0; y < before.image.height; ++y) {
        for (int x = 0; x < before.image.width / 2; ++x) differing += before.image.at(x, y) != after.image.at(x, y);
    }
    CHECK(differing == 0);
}
