#include "input/trace/decode_trace.hpp"

#include <linux/input-event-codes.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "input/devices/make_decoder.hpp"
#include "input/formats/decode_capture.hpp"
#include "input/pipeline/stroke_builder.hpp"

namespace input {
namespace {

/// Ranges that were known when the trace was recorded, from strings that cannot be asked any more.
void lend_ranges(PenAxes& axes, const PenAxes& recorded) {
    const auto lend = [](std::optional<AxisRange>& a, const std::optional<AxisRange>& b) {
        if (!a || (b && a->min == b->min && a->max == b->max)) a = b;
    };
    lend(axes.x, recorded.x);
    lend(axes.y, recorded.y);
    lend(axes.pressure, recorded.pressure);
    lend(axes.tilt_x, recorded.tilt_x);
    lend(axes.tilt_y, recorded.tilt_y);
}

/// The file that was used, by its name in the parser's; else the one that claims the device now.
const DeviceFile* file_of(const TraceDevice& d) {
    for (const DeviceFile& file : device_files()) {
        if (d.parser.ends_with("(" + file.file + ")")) return &file;
    }
    return find_device_file(d.identity, device_files());
}

std::unique_ptr<PenDecoder> decoder_of(const TraceDevice& d) {
    const DeviceFile* file = file_of(d);
    std::optional<ReportDescriptor> descriptor;
    if (core::Result<ReportDescriptor> parsed = parse_report_descriptor(d.descriptor)) descriptor = std::move(*parsed);
    if (file != nullptr && file->parser == "wacom-intuos") return make_decoder(file, descriptor, {});
    std::vector<PenLayout> layouts = make_layouts(file, descriptor, {});
    if (layouts.empty()) return nullptr;
    for (PenLayout& l : layouts) lend_ranges(l.axes, d.axes);
    return make_layout_decoder(std::move(layouts), "trace");
}

EvdevDescription description_of(const TraceDevice& d) {
    EvdevDescription e;
    const auto set = [&](unsigned code, const std::optional<AxisRange>& r) {
        if (!r) return;
        e.axes[code] = EvdevDescription::Axis{r->min, r->max, static_cast<std::int32_t>(std::lround(r->per_unit)), 0};
    };
    set(ABS_X, d.axes.x);
    set(ABS_Y, d.axes.y);
    set(ABS_PRESSURE, d.axes.pressure);
    set(ABS_TILT_X, d.axes.tilt_x);
    set(ABS_TILT_Y, d.axes.tilt_y);
    set(ABS_Z, d.axes.rotation);
    set(ABS_DISTANCE, d.axes.distance);
    set(ABS_WHEEL, d.axes.wheel);
    for (const std::uint16_t key : d.keys) e.keys[key] = true;
    return e;
}

/// One device of the trace, at work.
struct Player {
    std::unique_ptr<PenDecoder> reports;
    std::unique_ptr<EvdevPen> events;
};

class TraceDecoder {
  public:
    explicit TraceDecoder(const Trace& trace) : trace_(trace) {
        for (const TraceRecord& r : trace.records) {
            if (const auto* report = std::get_if<TraceReport>(&r)) raw_.insert(report->device);
            if (const auto* frame = std::get_if<TraceFrame>(&r)) raw_.insert(frame->device);
        }
    }

    DecodedTrace run() {
        for (const TraceRecord& r : trace_.records) std::visit(*this, r);
        for (const auto& [device, samples] : recorded_) {
            const std::vector<PenSample>& made = made_[device];
            const std::size_t both = std::min(samples.size(), made.size());
            for (std::size_t i = 0; i < both; ++i) out_.differing += samples[i] == made[i] ? 0 : 1;
            out_.differing += std::max(samples.size(), made.size()) - both;
        }
        return std::move(out_);
    }

    void operator()(const TraceDevice& d) {
        players_[d.number] = {decoder_of(d),
                              d.source == "hidraw" ? nullptr : std::make_unique<EvdevPen>(description_of(d))};
    }
    void operator()(const TraceReport& r) {
        const auto player = players_.find(r.device);
        if (player == players_.end() || !player->second.reports) return;
        PenReport report;
        const PenAxes* axes = nullptr;
        if (player->second.reports->decode(r.bytes, report, axes)) {
            make(to_sample(report, *axes, r.time_ns, r.device));
        }
    }
    void operator()(const TraceFrame& f) {
        const auto player = players_.find(f.device);
        if (player == players_.end() || !player->second.events) return;
        EvdevPen& pen = *player->second.events;
        for (const EvdevEvent& e : f.events) {
            if (pen.feed(e)) make(to_sample(pen.report(), pen.axes(), f.time_ns, f.device));
        }
    }
    void operator()(const PenSample& s) {
        if (raw_.count(s.device) == 0) {
            out_.samples.push_back(s);
        } else {
            recorded_[s.device].push_back(s);
        }
    }
    void operator()(const TraceChange&) {}
    void operator()(const TraceMarker&) {}

