#include "input/pipeline/pipeline.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "input/pipeline/palm_rejection.hpp"
#include "input/pipeline/stroke_builder.hpp"

using input::PenAxes;
using input::PenPipeline;
using input::PenSample;
using input::PipelineOptions;

namespace {

constexpr std::int64_t kMs = 1'000'000;

PenSample at(std::int64_t ms, double x, double y, double pressure = 0.5, std::uint32_t device = 1) {
    PenSample s;
    s.time_ns = ms * kMs;
    s.device = device;
    s.x = x;
    s.y = y;
    s.x_mm = x * 200.0;
    s.y_mm = y * 100.0;
    s.pressure = pressure;
    s.in_range = true;
    s.tip = pressure > 0.0;
    return s;
}

PenSample gone(std::int64_t ms, std::uint32_t device = 1) {
    return {.time_ns = ms * kMs, .device = device};
}

PenAxes tablet() {
    PenAxes axes;
    axes.x = input::AxisRange{0, 20000, 100.0};
    axes.y = input::AxisRange{0, 10000, 100.0};
    axes.pressure = input::AxisRange{0, 1000, 0.0};
    return axes;
}

PipelineOptions plain() {
    PipelineOptions options;
    options.smoothing.on = false;
    return options;
}

}  // namespace

TEST_CASE("calibration takes a part of the tablet", "[pipeline]") {
    const input::Calibration c({.area = {0.25, 0.5, 0.75, 1.0}}, input::TabletSize{200.0, 100.0});
    const PenSample s = c.apply(at(0, 0.5, 0.75));
    CHECK(*s.x == Approx(0.5));
    CHECK(*s.y == Approx(0.5));
    CHECK(*s.x_mm == Approx(50.0));
    CHECK(*s.y_mm == Approx(25.0));
    CHECK(*c.apply(at(0, 0.1, 0.75)).x == 0.0);
    CHECK(*c.apply(at(0, 0.9, 0.75)).x == 1.0);
    CHECK_FALSE(c.apply(gone(0)).x);
}

TEST_CASE("a circle stays a circle where the aspect is kept", "[pipeline]") {
    const input::Calibration square({.keep_aspect = 1.0}, input::TabletSize{200.0, 100.0});
    CHECK(square.area()[0] == Approx(0.25));
    CHECK(square.area()[2] == Approx(0.75));
    CHECK(square.area()[1] == 0.0);
    const input::Calibration wide({.keep_aspect = 4.0}, input::TabletSize{200.0, 100.0});
    CHECK(wide.area()[1] == Approx(0.25));
    const input::Calibration upright({.keep_aspect = 0.5, .turn = input::Turn::Right}, input::TabletSize{200.0, 100.0});
    CHECK(upright.area()[0] == Approx(0.0));
    CHECK(upright.area()[1] == Approx(0.0));
    const input::Calibration unsized({.keep_aspect = 1.0});
    CHECK(unsized.area()[0] == 0.0);
}

TEST_CASE("turned tablets turn the place, the lean and the size", "[pipeline]") {
    PenSample s = at(0, 0.1, 0.2);
    s.tilt_x_rad = 0.3;
    s.tilt_y_rad = 0.1;
    s.rotation_rad = 3.0;
    const input::TabletSize size{200.0, 100.0};
    const PenSample right = input::Calibration({.turn = input::Turn::Right}, size).apply(s);
    CHECK(*right.x == Approx(0.8));
    CHECK(*right.y == Approx(0.1));
    CHECK(*right.x_mm == Approx(80.0));
    CHECK(*right.y_mm == Approx(20.0));
    CHECK(*right.tilt_x_rad == Approx(-0.1));
    CHECK(*right.tilt_y_rad == Approx(0.3));
    CHECK(*right.rotation_rad == Approx(3.0 + std::numbers::pi / 2 - 2 * std::numbers::pi));
    const PenSample half = input::Calibration({.left_handed = true}, size).apply(s);
    CHECK(*half.x == Approx(0.9));
    CHECK(*half.y == Approx(0.8));
    CHECK(*half.tilt_x_rad == Approx(-0.3));
    const PenSample left = input::Calibration({.turn = input::Turn::Left}, size).apply(s);
    CHECK(*left.x == Approx(0.2));
    CHECK(*left.y == Approx(0.9));
    const PenSample round = input::Calibration({.turn = input::Turn::Half, .left_handed = true}, size).apply(s);
    CHECK(*round.x == Approx(0.1));
}

