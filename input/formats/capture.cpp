#include "input/formats/capture.hpp"

#include <algorithm>

#include "core/exchange/file_bytes.hpp"
#include "input/formats/text_lines.hpp"

namespace input {
namespace {

bool is_hex_line(std::string_view line) {
    std::vector<std::uint8_t> bytes;
    return append_hex_bytes(line, bytes, kMaxCapturedReportBytes) && bytes.size() >= 2;
}

/// PBM, PGM and PPM begin with P and a digit; their sizes would pass for a report in hex.
bool is_portable_picture(std::string_view text) {
    return text.size() > 2 && text[0] == 'P' && text[1] >= '1' && text[1] <= '7' &&
           (text[2] == '\n' || text[2] == '\r' || text[2] == ' ');
}

/// The first line that says what the file is.
std::optional<CaptureFormat> format_of(std::string_view text) {
    if (is_portable_picture(text)) return std::nullopt;
    TextLines lines(text);
    for (std::string_view line; lines.next(line) && lines.number() < 400;) {
        if (line.starts_with("R: ") || line.starts_with("D: ") || line.starts_with("# Report descriptor")) {
            return CaptureFormat::HidRecorder;
        }
        if (line.find(":STREAM ") != std::string_view::npos || line.find(":DESCRIPTOR ") != std::string_view::npos) {
            return CaptureFormat::UsbhidDump;
        }
        if (line.starts_with("# EVEMU")) return CaptureFormat::Evemu;
        if (line.starts_with("N: ") || line.starts_with("E: ")) return CaptureFormat::Evemu;
        if (line.starts_with("# libinput record") || line.starts_with("ndevices:"))
            return CaptureFormat::LibinputRecord;
        if (line.starts_with("/dev/input/event")) return CaptureFormat::EvdevText;
        if (is_hex_line(line)) return CaptureFormat::HexReports;
    }
    return std::nullopt;
}

/// hid-recorder and evemu share line prefixes; the reports of the one begin with a length and bytes, the events of the
/// other have four words.
CaptureFormat settle(CaptureFormat format, std::string_view text) {
    if (format != CaptureFormat::Evemu || text.starts_with("# EVEMU")) return format;
    return text.find("\nR: ") != std::string_view::npos ? CaptureFormat::HidRecorder : format;
}

}  // namespace

std::string_view format_name(CaptureFormat format) {
    switch (format) {
        case CaptureFormat::HidRecorder:
            return "hid-recorder";
        case CaptureFormat::UsbhidDump:
            return "usbhid-dump";
        case CaptureFormat::Evemu:
            return "evemu";
        case CaptureFormat::LibinputRecord:
            return "libinput-record";
        case CaptureFormat::EvdevText:
            return "evdev text";
        case CaptureFormat::HexReports:
            break;
    }
    return "hex reports";
}

core::Result<Capture> parse_capture(std::string_view text) {
    const std::optional<CaptureFormat> format = format_of(text);
    if (!format) {
        return core::unexpected(
            core::ErrorCode::UnknownFormat,
            "this is no recording of a tablet that can be read; give hid-recorder, usbhid-dump, evemu "
            "or libinput record output");
    }
    switch (settle(*format, text)) {
        case CaptureFormat::HidRecorder:
            return parse_hid_recorder(text);
        case CaptureFormat::UsbhidDump:
            return parse_usbhid_dump(text);
        case CaptureFormat::Evemu:
            return parse_evemu(text);
        case CaptureFormat::LibinputRecord:
            return parse_libinput_record(text);
        case CaptureFormat::EvdevText:
            return parse_evdev_text(text);
        case CaptureFormat::HexReports:
            break;
    }
    return parse_hex_reports(text);
}

core::Result<Capture> read_capture(const std::string& path) {
    const core::Result<std::string> text = core::read_file_bytes(path, kMaxCaptureBytes);
    if (!text) return core::unexpected(text.error());
    core::Result<Capture> capture = parse_capture(*text);
    if (capture) return capture;
    core::Error error = capture.error();
    error.where = error.where.empty() ? path : path + ", " + error.where;
    return core::unexpected(std::move(error));
}

}  // namespace input
