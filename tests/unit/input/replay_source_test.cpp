#include "input/sources/replay_source.hpp"

#include <catch2/catch.hpp>
#include <string>

using input::PenEvent;
using input::PenEventKind;
using input::ReplaySource;

namespace {

core::Drawing two_strokes() {
    return {{{{{0, 1, 1, 0.5}, {10'000, 2, 1, 0.6}, {20'000, 3, 1, 0.7}}}, {{{500'000, 9, 9, 1.0}}}}};
}

/// "D1 M2 …": the kind's letter and x.
std::string written(const std::vector<PenEvent>& events) {
    std::string text;
    for (const PenEvent& event : events) {
        text += text.empty() ? "" : " ";
        text += event.kind == PenEventKind::Down ? 'D' : event.kind == PenEventKind::Move ? 'M' : 'U';
        text += std::to_string(static_cast<int>(event.sample.x));
    }
    return text;
}

}  // namespace

TEST_CASE("a replay gives each sample when its time has come, and the lift with the last", "[replay_source]") {
    ReplaySource pen(two_strokes());
    CHECK(written(pen.next(7'000'000)) == "D1");
    CHECK(written(pen.next(7'000'000)).empty());
    CHECK(written(pen.next(7'009'999)).empty());
    CHECK(written(pen.next(7'010'000)) == "M2");
    CHECK(pen.due_us() == 7'020'000);
    CHECK(written(pen.next(7'300'000)) == "M3 U3");
    CHECK_FALSE(pen.finished());
    CHECK(written(pen.next(9'000'000)) == "D9 U9");
    CHECK(pen.finished());
    CHECK(pen.next(99'000'000).empty());
}

TEST_CASE("a replay keeps the recorded samples at any speed", "[replay_source]") {
    ReplaySource pen(two_strokes(), {.speed = 2.0});
    CHECK(written(pen.next(0)) == "D1");
    CHECK(written(pen.next(4'999)).empty());
    const std::vector<PenEvent> events = pen.next(5'000);
    REQUIRE(written(events) == "M2");
    CHECK(events[0].sample.time_us == 10'000);
    CHECK(events[0].sample.pressure == Approx(0.6));
    CHECK(written(pen.next(250'000)) == "M3 U3 D9 U9");
}

TEST_CASE("as fast as possible, a replay does not look at the clock", "[replay_source]") {
    SECTION("all at once") {
        ReplaySource pen(two_strokes(), {.paced = false});
        CHECK(written(pen.next(0)) == "D1 M2 M3 U3 D9 U9");
        CHECK(pen.finished());
    }
    SECTION("in batches") {
        ReplaySource pen(two_strokes(), {.paced = false, .batch = 4});
        CHECK(written(pen.next(0)) == "D1 M2 M3 U3");
        CHECK(written(pen.next(0)) == "D9 U9");
        CHECK(pen.finished());
    }
}

TEST_CASE("a clock that runs backwards gives nothing, and neither does an empty drawing", "[replay_source]") {
    ReplaySource pen(two_strokes());
    CHECK(written(pen.next(1'000)) == "D1");
    CHECK(pen.next(-1'000'000).empty());
    ReplaySource nothing({{core::Stroke{}}});
    CHECK(nothing.finished());
    CHECK(nothing.next(0).empty());
}