TEST_CASE("a tip draws from one pressure on and until a lower one", "[pipeline]") {
    input::TipThreshold tip({.down = 0.05, .up = 0.01});
    CHECK_FALSE(tip.apply(at(0, 0, 0, 0.04)).tip);
    CHECK(tip.apply(at(1, 0, 0, 0.05)).tip);
    CHECK(tip.apply(at(2, 0, 0, 0.02)).tip);
    CHECK_FALSE(tip.apply(at(3, 0, 0, 0.009)).tip);
    CHECK_FALSE(tip.apply(at(4, 0, 0, 0.04)).tip);
    PenSample bare = at(5, 0, 0);
    bare.pressure.reset();
    CHECK(tip.apply(bare).tip);
}

TEST_CASE("samples that repeat and samples from the past are left out and counted", "[pipeline]") {
    PenPipeline pipeline(plain());
    pipeline.attach(1, tablet(), true);
    CHECK(pipeline.feed(at(10, 0.1, 0.1)));
    CHECK_FALSE(pipeline.feed(at(15, 0.1, 0.1)));
    CHECK_FALSE(pipeline.feed(at(5, 0.2, 0.1)));
    CHECK(pipeline.feed(at(20, 0.2, 0.1)));
    CHECK(pipeline.feed(at(5, 0.2, 0.1, 0.5, 2)));  // another device has its own order
    CHECK(pipeline.duplicates() == 1);
    CHECK(pipeline.out_of_order() == 1);
    CHECK(pipeline.detach(1, 30 * kMs));
    CHECK(pipeline.duplicates() == 1);
}

TEST_CASE("a lift that never comes: silence ends the stroke", "[pipeline]") {
    PenPipeline pipeline(plain());
    pipeline.attach(1, tablet(), false);
    CHECK_FALSE(pipeline.due_ns());
    CHECK(pipeline.feed(at(0, 0.1, 0.1)));
    CHECK(pipeline.feed(at(10, 0.2, 0.1)));
    CHECK_FALSE(pipeline.feed(at(90, 0.2, 0.1)));  // a sign of life
    CHECK(pipeline.expire(189 * kMs).empty());
    CHECK(pipeline.due_ns() == 190 * kMs);
    const auto silent = pipeline.expire(500 * kMs);
    REQUIRE(silent.size() == 1);
    CHECK_FALSE(silent[0].in_range);
    CHECK(silent[0].time_ns == 190 * kMs);
    CHECK(pipeline.expire(900 * kMs).empty());
    CHECK(pipeline.feed(at(950, 0.2, 0.1)));  // it comes back
}

TEST_CASE("a pen that says when it leaves is waited for", "[pipeline]") {
    PenPipeline pipeline(plain());
    pipeline.attach(1, tablet(), true);
    CHECK(pipeline.feed(at(0, 0.1, 0.1)));
    CHECK(pipeline.expire(1900 * kMs).empty());
    CHECK(pipeline.expire(2000 * kMs).size() == 1);
}

TEST_CASE("an unplugged tablet's pen is gone", "[pipeline]") {
    PenPipeline pipeline(plain());
    pipeline.attach(1, tablet(), true);
    CHECK(pipeline.feed(at(0, 0.1, 0.1)));
    const auto left = pipeline.detach(1, 7 * kMs);
    REQUIRE(left);
    CHECK_FALSE(left->in_range);
    CHECK(left->time_ns == 7 * kMs);
    CHECK_FALSE(pipeline.detach(1, 8 * kMs));
}

