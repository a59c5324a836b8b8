#include <array>
#include <charconv>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "input/formats/text_lines.hpp"
#include "input/trace/trace.hpp"

namespace input {
namespace {

using nlohmann::ordered_json;

constexpr std::array<std::uint32_t, 256> make_crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t c = i;
        for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
        table[i] = c;
    }
    return table;
}
constexpr std::array<std::uint32_t, 256> kCrcTable = make_crc_table();

void append_hex(std::string& out, const std::vector<std::uint8_t>& bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    for (const std::uint8_t b : bytes) {
        out += kDigits[b >> 4U];
        out += kDigits[b & 15U];
    }
}

template <typename T>
void append_number(std::string& out, T value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    out.append(text.data(), end);
}

void append_head(std::string& out, char kind, std::uint32_t device, std::int64_t time_ns) {
    out += kind;
    out += ' ';
    append_number(out, device);
    out += ' ';
    append_number(out, time_ns);
}

ordered_json range_json(const AxisRange& r) {
    ordered_json j = ordered_json::array({r.min, r.max});
    if (r.per_unit > 0.0) j.push_back(r.per_unit);
    return j;
}

ordered_json axes_json(const PenAxes& a) {
    ordered_json j = ordered_json::object();
    for (const auto& [name, range] : kNamedAxes) {
        if (a.*range) j[name] = range_json(*(a.*range));
    }
    return j;
}

struct Lines {
    std::string out;

    void operator()(const TraceDevice& d) {
        out += "d ";
        append_number(out, d.number);
        out += ' ';
        std::string descriptor;
        append_hex(descriptor, d.descriptor);
        ordered_json j{{"name", d.identity.name},
                       {"bus", d.identity.bus},
                       {"vendor", d.identity.vendor},
                       {"product", d.identity.product},
                       {"version", d.identity.version},
                       {"interface", d.identity.interface},
                       {"serial", d.identity.serial},
                       {"firmware", d.identity.firmware},
                       {"source", d.source},
                       {"parser", d.parser},
                       {"axes", axes_json(d.axes)},
                       {"reports_range", d.reports_range},
                       {"descriptor", descriptor}};
        if (!d.keys.empty()) j["keys"] = d.keys;
        out += j.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    }
    void operator()(const TraceReport& r) {
        append_head(out, 'r', r.device, r.time_ns);
        out += ' ';
        append_hex(out, r.bytes);
    }
    void operator()(const TraceFrame& f) {
        append_head(out, 'e', f.device, f.time_ns);
        for (const EvdevEvent& e : f.events) {
            out += ' ';
            append_number(out, e.type);
            out += ':';
            append_number(out, e.code);
            out += ':';
            append_number(out, e.value);
        }
    }
    void operator()(const PenSample& s) {
        append_head(out, 's', s.device, s.time_ns);
        out += ' ';
        out += s.in_range ? 'R' : '-';
        out += s.tip ? 'T' : '-';
        const auto axis = [this](const char* key, const std::optional<double>& value) {
            if (!value) return;
            out += ' ';
            out += key;
            out += '=';
            append_number(out, *value);
        };
        axis("x", s.x);
        axis("y", s.y);
        axis("X", s.x_mm);
        axis("Y", s.y_mm);
        axis("p", s.pressure);
        axis("tx", s.tilt_x_rad);
        axis("ty", s.tilt_y_rad);
        axis("ro", s.rotation_rad);
        axis("di", s.distance);
        axis("wh", s.wheel);
        const auto whole = [this](const char* key, std::uint64_t value) {
            if (value == 0) return;
            out += ' ';
            out += key;
            out += '=';
            append_number(out, value);
        };
        whole("b", s.buttons);
        whole("to", static_cast<std::uint64_t>(s.tool));
        whole("se", s.serial);
        whole("id", s.tool_id);
    }
    void operator()(const TraceChange& c) {
        append_head(out, 'v', c.device, c.time_ns);
        constexpr std::array<const char*, 3> kNames{" attached", " detached", " asleep"};
        out += kNames[static_cast<std::size_t>(c.change)];
    }
    void operator()(const TraceMarker& m) {
        append_head(out, 'm', 0, m.time_ns);
        out += ' ';
        out += one_line(m.text);
    }
};

std::string with_checksum(std::string line) {
    line += checksum_text(line);
    return line + "\n";
}

}  // namespace

std::uint32_t crc32(std::string_view text) {
    std::uint32_t c = 0xFFFFFFFFU;
    for (const char byte : text) c = kCrcTable[(c ^ static_cast<std::uint8_t>(byte)) & 0xFFU] ^ (c >> 8U);
    return ~c;
}

std::string one_line(std::string_view text) {
    std::string out(trimmed(text.substr(0, 1000)));
    for (char& c : out) {
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    return std::string(trimmed(out));
}

std::string checksum_text(std::string_view line) {
    std::array<char, 16> sum{};
    std::snprintf(sum.data(), sum.size(), " *%08x", crc32(line));
    return sum.data();
}

std::string trace_header() {
    return with_checksum("croquis-trace " + std::to_string(kTraceVersion));
}

std::string trace_line(const TraceRecord& record) {
    Lines lines;
    std::visit(lines, record);
    return with_checksum(std::move(lines.out));
}

}  // namespace input
