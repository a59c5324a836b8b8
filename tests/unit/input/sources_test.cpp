#include <catch2/catch.hpp>
#include <thread>

#include "../../support/hex_bytes.hpp"
#include "../../support/temporary_folder.hpp"
#include "input/pipeline/stroke_builder.hpp"
#include "input/sources/pointer_source.hpp"
#include "input/sources/spsc_queue.hpp"
#include "input/sources/trace_source.hpp"
#include "input/trace/trace_recorder.hpp"

using input::PenSample;
using input::SourceEvent;
using input::SourceEventKind;

namespace {

constexpr std::int64_t kMs = 1'000'000;

PenSample at(std::int64_t ms, double x, bool tip = true) {
    PenSample s;
    s.time_ns = ms * kMs;
    s.device = 1;
    s.x = s.y = x;
    s.in_range = true;
    s.tip = tip;
    return s;
}

input::Trace small_trace() {
    input::Trace trace;
    input::TraceDevice device;
    device.number = 1;
    device.identity.name = "Pen";
    device.source = "hidraw";
    trace.records = {device, input::TraceChange{1, 1000 * kMs, input::DeviceChange::Attached}};
    for (int i = 0; i < 5; ++i) trace.records.emplace_back(at(1010 + 10 * i, 0.1 * i));
    trace.records.emplace_back(input::TraceChange{1, 1060 * kMs, input::DeviceChange::Detached});
    return trace;
}

std::vector<PenSample> samples_of(const std::vector<SourceEvent>& events) {
    std::vector<PenSample> out;
    for (const SourceEvent& e : events) {
        if (e.sample_valid) out.push_back(e.sample);
    }
    return out;
}

}  // namespace

TEST_CASE("the queue keeps its order, refuses when full, and counts what it refused", "[sources]") {
    input::SpscQueue<int> queue(4);
    for (int i = 0; i < 6; ++i) CHECK(queue.push(i) == (i < 4));
    CHECK(queue.lost() == 2);
    CHECK(queue.size() == 4);
    int value = -1;
    for (int i = 0; i < 4; ++i) {
        REQUIRE(queue.pop(value));
        CHECK(value == i);
    }
    CHECK_FALSE(queue.pop(value));
}

TEST_CASE("two threads pass everything through the queue in order", "[sources]") {
    input::SpscQueue<std::uint64_t> queue(64);
    constexpr std::uint64_t kCount = 200'000;
    std::jthread writer([&] {
        for (std::uint64_t i = 0; i < kCount;) {
            if (queue.push(i)) {
                ++i;
            } else {
                std::this_thread::yield();
            }
        }
    });
    std::uint64_t next = 0, value = 0;
    bool in_order = true;
    while (next < kCount) {
        if (queue.pop(value)) {
            in_order = in_order && value == next++;
        } else {
            std::this_thread::yield();
        }
    }
    CHECK(in_order);
}

TEST_CASE("a trace is replayed in its time, faster, or at once", "[sources]") {
    std::int64_t now = 5000 * kMs;
    const auto clock = [&] { return now; };
    std::vector<SourceEvent> events;
    SECTION("in its own time") {
        input::TraceSource source(small_trace(), {.clock = clock});
        source.drain(events);
        REQUIRE(events.size() == 1);
        CHECK(events[0].kind == SourceEventKind::Attached);
        CHECK(source.device(1).identity.name == "Pen");
        CHECK(source.due_ns() == 5010 * kMs);
        now += 25 * kMs;
        source.drain(events);
        CHECK(events.size() == 3);
        now += 1000 * kMs;
        source.drain(events);
        CHECK(events.size() == 7);
        CHECK(source.finished());
        CHECK(events[3].time_ns == 1030 * kMs);  // as recorded
    }
    SECTION("twice as fast") {
        input::TraceSource source(small_trace(), {.clock = clock, .speed = 2.0});
        source.drain(events);
        now += 25 * kMs;
        source.drain(events);
        CHECK(events.size() == 6);
    }
    SECTION("at once") {
        input::TraceSource source(small_trace(), {.clock = clock, .paced = false});
        source.drain(events);
        CHECK(events.size() == 7);
        CHECK(samples_of(events) == small_trace().samples());
    }
}