TEST_CASE("the pressure curve", "[pipeline]") {
    const input::PressureOptions options{.low = 0.1, .high = 0.9, .power = 2.0};
    CHECK(*input::apply_pressure(at(0, 0, 0, 0.05), options).pressure == 0.0);
    CHECK(*input::apply_pressure(at(0, 0, 0, 0.5), options).pressure == Approx(0.25));
    CHECK(*input::apply_pressure(at(0, 0, 0, 0.95), options).pressure == 1.0);
    CHECK(*input::apply_pressure(at(0, 0, 0, 0.3), {}).pressure == 0.3);
}

TEST_CASE("smoothing calms a still pen and hardly delays a fast one", "[pipeline]") {
    input::SmoothPlace smooth({}, 200.0, 100.0);
    double jitter = 0.0, calmed = 0.0;
    for (int i = 0; i < 400; ++i) {
        const double noise = (i % 2 == 0 ? 0.05 : -0.05);  // mm
        const PenSample s = smooth.apply(at(i * 5, 0.5 + noise / 200.0, 0.5));
        if (i < 100) continue;
        jitter += noise * noise;
        calmed += std::pow((*s.x - 0.5) * 200.0, 2);
    }
    CHECK(std::sqrt(calmed) < std::sqrt(jitter) / 2.5);

    input::SmoothPlace fast({}, 200.0, 100.0);
    double lag_mm = 0.0;
    for (int i = 0; i < 100; ++i) {
        const double x = 0.1 + i * 5e-3 * 100.0 / 200.0;  // 100 mm/s
        lag_mm = (x - *fast.apply(at(i * 5, x, 0.5)).x) * 200.0;
    }
    CHECK(lag_mm > 0.0);
    CHECK(lag_mm < 0.6);  // 6 ms
}

TEST_CASE("a stroke begins where the pen touches, smoothed or not", "[pipeline]") {
    input::SmoothPlace smooth({}, 200.0, 100.0);
    CHECK(*smooth.apply(at(0, 0.1, 0.5, 0.0)).x == Approx(0.1));
    CHECK(*smooth.apply(at(5, 0.3, 0.5, 0.0)).x < 0.3);
    CHECK(*smooth.apply(at(10, 0.5, 0.5, 0.5)).x == Approx(0.5));
    (void)smooth.apply(gone(15));
    CHECK(*smooth.apply(at(20, 0.9, 0.5, 0.5)).x == Approx(0.9));
}

TEST_CASE("prediction on a line and a circle is nearer than the last place", "[pipeline]") {
    for (const bool circle : {false, true}) {
        DYNAMIC_SECTION((circle ? "circle" : "line")) {
            input::PenPredictor predictor({.ahead_ns = 16 * kMs});
            const auto place = [&](double ms) {  // 150 mm/s; the circle has a radius of 30 mm
                const double t = ms / 1000.0;
                if (!circle) return at(0, 0.1 + 150.0 * t / 200.0, 0.5);
                return at(0, 0.5 + 30.0 * std::cos(5.0 * t) / 200.0, 0.5 + 30.0 * std::sin(5.0 * t) / 100.0);
            };
            double with = 0.0, without = 0.0;
            for (int i = 0; i < 120; ++i) {
                PenSample s = place(i * 5.0);
                s.time_ns = i * 5 * kMs;
                predictor.see(s);
                const PenSample truth = place(i * 5.0 + 16.0);
                const auto p = predictor.predict();
                if (i < 10) continue;
                REQUIRE(p);
                CHECK(p->time_ns == s.time_ns + 16 * kMs);
                with += std::hypot(*p->x_mm - *truth.x_mm, *p->y_mm - *truth.y_mm);
                without += std::hypot(*s.x_mm - *truth.x_mm, *s.y_mm - *truth.y_mm);
            }
            CHECK(with < without / 4);
        }
    }
}

