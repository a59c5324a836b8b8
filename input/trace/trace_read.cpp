#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/exchange/file_bytes.hpp"
#include "input/formats/text_lines.hpp"
#include "input/parse/report_descriptor.hpp"
#include "input/trace/trace.hpp"

namespace input {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxLineBytes = 64 * 1024;
constexpr std::size_t kMaxFaultsKept = 100;
constexpr std::int64_t kFarthest_ns = 4'000'000'000'000'000'000;  // so that no difference of two times overflows
constexpr std::string_view kMagic = "croquis-trace ";

/// The line without its checksum; nothing when that is missing or wrong.
std::optional<std::string_view> checked(std::string_view line) {
    constexpr std::size_t kSumBytes = 10;
    if (line.size() < kSumBytes || line.size() > kMaxLineBytes) return std::nullopt;
    const std::string_view body = line.substr(0, line.size() - kSumBytes), sum = line.substr(line.size() - kSumBytes);
    return sum == checksum_text(body) ? std::optional(body) : std::nullopt;
}

std::optional<std::vector<std::uint8_t>> bytes_of(std::string_view hex, std::size_t most) {
    if (hex.size() % 2 != 0 || hex.size() / 2 > most) return std::nullopt;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(hex.size() / 2);
    for (std::size_t i = 0; i < hex.size(); i += 2) {
        const auto value = number_of_text<std::uint8_t>(hex.substr(i, 2), 16);
        if (!value) return std::nullopt;
        bytes.push_back(*value);
    }
    return bytes;
}

std::optional<AxisRange> range_of(const json& j) {
    if (!j.is_array() || j.size() < 2 || j.size() > 3) return std::nullopt;
    for (const json& v : j) {
        if (!v.is_number()) return std::nullopt;
    }
    const auto whole = [](const json& v) {
        return static_cast<std::int32_t>(std::clamp(v.get<double>(), -2147483648.0, 2147483647.0));
    };
    AxisRange r{whole(j[0]), whole(j[1]), j.size() == 3 ? j[2].get<double>() : 0.0};
    if (r.max <= r.min || !std::isfinite(r.per_unit) || r.per_unit < 0.0) return std::nullopt;
    return r;
}

PenAxes axes_of(const json& j) {
    PenAxes a;
    if (!j.is_object()) return a;
    for (const auto& [name, range] : kNamedAxes) {
        if (j.contains(name)) a.*range = range_of(j[name]);
    }
    return a;
}

std::string text_member(const json& j, const char* name) {
    const auto found = j.find(name);
    return found != j.end() && found->is_string() ? found->get<std::string>() : std::string();
}

template <typename T>
T number_member(const json& j, const char* name, T otherwise) {
    const auto found = j.find(name);
    if (found == j.end() || !found->is_number_integer()) return otherwise;
    const auto value = found->get<std::int64_t>();
    if (value < static_cast<std::int64_t>(std::numeric_limits<T>::min()) ||
        value > static_cast<std::int64_t>(std::numeric_limits<T>::max())) {
        return otherwise;
    }
    return static_cast<T>(value);
}

std::optional<TraceRecord> device_of(std::uint32_t number, std::string_view rest) {
    const json j = json::parse(rest, nullptr, false);
    if (!j.is_object()) return std::nullopt;
    TraceDevice d;
    d.number = number;
    d.identity.name = text_member(j, "name");
    d.identity.bus = number_member<std::uint16_t>(j, "bus", 0);
    d.identity.vendor = number_member<std::uint16_t>(j, "vendor", 0);
    d.identity.product = number_member<std::uint16_t>(j, "product", 0);
    d.identity.version = number_member<std::uint16_t>(j, "version", 0);
    d.identity.interface = number_member<std::int32_t>(j, "interface", -1);
    d.identity.serial = text_member(j, "serial");
    d.identity.firmware = text_member(j, "firmware");
    d.source = text_member(j, "source");
    d.parser = text_member(j, "parser");
    d.axes = axes_of(j.value("axes", json()));
    const auto range = j.find("reports_range");
    d.reports_range = range == j.end() || !range->is_boolean() || range->get<bool>();
    for (const json& key : j.value("keys", json::array())) {
        if (!key.is_number_unsigned() || key.get<std::uint64_t>() >= 768 || d.keys.size() >= 768) return std::nullopt;
        d.keys.push_back(key.get<std::uint16_t>());
    }
    auto descriptor = bytes_of(text_member(j, "descriptor"), kMaxDescriptorBytes);
    if (!descriptor) return std::nullopt;
    d.descriptor = std::move(*descriptor);
    return d;
}

std::optional<TraceRecord> frame_of(std::uint32_t device, std::int64_t time_ns, std::string_view rest) {
    TraceFrame f{device, time_ns, {}};
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
        const std::size_t first = word.find(':'), second = word.find(':', first + 1);
        if (first == std::string_view::npos || second == std::string_view::npos) return std::nullopt;
        const auto type = number_of_text<std::uint16_t>(word.substr(0, first));
        const auto code = number_of_text<std::uint16_t>(word.substr(first + 1, second - first - 1));
        const auto value = number_of_text<std::int32_t>(word.substr(second + 1));
        if (!type || !code || !value) return std::nullopt;
        f.events.push_back({time_ns, *type, *code, *value});
    }
    if (f.events.empty()) return std::nullopt;
    return f;
}

