#include "core/silhouette/contour.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "core/geometry/polygon.hpp"
#include "support/ring_checks.hpp"
#include "support/shapes.hpp"
#include "support/text_shape.hpp"

using core::BinaryImage;
using core::GrayImage;
using core::largest_contour;
using core::Point;
using core::Polygon;
using support::text_shape;
using support::with_margin;

namespace {

Polygon contour_of(const BinaryImage& image, double least_area = 4.0) {
    const auto ring = largest_contour(image, least_area);
    REQUIRE(ring);
    return *ring;
}

/// From the ring's edges.
double distance_to(const Polygon& ring, Point p) {
    double least = 1e9;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], along = ring[(i + 1) % ring.size()] - a;
        const double share = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
        least = std::min(least, distance(a + along * share, p));
    }
    return least;
}

const BinaryImage kLetter = text_shape({
    "......#...",
    ".####.##..",
    ".#..###...",
    ".####.#...",
    "..........",
});

}  // namespace

TEST_CASE("the ring joins the middles of the pixel edges, from the lowest and leftmost on, anti-clockwise, y up",
          "[contour]") {
    const Polygon ring = contour_of(text_shape({"....", ".##.", ".##.", "...."}), 1.0);
    CHECK(ring == Polygon{{1, -2.5}, {2, -2.5}, {2.5, -2}, {2.5, -1}, {2, -0.5}, {1, -0.5}, {0.5, -1}, {0.5, -2}});
    CHECK(core::signed_area(ring) == Approx(3.5));
}

TEST_CASE("an object at the border of the image has a contour all round", "[contour]") {
    const BinaryImage full = text_shape({"###", "###", "###"});
    CHECK(contour_of(full) == support::moved(contour_of(with_margin(full, 1, 1, 1, 1)), {-1, 1}));
}

TEST_CASE("only the outer contour of the largest object counts, holes are filled", "[contour]") {
    const BinaryImage ring_with_islands = text_shape({
        "##########",
        "#........#",
        "#.######.#",
        "#.######.#",
        "#.######.#",
        "#........#",
        "##########",
    });
    BinaryImage filled(10, 7, 1);
    CHECK(contour_of(ring_with_islands) == contour_of(filled));
    // Few pixels that enclose much beat many pixels that enclose less.
    const BinaryImage frame_and_block = text_shape({
        "#######.####",
        "#.....#.####",
        "#.....#.####",
        "#.....#.####",
        "#######.####",
    });
    for (const Point p : contour_of(frame_and_block)) CHECK(p.x < 7);
}

TEST_CASE("pixels that meet at a corner only belong to one object", "[contour]") {
    const Polygon ring = contour_of(text_shape({"##...", "##...", "..##.", "..##.", "....#"}), 1.0);
    CHECK(ring.size() == 8 + 8 + 4);
    CHECK(support::is_simple(ring));
    double lowest = 0;
    for (const Point p : ring) lowest = std::min(lowest, p.y);
    CHECK(lowest == -4.5);
}

TEST_CASE("lines one pixel wide have two sides that never touch", "[contour]") {
    const BinaryImage straight = text_shape({"#########"});
    const BinaryImage diagonal = text_shape({"#....", ".#...", "..#..", "...#.", "....#"});
    const BinaryImage tree = text_shape({"#...#", ".#.#.", "..#..", ".###.", "..#..", "#####"});
    for (const BinaryImage& image : {straight, diagonal, tree, kLetter}) {
        const Polygon ring = contour_of(image, 0.0);
        CHECK(support::is_simple(ring));
        CHECK(core::signed_area(ring) > 0);
    }
}

TEST_CASE("the ring is simple whatever the pixels", "[contour]") {
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        BinaryImage image(9, 8);
        for (auto& pixel : image.pixels) pixel = random() % 5 < 3 ? 1 : 0;
        const Polygon ring = contour_of(image, 0.0);
        INFO("round " << round);
        REQUIRE(support::is_simple(ring));
        REQUIRE(core::signed_area(ring) > 0);
    }
}

TEST_CASE("the ring moves with the object and does not depend on the page", "[contour]") {
    const Polygon ring = contour_of(kLetter);
    CHECK(contour_of(with_margin(kLetter, 0, 0, 5, 9)) == ring);
    CHECK(contour_of(with_margin(kLetter, 13, 7, 0, 2)) == support::moved(ring, {13, -7}));
}

TEST_CASE("an empty page and a dot are answered with a code", "[contour]") {
    CHECK(largest_contour(BinaryImage()).error().code == core::ErrorCode::EmptyDrawing);
    CHECK(largest_contour(BinaryImage(20, 10, 0)).error().code == core::ErrorCode::EmptyDrawing);
    CHECK(largest_contour(text_shape({"...", ".#.", "..."})).error().code == core::ErrorCode::TooSmall);
    // Two by two pixels enclose 3.5 square pixels.
    const BinaryImage small = text_shape({"##", "##"});
    CHECK(largest_contour(small, 3.6).error().code == core::ErrorCode::TooSmall);
    CHECK(largest_contour(small, 3.5));
}

