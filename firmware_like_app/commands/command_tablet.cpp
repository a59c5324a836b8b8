// croquis tablet list|monitor|decode.

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/exchange/file_bytes.hpp"
#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/commands/live_tablets.hpp"
#include "firmware_like_app/commands/pen_json.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "input/formats/decode_capture.hpp"
#include "input/formats/text_lines.hpp"
#include "input/sources/tablet_hub.hpp"
#include "input/trace/decode_trace.hpp"

namespace app {
namespace {

using nlohmann::ordered_json;

struct TabletOptions {
    std::string file, by = "auto", id, descriptor;
    double seconds = 0.0;
    bool json = false;
};

/// One line of the list.
struct Listed {
    input::UdevNode node;
    std::string source, parser;
    input::PenAxes axes;
    bool used = false;  ///< by this source; a tablet's other nodes are listed, too
    bool readable = true;
};

std::vector<Listed> list_tablets() {
    std::vector<Listed> all;
    for (const input::EvdevPenNode& pen : input::list_evdev_pens()) {
        const bool used = pen.node.hid_path.empty() || input::kernel_knows_pen(pen.node);
        all.push_back({pen.node, "evdev", "evdev", pen.axes, used, pen.readable});
    }
    for (const input::HidPen& pen : input::list_hid_pens()) {
        const bool readable = access(pen.node.node.c_str(), R_OK | W_OK) == 0;
        all.push_back({pen.node, "hidraw", pen.parser, pen.axes, !input::kernel_knows_pen(pen.node), readable});
    }
    return all;
}

void run_list(const TabletOptions& options, CommandState& state) {
    ordered_json tablets = ordered_json::array();
    for (const Listed& t : list_tablets()) {
        const std::optional<int> battery = input::battery_of(t.node);
        const std::optional<input::TabletFacts> facts = input::tablet_facts(t.node.identity);
        const std::string name = facts && !facts->name.empty() ? facts->name : t.node.identity.name;
        if (options.json) {
            ordered_json j{{"node", t.node.node}, {"source", t.source},
                           {"used", t.used},      {"readable", t.readable},
                           {"name", name},        {"identity", identity_json(t.node.identity)},
                           {"parser", t.parser},  {"axes", axes_json(t.axes)}};
            if (battery) j["battery"] = *battery;
            if (facts) j["tablet_buttons"] = facts->buttons;
            tablets.push_back(std::move(j));
        } else {
            std::printf("%-18s %s %s, %s%s", t.node.node.c_str(), input::vendor_product(t.node.identity).c_str(),
                        name.c_str(), t.parser.c_str(),
                        t.used ? "" : " (not used: the tablet is read by another node)");
            if (t.axes.width_mm() && t.axes.height_mm())
                std::printf(", %.0f x %.0f mm", *t.axes.width_mm(), *t.axes.height_mm());
            if (battery) std::printf(", battery %d %%", *battery);
            std::printf("\n");
            tablets.push_back(true);
        }
        if (!t.readable && t.used) {
            fail(state, {core::ErrorCode::FileUnreadable, "this user may not open it; " + input::missing_rule(t.node),
                         t.node.node});
        }
    }
    if (options.json) {
        print_json(ordered_json{{"tablets", tablets}});
    } else if (tablets.empty()) {
        std::printf("no tablet is attached\n");
    }
}

/// What the monitor knows of one tablet.
struct Watched {
    input::TraceDevice device;
    input::PenSample last;
    std::int64_t last_ns = 0;
    std::size_t reports = 0, steps = 0;
    double step_sum_ms = 0.0, step_squares = 0.0;

