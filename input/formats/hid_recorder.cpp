// hid-recorder: "D:" which device the lines after it are of, "R:" its report descriptor, "N:" name, "P:" where it is
// plugged in, "I:" bus, vendor and product, "E:" a report with its time and length. "#" starts a comment.

#include "input/formats/capture.hpp"
#include "input/formats/capture_notes.hpp"
#include "input/formats/text_lines.hpp"
#include "input/parse/pen_layout.hpp"

namespace input {
namespace {

/// All that the file says of one device.
struct Recorded {
    int number = 0;
    DeviceIdentity device;
    std::vector<std::uint8_t> descriptor;
};

class Reader {
  public:
    explicit Reader(std::string_view text) : lines_(text) {}

    core::Result<Capture> run() {
        out_.format = CaptureFormat::HidRecorder;
        for (std::string_view line; lines_.next(line);) {
            if (line.size() < 3 || line[1] != ':') continue;
            if (const char* fault = take(line[0], trimmed(line.substr(2)))) return bad_line(lines_.number(), fault);
        }
        for (const Recorded& d : devices_) out_.descriptors.push_back({d.number, d.descriptor});
        if (!devices_.empty()) out_.device = main_device().device;
        return std::move(out_);
    }

  private:
    const char* take(char kind, std::string_view rest) {
        switch (kind) {
            case 'D':
                return begin_device(rest);
            case 'R':
                return counted_bytes(rest, current().descriptor, kMaxDescriptorBytes)
                           ? nullptr
                           : "R: needs a length and as many bytes in hexadecimal";
            case 'N':
                current().device.name = rest.substr(0, 200);
                return nullptr;
            case 'I':
                return identity(rest);
            case 'E':
                return report(rest);
            default:
                return nullptr;
        }
    }

    const char* begin_device(std::string_view rest) {
        const auto number = number_of_text<std::uint8_t>(rest);
        if (!number) return "D: needs the number of a device";
        number_ = *number;
        return nullptr;
    }

    Recorded& current() {
        for (Recorded& d : devices_) {
            if (d.number == number_) return d;
        }
        return devices_.emplace_back(Recorded{number_, {}, {}});
    }

    const char* identity(std::string_view rest) {
        const auto bus = number_of_text<std::uint16_t>(take_word(rest), 16);
        const auto vendor = number_of_text<std::uint16_t>(take_word(rest), 16);
        const auto product = number_of_text<std::uint16_t>(take_word(rest), 16);
        if (!bus || !vendor || !product) return "I: needs bus, vendor and product in hexadecimal";
        DeviceIdentity& device = current().device;
        device.bus = *bus;
        device.vendor = *vendor;
        device.product = *product;
        return nullptr;
    }

    static bool counted_bytes(std::string_view rest, std::vector<std::uint8_t>& bytes, std::size_t most) {
        const auto count = number_of_text<std::uint32_t>(take_word(rest));
        bytes.clear();
        return count && append_hex_bytes(rest, bytes, most) && bytes.size() == *count;
    }

    const char* report(std::string_view rest) {
        const auto time = nanoseconds_of_text(take_word(rest));
        CapturedReport r;
        r.interface = number_;
        if (!time || !counted_bytes(rest, r.bytes, kMaxCapturedReportBytes)) {
            return "E: needs a time, a length and as many bytes in hexadecimal";
        }
        r.time_ns = *time;
        out_.reports.push_back(std::move(r));
        return nullptr;
    }

    [[nodiscard]] const Recorded& main_device() const {
        for (const Recorded& d : devices_) {
            const auto descriptor = parse_report_descriptor(d.descriptor);
            if (descriptor && !find_pens(*descriptor).empty()) return d;
        }
        return devices_.front();
    }

    TextLines lines_;
    Capture out_;
    std::vector<Recorded> devices_;
    int number_ = 0;
};

}  // namespace

core::Result<Capture> parse_hid_recorder(std::string_view text) {
    return Reader(text).run();
}

}  // namespace input
