// croquis trace info|convert|replay|record.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/exchange/file_bytes.hpp"
#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/commands/live_tablets.hpp"
#include "firmware_like_app/commands/pen_json.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "input/formats/any_ink.hpp"
#include "input/formats/decode_capture.hpp"
#include "input/formats/ink_writers.hpp"
#include "input/sources/trace_source.hpp"
#include "input/trace/decode_trace.hpp"
#include "input/trace/trace_recorder.hpp"

namespace app {
namespace {

using nlohmann::ordered_json;

struct TraceOptions {
    std::string file, out, by = "auto";
    double seconds = 0.0, speed = 1.0;
    bool json = false, paced = false;
};

/// Damage does not stop a command, but it is said, and the exit code tells.
void warn(CommandState& state, const std::string& file, const std::string& warning) {
    if (warning.empty()) return;
    fail(state, {core::ErrorCode::Damaged, warning, file});
}

struct Counts {
    std::size_t reports = 0, frames = 0, samples = 0, changes = 0, markers = 0;
    std::int64_t first_ns = 0, last_ns = 0;
    bool any = false;

    void time(std::int64_t ns) {
        first_ns = any ? std::min(first_ns, ns) : ns;
        last_ns = any ? std::max(last_ns, ns) : ns;
        any = true;
    }
    void operator()(const input::TraceDevice&) {}
    void operator()(const input::TraceReport& r) { ++reports, time(r.time_ns); }
    void operator()(const input::TraceFrame& f) { ++frames, time(f.time_ns); }
    void operator()(const input::PenSample& s) { ++samples, time(s.time_ns); }
    void operator()(const input::TraceChange& c) { ++changes, time(c.time_ns); }
    void operator()(const input::TraceMarker& m) { ++markers, time(m.time_ns); }
};

void run_info(const TraceOptions& options, CommandState& state) {
    const core::Result<input::AnyInk> ink = input::read_any_ink(options.file);
    if (!ink) return fail(state, ink.error());
    const input::Trace& trace = ink->trace;
    Counts counts;
    for (const input::TraceRecord& r : trace.records) std::visit(counts, r);
    const std::vector<input::PenSample> samples = trace.samples();
    const std::size_t strokes = input::strokes_of(samples).size();
    const double duration_ms = static_cast<double>(counts.last_ns - counts.first_ns) * 1e-6;
    const double rate = input::report_rate_hz(samples);
    ordered_json devices = ordered_json::array();
    for (const input::TraceRecord& r : trace.records) {
        const auto* d = std::get_if<input::TraceDevice>(&r);
        if (d == nullptr) continue;
        if (!options.json) {
            const std::string id = d->identity.known() ? " " + input::vendor_product(d->identity) : std::string();
            std::printf("device %u: %s%s, by %s, parser %s\n", d->number, d->identity.name.c_str(), id.c_str(),
                        d->source.c_str(), d->parser.c_str());
        }
        devices.push_back({{"number", d->number},
                           {"identity", identity_json(d->identity)},
                           {"source", d->source},
                           {"parser", d->parser},
                           {"axes", axes_json(d->axes)},
                           {"descriptor", descriptor_json(d->descriptor)}});
    }
    if (options.json) {
        const ordered_json out{{"format", ink->format},
                               {"version", ink->format == "trace" ? input::kTraceVersion : 0},
                               {"devices", devices},
                               {"records",
                                {{"reports", counts.reports},
                                 {"frames", counts.frames},
                                 {"samples", counts.samples},
                                 {"changes", counts.changes},
                                 {"markers", counts.markers}}},
                               {"duration_ms", duration_ms},
                               {"rate_hz", rate},
                               {"strokes", strokes},
                               {"differing", input::decode_trace(trace).differing},
                               {"damaged", trace.fault_count}};
        print_json(out);
    } else {
        std::printf("%s: %zu reports, %zu frames, %zu samples, %zu strokes in %.1f s, %.0f samples a second\n",
                    ink->format.c_str(), counts.reports, counts.frames, counts.samples, strokes, duration_ms / 1000,
                    rate);
    }
    warn(state, options.file, ink->warning);
}

core::Result<std::string> text_for(const std::string& path, const input::Trace& trace,
                                   const std::vector<input::PenStroke>& strokes) {
    const std::string extension = core::lower_extension(path);
    if (extension == "trace") return input::trace_text(trace);
    if (extension == "inkml") return input::inkml_text(strokes);
    if (extension == "svg") return input::svg_text(strokes);
    if (extension == "ndjson") return input::quickdraw_text(strokes);
    return core::unexpected(core::ErrorCode::BadArgument, "the name has to end in .trace, .inkml, .svg or .ndjson",
                            path);
}

void run_convert(const TraceOptions& options, CommandState& state) {
    const core::Result<input::AnyInk> ink = input::read_any_ink(options.file);
    if (!ink) return fail(state, ink.error());
    const std::vector<input::PenStroke> strokes = input::strokes_of(input::decode_trace(ink->trace).samples);
    const core::Result<std::string> text = text_for(options.out, ink->trace, strokes);
    if (!text) {
        return fail_call(state, text.error());
    }
    if (core::lower_extension(options.out) != "trace" && input::drawing_of(strokes).empty()) {
        return fail(state, {core::ErrorCode::EmptyDrawing, "no pen draws in this", options.file});
    }
    if (const auto written = input::write_whole_file(options.out, *text); !written) return fail(state, written.error());
    if (options.json) {
        const ordered_json out{{"from", ink->format}, {"out", options.out}, {"strokes", strokes.size()}};
        print_json(out);
    } else {
        std::printf("%s: %zu strokes\n", options.out.c_str(), strokes.size());
    }
    warn(state, options.file, ink->warning);
}

/// Plays the trace and collects or prints the strokes as they end.
std::vector<input::PenStroke> replay(const input::Trace& trace, const TraceOptions& options) {
    input::TraceSource source(trace, {.speed = options.speed, .paced = options.paced});
    input::StrokeBuilder builder;
    std::vector<input::PenStroke> strokes;
    const auto take = [&](std::optional<input::PenStroke> stroke) {
        if (!stroke) return;
        strokes.push_back(std::move(*stroke));
        if (!options.json) std::printf("%s\n", stroke_line(strokes.size(), strokes.back()).c_str());
    };
    std::vector<input::SourceEvent> events;
    while (!source.finished()) {
        events.clear();
        source.drain(events);
        for (const input::SourceEvent& e : events) {
            if (e.kind == input::SourceEventKind::Detached) take(builder.end(e.device));
            if (e.sample_valid) take(builder.add(e.sample));
        }
        if (options.paced && !source.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    for (input::PenStroke& last : builder.finish()) take(std::move(last));
    return strokes;
}

void run_replay(const TraceOptions& options, CommandState& state) {
    const core::Result<input::AnyInk> ink = input::read_any_ink(options.file);
    if (!ink) return fail(state, ink.error());
    const std::vector<input::PenStroke> strokes = replay(ink->trace, options);
    if (options.json) {
        const ordered_json out{{"format", ink->format}, {"strokes", strokes_json(strokes)}};
        print_json(out);
    } else if (strokes.empty()) {
        std::printf("no strokes\n");
    }
    warn(state, options.file, ink->warning);
}

void run_record(const TraceOptions& options, CommandState& state) {
    input::DeviceNumbers numbers;
    core::Result<std::unique_ptr<input::PenSource>> source = open_tablets(options.by, numbers);
    if (!source) {
        return fail_call(state, source.error());
    }
    core::Result<std::unique_ptr<input::TraceRecorder>> recorder = input::TraceRecorder::create(options.out);
    if (!recorder) return fail(state, recorder.error());
    std::size_t devices = 0, samples = 0;
    const std::optional<double> seconds = options.seconds > 0.0 ? std::optional(options.seconds) : std::nullopt;
    if (!options.json) std::fprintf(stderr, "recording; Ctrl-C ends it\n");
    watch_tablets(**source, seconds, [&](const std::vector<input::SourceEvent>& events) {
        for (const input::SourceEvent& e : events) {
            (*recorder)->record(e, **source);
            devices += e.kind == input::SourceEventKind::Attached ? 1 : 0;
            samples += e.sample_valid ? 1 : 0;
        }
        return true;
    });
    const std::uint64_t lost = (*source)->lost() + (*recorder)->lost();
    recorder->reset();
    if (options.json) {
        const ordered_json out{{"out", options.out}, {"tablets", devices}, {"samples", samples}, {"lost", lost}};
        print_json(out);
    } else {
        std::printf("%s: %zu tablets, %zu samples, %llu lost\n", options.out.c_str(), devices, samples,
                    static_cast<unsigned long long>(lost));
    }
    if (devices == 0) {
        std::error_code ignored;
        std::filesystem::remove(options.out, ignored);
        fail(state, {core::ErrorCode::FileMissing,
                     "no tablet was there to record from; plug one in, and see croquis tablet list", options.out});
    }
}

}  // namespace

void add_trace_commands(Command cli, CommandState& state) {
    Command trace = cli.group("trace", "Stroke logs: what tablets sent, and what was made of it");
    auto options = std::make_shared<TraceOptions>();
    const char* kinds = "trace, hid-recorder, usbhid-dump, evemu, libinput record, InkML, SVG or Quick-Draw line";

    Command info = trace.command("info", "What is in it");
    info.option("FILE", options->file, kinds).required();
    info.flag("--json", options->json, "one JSON object on standard output");
    info.runs([options, &state] { run_info(*options, state); });

    Command convert = trace.command("convert", "Write it in another format");
    convert.option("FILE", options->file, kinds).required();
    convert.option("OUT", options->out, "ends in .trace, .inkml, .svg or .ndjson").required();
    convert.flag("--json", options->json, "one JSON object on standard output");
    convert.runs([options, &state] { run_convert(*options, state); });

    Command play = trace.command("replay", "Play it again and print its strokes");
    play.option("FILE", options->file, kinds).required();
    play.flag("--paced", options->paced, "in the time in which it was drawn");
    play.option("--speed", options->speed, "with --paced: so many times as fast").range(0.01, 1000.0);
    play.flag("--json", options->json, "one JSON object on standard output");
    play.runs([options, &state] { run_replay(*options, state); });

    Command record = trace.command("record", "Record from the tablets that are plugged in");
    record.option("OUT", options->out, "a new file, NAME.trace").required();
    record.option("--seconds", options->seconds, "stop after this time").positive();
    record.option("--by", options->by, "auto, hidraw, evdev or libinput");
    record.flag("--json", options->json, "one JSON object on standard output");
    record.runs([options, &state] { run_record(*options, state); });
}

}  // namespace app