    void see(const input::SourceEvent& e) {
        const double step_ms = static_cast<double>(e.time_ns - last_ns) * 1e-6;
        if (last_ns != 0 && step_ms < 100.0) {
            ++steps;
            step_sum_ms += step_ms;
            step_squares += step_ms * step_ms;
        }
        last_ns = e.time_ns;
        last = e.sample;
        ++reports;
    }
    [[nodiscard]] double rate_hz() const {
        return step_sum_ms > 0.0 ? 1000.0 * static_cast<double>(steps) / step_sum_ms : 0.0;
    }
    [[nodiscard]] double jitter_ms() const {
        if (steps < 2) return 0.0;
        const double mean = step_sum_ms / static_cast<double>(steps);
        return std::sqrt(std::max(0.0, step_squares / static_cast<double>(steps) - mean * mean));
    }
    /// Rate and jitter are of the last moments, not of the whole day.
    void forget() {
        steps = 0;
        step_sum_ms = step_squares = 0.0;
    }
};

std::optional<int> battery_of(const input::DeviceIdentity& identity) {
    for (const char* subsystem : {"hidraw", "input"}) {
        for (const input::UdevNode& node : input::udev_nodes(subsystem)) {
            if (node.identity.vendor == identity.vendor && node.identity.product == identity.product) {
                if (const auto battery = input::battery_of(node)) return battery;
            }
        }
    }
    return std::nullopt;
}

std::string monitor_line(const Watched& w, std::uint64_t lost, const std::optional<int>& battery) {
    const input::PenSample& s = w.last;
    const auto number = [](const std::optional<double>& v, const char* format) {
        std::array<char, 32> text{};
        if (v) std::snprintf(text.data(), text.size(), format, *v);
        return v ? std::string(text.data()) : std::string("-");
    };
    std::string line = w.device.identity.name + ": ";
    line += !s.in_range ? "away" : s.tip ? "draws" : "hovers";
    line += " x " + number(s.x_mm ? s.x_mm : s.x, "%.2f") + " y " + number(s.y_mm ? s.y_mm : s.y, "%.2f");
    line += " pressure " + number(s.pressure, "%.3f") + " tilt " + number(s.tilt_x_rad, "%+.2f") + "," +
            number(s.tilt_y_rad, "%+.2f");
    line += " " + std::string(tool_name(s.tool)) + " buttons " + std::to_string(s.buttons);
    std::array<char, 120> rest{};
    std::snprintf(rest.data(), rest.size(), " | %.0f Hz, jitter %.2f ms, %s, %llu lost", w.rate_hz(), w.jitter_ms(),
                  w.device.parser.c_str(), static_cast<unsigned long long>(lost));
    line += rest.data();
    if (battery) line += ", battery " + std::to_string(*battery) + " %";
    return line;
}

ordered_json monitor_json(const std::map<std::uint32_t, Watched>& tablets, std::uint64_t lost) {
    ordered_json list = ordered_json::array();
    for (const auto& [number, w] : tablets) {
        ordered_json j{{"device", identity_json(w.device.identity)},
                       {"parser", w.device.parser},
                       {"source", w.device.source},
                       {"axes", axes_json(w.device.axes)},
                       {"reports", w.reports},
                       {"rate_hz", w.rate_hz()},
                       {"jitter_ms", w.jitter_ms()},
                       {"last", sample_json(w.last)}};
        if (const auto battery = battery_of(w.device.identity)) j["battery"] = *battery;
        list.push_back(std::move(j));
    }
    return {{"tablets", list}, {"lost", lost}};
}

void run_monitor(const TabletOptions& options, CommandState& state) {
    input::DeviceNumbers numbers;
    core::Result<std::unique_ptr<input::PenSource>> source = open_tablets(options.by, numbers);
    if (!source) {
        return fail_call(state, source.error());
    }
    std::map<std::uint32_t, Watched> tablets;
    std::map<std::uint32_t, std::optional<int>> batteries;
    std::size_t shown = 0;
    auto next = std::chrono::steady_clock::now();
    const bool terminal = isatty(STDOUT_FILENO) != 0;
    const auto every = std::chrono::milliseconds(terminal ? 100 : 500);
    const auto show = [&] {
        if (terminal && shown > 0) std::printf("\033[%zuA", shown);
        shown = tablets.size();
        for (auto& [number, w] : tablets) {
            std::printf("%s%s\n", monitor_line(w, (*source)->lost(), batteries[number]).c_str(),
                        terminal ? "\033[K" : "");
            w.forget();
        }
        std::fflush(stdout);
    };
    const std::optional<double> seconds = options.seconds > 0.0 ? std::optional(options.seconds) : std::nullopt;
    watch_tablets(**source, seconds, [&](const std::vector<input::SourceEvent>& events) {
        for (const input::SourceEvent& e : events) {
            if (e.kind == input::SourceEventKind::Attached) {
                tablets[e.device].device = (*source)->device(e.device);
                batteries[e.device] = battery_of(tablets[e.device].device.identity);
            }
            if (e.kind == input::SourceEventKind::Detached && !options.json) {
                std::printf("%s is gone\n", tablets[e.device].device.identity.name.c_str());
                tablets.erase(e.device);
                shown = 0;
            }
            if (e.sample_valid) tablets[e.device].see(e);
        }
        if (!options.json && std::chrono::steady_clock::now() >= next) {
            next = std::chrono::steady_clock::now() + every;
            show();
        }
        return true;
    });
    if (options.json) print_json(monitor_json(tablets, (*source)->lost()));
    if (tablets.empty()) {
        fail(state,
             {core::ErrorCode::FileMissing, "no tablet is attached; plug one in, and see croquis tablet list", ""});
    }
}

bool is_text(const std::string& bytes) {
    return std::all_of(bytes.begin(), bytes.end(), [](char c) {
        const auto u = static_cast<unsigned char>(c);
        return u >= 0x20 || c == '\n' || c == '\r' || c == '\t';
    });
}

/// A report descriptor by itself, as /sys has it.
void decode_descriptor(const TabletOptions& options, const std::string& text, CommandState& state) {
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    const auto descriptor = input::parse_report_descriptor(bytes);
    if (!descriptor) {
        return fail(state, {core::ErrorCode::BadFormat,
                            "the report descriptor is malformed: " + descriptor.error().message +
                                (descriptor.error().where.empty() ? "" : " at " + descriptor.error().where),
                            options.file});
    }
    const ordered_json j = descriptor_json(bytes);
    if (options.json) {
        const ordered_json out{{"device", identity_json({})},
                               {"parser", "descriptor"},
                               {"descriptor", j},
                               {"samples", ordered_json::array()}};
        print_json(out);
        return;
    }
    std::printf("%zu bytes, %zu pens\n", bytes.size(), j["pens"].size());
    for (const auto& pen : j["pens"])
        std::printf("  %s: %s\n", pen["name"].get<std::string>().c_str(),
                    pen["axes"].dump(-1, ' ', false, ordered_json::error_handler_t::replace).c_str());
}

/// What the caller says of the device, over what lies beside the file. A sentence when it makes no sense.
std::string override_surroundings(const TabletOptions& options, input::Surroundings& around) {
    if (!options.id.empty()) {
        const std::size_t colon = options.id.find(':');
        const auto vendor = input::number_of_text<std::uint16_t>(options.id.substr(0, colon), 16);
        const auto product = colon == std::string::npos
                                 ? std::nullopt
                                 : input::number_of_text<std::uint16_t>(options.id.substr(colon + 1), 16);
        if (!vendor || !product) return "--device takes VENDOR:PRODUCT in hexadecimal, like 256c:006e";
        around.device.vendor = *vendor;
        around.device.product = *product;
    }
    if (!options.descriptor.empty()) {
        const core::Result<std::string> bytes = core::read_file_bytes(options.descriptor, input::kMaxDescriptorBytes);
        if (!bytes) return bytes.error().sentence();
        around.descriptors.clear();
        for (int interface = 0; interface < 4; ++interface) {
            around.descriptors.push_back({interface, {bytes->begin(), bytes->end()}});
        }
    }
    return {};
}

struct Decoded {
    input::DeviceIdentity device;
    std::string parser;
    input::PenAxes axes;
    std::vector<std::uint8_t> descriptor;
    std::vector<input::PenSample> samples;
    bool ranges_from_recording = false;
};

void print_decoded(const TabletOptions& options, const Decoded& d) {
    if (options.json) {
        ordered_json descriptor = descriptor_json(d.descriptor);
        descriptor["axes"] = axes_json(d.axes);
        ordered_json out{{"device", identity_json(d.device)}, {"parser", d.parser}, {"descriptor", descriptor}};
        if (d.ranges_from_recording) out["ranges"] = "from the recording";
        out["rate_hz"] = input::report_rate_hz(d.samples);
        out["samples"] = samples_json(d.samples);
        print_json(out);
        return;
    }
    std::printf("%s %s, parser %s, %zu samples, %.0f Hz%s\n", d.device.name.c_str(),
                input::vendor_product(d.device).c_str(), d.parser.c_str(), d.samples.size(),
                input::report_rate_hz(d.samples), d.ranges_from_recording ? "; ranges from the recording itself" : "");
    const std::vector<input::PenStroke> strokes = input::strokes_of(d.samples);
    for (std::size_t i = 0; i < strokes.size(); ++i) std::printf("%s\n", stroke_line(i + 1, strokes[i]).c_str());
}

void decode_trace_file(const TabletOptions& options, CommandState& state) {
    const core::Result<input::Trace> trace = input::read_trace(options.file);
    if (!trace) return fail(state, trace.error());
    Decoded d;
    d.samples = input::decode_trace(*trace).samples;
    for (const input::TraceRecord& r : trace->records) {
        const auto* device = std::get_if<input::TraceDevice>(&r);
        if (device == nullptr) continue;
        d.device = device->identity;
        d.parser = device->parser;
        d.axes = device->axes;
        d.descriptor = device->descriptor;
        break;
    }
    print_decoded(options, d);
    if (trace->fault_count > 0) fail(state, {core::ErrorCode::Damaged, trace->damage(), options.file});
}

void run_decode(const TabletOptions& options, CommandState& state) {
    const core::Result<std::string> text = core::read_file_bytes(options.file, input::kMaxCaptureBytes);
    if (!text) return fail(state, text.error());
    if (input::looks_like_trace(*text)) return decode_trace_file(options, state);
    if (text->size() <= input::kMaxDescriptorBytes && !is_text(*text)) return decode_descriptor(options, *text, state);
    const core::Result<input::Capture> capture = input::read_capture(options.file);
    if (!capture) return fail(state, capture.error());
    input::Surroundings around = input::find_surroundings(options.file);
    if (const std::string fault = override_surroundings(options, around); !fault.empty()) {
        return fail_call(state, {core::ErrorCode::BadArgument, fault, ""});
    }
    const input::DecodedCapture decoded = input::decode_capture(*capture, around);
    if (decoded.why_none) return fail(state, {core::ErrorCode::BadFormat, *decoded.why_none, options.file});
    const input::Trace trace = input::trace_of_capture(*capture, around);
    const input::TraceDevice* device = trace.device(1);
    print_decoded(options, {decoded.device, decoded.parser, decoded.axes,
                            device == nullptr ? std::vector<std::uint8_t>{} : device->descriptor, decoded.samples,
                            decoded.ranges_from_recording});
    if (decoded.malformed) fail(state, {core::ErrorCode::BadFormat, *decoded.malformed, options.file});
}

}  // namespace

void add_tablet_commands(Command cli, CommandState& state) {
    Command tablet = cli.group("tablet", "Tablets: which are there, what they send");
    auto options = std::make_shared<TabletOptions>();

    Command list = tablet.command("list", "The tablets that are attached");
    list.flag("--json", options->json, "one JSON object on standard output");
    list.runs([options, &state] { run_list(*options, state); });

    Command monitor = tablet.command("monitor", "Live axes, report rate, jitter, parser, battery");
    monitor.option("--seconds", options->seconds, "stop after this time").positive();
    monitor.option("--by", options->by, "auto, hidraw, evdev or libinput");
    monitor.flag("--json", options->json, "one JSON object when it ends");
    monitor.runs([options, &state] { run_monitor(*options, state); });

    Command decode = tablet.command("decode", "Decode a captured report file to pen samples");
    decode
        .option("FILE", options->file,
                "hid-recorder, usbhid-dump, evemu, libinput record, trace; or a report descriptor")
        .required();
    decode.option("--device", options->id, "VENDOR:PRODUCT, where the file does not say it");
    decode.option("--descriptor", options->descriptor, "the tablet's report descriptor, bytes as /sys has them");
    decode.flag("--json", options->json, "one JSON object on standard output");
    decode.runs([options, &state] { run_decode(*options, state); });
}

}  // namespace app