bool set_axis(PenSample& s, std::string_view key, double value) {
    const std::array<std::pair<std::string_view, std::optional<double>*>, 10> all{{{"x", &s.x},
                                                                                   {"y", &s.y},
                                                                                   {"X", &s.x_mm},
                                                                                   {"Y", &s.y_mm},
                                                                                   {"p", &s.pressure},
                                                                                   {"tx", &s.tilt_x_rad},
                                                                                   {"ty", &s.tilt_y_rad},
                                                                                   {"ro", &s.rotation_rad},
                                                                                   {"di", &s.distance},
                                                                                   {"wh", &s.wheel}}};
    for (const auto& [name, axis] : all) {
        if (name != key) continue;
        *axis = value;
        return true;
    }
    return false;
}

bool set_whole(PenSample& s, std::string_view key, std::uint64_t value) {
    if (key == "b" && value <= 0xffffffffU) {
        s.buttons = static_cast<std::uint32_t>(value);
    } else if (key == "to" && value <= static_cast<std::uint64_t>(PenTool::Touch)) {
        s.tool = static_cast<PenTool>(value);
    } else if (key == "se") {
        s.serial = value;
    } else if (key == "id" && value <= 0xffffffffU) {
        s.tool_id = static_cast<std::uint32_t>(value);
    } else {
        return false;
    }
    return true;
}

std::optional<TraceRecord> sample_of(std::uint32_t device, std::int64_t time_ns, std::string_view rest) {
    PenSample s;
    s.device = device;
    s.time_ns = time_ns;
    const std::string_view state = take_word(rest);
    if (state.size() != 2 || (state[0] != 'R' && state[0] != '-') || (state[1] != 'T' && state[1] != '-')) {
        return std::nullopt;
    }
    s.in_range = state[0] == 'R';
    s.tip = state[1] == 'T';
    if (s.tip && !s.in_range) return std::nullopt;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
        const std::size_t equals = word.find('=');
        if (equals == std::string_view::npos) return std::nullopt;
        const std::string_view key = word.substr(0, equals), text = word.substr(equals + 1);
        const auto whole = number_of_text<std::uint64_t>(text);
        if (whole && set_whole(s, key, *whole)) continue;
        double value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool number = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
        if (!number || !set_axis(s, key, value)) return std::nullopt;
    }
    return s;
}

std::optional<TraceRecord> change_of(std::uint32_t device, std::int64_t time_ns, std::string_view rest) {
    rest = trimmed(rest);
    if (rest == "attached") return TraceChange{device, time_ns, DeviceChange::Attached};
    if (rest == "detached") return TraceChange{device, time_ns, DeviceChange::Detached};
    if (rest == "asleep") return TraceChange{device, time_ns, DeviceChange::Asleep};
    return std::nullopt;
}

