#include "input/parse/evdev_pen.hpp"

#include <linux/input-event-codes.h>

#include <catch2/catch.hpp>

using input::EvdevDescription;
using input::EvdevPen;
using input::PenTool;

namespace {

EvdevDescription wacom() {
    EvdevDescription d;
    d.axes[ABS_X] = EvdevDescription::Axis{0, 44800, 200, 0};
    d.axes[ABS_Y] = EvdevDescription::Axis{0, 29600, 200, 0};
    d.axes[ABS_PRESSURE] = EvdevDescription::Axis{0, 8191, 0, 0};
    d.axes[ABS_TILT_X] = EvdevDescription::Axis{-64, 63, 57, 0};
    for (const int key : {BTN_TOOL_PEN, BTN_TOOL_RUBBER, BTN_TOUCH, BTN_STYLUS, BTN_STYLUS2})
        d.keys[static_cast<std::size_t>(key)] = true;
    return d;
}

struct Change {
    std::uint16_t type, code;
    std::int32_t value;
};

/// Feeds the changes and a SYN_REPORT; whether a frame came out.
bool frame(EvdevPen& pen, std::initializer_list<Change> changes) {
    for (const Change& c : changes) CHECK_FALSE(pen.feed({0, c.type, c.code, c.value}));
    return pen.feed({0, EV_SYN, SYN_REPORT, 0});
}

}  // namespace

TEST_CASE("frames of events become reports", "[evdev_pen]") {
    EvdevPen pen(wacom());
    CHECK_FALSE(pen.report().in_range);
    REQUIRE(
        frame(pen, {{EV_KEY, BTN_TOOL_PEN, 1}, {EV_ABS, ABS_X, 100}, {EV_ABS, ABS_Y, 200}, {EV_MSC, MSC_SERIAL, -1}}));
    CHECK(pen.report().in_range);
    CHECK_FALSE(pen.report().tip);
    CHECK(pen.report().serial == 0xffffffffULL);
    REQUIRE(frame(pen, {{EV_KEY, BTN_TOUCH, 1}, {EV_ABS, ABS_PRESSURE, 1000}, {EV_KEY, BTN_STYLUS2, 1}}));
    CHECK(pen.report().tip);
    CHECK(pen.report().x == 100);
    CHECK(pen.report().pressure == 1000);
    CHECK(pen.report().buttons == input::kBarrel2);
    REQUIRE(frame(pen, {{EV_KEY, BTN_TOUCH, 0}, {EV_KEY, BTN_TOOL_PEN, 0}, {EV_KEY, BTN_STYLUS2, 0}}));
    CHECK_FALSE(pen.report().in_range);
    REQUIRE(frame(pen, {{EV_KEY, BTN_TOOL_RUBBER, 1}, {EV_ABS, ABS_X, 5}}));
    CHECK(pen.report().tool == PenTool::Eraser);
}

TEST_CASE("frames that say nothing of the pen give nothing", "[evdev_pen]") {
    EvdevPen pen(wacom());
    CHECK_FALSE(frame(pen, {}));
    CHECK_FALSE(frame(pen, {{EV_KEY, KEY_A, 1}, {EV_MSC, MSC_SCAN, 4}}));
}

TEST_CASE("a pen that touches already when the device is opened", "[evdev_pen]") {
    EvdevDescription d = wacom();
    d.axes[ABS_X]->value = 700;
    d.axes[ABS_PRESSURE]->value = 4000;
    std::bitset<768> pressed;
    pressed[BTN_TOOL_PEN] = pressed[BTN_TOUCH] = true;
    const EvdevPen pen(d, pressed);
    CHECK(pen.report().in_range);
    CHECK(pen.report().tip);
    CHECK(pen.report().x == 700);
    CHECK(pen.report().pressure == 4000);
}

TEST_CASE("lost events are said, and the broken frame is passed over", "[evdev_pen]") {
    EvdevPen pen(wacom());
    REQUIRE(frame(pen, {{EV_KEY, BTN_TOOL_PEN, 1}, {EV_ABS, ABS_X, 100}}));
    CHECK_FALSE(frame(pen, {{EV_SYN, SYN_DROPPED, 0}, {EV_ABS, ABS_X, 900}}));
    CHECK(pen.lost_events());
    CHECK(pen.report().x == 100);
    EvdevDescription now = wacom();
    now.axes[ABS_X]->value = 901;
    pen.resync(now, {});
    CHECK_FALSE(pen.lost_events());
    CHECK(pen.report().x == 901);
    CHECK_FALSE(pen.report().in_range);
}

TEST_CASE("what is a pen's node and what is not", "[evdev_pen]") {
    CHECK(wacom().is_pen());
    EvdevDescription keys = wacom();
    keys.axes[ABS_X] = keys.axes[ABS_Y] = EvdevDescription::Axis{0, 1, 0, 0};
    CHECK_FALSE(keys.is_pen());
    EvdevDescription touch = wacom();
    touch.axes[ABS_MT_SLOT] = EvdevDescription::Axis{0, 9, 0, 0};
    CHECK_FALSE(touch.is_pen());
    EvdevDescription mouse;
    mouse.keys[BTN_LEFT] = true;
    CHECK_FALSE(mouse.is_pen());
}

TEST_CASE("a tablet without tools and touch goes by pressure", "[evdev_pen]") {
    EvdevDescription d = wacom();
    d.keys.reset();
    d.keys[BTN_STYLUS] = true;
    EvdevPen pen(d);
    REQUIRE(frame(pen, {{EV_ABS, ABS_X, 4}, {EV_ABS, ABS_PRESSURE, 9}}));
    CHECK(pen.report().in_range);
    CHECK(pen.report().tip);
}