TEST_CASE("what is recorded can be read, and a file is never overwritten", "[sources]") {
    const support::TemporaryFolder folder;
    const std::string path = folder.path("a.trace");
    {
        input::TraceSource source(small_trace(), {.paced = false});
        std::vector<SourceEvent> events;
        source.drain(events);
        auto recorder = input::TraceRecorder::create(path);
        REQUIRE(recorder);
        for (const SourceEvent& e : events) (*recorder)->record(e, source);
        (*recorder)->mark(7, "done");
        CHECK((*recorder)->lost() == 0);
    }
    const auto trace = input::read_trace(path);
    REQUIRE(trace);
    CHECK(trace->fault_count == 0);
    CHECK(trace->samples() == small_trace().samples());
    CHECK(trace->device(1)->identity.name == "Pen");
    CHECK(trace->records.size() == small_trace().records.size() + 1);
    const auto again = input::TraceRecorder::create(path);
    REQUIRE_FALSE(again);
    CHECK(again.error().message == "there is such a file already; give another name");
    CHECK_FALSE(input::TraceRecorder::create(folder.path("no/a.trace")));
}

TEST_CASE("events become the records of a trace", "[sources]") {
    SourceEvent e;
    e.device = 1;
    e.time_ns = 9;
    e.set_raw(input::RawKind::HidReport, support::hex_bytes("07 01 02"));
    std::vector<input::TraceRecord> records;
    input::append_records(e, {}, records);
    REQUIRE(records.size() == 1);
    CHECK(std::get<input::TraceReport>(records[0]).bytes.size() == 3);
    e.set_raw(input::RawKind::HidReport, std::vector<std::uint8_t>(300, 1));
    e.sample_valid = true;
    e.sample = at(9, 0.5);
    input::append_records(e, {}, records);
    REQUIRE(records.size() == 3);
    CHECK(std::holds_alternative<input::TraceMarker>(records[1]));
    CHECK(std::holds_alternative<PenSample>(records[2]));
}

TEST_CASE("mouse and touch draw", "[sources]") {
    input::DeviceNumbers numbers;
    input::PointerSource pointer({.numbers = &numbers, .palm = {}});
    pointer.mouse(0.1, 0.2, false, 0);
    pointer.mouse(0.2, 0.2, true, kMs);
    pointer.mouse(1.5, 0.2, true, 2 * kMs);
    pointer.mouse_left(3 * kMs);
    pointer.touch_down(7, 0.5, 0.5, 0.25, 4 * kMs);
    pointer.touch_down(8, 0.9, 0.9, {}, 5 * kMs);  // a second finger draws nothing
    pointer.touch_move(8, 0.8, 0.9, {}, 6 * kMs);
    pointer.touch_move(7, 0.6, 0.5, 0.5, 6 * kMs);
    pointer.touch_up(7, 7 * kMs);
    std::vector<SourceEvent> events;
    pointer.drain(events);
    const auto strokes = input::strokes_of(samples_of(events));
    REQUIRE(strokes.size() == 2);
    CHECK(strokes[0].samples.size() == 2);
    CHECK(*strokes[0].samples[1].x == 1.0);
    CHECK_FALSE(strokes[0].samples[0].pressure);
    CHECK(strokes[1].tool == input::PenTool::Touch);
    CHECK(strokes[1].samples.size() == 2);
    CHECK(*strokes[1].samples[0].pressure == 0.25);
    CHECK(strokes[0].device != strokes[1].device);
    CHECK(pointer.device(strokes[0].device).identity.name == "mouse");
    events.clear();
    pointer.drain(events);
    CHECK(events.empty());
}

TEST_CASE("a touch is no pen while one is near, and a palm's line is taken back", "[sources]") {
    input::DeviceNumbers numbers;
    input::PointerSource pointer({.numbers = &numbers, .palm = {}});
    pointer.touch_down(1, 0.5, 0.5, {}, 900 * kMs);
    pointer.pen(at(1000, 0.3, false));
    CHECK(pointer.take_cancelled());
    CHECK_FALSE(pointer.take_cancelled());
    pointer.touch_move(1, 0.6, 0.5, {}, 1010 * kMs);
    pointer.touch_down(2, 0.1, 0.1, {}, 1020 * kMs);
    std::vector<SourceEvent> events;
    pointer.drain(events);
    CHECK(samples_of(events).size() == 2);  // down, and gone
    pointer.pen_detached(1, 1030 * kMs);
    events.clear();
    pointer.touch_down(3, 0.1, 0.1, {}, 2000 * kMs);
    pointer.drain(events);
    CHECK(samples_of(events).size() == 1);
}
