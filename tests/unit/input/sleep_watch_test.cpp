#include "input/sources/sleep_watch.hpp"

#include <catch2/catch.hpp>

using input::SourceEvent;
using input::SourceEventKind;

namespace {

constexpr std::int64_t kMs = 1'000'000;

input::TraceDevice tablet(std::uint32_t number, const char* source, bool reports_range = true) {
    input::TraceDevice d;
    d.number = number;
    d.source = source;
    d.reports_range = reports_range;
    return d;
}

SourceEvent event(SourceEventKind kind, std::uint32_t device, std::int64_t ms, bool near = false) {
    SourceEvent e;
    e.kind = kind;
    e.device = device;
    e.time_ns = ms * kMs;
    e.sample_valid = kind == SourceEventKind::Sample;
    e.sample.device = device;
    e.sample.time_ns = e.time_ns;
    e.sample.in_range = near;
    return e;
}

std::vector<SourceEvent> asleep(input::SleepWatch& watch, std::int64_t ms) {
    std::vector<SourceEvent> out;
    watch.append_asleep(ms * kMs, out);
    return out;
}

}  // namespace

TEST_CASE("a tablet that is silent while its pen is near is asleep, said once", "[sleep]") {
    input::SleepWatch watch;
    watch.see(event(SourceEventKind::Attached, 7, 0), tablet(7, "hidraw"));
    CHECK(asleep(watch, 60'000).empty());  // no pen: silence is right
    watch.see(event(SourceEventKind::Sample, 7, 61'000, true), {});
    CHECK(asleep(watch, 62'999).empty());
    const std::vector<SourceEvent> said = asleep(watch, 63'500);
    REQUIRE(said.size() == 1);
    CHECK(said[0].kind == SourceEventKind::Asleep);
    CHECK(said[0].device == 7);
    CHECK(said[0].time_ns == 63'000 * kMs);
    CHECK(asleep(watch, 90'000).empty());

    watch.see(event(SourceEventKind::Sample, 7, 91'000, true), {});  // awake, and asleep again
    CHECK(asleep(watch, 93'000).size() == 1);
}

TEST_CASE("silence without a pen, of an event node or of a tablet that never says is no sleep", "[sleep]") {
    input::SleepWatch watch;
    watch.see(event(SourceEventKind::Attached, 1, 0), tablet(1, "hidraw"));
    watch.see(event(SourceEventKind::Attached, 2, 0), tablet(2, "evdev"));
    watch.see(event(SourceEventKind::Attached, 3, 0), tablet(3, "hidraw", false));
    for (const std::uint32_t device : {1U, 2U, 3U}) watch.see(event(SourceEventKind::Sample, device, 10, true), {});
    watch.see(event(SourceEventKind::Sample, 1, 20, false), {});  // the pen leaves
    CHECK(asleep(watch, 10'000).empty());
    watch.see(event(SourceEventKind::Sample, 1, 10'000, true), {});
    watch.see(event(SourceEventKind::Detached, 1, 10'100), {});
    CHECK(asleep(watch, 20'000).empty());
}

TEST_CASE("reports that hold no pen are signs of life, too", "[sleep]") {
    input::SleepWatch watch;
    watch.see(event(SourceEventKind::Attached, 1, 0), tablet(1, "hidraw"));
    watch.see(event(SourceEventKind::Sample, 1, 0, true), {});
    SourceEvent keys = event(SourceEventKind::Sample, 1, 1'900);
    keys.sample_valid = false;
    watch.see(keys, {});
    CHECK(asleep(watch, 2'500).empty());
    CHECK(asleep(watch, 3'900).size() == 1);
}