TEST_CASE("the object is what the border of the page is not, in either polarity", "[contour]") {
    GrayImage dark_on_light(6, 5, 250), light_on_dark(6, 5, 3);
    for (const auto& [x, y] : {std::pair{2, 2}, {3, 2}, {0, 2}}) {  // one of them on the border
        dark_on_light.at(x, y) = 10;
        light_on_dark.at(x, y) = 255;
    }
    const BinaryImage expected = text_shape({"......", "......", "#.##..", "......", "......"});
    CHECK(core::object_mask(dark_on_light).pixels == expected.pixels);
    CHECK(core::object_mask(light_on_dark).pixels == expected.pixels);
}

TEST_CASE("half grey parts object and page", "[contour]") {
    GrayImage page(5, 5, 255);
    page.at(2, 2) = 127;
    page.at(2, 3) = 128;
    const BinaryImage mask = core::object_mask(page);
    CHECK(mask.at(2, 2) == 1);
    CHECK(mask.at(2, 3) == 0);
}

TEST_CASE("a page of one shade has no object, one without pixels gives one without pixels", "[contour]") {
    for (const int shade : {0, 127, 128, 255}) {
        const BinaryImage mask = core::object_mask(GrayImage(4, 4, static_cast<std::uint8_t>(shade)));
        CHECK(mask.pixels == std::vector<std::uint8_t>(16, 0));
    }
    CHECK(core::object_mask(GrayImage()).pixels.empty());
    CHECK(core::object_mask(GrayImage(0, 3)).pixels.empty());
    CHECK(core::object_mask(GrayImage(3, 0)).pixels.empty());
}

TEST_CASE("smoothing keeps place and size, and takes the steps of pixels away", "[contour]") {
    const Polygon circle = support::moved(support::disc(1000, 50.0), {300, -200});
    const Polygon smooth = core::smooth_contour(circle, 400, 2.0);
    REQUIRE(smooth.size() == 400);
    for (const Point p : smooth) CHECK(distance(p, {300, -200}) == Approx(50.0).epsilon(0.002));
    // A zigzag of period two points is gone, its mean line stays.
    Polygon saw = support::disc(400, 50.0);
    for (std::size_t i = 0; i < saw.size(); i += 2) saw[i] = saw[i] * 1.01;
    for (const Point p : core::smooth_contour(saw, 400, 2.0)) CHECK(length(p) == Approx(50.25).epsilon(0.004));
}

TEST_CASE("without a Gaussian the contour is only spaced evenly", "[contour]") {
    const Polygon ring = contour_of(kLetter);
    const Polygon smooth = core::smooth_contour(ring, 50, 0.0);
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        CHECK(distance_to(ring, smooth[i]) < 0.02);
        CHECK(distance(smooth[i], smooth[(i + 1) % smooth.size()]) <= core::perimeter(ring) / 50 * 1.001);
    }
}

TEST_CASE("a contour moved by whole pixels is smoothed to the same, moved, to the last bit", "[contour]") {
    const Polygon ring = contour_of(kLetter);
    const Polygon there = core::smooth_contour(support::moved(ring, {640, -327}), 100, 2.0);
    CHECK(there == support::moved(core::smooth_contour(ring, 100, 2.0), {640, -327}));
}

TEST_CASE("a mirrored or quarter-turned contour is smoothed to the same points of the shape", "[contour]") {
    const Polygon ring = contour_of(kLetter);
    const auto farthest_from = [&](const Polygon& copy, const auto& back) {
        const Polygon points = core::smooth_contour(ring, 100, 2.0), others = core::smooth_contour(copy, 100, 2.0);
        double farthest = 0.0;
        for (const Point p : others) {
            double least = 1e9;
            for (const Point q : points) least = std::min(least, distance(back(p), q));
            farthest = std::max(farthest, least);
        }
        return farthest;
    };
    Polygon mirrored, turned;
    for (const Point p : ring) mirrored.insert(mirrored.begin(), {-p.x, p.y});
    for (const Point p : ring) turned.push_back({-p.y, p.x});
    CHECK(farthest_from(mirrored, [](Point p) { return Point{-p.x, p.y}; }) < 1e-4);
    CHECK(farthest_from(turned, [](Point p) { return Point{p.y, -p.x}; }) < 1e-4);
}

TEST_CASE("a contour is smoothed to the same from wherever it starts", "[contour]") {
    const Polygon ring = contour_of(kLetter);
    const Polygon smooth = core::smooth_contour(ring, 100, 2.0);
    for (const std::ptrdiff_t start : {1, 7, 20}) {
        Polygon later = ring;
        std::rotate(later.begin(), later.begin() + start, later.end());
        CHECK(core::smooth_contour(later, 100, 2.0) == smooth);
    }
}
