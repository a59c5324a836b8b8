#include "firmware_like_app/kiosk/alignment.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <random>

using Fault = app::AlignmentFit::Fault;

namespace {

constexpr double kAspect = 16.0 / 9;

/// The crosses touched by a pen that says `place` of where it really is.
std::vector<app::CrossHit> touched(const std::function<core::Point(core::Point)>& place) {
    std::vector<app::CrossHit> hits;
    for (std::size_t i = 0; i < app::kCrossCount; ++i) hits.push_back({app::cross_at(i), place(app::cross_at(i))});
    return hits;
}

core::Point corrected(const app::AlignmentFit& fit, core::Point p) {
    return {fit.align[0] * p.x + fit.align[1] * p.y + fit.align[2],
            fit.align[3] * p.x + fit.align[4] * p.y + fit.align[5]};
}

}  // namespace

TEST_CASE("the crosses lie in three rows of three, all different, away from the edges", "[alignment]") {
    for (std::size_t i = 0; i < app::kCrossCount; ++i) {
        const core::Point p = app::cross_at(i);
        CHECK((p.x >= 0.1 && p.x <= 0.9 && p.y >= 0.1 && p.y <= 0.9));
        for (std::size_t j = 0; j < i; ++j) CHECK((app::cross_at(j).x != p.x || app::cross_at(j).y != p.y));
    }
}

TEST_CASE("a pen that is shifted, scaled, turned a little and sheared is corrected exactly", "[alignment]") {
    const auto off = [](core::Point p) {
        return core::Point{1.04 * p.x + 0.03 * p.y - 0.05, -0.02 * p.x + 0.93 * p.y + 0.04};
    };
    const app::AlignmentFit fit = app::fit_alignment(touched(off), kAspect);
    CHECK(fit.fault == Fault::None);
    CHECK(fit.worst < 1e-9);
    for (const core::Point p : {core::Point{0, 0}, core::Point{1, 1}, core::Point{0.3, 0.8}}) {
        CHECK(corrected(fit, off(p)).x == Approx(p.x).margin(1e-9));
        CHECK(corrected(fit, off(p)).y == Approx(p.y).margin(1e-9));
    }
}

TEST_CASE("an unsteady hand is averaged, and a cross that was missed is refused", "[alignment]") {
    std::mt19937 random(4);
    std::normal_distribution<double> shake(0, 0.002);
    auto hits = touched([&](core::Point p) {
        return core::Point{p.x + 0.02 + shake(random), p.y - 0.01 + shake(random)};
    });
    const app::AlignmentFit fit = app::fit_alignment(hits, kAspect);
    CHECK(fit.fault == Fault::None);
    CHECK(corrected(fit, {0.52, 0.49}).x == Approx(0.5).margin(0.003));
    CHECK(corrected(fit, {0.52, 0.49}).y == Approx(0.5).margin(0.003));
    hits[4].pen.x += 0.08;
    CHECK(app::fit_alignment(hits, kAspect).fault == Fault::Missed);
}

TEST_CASE("too few crosses, all in one place or on a line, and tablets that lie otherwise are refused", "[alignment]") {
    CHECK(app::fit_alignment({}, kAspect).fault == Fault::Missed);
    auto few = touched([](core::Point p) { return p; });
    few.resize(3);
    CHECK(app::fit_alignment(few, kAspect).fault == Fault::Missed);
    CHECK(app::fit_alignment(touched([](core::Point) {
                                 return core::Point{0.5, 0.5};
                             }),
                             kAspect)
              .fault == Fault::Missed);
    CHECK(app::fit_alignment(touched([](core::Point p) {
                                 return core::Point{p.x, p.x};
                             }),
                             kAspect)
              .fault == Fault::Missed);
    CHECK(app::fit_alignment(touched([](core::Point p) {
                                 return core::Point{p.y, 1 - p.x};
                             }),
                             kAspect)
              .fault == Fault::FarOff);
    CHECK(app::fit_alignment(touched([](core::Point p) {
                                 return core::Point{1 - p.x, p.y};
                             }),
                             kAspect)
              .fault == Fault::FarOff);
    CHECK(app::fit_alignment(touched([](core::Point p) { return p * 0.3; }), kAspect).fault == Fault::FarOff);
}