std::optional<TraceRecord> record_of(std::string_view body) {
    std::string_view rest = body;
    const std::string_view kind = take_word(rest);
    const auto device = number_of_text<std::uint32_t>(take_word(rest));
    if (kind.size() != 1 || !device) return std::nullopt;
    if (kind == "d") return device_of(*device, trimmed(rest));
    const auto time_ns = number_of_text<std::int64_t>(take_word(rest));
    if (!time_ns || *time_ns < -kFarthest_ns || *time_ns > kFarthest_ns) return std::nullopt;
    switch (kind[0]) {
        case 'r': {
            auto bytes = bytes_of(trimmed(rest), kMaxLineBytes);
            if (!bytes || bytes->empty()) return std::nullopt;
            return TraceReport{*device, *time_ns, std::move(*bytes)};
        }
        case 'e':
            return frame_of(*device, *time_ns, rest);
        case 's':
            return sample_of(*device, *time_ns, rest);
        case 'v':
            return change_of(*device, *time_ns, rest);
        case 'm':
            return TraceMarker{*time_ns, one_line(trimmed(rest))};
        default:
            return std::nullopt;
    }
}

}  // namespace

bool looks_like_trace(std::string_view text) {
    return text.starts_with(kMagic);
}

core::Result<Trace> parse_trace(std::string_view text) {
    if (!looks_like_trace(text)) {
        return core::unexpected(core::ErrorCode::UnknownFormat, "this is no trace; its first line is another");
    }
    Trace trace;
    const auto fault = [&](std::size_t line, const char* why, bool torn) {
        ++trace.fault_count;
        if (trace.faults.size() < kMaxFaultsKept) trace.faults.push_back({line, why, torn});
    };
    const bool whole = text.back() == '\n';
    const std::size_t last_line_at =
        text.find_last_of('\n') == std::string_view::npos ? 0 : text.find_last_of('\n') + 1;
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
        const bool torn = !whole && static_cast<std::size_t>(line.data() - text.data()) >= last_line_at;
        const std::optional<std::string_view> body = torn ? std::nullopt : checked(line);
        if (!body) {
            fault(lines.number(), torn ? "the line was cut off" : "its checksum is wrong", torn);
            continue;
        }
        if (lines.number() == 1) {
            const auto version = number_of_text<int>(body->substr(kMagic.size()));
            if (version && *version > kTraceVersion) {
                return core::unexpected(core::ErrorCode::NewerVersion,
                                        "this trace was written by a newer version of the program; update it");
            }
            if (!version || *version < 1) fault(1, "it names no version", false);
            continue;
        }
        std::optional<TraceRecord> record = record_of(*body);
        record ? trace.records.push_back(std::move(*record)) : fault(lines.number(), "it cannot be read", false);
    }
    if (trace.records.empty() && trace.fault_count > 0) {
        return core::unexpected(core::ErrorCode::Damaged, "not one record of this trace can be read; record again");
    }
    return trace;
}

core::Result<Trace> read_trace(const std::string& path) {
    const core::Result<std::string> text = core::read_file_bytes(path, kMaxTraceBytes);
    if (!text) return core::unexpected(text.error());
    core::Result<Trace> trace = parse_trace(*text);
    if (trace) return trace;
    core::Error error = trace.error();
    error.where = path;
    return core::unexpected(std::move(error));
}

std::vector<PenSample> Trace::samples() const {
    std::vector<PenSample> out;
    for (const TraceRecord& r : records) {
        if (const auto* s = std::get_if<PenSample>(&r)) out.push_back(*s);
    }
    return out;
}

const TraceDevice* Trace::device(std::uint32_t number) const {
    const TraceDevice* last = nullptr;
    for (const TraceRecord& r : records) {
        const auto* d = std::get_if<TraceDevice>(&r);
        if (d != nullptr && d->number == number) last = d;
    }
    return last;
}

std::string Trace::damage() const {
    if (fault_count == 0) return {};
    if (fault_count == 1 && faults.front().torn) {
        return "the last record was cut off; the " + std::to_string(records.size()) + " before it are whole";
    }
    return std::to_string(fault_count) + (fault_count == 1 ? " record is" : " records are") +
           " damaged, first in line " + std::to_string(faults.front().line) + " (" + faults.front().why +
           "); the other " + std::to_string(records.size()) + " are whole";
}

}  // namespace input
