// usbhid-dump: blocks of a heading "bus:device:interface:KIND time" (older versions: "interface:KIND time"), bytes in
// hexadecimal, and an empty line. KIND is STREAM for a report, DESCRIPTOR for a report descriptor.

#include "input/formats/capture.hpp"
#include "input/formats/capture_notes.hpp"
#include "input/formats/text_lines.hpp"
#include "input/parse/report_descriptor.hpp"

namespace input {
namespace {

struct Heading {
    bool descriptor = false;
    int interface = 0;
    std::int64_t time_ns = 0;
};

/// Nothing for a line that is no heading.
std::optional<Heading> heading_of(std::string_view line) {
    std::string_view rest = line;
    const std::string_view place = take_word(rest);
    const std::size_t colon = place.rfind(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const std::string_view kind = place.substr(colon + 1);
    if (kind != "STREAM" && kind != "DESCRIPTOR") return std::nullopt;
    std::string_view interface = place.substr(0, colon);
    interface = interface.substr(interface.rfind(':') + 1);
    const auto number = number_of_text<std::uint8_t>(interface);
    const auto time = nanoseconds_of_text(trimmed(rest));
    if (!number || !time) return std::nullopt;
    return Heading{kind == "DESCRIPTOR", *number, *time};
}

}  // namespace

core::Result<Capture> parse_usbhid_dump(std::string_view text) {
    Capture out;
    out.format = CaptureFormat::UsbhidDump;
    std::optional<Heading> open;
    std::vector<std::uint8_t> bytes;
    const auto close = [&] {
        if (!open) return;
        if (open->descriptor) {
            out.descriptors.push_back({open->interface, bytes});
        } else if (!bytes.empty()) {
            out.reports.push_back({open->time_ns, open->interface, bytes});
        }
        open.reset();
        bytes.clear();
    };
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
        if (trimmed(line).empty()) {
            close();
        } else if (const std::optional<Heading> heading = heading_of(line)) {
            close();
            open = heading;
        } else if (!open) {
            note_line(out, lines.number(), "neither a heading nor bytes");
        } else if (!append_hex_bytes(line, bytes, kMaxCapturedReportBytes)) {
            note_line(out, lines.number(), "no bytes in hexadecimal; the block is passed over");
            open.reset();
            bytes.clear();
        }
    }
    close();
    if (out.reports.empty() && out.descriptors.empty()) {
        return core::unexpected(core::ErrorCode::BadFormat, "the usbhid-dump output holds no report and no descriptor");
    }
    return out;
}

core::Result<Capture> parse_hex_reports(std::string_view text) {
    Capture out;
    out.format = CaptureFormat::HexReports;
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
        if (trimmed(line).empty()) continue;
        CapturedReport report;
        report.time_ns = static_cast<std::int64_t>(out.reports.size()) * kUntimedReport_ns;
        if (!append_hex_bytes(line, report.bytes, kMaxCapturedReportBytes)) {
            note_line(out, lines.number(), "no bytes in hexadecimal");
            continue;
        }
        out.reports.push_back(std::move(report));
    }
    return out;
}

}  // namespace input
