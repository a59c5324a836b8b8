// What a pen's report costs on its way, stage by stage.

#include <catch2/catch.hpp>

#include "../support/hex_bytes.hpp"
#include "input/devices/make_decoder.hpp"
#include "input/pipeline/pipeline.hpp"
#include "input/sources/pen_source.hpp"
#include "input/sources/spsc_queue.hpp"

TEST_CASE("a pen's report", "[pen]") {
    const auto descriptor = input::parse_report_descriptor(support::generic_pen_descriptor());
    const auto decoder = input::make_decoder(nullptr, *descriptor, {});
    const std::vector<std::uint8_t> bytes = support::hex_bytes("07 13 10 27 20 4e ff 1f 0a f6");
    input::PenReport report;
    const input::PenAxes* axes = nullptr;
    REQUIRE(decoder->decode(bytes, report, axes));

    BENCHMARK("decode by descriptor, to a sample") {
        (void)decoder->decode(bytes, report, axes);
        return to_sample(report, *axes, 1, 1);
    };
    BENCHMARK_ADVANCED("decode, into the queue and out")(Catch::Benchmark::Chronometer meter) {
        input::SpscQueue<input::SourceEvent> queue(1024);
        input::SourceEvent out;
        meter.measure([&] {
            (void)decoder->decode(bytes, report, axes);
            input::SourceEvent event;
            event.set_raw(input::RawKind::HidReport, bytes);
            event.sample = to_sample(report, *axes, 1, 1);
            event.sample_valid = true;
            queue.push(event);
            return queue.pop(out);
        });
    };
    BENCHMARK_ADVANCED("the whole pipeline after the queue")(Catch::Benchmark::Chronometer meter) {
        input::PenPipeline pipeline({});
        pipeline.attach(1, *axes, true);
        input::PenSample s = to_sample(report, *axes, 1, 1);
        meter.measure([&] {
            s.time_ns += 4'000'000;
            s.x = *s.x < 0.9 ? *s.x + 1e-4 : 0.1;
            return pipeline.feed(s);
        });
    };
    BENCHMARK("parse the descriptor and find its pens") {
        return input::find_pens(*input::parse_report_descriptor(support::generic_pen_descriptor())).size();
    };
    BENCHMARK("a line of the trace") {
        return input::trace_line(to_sample(report, *axes, 123456789, 1)).size();
    };
}
