#include "firmware_like_app/commands/pen_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "input/parse/pen_layout.hpp"

namespace app {

using nlohmann::ordered_json;

const char* tool_name(input::PenTool tool) {
    constexpr std::array<const char*, 8> kNames{"pen",      "eraser", "brush", "pencil",
                                                "airbrush", "lens",   "mouse", "touch"};
    return kNames[static_cast<std::size_t>(tool)];
}

ordered_json sample_json(const input::PenSample& s) {
    ordered_json j{{"t_ns", s.time_ns}};
    const auto axis = [&j](const char* name, const std::optional<double>& value) {
        if (value) j[name] = *value;
    };
    axis("x_mm", s.x_mm);
    axis("y_mm", s.y_mm);
    axis("x", s.x);
    axis("y", s.y);
    axis("pressure", s.pressure);
    axis("tilt_x_rad", s.tilt_x_rad);
    axis("tilt_y_rad", s.tilt_y_rad);
    axis("rotation_rad", s.rotation_rad);
    axis("distance", s.distance);
    axis("wheel", s.wheel);
    j["tip"] = s.tip;
    j["hover"] = s.hover();
    j["eraser"] = s.eraser();
    j["buttons"] = s.buttons;
    j["in_range"] = s.in_range;
    j["tool"] = tool_name(s.tool);
    if (s.serial != 0) j["serial"] = s.serial;
    if (s.tool_id != 0) j["tool_id"] = s.tool_id;
    return j;
}

ordered_json samples_json(const std::vector<input::PenSample>& samples) {
    ordered_json list = ordered_json::array();
    for (const input::PenSample& s : samples) list.push_back(sample_json(s));
    return list;
}

ordered_json axes_json(const input::PenAxes& a) {
    ordered_json j = ordered_json::object();
    for (const auto& [name, member] : input::kNamedAxes) {
        const std::optional<input::AxisRange>& range = a.*member;
        if (!range) continue;
        j[name] = {{"min", range->min}, {"max", range->max}};
        if (range->per_unit > 0.0) j[name]["per_unit"] = range->per_unit;
    }
    if (a.width_mm() && a.height_mm()) j["size_mm"] = {*a.width_mm(), *a.height_mm()};
    return j;
}

ordered_json identity_json(const input::DeviceIdentity& d) {
    ordered_json j{{"name", d.name}, {"id", d.known() ? input::vendor_product(d) : ""}, {"bus", d.bus}};
    if (d.interface >= 0) j["interface"] = d.interface;
    if (!d.serial.empty()) j["serial"] = d.serial;
    if (!d.firmware.empty()) j["firmware"] = d.firmware;
    return j;
}

ordered_json descriptor_json(const std::vector<std::uint8_t>& bytes) {
    if (bytes.empty()) return ordered_json::object();
    const auto descriptor = input::parse_report_descriptor(bytes);
    if (!descriptor) return {{"bytes", bytes.size()}, {"malformed", descriptor.error().sentence()}};
    ordered_json collections = ordered_json::array(), reports = ordered_json::array(), pens = ordered_json::array();
    for (const input::HidCollection& c : descriptor->collections) {
        if (c.parent < 0) collections.push_back(input::usage_name(c.usage));
    }
    constexpr std::array<const char*, 3> kKinds{"input", "output", "feature"};
    for (const input::HidReportSize& r : descriptor->reports) {
        reports.push_back({{"kind", kKinds[static_cast<std::size_t>(r.kind)]},
                           {"id", r.report_id},
                           {"bytes", descriptor->report_bytes(r.kind, r.report_id)}});
    }
    for (const input::PenLayout& p : input::find_pens(*descriptor)) {
        pens.push_back({{"name", p.name}, {"report", p.report_id}, {"bytes", p.bytes}, {"axes", axes_json(p.axes)}});
    }
    ordered_json j{{"bytes", bytes.size()}, {"collections", collections}, {"reports", reports}, {"pens", pens}};
    if (!descriptor->notes.empty()) j["notes"] = descriptor->notes;
    return j;
}

ordered_json strokes_json(const std::vector<input::PenStroke>& strokes) {
    ordered_json list = ordered_json::array();
    for (const input::PenStroke& s : strokes) {
        list.push_back({{"device", s.device}, {"tool", tool_name(s.tool)}, {"samples", samples_json(s.samples)}});
    }
    return list;
}

std::string stroke_line(std::size_t number, const input::PenStroke& stroke) {
    double length_mm = 0.0, least = 1.0, most = 0.0;
    const std::vector<input::PenSample>& all = stroke.samples;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i > 0 && all[i].x_mm && all[i - 1].x_mm && all[i].y_mm && all[i - 1].y_mm) {
            length_mm += std::hypot(*all[i].x_mm - *all[i - 1].x_mm, *all[i].y_mm - *all[i - 1].y_mm);
        }
        if (!all[i].pressure) continue;
        least = std::min(least, *all[i].pressure);
        most = std::max(most, *all[i].pressure);
    }
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "stroke %zu: %zu samples in %.2f s, %.1f mm, pressure %.2f to %.2f, %s",
                  number, all.size(), static_cast<double>(all.back().time_ns - all.front().time_ns) * 1e-9, length_mm,
                  std::min(least, most), most, tool_name(stroke.tool));
    return text.data();
}

}  // namespace app
