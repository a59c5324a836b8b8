// libinput record: YAML, of which the lines that matter are read as that program writes them: under "devices:" each
// "- node:" begins a device; of its "evdev:" part name, id, codes, absinfo and properties; its "hid:" descriptor; under
// "events:" each "- [seconds, microseconds, type, code, value]".

#include <linux/input-event-codes.h>

#include <algorithm>

#include "input/formats/capture.hpp"
#include "input/formats/capture_notes.hpp"
#include "input/formats/text_lines.hpp"
#include "input/parse/report_descriptor.hpp"

namespace input {
namespace {

constexpr std::size_t kMaxListItems = kMaxDescriptorBytes;

/// "[1, 2, 0x03]" and what stands before its comment; nothing when it is no list of numbers.
std::optional<std::vector<std::int64_t>> list_of(std::string_view text) {
    const std::size_t open = text.find('['), end = text.find(']');
    if (open == std::string_view::npos || end == std::string_view::npos || end < open) return std::nullopt;
    std::string_view items = text.substr(open + 1, end - open - 1);
    std::vector<std::int64_t> out;
    while (!trimmed(items).empty()) {
        const std::size_t comma = std::min(items.find(','), items.size());
        const std::string_view item = trimmed(items.substr(0, comma));
        const auto value = item.starts_with("0x") ? number_of_text<std::int64_t>(item.substr(2), 16)
                                                  : number_of_text<std::int64_t>(item);
        if (!value || out.size() >= kMaxListItems) return std::nullopt;
        out.push_back(*value);
        items.remove_prefix(std::min(comma + 1, items.size()));
    }
    return out;
}

bool fits(const std::vector<std::int64_t>& list, std::size_t size, std::int64_t low, std::int64_t high) {
    return list.size() == size &&
           std::all_of(list.begin(), list.end(), [&](std::int64_t v) { return v >= low && v <= high; });
}

class Reader {
  public:
    explicit Reader(std::string_view text) : lines_(text) {}

    core::Result<Capture> run() {
        for (std::string_view line; lines_.next(line);) {
            if (open_list_.empty()) {
                if (const char* fault = take(line)) return bad_line(lines_.number(), fault);
            } else {
                if (const char* fault = continue_list(line)) return bad_line(lines_.number(), fault);
            }
        }
        if (!open_list_.empty()) return bad_line(lines_.number(), "the recording ends inside a list");
        if (devices_.empty()) {
            return core::unexpected(core::ErrorCode::BadFormat, "the libinput recording holds no device");
        }
        const auto pen =
            std::find_if(devices_.begin(), devices_.end(), [](const Capture& c) { return c.evdev.is_pen(); });
        return std::move(pen == devices_.end() ? devices_.front() : *pen);
    }

  private:
    const char* take(std::string_view line) {
        std::string_view text = trimmed(line);
        if (text.empty() || text.front() == '#') return nullptr;
        if (text.starts_with("- node:")) return begin_device();
        if (devices_.empty()) return nullptr;
        if (text.starts_with("- [")) return event(text);
        if (text.starts_with("- ")) text = trimmed(text.substr(2));
        const std::size_t colon = text.find(':');
        if (colon == std::string_view::npos) return nullptr;
        return entry(text.substr(0, colon), trimmed(text.substr(colon + 1)));
    }

    const char* begin_device() {
        if (devices_.size() >= 256) return "more than 256 devices";
        Capture& device = devices_.emplace_back();
        device.format = CaptureFormat::LibinputRecord;
        device.has_evdev_description = true;
        part_ = Part::None;
        return nullptr;
    }

    const char* entry(std::string_view key, std::string_view value) {
        Capture& device = devices_.back();
        if (key == "name" && device.device.name.empty()) {
            if (value.size() >= 2 && value.front() == '"') value = value.substr(1, value.rfind('"') - 1);
            device.device.name = value.substr(0, 200);
        } else if (key == "codes") {
            part_ = Part::Codes;
        } else if (key == "absinfo") {
            part_ = Part::Axes;
        } else if (value.starts_with('[')) {
            open_key_ = key;
            return add_to_list(value);
        } else if (value.empty()) {
            part_ = Part::None;
        }
        return nullptr;
    }

