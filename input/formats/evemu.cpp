// evemu: "N:" name, "I:" bus, vendor, product and version, "P:" properties, "B:" a row of bits of a type's codes, "A:"
// code, minimum, maximum, fuzz, flat and (since 1.1) resolution of an axis, "E:" time, type, code and value of an
// event. A recording may come without the description; then its axes are what the events show (see
// `has_evdev_description`).
//
// The second format here is that of older programs: "/dev/input/event9 1281178415.886711 EV_KEY BTN_DIGI 0x00000001".

#include <linux/input-event-codes.h>

#include <array>

#include "input/formats/capture.hpp"
#include "input/formats/capture_notes.hpp"
#include "input/formats/text_lines.hpp"

namespace input {
namespace {

template <typename T>
std::optional<T> next_number(std::string_view& rest, int base) {
    return number_of_text<T>(take_word(rest), base);
}

class Reader {
  public:
    explicit Reader(std::string_view text) : lines_(text) {}

    core::Result<Capture> run() {
        out_.format = CaptureFormat::Evemu;
        for (std::string_view line; lines_.next(line);) {
            if (line.size() < 3 || line[1] != ':') continue;
            if (const char* fault = take(line[0], line.substr(2))) return bad_line(lines_.number(), fault);
        }
        return std::move(out_);
    }

  private:
    const char* take(char kind, std::string_view rest) {
        switch (kind) {
            case 'N':
                out_.device.name = trimmed(rest).substr(0, 200);
                out_.has_evdev_description = true;
                return nullptr;
            case 'I':
                return identity(rest);
            case 'P':
                return bits(rest, property_row_, [this](std::size_t bit) {
                    if (bit < out_.evdev.properties.size()) out_.evdev.properties[bit] = true;
                });
            case 'B':
                return codes(rest);
            case 'A':
                return axis(rest);
            case 'E':
                return event(rest);
            default:
                return nullptr;
        }
    }

    const char* identity(std::string_view rest) {
        const auto bus = next_number<std::uint16_t>(rest, 16);
        const auto vendor = next_number<std::uint16_t>(rest, 16);
        const auto product = next_number<std::uint16_t>(rest, 16);
        const auto version = next_number<std::uint16_t>(rest, 16);
        if (!bus || !vendor || !product || !version) return "I: needs bus, vendor, product and version in hexadecimal";
        out_.device.bus = *bus;
        out_.device.vendor = *vendor;
        out_.device.product = *product;
        out_.device.version = *version;
        return nullptr;
    }

    template <typename Set>
    const char* bits(std::string_view rest, std::size_t& first_byte, Set set) {
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            const auto byte = number_of_text<std::uint8_t>(word, 16);
            if (!byte || first_byte > 4096) return "P: and B: need bytes in hexadecimal";
            for (std::size_t bit = 0; bit < 8; ++bit) {
                if ((*byte >> bit) & 1U) set(first_byte * 8 + bit);
            }
            ++first_byte;
        }
        return nullptr;
    }

    const char* codes(std::string_view rest) {
        const auto type = next_number<std::uint8_t>(rest, 16);
        if (!type || *type >= code_row_.size()) return "B: needs an event type";
        return bits(rest, code_row_[*type], [&](std::size_t bit) {
            if (*type == EV_KEY && bit < out_.evdev.keys.size()) out_.evdev.keys[bit] = true;
        });
    }

    const char* axis(std::string_view rest) {
        const auto code = next_number<std::uint8_t>(rest, 16);
        const auto min = next_number<std::int32_t>(rest, 10);
        const auto max = next_number<std::int32_t>(rest, 10);
        const auto fuzz = next_number<std::int32_t>(rest, 10);
        const auto flat = next_number<std::int32_t>(rest, 10);
        if (!code || *code >= out_.evdev.axes.size() || !min || !max || !fuzz || !flat) {
            return "A: needs an axis, its minimum, maximum, fuzz and flat";
        }
        const auto resolution = next_number<std::int32_t>(rest, 10);
        out_.evdev.axes[*code] = EvdevDescription::Axis{*min, *max, resolution.value_or(0), 0};
        return nullptr;
    }

