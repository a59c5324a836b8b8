#include "input/pen_axes.hpp"

#include <catch2/catch.hpp>

using input::AxisRange;
using input::PenAxes;
using input::PenReport;
using input::PenSample;

TEST_CASE("a report becomes a sample in units", "[pen_axes]") {
    PenAxes axes;
    axes.x = AxisRange{0, 20000, 100.0};
    axes.y = AxisRange{1000, 11000, 100.0};
    axes.pressure = AxisRange{0, 1023, 0.0};
    axes.tilt_x = AxisRange{-64, 63, 57.0};
    PenReport r;
    r.in_range = r.tip = true;
    r.x = 5000;
    r.y = 6000;
    r.pressure = 1023;
    r.tilt_x = 57;
    r.tilt_y = 20;  // no range: dropped
    const PenSample s = to_sample(r, axes, 42, 3);
    CHECK(s.time_ns == 42);
    CHECK(s.device == 3);
    CHECK(*s.x == Approx(0.25));
    CHECK(*s.y == Approx(0.5));
    CHECK(*s.x_mm == Approx(50.0));
    CHECK(*s.y_mm == Approx(50.0));
    CHECK(*s.pressure == Approx(1.0));
    CHECK(*s.tilt_x_rad == Approx(1.0));
    CHECK_FALSE(s.tilt_y_rad);
    CHECK_FALSE(s.rotation_rad);
    CHECK(s.tip);
    CHECK_FALSE(s.hover());
}

TEST_CASE("values outside their range are brought back", "[pen_axes]") {
    PenAxes axes;
    axes.x = axes.y = AxisRange{0, 100, 0.0};
    PenReport r;
    r.in_range = true;
    r.x = -5;
    r.y = 500;
    const PenSample s = to_sample(r, axes, 0, 1);
    CHECK(*s.x == 0.0);
    CHECK(*s.y == 1.0);
    CHECK_FALSE(s.x_mm);
}

TEST_CASE("angles without a resolution", "[pen_axes]") {
    PenAxes axes;
    axes.tilt_x = AxisRange{-60, 60, 0.0};      // degrees
    axes.tilt_y = AxisRange{-9000, 9000, 0.0};  // some steps to the widest tilt
    axes.rotation = AxisRange{0, 3600, 0.0};
    PenReport r;
    r.in_range = true;
    r.tilt_x = 45;
    r.tilt_y = 4500;
    r.rotation = 2700;
    const PenSample s = to_sample(r, axes, 0, 1);
    CHECK(*s.tilt_x_rad == Approx(0.785398));
    CHECK(*s.tilt_y_rad == Approx(0.523599));
    CHECK(*s.rotation_rad == Approx(1.570796));
}

TEST_CASE("a pen that is gone has no axes", "[pen_axes]") {
    PenAxes axes;
    axes.x = axes.y = axes.pressure = AxisRange{0, 100, 1.0};
    PenReport r;
    r.x = r.y = r.pressure = 50;
    r.buttons = 3;
    r.tip = true;
    const PenSample s = to_sample(r, axes, 9, 1);
    CHECK(s == PenSample{.time_ns = 9, .device = 1});
}

TEST_CASE("a sample for the sheet is in millimetres where there is a size", "[pen_axes]") {
    PenSample s;
    s.time_ns = 5'000'000;
    s.x = 0.5;
    s.y = 0.25;
    CHECK(to_core(s, 1'000'000).x == Approx(500.0));
    CHECK(to_core(s, 1'000'000).pressure == 1.0);
    s.x_mm = 20.0;
    s.y_mm = 10.0;
    s.pressure = 0.3;
    const core::PenSample sheet = to_core(s, 1'000'000);
    CHECK(sheet.time_us == 4000);
    CHECK(sheet.x == 20.0);
    CHECK(sheet.y == 10.0);
    CHECK(sheet.pressure == Approx(0.3));
}