  private:
    void make(const PenSample& s) {
        out_.samples.push_back(s);
        made_[s.device].push_back(s);
    }

    const Trace& trace_;
    std::set<std::uint32_t> raw_;  ///< devices that recorded what they sent
    std::map<std::uint32_t, Player> players_;
    std::map<std::uint32_t, std::vector<PenSample>> recorded_, made_;
    DecodedTrace out_;
};

TraceDevice device_of(const Capture& capture, const Surroundings& around, const DecodedCapture& decoded) {
    TraceDevice d;
    d.number = 1;
    d.identity = decoded.device;
    d.source = "recording";
    d.parser = decoded.parser;
    d.axes = decoded.axes;
    d.keys = decoded.keys;
    for (const auto* list : {&capture.descriptors, &around.descriptors}) {
        for (const CapturedDescriptor& bytes : *list) {
            if (d.descriptor.empty() && bytes.interface == decoded.device.interface) d.descriptor = bytes.bytes;
        }
    }
    return d;
}

}  // namespace

DecodedTrace decode_trace(const Trace& trace) {
    return TraceDecoder(trace).run();
}

Trace trace_of_capture(const Capture& capture, const Surroundings& around) {
    const DecodedCapture decoded = decode_capture(capture, around);
    Trace trace;
    trace.records.push_back(device_of(capture, around, decoded));
    std::size_t next = 0;
    const auto samples_until = [&](std::int64_t time_ns) {
        while (next < decoded.samples.size() && decoded.samples[next].time_ns <= time_ns) {
            trace.records.push_back(decoded.samples[next++]);
        }
    };
    for (const CapturedReport& r : capture.reports) {
        if (r.interface != decoded.device.interface) continue;
        trace.records.push_back(TraceReport{1, r.time_ns, r.bytes});
        samples_until(r.time_ns);
    }
    TraceFrame frame{1, 0, {}};
    for (const EvdevEvent& e : capture.events) {
        frame.events.push_back(e);
        if (e.type != EV_SYN || e.code != SYN_REPORT) continue;
        frame.time_ns = e.time_ns;
        for (EvdevEvent& of_frame : frame.events) of_frame.time_ns = e.time_ns;
        trace.records.push_back(frame);
        frame.events.clear();
        samples_until(e.time_ns);
    }
    samples_until(INT64_MAX);
    return trace;
}

Trace trace_of_drawing(const core::Drawing& drawing) {
    double left = 1e300, top = 1e300, right = -1e300, bottom = -1e300;
    for (const core::Stroke& stroke : drawing.strokes) {
        for (const core::PenSample& s : stroke.samples) {
            left = std::min(left, s.x);
            right = std::max(right, s.x);
            top = std::min(top, s.y);
            bottom = std::max(bottom, s.y);
        }
    }
    const double side = std::max({right - left, bottom - top, 1e-9});
    Trace trace;
    TraceDevice device;
    device.number = 1;
    device.identity.name = "a drawing";
    device.source = "drawing";
    device.parser = "drawing";
    trace.records.push_back(device);
    for (const core::Stroke& stroke : drawing.strokes) {
        PenSample s;
        for (const core::PenSample& from : stroke.samples) {
            s = {};
            s.time_ns = from.time_us * 1000;
            s.device = 1;
            s.x = (from.x - left) / side;
            s.y = (from.y - top) / side;
            s.x_mm = from.x;
            s.y_mm = from.y;
            s.pressure = from.pressure;
            s.in_range = s.tip = true;
            trace.records.push_back(s);
        }
        PenSample up;
        up.time_ns = s.time_ns;
        up.device = 1;
        trace.records.push_back(up);
    }
    return trace;
}

std::string trace_text(const Trace& trace) {
    std::string text = trace_header();
    for (const TraceRecord& r : trace.records) text += trace_line(r);
    return text;
}

}  // namespace input