    /// Lists run over several lines: the descriptor always, the codes of keys often.
    const char* add_to_list(std::string_view text) {
        if (open_list_.size() + text.size() > 64 * 1024) return "a list of more than 64 kB";
        text = text.substr(0, text.find('#'));
        open_list_ += text;
        if (text.find(']') == std::string_view::npos) return nullptr;
        const auto list = list_of(open_list_);
        open_list_.clear();
        if (!list) return "a list holds something else than numbers";
        return finish_list(*list);
    }

    const char* continue_list(std::string_view line) { return add_to_list(line); }

    const char* finish_list(const std::vector<std::int64_t>& list) {
        Capture& device = devices_.back();
        if (open_key_ == "id") {
            if (!fits(list, 4, 0, 0xffff)) return "id needs bus, vendor, product and version";
            device.device.bus = static_cast<std::uint16_t>(list[0]);
            device.device.vendor = static_cast<std::uint16_t>(list[1]);
            device.device.product = static_cast<std::uint16_t>(list[2]);
            device.device.version = static_cast<std::uint16_t>(list[3]);
        } else if (open_key_ == "hid") {
            if (!fits(list, list.size(), 0, 255)) return "hid needs bytes";
            device.descriptors.push_back({0, {list.begin(), list.end()}});
        } else if (open_key_ == "properties") {
            for (const std::int64_t p : list) {
                if (p >= 0 && p < 32) device.evdev.properties[static_cast<std::size_t>(p)] = true;
            }
        } else if (const auto number = number_of_text<std::uint16_t>(open_key_)) {
            return numbered(*number, list);
        }
        return nullptr;
    }

    const char* numbered(std::uint16_t number, const std::vector<std::int64_t>& list) {
        EvdevDescription& evdev = devices_.back().evdev;
        if (part_ == Part::Axes) {
            if (number >= evdev.axes.size() || !fits(list, 5, INT32_MIN, INT32_MAX)) {
                return "absinfo needs minimum, maximum, fuzz, flat and resolution";
            }
            evdev.axes[number] =
                EvdevDescription::Axis{static_cast<std::int32_t>(list[0]), static_cast<std::int32_t>(list[1]),
                                       static_cast<std::int32_t>(list[4]), 0};
        } else if (part_ == Part::Codes && number == EV_KEY) {
            for (const std::int64_t code : list) {
                if (code >= 0 && code < 768) evdev.keys[static_cast<std::size_t>(code)] = true;
            }
        }
        return nullptr;
    }

    const char* event(std::string_view text) {
        const auto list = list_of(text);
        if (!list || list->size() != 5) return "an event needs seconds, microseconds, type, code and value";
        const std::vector<std::int64_t>& e = *list;
        const auto within = [](std::int64_t v, std::int64_t low, std::int64_t high) { return v >= low && v <= high; };
        if (!within(e[0], 0, 4'000'000'000) || !within(e[1], 0, 999'999) || !within(e[2], 0, 0xffff) ||
            !within(e[3], 0, 0xffff) || !within(e[4], INT32_MIN, INT32_MAX)) {
            return "an event holds a number that is out of range";
        }
        devices_.back().events.push_back({(e[0] * 1'000'000 + e[1]) * 1000, static_cast<std::uint16_t>(e[2]),
                                          static_cast<std::uint16_t>(e[3]), static_cast<std::int32_t>(e[4])});
        return nullptr;
    }

    enum class Part { None, Codes, Axes };

    TextLines lines_;
    std::vector<Capture> devices_;
    Part part_ = Part::None;
    std::string open_key_;
    std::string open_list_;
};

}  // namespace

core::Result<Capture> parse_libinput_record(std::string_view text) {
    return Reader(text).run();
}

}  // namespace input
