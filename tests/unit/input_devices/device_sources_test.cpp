// Sources on tablets that are not there. See ../../support/mock_tablet.hpp.

#include <linux/input-event-codes.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>

#include "../../support/hex_bytes.hpp"
#include "../../support/mock_tablet.hpp"
#include "../../support/temporary_folder.hpp"
#include "input/pipeline/pipeline.hpp"
#include "input/pipeline/stroke_builder.hpp"
#include "input/sources/evdev_source.hpp"
#include "input/sources/hid_source.hpp"
#include "input/sources/libinput_source.hpp"
#include "input/sources/tablet_hub.hpp"
#include "input/sources/trace_source.hpp"
#include "input/trace/decode_trace.hpp"

using input::PenSample;
using input::SourceEvent;
using input::SourceEventKind;
using support::MockEvent;
using support::MockTablets;

namespace {

constexpr std::int64_t kStep_us = 5000;

/// A clock that the test moves.
struct TestClock {
    std::atomic<std::int64_t> now_ns{1'000'000'000};
    [[nodiscard]] input::Clock clock() {
        return [this] { return now_ns.load(); };
    }
};

/// Drains until `enough` holds or two seconds are over.
template <typename Enough>
bool wait_for(input::PenSource& source, std::vector<SourceEvent>& events, Enough enough) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    while (!enough() && std::chrono::steady_clock::now() < end) {
        source.drain(events);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    source.drain(events);
    return enough();
}

std::size_t count(const std::vector<SourceEvent>& events, SourceEventKind kind) {
    return static_cast<std::size_t>(std::count_if(events.begin(), events.end(), [&](const SourceEvent& e) {
        return e.kind == kind && (kind != SourceEventKind::Sample || e.sample_valid);
    }));
}

std::vector<PenSample> samples(const std::vector<SourceEvent>& events, std::uint32_t device = 0) {
    std::vector<PenSample> out;
    for (const SourceEvent& e : events) {
        if (e.kind == SourceEventKind::Sample && e.sample_valid && (device == 0 || e.device == device))
            out.push_back(e.sample);
    }
    return out;
}

/// One moment of a drawing, in the steps of the mock event node.
struct Moment {
    bool near = true, tip = false, eraser = false, barrel = false, barrel2 = false;
    int x = 0, y = 0, pressure = 0, tilt_x = 0, tilt_y = 0;
};

/// Two strokes of a spiral with pressure and tilt, a hover between, a button, and then the eraser's end.
std::vector<Moment> drawing() {
    std::vector<Moment> d;
    for (int i = 0; i < 8; ++i) d.push_back({.x = 20000 + 10 * i, .y = 15000, .tilt_x = 20, .tilt_y = -10});
    for (int stroke = 0; stroke < 2; ++stroke) {
        for (int i = 0; i < 40; ++i) {
            const double a = i * 0.15;
            d.push_back({.tip = true,
                         .barrel = i >= 20 && i < 24,
                         .x = 20000 + static_cast<int>(100 * i * std::cos(a)) + 3000 * stroke,
                         .y = 15000 + static_cast<int>(100 * i * std::sin(a)),
                         .pressure = 1000 + 150 * i,
                         .tilt_x = 20 - i,
                         .tilt_y = i - 30});
        }
        d.push_back({.x = 24000 + stroke, .y = 15000});
    }
    d.push_back({.near = false});
    for (int i = 0; i < 10; ++i)
        d.push_back({.tip = i > 1, .eraser = true, .x = 9000 + i, .y = 800, .pressure = i > 1 ? 900 + i : 0});
    d.push_back({.near = false});
    return d;
}

/// The changes between two moments as a kernel driver tells them; empty when nothing changed.
std::vector<MockEvent> changes(const Moment& from, const Moment& to) {
    std::vector<MockEvent> e;
    const auto key = [&](std::uint16_t code, bool a, bool b) {
        if (a != b) e.push_back({EV_KEY, code, b ? 1 : 0});
    };
    const auto axis = [&](std::uint16_t code, int a, int b) {
        if (a != b) e.push_back({EV_ABS, code, b});
    };
    key(BTN_TOOL_PEN, from.near && !from.eraser, to.near && !to.eraser);
    key(BTN_TOOL_RUBBER, from.near && from.eraser, to.near && to.eraser);
    key(BTN_TOUCH, from.near && from.tip, to.near && to.tip);
    key(BTN_STYLUS, from.near && from.barrel, to.near && to.barrel);
    key(BTN_STYLUS2, from.near && from.barrel2, to.near && to.barrel2);
    axis(ABS_X, from.x, to.x);
    axis(ABS_Y, from.y, to.y);
    axis(ABS_PRESSURE, from.pressure, to.pressure);
    axis(ABS_TILT_X, from.tilt_x, to.tilt_x);
    axis(ABS_TILT_Y, from.tilt_y, to.tilt_y);
    return e;
}

/// A descriptor with the event node's ranges: report 7; flags; x, y, pressure of 16 bits; tilt of 8.
std::vector<std::uint8_t> same_ranges_descriptor() {
    return support::hex_bytes(
        "05 0d 09 02 a1 01 85 07 09 20 a1 00 09 42 09 44 09 45 09 3c 09 32 09 5a 15 00 25 01 75 01 95 06 81 02 95 02 "
        "81 03 "
        "05 01 09 30 55 0f 65 11 35 00 46 e0 00 27 00 af 00 00 75 10 95 01 81 02 09 31 46 94 00 26 a0 73 81 02 05 0d "
        "09 30 "
        "45 00 55 00 65 00 26 ff 1f 81 02 09 3d 09 3e 65 12 15 c0 25 3f 55 0e 35 90 45 6f 75 08 95 02 81 02 c0 c0");
}

std::vector<std::uint8_t> report_of(const Moment& m) {
    const auto low = [](int v) { return static_cast<std::uint8_t>(v & 0xff); };
    const auto high = [](int v) { return static_cast<std::uint8_t>((v >> 8) & 0xff); };
    std::uint8_t flags = 0;
    if (m.near) flags |= 0x10;
    if (m.near && m.tip) flags |= m.eraser ? 0x04 : 0x01;
    if (m.near && m.barrel) flags |= 0x02;
    if (m.near && m.eraser) flags |= 0x08;
    if (m.near && m.barrel2) flags |= 0x20;
    return {7,         flags,           low(m.x),         high(m.x),     low(m.y),
            high(m.y), low(m.pressure), high(m.pressure), low(m.tilt_x), low(m.tilt_y)};
}

/// Without the numbers that tell sources apart, and without what one of them does not have.
std::vector<input::PenStroke> plain(std::vector<input::PenStroke> strokes, bool tilt = true) {
    for (input::PenStroke& stroke : strokes) {
        stroke.device = 1;
        for (PenSample& s : stroke.samples) {
            s.device = 1;
            s.serial = 0;
            s.tool_id = 0;
            s.distance.reset();
            s.rotation_rad.reset();
            if (!tilt) s.tilt_x_rad.reset(), s.tilt_y_rad.reset();
        }
    }
    return strokes;
}

/// Samples through the pipeline's cleaning, unsmoothed, as strokes.
std::vector<input::PenStroke> strokes_by_pipeline(const std::vector<PenSample>& in, const input::TraceDevice& device) {
    input::PipelineOptions options;
    options.smoothing.on = false;
    options.tip = {.down = 0.0, .up = 0.0};
    input::PenPipeline pipeline(options);
    pipeline.attach(device.number, device.axes, device.reports_range);
    std::vector<PenSample> out;
    for (const PenSample& s : in) {
        if (const auto passed = pipeline.feed(s)) out.push_back(*passed);
    }
    return input::strokes_of(out);
}

/// The records of a source's events.
input::Trace recorded(const std::vector<SourceEvent>& events, const input::PenSource& source) {
    input::Trace trace;
    for (const SourceEvent& e : events) input::append_records(e, source.device(e.device), trace.records);
    return trace;
}

struct Played {
    std::vector<SourceEvent> events;
    input::TraceDevice device;
    input::Trace trace;
};

Played play_by_hidraw() {
    MockTablets tablets;
    tablets.plug_hid(0, same_ranges_descriptor(), false);
    TestClock clock;
    input::DeviceNumbers numbers;
    input::HidSource source({.clock = clock.clock(), .numbers = &numbers});
    Played p;
    REQUIRE(wait_for(source, p.events, [&] { return count(p.events, SourceEventKind::Attached) == 1; }));
    for (const Moment& m : drawing()) {
        clock.now_ns += kStep_us * 1000;
        const std::size_t before = count(p.events, SourceEventKind::Sample);
        tablets.report(0, report_of(m));
        REQUIRE(wait_for(source, p.events, [&] { return count(p.events, SourceEventKind::Sample) > before; }));
    }
    CHECK(source.lost() == 0);
    p.device = source.device(p.events.front().device);
    p.trace = recorded(p.events, source);
    return p;
}

/// With the drawing's moments at these times, or 5 ms apart.
Played play_by_evdev(const std::vector<std::int64_t>& times_us = {}) {
    MockTablets tablets;
    tablets.plug_evdev(0, false);
    TestClock clock;
    input::DeviceNumbers numbers;
    input::EvdevSource source({.clock = clock.clock(), .numbers = &numbers});
    Played p;
    REQUIRE(wait_for(source, p.events, [&] { return count(p.events, SourceEventKind::Attached) == 1; }));
    Moment last{.near = false};
    std::int64_t now_us = clock.now_ns / 1000;
    std::size_t moment = 0;
    for (const Moment& m : drawing()) {
        now_us = times_us.empty() ? now_us + kStep_us : times_us[moment++];
        const std::vector<MockEvent> e = changes(last, m);
        last = m;
        if (e.empty()) continue;
        const std::size_t before = count(p.events, SourceEventKind::Sample);
        tablets.frame(0, e, now_us);
        REQUIRE(wait_for(source, p.events, [&] { return count(p.events, SourceEventKind::Sample) > before; }));
    }
    p.device = source.device(p.events.front().device);
    p.trace = recorded(p.events, source);
    return p;
}

}  // namespace

TEST_CASE("one drawing by hidraw, by events and by replay gives the same strokes and the same traces", "[devices]") {
    const Played hid = play_by_hidraw(), evdev = play_by_evdev();
    CHECK(hid.device.parser == "descriptor");
    CHECK(*hid.device.axes.width_mm() == Approx(224.0));
    CHECK(evdev.device.parser == "evdev");
    CHECK(*evdev.device.axes.width_mm() == Approx(224.0));

    const auto by_hid = plain(strokes_by_pipeline(samples(hid.events), hid.device), false);
    const auto by_events = plain(strokes_by_pipeline(samples(evdev.events), evdev.device), false);
    REQUIRE(by_hid.size() == 3);
    CHECK(by_hid[0].samples.size() == 40);
    CHECK(by_hid[2].tool == input::PenTool::Eraser);
    CHECK(by_hid == by_events);

    for (const Played* played : {&hid, &evdev}) {
        const auto back = input::parse_trace(input::trace_text(played->trace));
        REQUIRE(back);
        CHECK(input::decode_trace(*back).differing == 0);
        input::TraceSource replay(*back, {.paced = false});
        std::vector<SourceEvent> events;
        replay.drain(events);
        CHECK(replay.finished());
        CHECK(samples(events) == samples(played->events));
        CHECK(strokes_by_pipeline(samples(events), played->device) ==
              strokes_by_pipeline(samples(played->events), played->device));
        CHECK(input::trace_text(recorded(events, replay)) == input::trace_text(played->trace));
    }
}

TEST_CASE("tilt by hidraw and by events", "[devices]") {
    const Played hid = play_by_hidraw(), evdev = play_by_evdev();
    const std::vector<PenSample> a = samples(hid.events), b = samples(evdev.events);
    CHECK(*a[0].tilt_x_rad == Approx(20 / 57.0).epsilon(0.02));
    CHECK(*b[0].tilt_x_rad == Approx(20 / 57.0));
    CHECK(*b[0].tilt_y_rad == Approx(-10 / 57.0));
}

TEST_CASE("libinput sees the same strokes", "[devices]") {
    // Left alone libinput shows the mean of a tablet's last four places; a quirk switches that off.
    const support::TemporaryFolder quirks;
    quirks.write("10-mock.quirks", "[Mock Pen]\nMatchUdevType=tablet\nAttrTabletSmoothing=0\n");
    setenv("LIBINPUT_QUIRKS_DIR", quirks.path("").c_str(), 1);
    // libinput compares event times with the machine's clock, so this drawing takes its real half second.
    MockTablets tablets;
    tablets.plug_evdev(0, false);
    input::DeviceNumbers numbers;
    input::LibinputSource libinput({.numbers = &numbers, .nodes = {MockTablets::evdev_node(0)}});
    std::vector<SourceEvent> events;
    REQUIRE(wait_for(libinput, events, [&] { return count(events, SourceEventKind::Attached) == 1; }));
    std::vector<std::int64_t> times_us;
    Moment last{.near = false};
    for (const Moment& m : drawing()) {
        std::this_thread::sleep_for(std::chrono::microseconds(kStep_us));
        times_us.push_back(input::monotonic_clock()() / 1000);
        tablets.frame(0, changes(last, m), times_us.back());
        last = m;
        libinput.drain(events);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    libinput.drain(events);
    const input::TraceDevice device = libinput.device(events.front().device);
    CHECK(device.identity.name == "Mock Pen");
    CHECK(*device.axes.width_mm() == Approx(224.0));
    const auto by_libinput = plain(strokes_by_pipeline(samples(events), device), false);
    const Played evdev = play_by_evdev(times_us);
    const auto by_events = plain(strokes_by_pipeline(samples(evdev.events), evdev.device), false);
    REQUIRE(by_libinput.size() == by_events.size());
    for (std::size_t i = 0; i < by_events.size(); ++i) {
        CHECK(by_libinput[i].tool == by_events[i].tool);
        REQUIRE(by_libinput[i].samples.size() == by_events[i].samples.size());
        for (std::size_t k = 0; k < by_events[i].samples.size(); ++k) {
            const PenSample &l = by_libinput[i].samples[k], &e = by_events[i].samples[k];
            CHECK(l.time_ns == e.time_ns);
            CHECK(*l.x_mm == Approx(*e.x_mm).margin(0.006));  // libinput counts one step more
            CHECK(*l.y_mm == Approx(*e.y_mm).margin(0.006));
            CHECK(l.buttons == e.buttons);
            CHECK(*l.pressure == Approx(*e.pressure).margin(0.06));  // libinput takes its threshold off
        }
    }
}

TEST_CASE("hover alone draws nothing", "[devices]") {
    MockTablets tablets;
    tablets.plug_evdev(0, false);
    TestClock clock;
    input::DeviceNumbers numbers;
    input::EvdevSource source({.clock = clock.clock(), .numbers = &numbers});
    std::vector<SourceEvent> events;
    tablets.frame(0, {{EV_KEY, BTN_TOOL_PEN, 1}, {EV_ABS, ABS_X, 100}}, 1);
    for (int i = 0; i < 20; ++i) tablets.frame(0, {{EV_ABS, ABS_X, 200 + i}}, 5000 * i);
    REQUIRE(wait_for(source, events, [&] { return count(events, SourceEventKind::Sample) == 21; }));
    for (const PenSample& s : samples(events)) CHECK(s.hover());
    CHECK(input::strokes_of(samples(events)).empty());
}

TEST_CASE("a pen that touches when the node is opened draws from there", "[devices]") {
    MockTablets tablets;
    tablets.plug_evdev(0, false, 12345);
    TestClock clock;
    input::DeviceNumbers numbers;
    input::EvdevSource source({.clock = clock.clock(), .numbers = &numbers});
    std::vector<SourceEvent> events;
    REQUIRE(wait_for(source, events, [&] { return count(events, SourceEventKind::Sample) == 1; }));
    tablets.frame(0, {{EV_ABS, ABS_X, 12400}}, clock.now_ns / 1000 + 5000);
    tablets.frame(0, {{EV_KEY, BTN_TOUCH, 0}, {EV_KEY, BTN_TOOL_PEN, 0}}, clock.now_ns / 1000 + 10000);
    REQUIRE(wait_for(source, events, [&] { return count(events, SourceEventKind::Sample) == 3; }));
    const auto strokes = input::strokes_of(samples(events));
    REQUIRE(strokes.size() == 1);
    CHECK(strokes[0].samples.size() == 2);
    CHECK(*strokes[0].samples[0].x_mm == Approx(12345 / 200.0));
    CHECK(*strokes[0].samples[0].pressure == Approx(4000 / 8191.0));
    const input::Trace trace = recorded(events, source);
    CHECK(input::decode_trace(trace).differing == 0);
}

TEST_CASE("unplugged in mid-stroke, plugged in again", "[devices]") {
    for (const bool hid : {true, false}) {
        DYNAMIC_SECTION((hid ? "hidraw" : "events")) {
            MockTablets tablets;
            TestClock clock;
            input::DeviceNumbers numbers;
            std::unique_ptr<input::PenSource> source;
            if (hid) {
                source = std::make_unique<input::HidSource>(
                    input::HidSourceOptions{.clock = clock.clock(), .numbers = &numbers});
            } else {
                source = std::make_unique<input::EvdevSource>(
                    input::EvdevSourceOptions{.clock = clock.clock(), .numbers = &numbers});
            }
            int number = 0;  // umockdev gives no node twice: the tablet comes back under another, as it may in life
            const auto plug = [&] {
                if (hid) {
                    tablets.plug_hid(number, same_ranges_descriptor(), true);
                } else {
                    tablets.plug_evdev(number, true);
                }
            };
            const auto draw = [&](int x, std::int64_t time_us) {
                if (hid) {
                    tablets.report(number, report_of({.tip = true, .x = x, .y = 100, .pressure = 5000}));
                } else {
                    tablets.frame(number,
                                  {{EV_KEY, BTN_TOOL_PEN, 1},
                                   {EV_KEY, BTN_TOUCH, 1},
                                   {EV_ABS, ABS_X, x},
                                   {EV_ABS, ABS_PRESSURE, 5000}},
                                  time_us);
                }
            };
            std::vector<SourceEvent> events;
            source->drain(events);
            CHECK(events.empty());
            plug();
            REQUIRE(wait_for(*source, events, [&] { return count(events, SourceEventKind::Attached) == 1; }));
            draw(1000, 1);
            REQUIRE(wait_for(*source, events, [&] { return count(events, SourceEventKind::Sample) == 1; }));
            CHECK(samples(events)[0].tip);
            if (hid) {
                tablets.unplug_hid(0);
            } else {
                tablets.unplug_evdev(0);
            }
            REQUIRE(wait_for(*source, events, [&] { return count(events, SourceEventKind::Detached) == 1; }));

            input::PenPipeline pipeline({});
            const std::uint32_t first = events.front().device;
            pipeline.attach(first, source->device(first).axes, true);
            REQUIRE(pipeline.feed(samples(events)[0]));
            CHECK(pipeline.detach(first, clock.now_ns));  // the stroke ends

            number = 1;
            plug();
            REQUIRE(wait_for(*source, events, [&] { return count(events, SourceEventKind::Attached) == 2; }));
            draw(2000, 2);
            REQUIRE(wait_for(*source, events, [&] { return count(events, SourceEventKind::Sample) == 2; }));
            CHECK(events.back().device != first);
            CHECK(*samples(events)[1].x_mm == Approx(2000 / 200.0));
        }
    }
}

TEST_CASE("two tablets at once", "[devices]") {
    MockTablets tablets;
    tablets.plug_evdev(0, false);
    tablets.plug_evdev(1, false);
    TestClock clock;
    input::DeviceNumbers numbers;
    input::EvdevSource source({.clock = clock.clock(), .numbers = &numbers});
    std::vector<SourceEvent> events;
    REQUIRE(wait_for(source, events, [&] { return count(events, SourceEventKind::Attached) == 2; }));
    for (int i = 0; i < 10; ++i) {
        for (const int n : {0, 1}) {
            tablets.frame(n,
                          {{EV_KEY, BTN_TOOL_PEN, 1},
                           {EV_KEY, BTN_TOUCH, 1},
                           {EV_ABS, ABS_X, 1000 * (n + 1) + i},
                           {EV_ABS, ABS_PRESSURE, 100 + i}},
                          10'000 + 5000 * i);
        }
    }
    REQUIRE(wait_for(source, events, [&] { return count(events, SourceEventKind::Sample) == 20; }));
    const auto strokes = input::strokes_of(samples(events));
    REQUIRE(strokes.size() == 2);
    CHECK(strokes[0].samples.size() == 10);
    CHECK(strokes[1].samples.size() == 10);
    CHECK(strokes[0].device != strokes[1].device);
}

TEST_CASE("a lift that never comes: silence ends the stroke", "[devices]") {
    // A tablet in the mode of a mouse with pressure: it says neither that the pen leaves nor, unplugged slowly, its
    // lift.
    MockTablets tablets;
    tablets.plug_hid(
        0,
        support::hex_bytes(
            "05 01 09 02 a1 01 85 09 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02 95 "
            "05 81 01 05 01 09 30 09 31 26 ff 7f 75 10 95 02 81 02 05 0d 09 30 26 ff 03 95 01 81 02 c0 c0"),
        false);
    TestClock clock;
    input::DeviceNumbers numbers;
    input::HidSource source({.clock = clock.clock(), .numbers = &numbers});
    std::vector<SourceEvent> events;
    REQUIRE(wait_for(source, events, [&] { return count(events, SourceEventKind::Attached) == 1; }));
    const input::TraceDevice device = source.device(events.front().device);
    CHECK_FALSE(device.reports_range);
    for (int i = 0; i < 3; ++i) {
        clock.now_ns += kStep_us * 1000;
        tablets.report(0, support::hex_bytes("09 01 10 0" + std::to_string(i) + " 20 00 ff 02"));
        REQUIRE(wait_for(source, events,
                         [&] { return count(events, SourceEventKind::Sample) == static_cast<std::size_t>(i) + 1; }));
    }
    input::PenPipeline pipeline({});
    pipeline.attach(device.number, device.axes, device.reports_range);
    input::StrokeBuilder strokes;
    for (const PenSample& s : samples(events)) {
        const auto passed = pipeline.feed(s);
        REQUIRE(passed);
        CHECK_FALSE(strokes.add(*passed));
    }
    const auto silent = pipeline.expire(clock.now_ns + 150'000'000);
    REQUIRE(silent.size() == 1);
    const auto stroke = strokes.add(silent[0]);
    REQUIRE(stroke);
    CHECK(stroke->samples.size() == 3);
}

TEST_CASE("lost events: the state is asked anew", "[devices]") {
    MockTablets tablets;
    tablets.plug_evdev(0, false, 7000);
    TestClock clock;
    input::DeviceNumbers numbers;
    input::EvdevSource source({.clock = clock.clock(), .numbers = &numbers});
    std::vector<SourceEvent> events;
    REQUIRE(wait_for(source, events, [&] { return count(events, SourceEventKind::Sample) == 1; }));
    tablets.frame(0, {{EV_SYN, SYN_DROPPED, 0}, {EV_ABS, ABS_X, 1}}, 5000);
    REQUIRE(wait_for(source, events, [&] { return count(events, SourceEventKind::Sample) == 2; }));
    CHECK(*samples(events)[1].x_mm == Approx(35.0));
    CHECK(samples(events)[1].tip);
}

TEST_CASE("a full queue is counted, and what came first stays", "[devices]") {
    MockTablets tablets;
    tablets.plug_evdev(0, false);
    TestClock clock;
    input::DeviceNumbers numbers;
    input::EvdevSource source({.clock = clock.clock(), .numbers = &numbers, .queue_events = 8});
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const std::int64_t start_us = clock.now_ns / 1000;
    tablets.frame(0, {{EV_KEY, BTN_TOOL_PEN, 1}}, start_us);
    for (int i = 0; i < 30; ++i) tablets.frame(0, {{EV_ABS, ABS_X, 10 + i}}, start_us + 5000 * i);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    while (source.lost() < 24 && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::vector<SourceEvent> events;
    source.drain(events);
    CHECK(source.lost() == 24);  // attached, 31 frames, 8 kept
    CHECK(events.size() == 8);
    CHECK(events[0].kind == SourceEventKind::Attached);
}

TEST_CASE("a mouse that reports nothing of a pen is left alone", "[devices]") {
    MockTablets tablets;
    tablets.plug_hid(
        0,
        support::hex_bytes("05 01 09 02 a1 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02 95 05 81 "
                           "03 05 01 09 30 09 31 15 81 25 7f 75 08 95 02 81 06 c0 c0"),
        false);
    input::DeviceNumbers numbers;
    input::HidSource source({.numbers = &numbers});
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    std::vector<SourceEvent> events;
    source.drain(events);
    CHECK(events.empty());
    CHECK(source.take_problems().empty());
    CHECK(input::list_hid_pens().empty());
}

TEST_CASE("tablets are listed with what they can", "[devices]") {
    MockTablets tablets;
    tablets.plug_hid(1, same_ranges_descriptor(), false);
    tablets.plug_evdev(2, false);
    const auto hid = input::list_hid_pens();
    REQUIRE(hid.size() == 1);
    CHECK(hid[0].node.node == "/dev/hidraw1");
    CHECK(hid[0].node.identity.name == "Mock HID Pen");
    CHECK(hid[0].node.identity.vendor == 0x1234);
    CHECK(hid[0].node.identity.interface == 0);
    const auto events = input::list_evdev_pens();
    REQUIRE(events.size() == 1);
    CHECK(events[0].node.node == "/dev/input/event2");
    CHECK(*events[0].axes.width_mm() == Approx(224.0));
    CHECK(input::missing_rule(hid[0].node).find("KERNELS==\"*:1234:5678.*\"") != std::string::npos);
}

TEST_CASE("each tablet has one owner", "[devices]") {
    MockTablets tablets;
    tablets.plug_hid(0, same_ranges_descriptor(), false);
    tablets.plug_hid(1, same_ranges_descriptor(), false, true);  // the kernel's driver has its pen
    tablets.plug_evdev(5, false);
    TestClock clock;
    input::DeviceNumbers numbers;
    input::TabletHub hub({.clock = clock.clock(), .numbers = &numbers});
    std::vector<SourceEvent> events;
    REQUIRE(wait_for(hub, events, [&] { return count(events, SourceEventKind::Attached) == 2; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    hub.drain(events);
    CHECK(count(events, SourceEventKind::Attached) == 2);
    std::set<std::string> owners;
    for (const SourceEvent& e : events)
        owners.insert(hub.device(e.device).source + " " + hub.device(e.device).identity.serial);
    CHECK(owners == std::set<std::string>{"evdev ", "hidraw SN0"});
    clock.now_ns += 5'000'000;
    tablets.report(0, report_of({.x = 5, .y = 5}));
    tablets.frame(5, {{EV_KEY, BTN_TOOL_PEN, 1}}, clock.now_ns / 1000 + 5000);
    CHECK(wait_for(hub, events, [&] { return count(events, SourceEventKind::Sample) == 2; }));
    CHECK(hub.lost() == 0);
    CHECK(hub.take_problems().empty());
}

TEST_CASE("the hub says that a tablet fell asleep with its pen on it", "[devices]") {
    MockTablets tablets;
    tablets.plug_hid(0, same_ranges_descriptor(), false);
    TestClock clock;
    input::DeviceNumbers numbers;
    input::TabletHub hub({.clock = clock.clock(), .numbers = &numbers});
    std::vector<SourceEvent> events;
    REQUIRE(wait_for(hub, events, [&] { return count(events, SourceEventKind::Attached) == 1; }));
    tablets.report(0, report_of({.x = 500, .y = 500}));
    REQUIRE(wait_for(hub, events, [&] { return count(events, SourceEventKind::Sample) == 1; }));
    clock.now_ns += 1'900'000'000;
    hub.drain(events);
    CHECK(count(events, SourceEventKind::Asleep) == 0);
    clock.now_ns += 200'000'000;
    hub.drain(events);
    hub.drain(events);
    CHECK(count(events, SourceEventKind::Asleep) == 1);
    CHECK(count(events, SourceEventKind::Detached) == 0);
}

TEST_CASE("what stands in the way of opening a node is said with the remedy", "[devices]") {
    input::UdevNode node;
    node.subsystem = "hidraw";
    node.node = "/dev/hidraw3";
    node.identity.name = "Some Pen";
    node.identity.vendor = 0x256c;
    node.identity.product = 0x006e;
    const std::string refused = input::opening_problem(node, EACCES);
    CHECK(refused.find("/dev/hidraw3 (Some Pen) may not be opened by this user") == 0);
    CHECK(refused.find(
              "SUBSYSTEM==\"hidraw\", KERNELS==\"*:256C:006E.*\", MODE=\"0660\", GROUP=\"input\", TAG+=\"uaccess\"") !=
          std::string::npos);
    CHECK(refused.find("/etc/udev/rules.d/70-croquis-tablets.rules") != std::string::npos);
    CHECK(input::opening_problem(node, EBUSY) ==
          "/dev/hidraw3 (Some Pen) is held by another program; end that program");
    CHECK(input::opening_problem(node, ENODEV).empty());
    CHECK(input::opening_problem(node, EIO).find("cannot be opened") != std::string::npos);
}