TEST_CASE("prediction is only for pens that draw, and never runs away", "[pipeline]") {
    input::PenPredictor predictor({.ahead_ns = 32 * kMs, .longest_mm = 8.0});
    predictor.see(at(0, 0.1, 0.5));
    predictor.see(at(5, 0.2, 0.5));
    CHECK_FALSE(predictor.predict());
    predictor.see(at(10, 0.3, 0.5));
    predictor.see(at(15, 0.4, 0.5));
    const auto p = predictor.predict();
    REQUIRE(p);
    CHECK(*p->x_mm - 80.0 <= 8.0001);
    CHECK(*p->x_mm > 80.0);
    predictor.see(at(20, 0.4, 0.5, 0.0));
    CHECK_FALSE(predictor.predict());
    input::PenPredictor off({.on = false});
    for (int i = 0; i < 5; ++i) off.see(at(i, 0.1 * i, 0.5));
    CHECK_FALSE(off.predict());
}

TEST_CASE("palm rejection works before the first stroke", "[pipeline]") {
    input::PalmRejection palm({.before_ns = 200 * kMs, .after_ns = 500 * kMs});
    CHECK(palm.touch_began(1, 0));
    CHECK(palm.touch_began(2, 900 * kMs));
    CHECK(palm.see(at(1000, 0.1, 0.1, 0.0)) == std::vector<std::int64_t>{2});  // the hand that came with the pen
    CHECK(palm.touch_allowed(1));
    CHECK_FALSE(palm.touch_allowed(2));
    CHECK_FALSE(palm.touch_began(3, 1100 * kMs));
    CHECK(palm.see(gone(1200)).empty());
    CHECK_FALSE(palm.touch_began(4, 1600 * kMs));
    palm.touch_ended(4);
    CHECK(palm.touch_began(4, 1800 * kMs));
    CHECK_FALSE(palm.touch_allowed(99));
}

TEST_CASE("palm rejection forgets an unplugged pen", "[pipeline]") {
    input::PalmRejection palm({});
    (void)palm.see(at(0, 0.1, 0.1, 0.0));
    CHECK_FALSE(palm.touch_began(1, 100 * kMs));
    palm.forget(1, 200 * kMs);
    CHECK(palm.touch_began(2, 800 * kMs));
}

TEST_CASE("strokes end by lift, by leaving, by turning the pen over, by unplugging", "[pipeline]") {
    PenSample erasing = at(8, 0.5, 0.5);
    erasing.tool = input::PenTool::Eraser;
    const auto strokes =
        input::strokes_of({at(0, 0.1, 0.1, 0.0), at(1, 0.1, 0.1), at(2, 0.2, 0.1), at(3, 0.2, 0.1, 0.0),
                           at(4, 0.3, 0.1), gone(5), at(6, 0.4, 0.1), at(7, 0.41, 0.1), erasing, gone(9)});
    REQUIRE(strokes.size() == 4);
    CHECK(strokes[0].samples.size() == 2);
    CHECK(strokes[1].samples.size() == 1);
    CHECK(strokes[2].samples.size() == 2);
    CHECK(strokes[3].tool == input::PenTool::Eraser);
    const core::Drawing drawing = input::drawing_of(strokes);
    REQUIRE(drawing.strokes.size() == 3);
    CHECK(drawing.strokes[0].samples[0].time_us == 0);
    CHECK(drawing.strokes[1].samples[0].time_us == 3000);
    CHECK(drawing.strokes[0].samples[1].x == Approx(40.0));

    input::StrokeBuilder builder;
    CHECK_FALSE(builder.add(at(0, 0.1, 0.1)));
    CHECK(builder.end(1));
    CHECK_FALSE(builder.end(1));
}

TEST_CASE("two tablets draw at once", "[pipeline]") {
    const auto strokes = input::strokes_of({at(0, 0.1, 0.1, 0.5, 1), at(1, 0.8, 0.8, 0.5, 2), at(2, 0.2, 0.1, 0.5, 1),
                                            at(3, 0.9, 0.8, 0.5, 2), gone(4, 2), gone(5, 1)});
    REQUIRE(strokes.size() == 2);
    CHECK(strokes[0].device == 2);
    CHECK(strokes[0].samples.size() == 2);
    CHECK(strokes[1].device == 1);
}