    const char* event(std::string_view rest) {
        const auto time = nanoseconds_of_text(take_word(rest));
        const auto type = next_number<std::uint16_t>(rest, 16);
        const auto code = next_number<std::uint16_t>(rest, 16);
        const auto value = next_number<std::int32_t>(rest, 10);
        if (!time || !type || !code || !value) return "E: needs a time, a type, a code and a value";
        out_.events.push_back({*time, *type, *code, *value});
        return nullptr;
    }

    TextLines lines_;
    Capture out_;
    std::size_t property_row_ = 0;
    std::array<std::size_t, 32> code_row_{};  ///< bytes of each type's bits read so far
};

struct CodeName {
    std::string_view name;
    std::uint16_t code;
};

constexpr std::array<CodeName, 5> kTypes{
    {{"EV_SYN", EV_SYN}, {"EV_KEY", EV_KEY}, {"EV_REL", EV_REL}, {"EV_ABS", EV_ABS}, {"EV_MSC", EV_MSC}}};

/// The names that those programs gave to what pens send; BTN_DIGI is the first code of the digitizers' block.
constexpr std::array<CodeName, 19> kCodes{{{"SYN_REPORT", SYN_REPORT},
                                           {"SYN_DROPPED", SYN_DROPPED},
                                           {"ABS_X", ABS_X},
                                           {"ABS_Y", ABS_Y},
                                           {"ABS_Z", ABS_Z},
                                           {"ABS_WHEEL", ABS_WHEEL},
                                           {"ABS_PRESSURE", ABS_PRESSURE},
                                           {"ABS_DISTANCE", ABS_DISTANCE},
                                           {"ABS_TILT_X", ABS_TILT_X},
                                           {"ABS_TILT_Y", ABS_TILT_Y},
                                           {"ABS_MISC", ABS_MISC},
                                           {"BTN_DIGI", BTN_TOOL_PEN},
                                           {"BTN_TOOL_PEN", BTN_TOOL_PEN},
                                           {"BTN_TOOL_RUBBER", BTN_TOOL_RUBBER},
                                           {"BTN_TOOL_MOUSE", BTN_TOOL_MOUSE},
                                           {"BTN_TOUCH", BTN_TOUCH},
                                           {"BTN_STYLUS", BTN_STYLUS},
                                           {"BTN_STYLUS2", BTN_STYLUS2},
                                           {"MSC_SERIAL", MSC_SERIAL}}};

template <std::size_t N>
std::optional<std::uint16_t> code_of(const std::array<CodeName, N>& names, std::string_view name) {
    for (const CodeName& n : names) {
        if (n.name == name) return n.code;
    }
    return std::nullopt;
}

std::optional<std::int32_t> value_of(std::string_view text) {
    if (!text.starts_with("0x")) return number_of_text<std::int32_t>(text);
    const auto value = number_of_text<std::uint32_t>(text.substr(2), 16);
    if (!value) return std::nullopt;
    return static_cast<std::int32_t>(*value);
}

}  // namespace

core::Result<Capture> parse_evemu(std::string_view text) {
    return Reader(text).run();
}

core::Result<Capture> parse_evdev_text(std::string_view text) {
    Capture out;
    out.format = CaptureFormat::EvdevText;
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
        std::string_view rest = line;
        if (!take_word(rest).starts_with("/dev/input/event")) continue;
        const auto time = nanoseconds_of_text(take_word(rest));
        const auto type = code_of(kTypes, take_word(rest));
        const std::string_view name = take_word(rest);
        const auto value = value_of(take_word(rest));
        if (!time || !type || !value)
            return bad_line(lines.number(), "an event needs a time, a type, a code and a value");
        const auto code = code_of(kCodes, name);
        if (!code) {
            note_line(out, lines.number(), "an event that no pen sends");
            continue;
        }
        out.events.push_back({*time, *type, *code, *value});
    }
    return out;
}

}  // namespace input
