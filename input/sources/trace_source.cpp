#include "input/sources/trace_source.hpp"

#include <cassert>
#include <cmath>
#include <cstring>

#include "input/trace/decode_trace.hpp"

namespace input {
namespace {

std::vector<std::uint8_t> raw_of(const TraceFrame& frame) {
    std::vector<std::uint8_t> bytes(frame.events.size() * sizeof(RawEvdevEvent));
    for (std::size_t i = 0; i < frame.events.size(); ++i) {
        const RawEvdevEvent e{frame.events[i].type, frame.events[i].code, frame.events[i].value};
        std::memcpy(bytes.data() + i * sizeof e, &e, sizeof e);
    }
    return bytes;
}

}  // namespace

TraceSource::TraceSource(const Trace& trace, TraceSourceOptions options) : options_(std::move(options)) {
    assert(options_.speed > 0.0);
    make_events(trace);
}

/// A raw record and the sample after it, of the same device and moment, are one event.
void TraceSource::make_events(const Trace& trace) {
    std::vector<PenSample> again;
    if (options_.decode_again) again = decode_trace(trace).samples;
    std::map<std::uint32_t, std::vector<PenSample>> by_device;
    for (const PenSample& s : again) by_device[s.device].push_back(s);
    std::map<std::uint32_t, std::size_t> taken;

    const auto add = [&](SourceEventKind kind, std::uint32_t device, std::int64_t time_ns) -> SourceEvent& {
        SourceEvent& e = events_.emplace_back();
        e.kind = kind;
        e.device = device;
        e.time_ns = time_ns;
        return e;
    };
    for (const TraceRecord& record : trace.records) {
        if (const auto* d = std::get_if<TraceDevice>(&record)) {
            devices_[d->number] = *d;
        } else if (const auto* r = std::get_if<TraceReport>(&record)) {
            add(SourceEventKind::Sample, r->device, r->time_ns).set_raw(RawKind::HidReport, r->bytes);
        } else if (const auto* f = std::get_if<TraceFrame>(&record)) {
            add(SourceEventKind::Sample, f->device, f->time_ns).set_raw(RawKind::EvdevFrame, raw_of(*f));
        } else if (const auto* s = std::get_if<PenSample>(&record)) {
            const bool of_raw = !events_.empty() && events_.back().raw != RawKind::None &&
                                !events_.back().sample_valid && events_.back().device == s->device &&
                                events_.back().time_ns == s->time_ns;
            SourceEvent& e = of_raw ? events_.back() : add(SourceEventKind::Sample, s->device, s->time_ns);
            const std::vector<PenSample>& made = by_device[s->device];
            std::size_t& k = taken[s->device];
            e.sample = options_.decode_again && k < made.size() && made[k].time_ns == s->time_ns ? made[k] : *s;
            ++k;
            e.sample_valid = true;
        } else if (const auto* c = std::get_if<TraceChange>(&record)) {
            constexpr std::array<SourceEventKind, 3> kKinds{SourceEventKind::Attached, SourceEventKind::Detached,
                                                            SourceEventKind::Asleep};
            add(kKinds[static_cast<std::size_t>(c->change)], c->device, c->time_ns);
        }
    }
    // A trace of another program's recording has no word of its device's coming.
    if (!events_.empty() && events_.front().kind != SourceEventKind::Attached) {
        for (const auto& [number, d] : devices_) {
            SourceEvent e;
            e.kind = SourceEventKind::Attached;
            e.device = number;
            e.time_ns = events_.front().time_ns;
            events_.insert(events_.begin(), e);
        }
    }
}

void TraceSource::drain(std::vector<SourceEvent>& out) {
    if (!started_) {
        started_ = true;
        start_ns_ = options_.clock();
    }
    while (!finished() && (!options_.paced || due_ns() <= options_.clock())) out.push_back(events_[next_++]);
}

std::int64_t TraceSource::due_ns() const {
    assert(started_ && !finished());
    const double since = static_cast<double>(events_[next_].time_ns - events_.front().time_ns);
    return start_ns_ + std::llround(since / options_.speed);
}

TraceDevice TraceSource::device(std::uint32_t number) const {
    const auto found = devices_.find(number);
    return found == devices_.end() ? TraceDevice{} : found->second;
}

}  // namespace input
