#include "core/silhouette/bit_image.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/silhouette/capsule.hpp"
#include "core/silhouette/distance_raster.hpp"

using core::BitImage;
using core::RunParts;

namespace {

BitImage image_of(const std::vector<std::string>& rows) {
    BitImage image(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#') image.set_run(y, x, x);
        }
    }
    return image;
}

BitImage noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    BitImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (random() % 5 < 3) image.set_run(y, x, x);
        }
    }
    return image;
}

/// Connected parts by flooding, for comparison.
int flooded(const BitImage& image, bool value, bool corners) {
    std::vector<char> seen(static_cast<std::size_t>(image.width() * image.height()), 0);
    int parts = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.at(x, y) != value || seen[static_cast<std::size_t>(y * image.width() + x)] != 0) continue;
            ++parts;
            std::vector<std::pair<int, int>> open{{x, y}};
            while (!open.empty()) {
                const auto [u, v] = open.back();
                open.pop_back();
                if (u < 0 || v < 0 || u >= image.width() || v >= image.height() || image.at(u, v) != value) continue;
                char& here = seen[static_cast<std::size_t>(v * image.width() + u)];
                if (here != 0) continue;
                here = 1;
                for (int dy = -1; dy <= 1; ++dy) {
                    for (int dx = -1; dx <= 1; ++dx) {
                        if (corners || dx == 0 || dy == 0) open.emplace_back(u + dx, v + dy);
                    }
                }
            }
        }
    }
    return parts;
}

}  // namespace

TEST_CASE("runs are set, cleared and cut at the edges", "[bit image]") {
    BitImage image(130, 2);
    image.set_run(0, -5, 400);
    image.set_run(7, 0, 5);
    image.clear_run(0, 60, 70);
    for (int x = 0; x < 130; ++x) CHECK(image.at(x, 0) == (x < 60 || x > 70));
    CHECK(image.row(0)[2] == 3);  // nothing beyond the width
    image.fill(true);
    image.clear_run(0, 0, 129);
    image.clear_run(1, 0, 129);
    CHECK(image == BitImage(130, 2));
}

TEST_CASE("parts are those that sides or corners join, the first run's first", "[bit image]") {
    const BitImage image = image_of({"##..#", "..##.", "#...#"});
    RunParts parts;
    parts.find(image, true, RunParts::Joined::BySides, 0, 2);
    CHECK(parts.count() == 5);
    parts.find(image, true, RunParts::Joined::ByCorners, 0, 2);
    CHECK(parts.count() == 2);
    CHECK(parts.runs()[0].part == 0);
    CHECK(parts.runs()[3].part == 1);
    CHECK(parts.runs()[3].x0 == 0);
    parts.find(image, false, RunParts::Joined::BySides, 0, 2);
    CHECK(parts.count() == 3);
}

TEST_CASE("parts of noise are those that flooding finds", "[bit image]") {
    RunParts parts;
    for (unsigned seed = 0; seed < 6; ++seed) {
        const BitImage image = noise(61 + static_cast<int>(seed) * 3, 40, seed);
        for (const bool value : {true, false}) {
            parts.find(image, value, RunParts::Joined::BySides, 0, 39);
            CHECK(parts.count() == flooded(image, value, false));
            parts.find(image, value, RunParts::Joined::ByCorners, 0, 39);
            CHECK(parts.count() == flooded(image, value, true));
        }
    }
}

TEST_CASE("the runs of a capsule are its pixels, row by row", "[capsule]") {
    std::mt19937 random(3);
    const auto place = [&] { return static_cast<std::int64_t>(random() % 900) - 450; };
    for (int round = 0; round < 300; ++round) {
        const core::FixedPoint a{place(), place()}, b = round % 7 == 0 ? a : core::FixedPoint{place(), place()};
        const std::int64_t half = 8 + static_cast<std::int64_t>(random() % 60);
        BitImage by_runs(80, 80), by_pixels(80, 80);
        core::each_capsule_run(a, b, half, [&](int y, int x0, int x1) { by_runs.set_run(y + 40, x0 + 40, x1 + 40); });
        for (int y = -40; y < 40; ++y) {
            for (int x = -40; x < 40; ++x) {
                if (core::in_capsule(a, b, half, x, y)) by_pixels.set_run(y + 40, x + 40, x + 40);
            }
        }
        REQUIRE(by_runs == by_pixels);
    }
}

TEST_CASE("distances kept while ink is added are those found at once, and those by looking at all ink",
          "[distance raster]") {
    std::mt19937 random(11);
    core::DistanceRaster grown(128, 90, 20), at_once(128, 90, 20);
    std::vector<core::RasterPixel> ink;
    for (int step = 0; step < 12; ++step) {
        const int y = 21 + static_cast<int>(random() % 48), x = 21 + static_cast<int>(random() % 70);
        const int length = static_cast<int>(random() % 12);
        for (int i = 0; i <= length; ++i) ink.push_back({x + i, y});
        grown.ink(y, x, x + length);
        grown.settle();
        at_once.clear();
        for (const core::RasterPixel p : ink) at_once.ink(p.y, p.x, p.x);
        at_once.settle_all();
    }
    int wrong = 0;
    BitImage far_grown(128, 90), far_at_once(128, 90);
    grown.farther_than(150, far_grown);
    at_once.farther_than(150, far_at_once);
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 128; ++x) {
            int least = 1 << 20;
            for (const core::RasterPixel p : ink)
                least = std::min(least, (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y));
            if (least <= 400 && (grown.squared(x, y) != least || at_once.squared(x, y) != least)) ++wrong;
            if (least > 400 && (grown.squared(x, y) <= 400 || at_once.squared(x, y) <= 400)) ++wrong;
            if (far_grown.at(x, y) != (least > 150) || far_at_once.at(x, y) != (least > 150)) ++wrong;
        }
    }
    CHECK(wrong == 0);
}
