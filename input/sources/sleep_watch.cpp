#include "input/sources/sleep_watch.hpp"

namespace input {

void SleepWatch::see(const SourceEvent& event, const TraceDevice& device) {
    if (event.kind == SourceEventKind::Attached && device.source == "hidraw" && device.reports_range) {
        devices_[event.device] = {event.time_ns, false};
    }
    if (event.kind == SourceEventKind::Detached) devices_.erase(event.device);
    if (event.kind != SourceEventKind::Sample) return;
    const auto found = devices_.find(event.device);
    if (found == devices_.end()) return;
    found->second.last_ns = event.time_ns;
    if (event.sample_valid) found->second.pen_near = event.sample.in_range;
}

void SleepWatch::append_asleep(std::int64_t now_ns, std::vector<SourceEvent>& out) {
    for (auto& [number, watched] : devices_) {
        if (!watched.pen_near || now_ns - watched.last_ns < silence_ns_) continue;
        watched.pen_near = false;  // it has been said; a sample with a pen begins anew
        SourceEvent event;
        event.kind = SourceEventKind::Asleep;
        event.device = number;
        event.time_ns = watched.last_ns + silence_ns_;
        out.push_back(event);
    }
}

}  // namespace input
