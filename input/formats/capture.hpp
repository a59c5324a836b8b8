#pragma once
// What a recording by another program holds: HID reports, or evdev events, and what it says of the device.
//
//     const auto capture = input::parse_capture(text);   // finds the format by the content

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "input/device_identity.hpp"
#include "input/parse/evdev_pen.hpp"

namespace input {

enum class CaptureFormat : std::uint8_t { HidRecorder, UsbhidDump, Evemu, LibinputRecord, EvdevText, HexReports };

/// "hid-recorder", "usbhid-dump", "evemu", "libinput-record", "evdev text", "hex reports".
[[nodiscard]] std::string_view format_name(CaptureFormat format);

struct CapturedReport {
    std::int64_t time_ns = 0;  ///< as written; not monotonic for certain
    int interface = 0;         ///< of a USB device, or the number of the device in a hid-recorder file
    std::vector<std::uint8_t> bytes;
};

struct CapturedDescriptor {
    int interface = 0;
    std::vector<std::uint8_t> bytes;
};

/// One event node, or the HID interfaces of one device.
struct Capture {
    CaptureFormat format = CaptureFormat::HidRecorder;
    DeviceIdentity device;
    std::vector<CapturedDescriptor> descriptors;
    std::vector<CapturedReport> reports;
    EvdevDescription evdev;
    bool has_evdev_description = false;
    std::vector<EvdevEvent> events;
    std::vector<std::string> notes;  ///< lines that were passed over, one phrase each; at most 32
};

/// Larger recordings are refused.
inline constexpr std::size_t kMaxCaptureBytes = std::size_t{256} << 20U;
inline constexpr std::int64_t kUntimedReport_ns = 8'000'000;
/// A report longer than this is no report.
inline constexpr std::size_t kMaxCapturedReportBytes = 4096;

/// Finds the format by the content and reads it. UnknownFormat when it is none of the six; BadFormat naming the line
/// where a line of the format cannot be read. Of several devices in one file the first pen counts, else the first.
/// Linear time.
[[nodiscard]] core::Result<Capture> parse_capture(std::string_view text);

/// The same from a file; errors name it.
[[nodiscard]] core::Result<Capture> read_capture(const std::string& path);

/// One each; `text` is taken to be of the format.
[[nodiscard]] core::Result<Capture> parse_hid_recorder(std::string_view text);
[[nodiscard]] core::Result<Capture> parse_usbhid_dump(std::string_view text);
[[nodiscard]] core::Result<Capture> parse_evemu(std::string_view text);
[[nodiscard]] core::Result<Capture> parse_libinput_record(std::string_view text);
[[nodiscard]] core::Result<Capture> parse_evdev_text(std::string_view text);
/// One report a line, without times: they are made, kUntimedReport_ns apart.
[[nodiscard]] core::Result<Capture> parse_hex_reports(std::string_view text);

}  // namespace input
