#include "input/formats/decode_capture.hpp"

#include <linux/input-event-codes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace input {
namespace {

constexpr std::uint32_t kDevice = 1;

std::string parser_name(std::string_view name, const DeviceFile* file) {
    return file == nullptr ? std::string(name) : std::string(name) + " (" + file->file + ")";
}

const DeviceFile* file_for(const DeviceIdentity& device, const Surroundings& around) {
    if (device.known()) {
        // A name in a recording's surroundings may tell what firmware would: models that share their numbers.
        const DeviceFile* claimed = find_device_file(device, device_files());
        for (const std::string& name : around.names) {
            const DeviceFile* named = find_device_file_by_name(name, device_files());
            const bool same =
                named != nullptr && std::any_of(named->claims.begin(), named->claims.end(), [&](const DeviceClaim& c) {
                    return c.vendor == device.vendor && c.product == device.product;
                });
            if (same) return named;
        }
        return claimed;
    }
    for (const std::string& name : around.names) {
        if (const DeviceFile* named = find_device_file_by_name(name, device_files())) return named;
    }
    return nullptr;
}

DeviceIdentity merged(DeviceIdentity device, const DeviceIdentity& around) {
    if (!device.known()) {
        device.vendor = around.vendor;
        device.product = around.product;
    }
    if (device.name.empty()) device.name = around.name;
    if (device.firmware.empty()) device.firmware = around.firmware;
    return device;
}

const std::vector<std::uint8_t>* descriptor_of(int interface, const Capture& capture, const Surroundings& around) {
    for (const auto* list : {&capture.descriptors, &around.descriptors}) {
        for (const CapturedDescriptor& d : *list) {
            if (d.interface == interface) return &d.bytes;
        }
    }
    return nullptr;
}

/// Gives axes without a range the largest value that the reports hold there.
bool learn_ranges(std::vector<PenLayout>& layouts, const std::vector<const CapturedReport*>& reports) {
    bool learnt = false;
    for (PenLayout& layout : layouts) {
        std::array<std::int32_t, 3> most{};
        for (const CapturedReport* report : reports) {
            PenReport r;
            if (!layout.decode(report->bytes, r)) continue;
            const std::array<std::optional<std::int32_t>, 3> values{r.x, r.y, r.pressure};
            for (std::size_t i = 0; i < 3; ++i) most[i] = std::max(most[i], values[i].value_or(0));
        }
        const auto learn = [&](std::optional<AxisRange>& axis, std::int32_t value, PenRole role) {
            if (axis || value <= 0 || !layout.has(role)) return;
            axis = AxisRange{0, value, 0.0};
            learnt = true;
        };
        learn(layout.axes.x, most[0], PenRole::X);
        learn(layout.axes.y, most[1], PenRole::Y);
        learn(layout.axes.pressure, most[2], PenRole::Pressure);
    }
    return learnt;
}

std::unique_ptr<PenDecoder> decoder_for(const DeviceFile* file, const std::optional<ReportDescriptor>& descriptor,
                                        const UsbStrings& strings, const std::vector<const CapturedReport*>& reports,
                                        bool& learnt) {
    if (file != nullptr && file->parser == "wacom-intuos") return make_decoder(file, descriptor, strings);
    std::vector<PenLayout> layouts = make_layouts(file, descriptor, strings);
    if (layouts.empty()) return nullptr;
    learnt = learn_ranges(layouts, reports);
    return make_layout_decoder(std::move(layouts), file != nullptr && !file->layouts.empty() ? "fields" : "descriptor");
}

/// The reports of one interface.
void decode_interface(int interface, const std::vector<const CapturedReport*>& reports, const Capture& capture,
                      const Surroundings& around, DecodedCapture& out) {
    DeviceIdentity device = out.device;
    device.interface = interface;
    const DeviceFile* file = file_for(device, around);
    std::optional<ReportDescriptor> descriptor;
    if (const auto* bytes = descriptor_of(interface, capture, around)) {
        core::Result<ReportDescriptor> parsed = parse_report_descriptor(*bytes);
        if (parsed) {
            descriptor = std::move(*parsed);
        } else {
            out.malformed = "the report descriptor is malformed: " + parsed.error().message +
                            (parsed.error().where.empty() ? "" : " at " + parsed.error().where);
        }
    }
    bool learnt = false;
    const std::unique_ptr<PenDecoder> decoder = decoder_for(file, descriptor, around.strings, reports, learnt);
    out.reports += reports.size();
    if (!decoder) {
        out.other_reports += reports.size();
        return;
    }
    std::size_t pens = 0;
    const PenAxes* used = nullptr;
    for (const CapturedReport* report : reports) {
        PenReport r;
        const PenAxes* axes = nullptr;
        if (!decoder->decode(report->bytes, r, axes)) {
            ++out.other_reports;
            continue;
        }
        out.samples.push_back(to_sample(r, *axes, report->time_ns, kDevice));
        if (r.in_range) used = axes;
        ++pens;
    }
    if (pens == 0) return;
    out.device.interface = interface;
    out.parser = parser_name(decoder->name(), file);
    out.axes = used != nullptr ? *used : decoder->axes();
    out.ranges_from_recording = out.ranges_from_recording || learnt;
}

void decode_reports(const Capture& capture, const Surroundings& around, DecodedCapture& out) {
    std::map<int, std::vector<const CapturedReport*>> by_interface;
    for (const CapturedReport& r : capture.reports) by_interface[r.interface].push_back(&r);
    for (const auto& [interface, reports] : by_interface) decode_interface(interface, reports, capture, around, out);
    std::stable_sort(out.samples.begin(), out.samples.end(),
                     [](const PenSample& a, const PenSample& b) { return a.time_ns < b.time_ns; });
    if (!out.samples.empty()) return;
    const bool described = !capture.descriptors.empty() || !around.descriptors.empty();
    if (out.malformed) {
        out.why_none = out.malformed;
    } else if (capture.reports.empty()) {
        out.why_none = "the recording holds no report";
    } else if (!described && file_for(out.device, around) == nullptr) {
        out.why_none =
            "neither the recording nor what lies beside it says what the reports mean, and no data file knows the "
            "tablet";
    } else {
        out.why_none = "none of the reports is of a pen";
    }
}

using EvdevAxis = EvdevDescription::Axis;

/// What the events themselves show.
EvdevDescription seen_in(const std::vector<EvdevEvent>& events) {
    EvdevDescription d;
    for (const EvdevEvent& e : events) {
        if (e.type == EV_KEY && e.code < d.keys.size()) d.keys[e.code] = true;
        if (e.type != EV_ABS || e.code >= d.axes.size()) continue;
        std::optional<EvdevAxis>& axis = d.axes[e.code];
        if (!axis) axis = EvdevAxis{std::min(e.value, 0), e.value, 0, 0};
        axis->min = std::min(axis->min, e.value);
        axis->max = std::max(axis->max, e.value);
    }
    return d;
}

/// The axes of the file that go with these events.
const PenAxes* axes_of_file(const DeviceFile* file) {
    if (file == nullptr) return nullptr;
    return file->axes.x || file->layouts.empty() ? &file->axes : &file->layouts.front().layout.axes;
}

struct Described {
    EvdevDescription evdev;
    const DeviceFile* file = nullptr;  ///< from which ranges came
    bool learnt = false;               ///< ranges are those of the recording
    bool taken_for_pen = false;        ///< a descriptor or data file says that it is one
};

/// Ranges for events whose device is not described: those of a HID descriptor beside them, else a data file's, else
/// what the events show.
Described describe(const Capture& capture, const Surroundings& around) {
    Described out;
    out.evdev = seen_in(capture.events);
    const auto take = [&](const PenAxes& axes) {
        const auto one = [&](unsigned code, const std::optional<AxisRange>& range) {
            if (range && out.evdev.axes[code]) out.evdev.axes[code] = EvdevAxis{range->min, range->max, 0, 0};
        };
        one(ABS_X, axes.x);
        one(ABS_Y, axes.y);
        one(ABS_PRESSURE, axes.pressure);
        out.taken_for_pen = out.evdev.axes[ABS_X] && out.evdev.axes[ABS_Y];
    };
    for (const CapturedDescriptor& bytes : around.descriptors) {
        const auto parsed = parse_report_descriptor(bytes.bytes);
        const std::vector<PenLayout> pens = parsed ? find_pens(*parsed) : std::vector<PenLayout>{};
        if (pens.empty()) continue;
        take(pens.front().axes);
        return out;
    }
    out.file = file_for(capture.device, around);
    const PenAxes* axes = axes_of_file(out.file);
    if (axes != nullptr && axes->x && axes->y) {
        take(*axes);
    } else {
        out.learnt = true;
    }
    return out;
}

/// The size that a data file knows, for axes without a resolution.
void lend_size(EvdevDescription& d, const DeviceFile* file) {
    const PenAxes* axes = axes_of_file(file);
    if (axes == nullptr) return;
    const auto lend = [&](unsigned code, const std::optional<AxisRange>& range, double size_mm) {
        std::optional<EvdevAxis>& axis = d.axes[code];
        if (!axis || axis->resolution != 0 || axis->max <= axis->min) return;
        double per_mm = range ? range->per_unit : 0.0;
        if (size_mm > 0.0) per_mm = (static_cast<double>(axis->max) - axis->min) / size_mm;
        axis->resolution = static_cast<std::int32_t>(std::lround(std::clamp(per_mm, 0.0, 1e6)));
    };
    const std::array<double, 2> none{};
    lend(ABS_X, axes->x, file->size_mm.value_or(none)[0]);
    lend(ABS_Y, axes->y, file->size_mm.value_or(none)[1]);
}

void decode_events(const Capture& capture, const Surroundings& around, DecodedCapture& out) {
    Described described;
    if (capture.has_evdev_description) {
        described.evdev = capture.evdev;
    } else if (around.evdev) {
        described.evdev = *around.evdev;
    } else {
        described = describe(capture, around);
    }
    lend_size(described.evdev, file_for(out.device, around));
    out.ranges_from_recording = described.learnt;
    out.parser = parser_name("evdev", described.file);
    if (!described.evdev.is_pen() && !described.taken_for_pen) {
        out.why_none = capture.events.empty() ? "the recording holds no event" : "the events are not those of a pen";
        return;
    }
    EvdevPen pen(described.evdev);
    out.axes = pen.axes();
    out.keys = described.evdev.pen_keys();
    for (const EvdevEvent& e : capture.events) {
        const bool frame = e.type == EV_SYN && e.code == SYN_REPORT;
        out.reports += frame ? 1 : 0;
        if (pen.feed(e)) {
            out.samples.push_back(to_sample(pen.report(), pen.axes(), e.time_ns, kDevice));
        } else if (frame) {
            ++out.other_reports;
        }
    }
    if (out.samples.empty()) {
        out.why_none = out.reports == 0 ? "the recording holds no event" : "none of the events is of a pen";
    }
}

}  // namespace

DecodedCapture decode_capture(const Capture& capture, const Surroundings& around) {
    DecodedCapture out;
    out.device = merged(capture.device, around.device);
    if (capture.format == CaptureFormat::Evemu || capture.format == CaptureFormat::LibinputRecord ||
        capture.format == CaptureFormat::EvdevText) {
        decode_events(capture, around, out);
    } else {
        decode_reports(capture, around, out);
    }
    return out;
}

double report_rate_hz(const std::vector<PenSample>& samples) {
    constexpr std::int64_t kPause_ns = 100'000'000;
    std::vector<std::int64_t> steps;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const std::int64_t step = samples[i].time_ns - samples[i - 1].time_ns;
        if (samples[i].in_range && samples[i - 1].in_range && step > 0 && step < kPause_ns) steps.push_back(step);
    }
    if (steps.size() < 3) return 0.0;
    std::int64_t total = 0;
    for (const std::int64_t step : steps) total += step;
    return 1e9 * static_cast<double>(steps.size()) / static_cast<double>(total);
}

}  // namespace input
