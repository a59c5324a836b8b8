#include "input/sources/pen_source.hpp"

#include <chrono>
#include <cstring>

namespace input {
namespace {

TraceFrame frame_of(const SourceEvent& event) {
    TraceFrame frame{event.device, event.time_ns, {}};
    for (std::size_t at = 0; at + sizeof(RawEvdevEvent) <= event.raw_size; at += sizeof(RawEvdevEvent)) {
        RawEvdevEvent e;
        std::memcpy(&e, event.raw_bytes.data() + at, sizeof e);
        frame.events.push_back({event.time_ns, e.type, e.code, e.value});
    }
    return frame;
}

}  // namespace

Clock monotonic_clock() {
    return [] {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
            .count();
    };
}

void append_records(const SourceEvent& event, const TraceDevice& device, std::vector<TraceRecord>& out) {
    switch (event.kind) {
        case SourceEventKind::Attached:
            out.emplace_back(device);
            out.emplace_back(TraceChange{event.device, event.time_ns, DeviceChange::Attached});
            return;
        case SourceEventKind::Detached:
            out.emplace_back(TraceChange{event.device, event.time_ns, DeviceChange::Detached});
            return;
        case SourceEventKind::Asleep:
            out.emplace_back(TraceChange{event.device, event.time_ns, DeviceChange::Asleep});
            return;
        case SourceEventKind::Sample:
            break;
    }
    if (event.raw_too_long)
        out.emplace_back(TraceMarker{event.time_ns, "a raw record of more than 256 bytes was left out"});
    if (event.raw_size > 0 && event.raw == RawKind::HidReport) {
        const auto bytes = event.raw_data();
        out.emplace_back(TraceReport{event.device, event.time_ns, {bytes.begin(), bytes.end()}});
    }
    if (event.raw_size > 0 && event.raw == RawKind::EvdevFrame) out.emplace_back(frame_of(event));
    if (event.sample_valid) out.emplace_back(event.sample);
}

}  // namespace input
