#pragma once
// Where pens come from: one interface for tablets by hidraw, by event nodes and by libinput, for mouse and touch, and
// for a trace that is played again.
//
//     std::vector<input::SourceEvent> events;
//     source.drain(events);                       // never waits
//     for (const input::SourceEvent& e : events)
//         if (e.kind == input::SourceEventKind::Sample) pipeline.feed(e.sample);

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "input/trace/trace.hpp"

namespace input {

enum class SourceEventKind : std::uint8_t { Sample, Attached, Detached, Asleep };
enum class RawKind : std::uint8_t { None, HidReport, EvdevFrame };

/// Longest raw record that travels with its sample. Pens send 8 to 64 bytes; a longer record is left out and said to
/// be.
inline constexpr std::size_t kMaxRawBytes = 256;

/// What a source has to say, small enough for a queue of fixed size. A report that is of no pen comes as a raw record
/// without a sample (`sample_valid` false), so that a trace has everything.
struct SourceEvent {
    SourceEventKind kind = SourceEventKind::Sample;
    std::uint32_t device = 0;
    std::int64_t time_ns = 0;
    bool sample_valid = false;
    PenSample sample;
    RawKind raw = RawKind::None;
    bool raw_too_long = false;
    std::uint16_t raw_size = 0;
    std::array<std::uint8_t, kMaxRawBytes> raw_bytes{};

    [[nodiscard]] std::span<const std::uint8_t> raw_data() const { return {raw_bytes.data(), raw_size}; }
    /// Keeps a copy; too long a record is left out.
    void set_raw(RawKind what, std::span<const std::uint8_t> bytes) {
        raw = what;
        raw_too_long = bytes.size() > raw_bytes.size();
        raw_size = raw_too_long ? 0 : static_cast<std::uint16_t>(bytes.size());
        if (!raw_too_long) std::copy(bytes.begin(), bytes.end(), raw_bytes.begin());
    }
};
static_assert(std::is_trivially_copyable_v<SourceEvent>);

/// An evdev event as a raw record holds it, eight bytes.
struct RawEvdevEvent {
    std::uint16_t type = 0, code = 0;
    std::int32_t value = 0;
};
static_assert(sizeof(RawEvdevEvent) == 8);

/// Nanoseconds that never run backwards. Tests give their own.
using Clock = std::function<std::int64_t()>;
[[nodiscard]] Clock monotonic_clock();

/// Numbers for devices, one row for all sources of a program, so that no two tablets have the same.
class DeviceNumbers {
  public:
    [[nodiscard]] std::uint32_t next() { return ++last_; }

  private:
    std::atomic<std::uint32_t> last_{0};
};

class PenSource {
  public:
    virtual ~PenSource() = default;

    /// Appends what has come since the last call, in the order of time for each device. Never waits.
    virtual void drain(std::vector<SourceEvent>& out) = 0;
    /// What was said of a device when it was attached; with number 0 for one that never was.
    [[nodiscard]] virtual TraceDevice device(std::uint32_t number) const = 0;
    /// Events that a full queue refused, since the start.
    [[nodiscard]] virtual std::uint64_t lost() const = 0;
    /// What went wrong since the last call, in sentences for people: a node without permission, a device held by
    /// another.
    [[nodiscard]] virtual std::vector<std::string> take_problems() { return {}; }
    /// "hidraw", "evdev", "libinput", "pointer", "replay"
    [[nodiscard]] virtual std::string_view name() const = 0;
};

/// The trace records of an event, in the order in which a trace has them. `device` is what the source says of it.
void append_records(const SourceEvent& event, const TraceDevice& device, std::vector<TraceRecord>& out);

}  // namespace input
