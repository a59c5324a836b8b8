#pragma once
// The stroke log, `.trace`: what tablets sent and what was made of it, line by line.
//
// A file is text. Each line is a record and ends in " *" and the CRC-32 of what stands before, in eight hexadecimal
// digits; so a damaged line is found, and a file that was cut off loses its last line and no more.
//
//     croquis-trace 1                               first line: the version
//     d 1 {"name":"…","source":"hidraw", …}         device 1 is there: identity, axes, parser, descriptor
//     r 1 1500000000 0881fa52523c00200000003c       a HID report as it came; nanoseconds on the monotonic clock
//     e 1 1500000000 3:0:4488 3:1:4680 0:0:0        a frame of events: type:code:value
//     s 1 1500000000 RT x=0.4 y=0.5 p=0.25          the sample made of it: R in range, T tip, then what the device has
//     v 1 1600000000 detached                       attached, detached or asleep
//     m 0 1600000000 second visitor                 a marker, for people
//
// A sample's keys: x y (0 … 1), X Y (mm), p pressure, tx ty tilt, ro rotation (rad), di distance, wh wheel, b buttons,
// to tool, se serial, id tool id. Numbers are written so that reading gives the same bits.

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.hpp"
#include "input/device_identity.hpp"
#include "input/parse/evdev_pen.hpp"
#include "input/pen_axes.hpp"

namespace input {

/// A tablet as a trace knows it.
struct TraceDevice {
    std::uint32_t number = 0;
    DeviceIdentity identity;
    std::string source;  ///< "hidraw", "evdev", "libinput", "pointer", "recording"
    std::string parser;  ///< as in DecodedCapture
    PenAxes axes;
    bool reports_range = true;
    std::vector<std::uint8_t> descriptor;  ///< HID report descriptor; empty where there is none
    std::vector<std::uint16_t> keys;  ///< of an event node, those that matter to a pen, ascending; empty for others
    friend bool operator==(const TraceDevice&, const TraceDevice&) = default;
};

enum class DeviceChange : std::uint8_t { Attached, Detached, Asleep };

struct TraceReport {
    std::uint32_t device = 0;
    std::int64_t time_ns = 0;
    std::vector<std::uint8_t> bytes;
    friend bool operator==(const TraceReport&, const TraceReport&) = default;
};
struct TraceFrame {
    std::uint32_t device = 0;
    std::int64_t time_ns = 0;
    std::vector<EvdevEvent> events;  ///< all with the frame's time
    friend bool operator==(const TraceFrame&, const TraceFrame&) = default;
};
struct TraceChange {
    std::uint32_t device = 0;
    std::int64_t time_ns = 0;
    DeviceChange change = DeviceChange::Attached;
    friend bool operator==(const TraceChange&, const TraceChange&) = default;
};
struct TraceMarker {
    std::int64_t time_ns = 0;
    std::string text;
    friend bool operator==(const TraceMarker&, const TraceMarker&) = default;
};
using TraceRecord = std::variant<TraceDevice, TraceReport, TraceFrame, PenSample, TraceChange, TraceMarker>;

/// A line that could not be read.
struct TraceFault {
    std::size_t line = 0;
    std::string why;
    bool torn = false;  ///< the last line, cut off: the station lost power, nothing worse
};

struct Trace {
    std::vector<TraceRecord> records;
    std::vector<TraceFault> faults;  ///< at most 100 are kept
    std::size_t fault_count = 0;

    [[nodiscard]] std::vector<PenSample> samples() const;
    [[nodiscard]] const TraceDevice* device(std::uint32_t number) const;  ///< as it was last announced
    /// One sentence about all faults, for a person; empty without.
    [[nodiscard]] std::string damage() const;
};

inline constexpr int kTraceVersion = 1;
/// Larger files are refused; a day of a pen at 266 Hz has about 3 GB, a visitor's hour 130 MB.
inline constexpr std::size_t kMaxTraceBytes = std::size_t{1} << 30U;

[[nodiscard]] std::string trace_header();
/// The record's line with its checksum and line end.
[[nodiscard]] std::string trace_line(const TraceRecord& record);

/// Reads what can be read: a record whose checksum is wrong is left out and becomes a fault. UnknownFormat when the
/// first line is not that of a trace, NewerVersion when a newer program wrote it, Damaged when not one record can be
/// read. Linear time.
[[nodiscard]] core::Result<Trace> parse_trace(std::string_view text);
[[nodiscard]] core::Result<Trace> read_trace(const std::string& path);
/// Whether a file begins like a trace, damaged or not.
[[nodiscard]] bool looks_like_trace(std::string_view text);

/// A marker's text as a trace can have it: at most 1000 bytes, without line ends and other control characters, without
/// blanks around.
[[nodiscard]] std::string one_line(std::string_view text);
/// " *" and the checksum, as it ends the line.
[[nodiscard]] std::string checksum_text(std::string_view line);
/// CRC-32 (IEEE 802.3) of a text.
[[nodiscard]] std::uint32_t crc32(std::string_view text);

}  // namespace input
