#include "core/geometry/space_line.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using core::SpaceLine;
using core::Vec3;

namespace {

const SpaceLine kHook{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}};

SpaceLine wave(double height, double length) {
    SpaceLine line;
    for (int k = 0; k <= 400; ++k) {
        const double x = 0.1 * k;
        line.push_back({x, height * std::sin(2.0 * 3.14159265 * x / length), 0});
    }
    return line;
}

double tallest(const SpaceLine& line) {
    double most = 0.0;
    for (const Vec3& p : line) most = std::max(most, std::abs(p.y));
    return most;
}

}  // namespace

TEST_CASE("lengths, places and nearest places", "[space_line]") {
    CHECK(core::line_length(kHook) == Approx(7.0));
    CHECK(core::place_along(kHook, 5.5) == Vec3{4, 1.5, 0});
    CHECK(core::place_along(kHook, -1) == Vec3{0, 0, 0});
    CHECK(core::place_along(kHook, 99) == Vec3{4, 3, 0});
    const core::NearestOnLine near = core::nearest_on_line(kHook, {5, 1, 0});
    CHECK(near.along == Approx(5.0));
    CHECK(near.distance == Approx(1.0));
}

TEST_CASE("resampling keeps the ends and makes equal steps along the line", "[space_line]") {
    const SpaceLine line = core::resampled(kHook, 14);
    REQUIRE(line.size() == 15);
    CHECK(line.front() == kHook.front());
    CHECK(line.back() == kHook.back());
    CHECK(line[8] == Vec3{4, 0, 0});
    for (std::size_t i = 0; i + 1 < line.size(); ++i) CHECK(core::length(line[i + 1] - line[i]) == Approx(0.5));
}

TEST_CASE("a split line has the same place at the end and the start of its halves", "[space_line]") {
    for (const double at : {0.5, 3.9, 4.0, 4.1, 6.9}) {
        const core::SplitLine halves = core::split_line(kHook, at);
        CHECK(halves.before.back() == halves.after.front());
        CHECK(core::line_length(halves.before) == Approx(at));
        CHECK(core::line_length(halves.after) == Approx(7.0 - at));
        CHECK(halves.before.front() == kHook.front());
        CHECK(halves.after.back() == kHook.back());
    }
}

TEST_CASE("smoothing takes trembling out and keeps drawn bumps", "[space_line]") {
    CHECK(tallest(core::smoothed(wave(0.1, 1.0), 0.5, 6)) < 0.03);
    CHECK(tallest(core::smoothed(wave(2.0, 10.0), 0.5, 6)) > 1.9);
    CHECK(core::smoothed(kHook, 0.5, 6).front() == kHook.front());
}

TEST_CASE("sharp turns are found, waves are none", "[space_line]") {
    const std::vector<double> turns = core::sharp_turns(kHook, 0.9, 1.0);
    REQUIRE(turns.size() == 1);
    CHECK(turns[0] == Approx(4.0).margin(0.3));
    CHECK(core::sharp_turns(wave(1.5, 12.0), 0.9, 1.25).empty());
    CHECK(core::sharp_turns({{0, 0, 0}, {0.1, 0, 0}}, 0.9, 1.0).empty());
}
