#include "input/devices/device_file.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "input/formats/text_lines.hpp"

namespace input {
namespace {

using nlohmann::json;

struct RoleName {
    std::string_view name;
    PenRole role;
};

constexpr std::array<RoleName, 19> kRoleNames{{{"x", PenRole::X},
                                               {"y", PenRole::Y},
                                               {"pressure", PenRole::Pressure},
                                               {"tilt_x", PenRole::TiltX},
                                               {"tilt_y", PenRole::TiltY},
                                               {"rotation", PenRole::Rotation},
                                               {"distance", PenRole::Distance},
                                               {"wheel", PenRole::Wheel},
                                               {"tip", PenRole::Tip},
                                               {"barrel1", PenRole::Barrel1},
                                               {"barrel2", PenRole::Barrel2},
                                               {"barrel3", PenRole::Barrel3},
                                               {"in_range", PenRole::InRange},
                                               {"invert", PenRole::Invert},
                                               {"eraser", PenRole::Eraser},
                                               {"serial_low", PenRole::SerialLow},
                                               {"serial_high", PenRole::SerialHigh},
                                               {"tool_id", PenRole::ToolId},
                                               {"button_code", PenRole::ButtonCode}}};

/// Reads one file. The first fault is kept, with the member it is in; what follows does nothing.
class Reader {
  public:
    explicit Reader(std::string file) { out_.file = std::move(file); }

    core::Result<DeviceFile> run(std::string_view text) {
        const json root = json::parse(text, nullptr, false, true);
        if (!root.is_object()) return core::unexpected(core::ErrorCode::BadFormat, "this is no JSON object", out_.file);
        only(root, "",
             {"name", "why", "parser", "claims", "names", "reports", "wake", "axes", "size_mm", "fine", "silence_ms",
              "barrel_buttons", "eraser"});
        out_.name = text_of(root, "name", true);
        out_.why = text_of(root, "why", true);
        out_.parser = text_of(root, "parser", true);
        if (out_.parser != "descriptor" && out_.parser != "fields" && out_.parser != "wacom-intuos") {
            fail("parser", "is none of descriptor, fields, wacom-intuos");
        }
        read_claims(root);
        for (const json& name : list(root, "names")) {
            if (!name.is_string()) return fault_error("names", "holds something else than texts");
            out_.names.push_back(name.get<std::string>());
        }
        if (root.contains("axes")) out_.axes = axes_of(root["axes"], "axes");
        if (root.contains("size_mm")) out_.size_mm = size_of(root["size_mm"]);
        read_reports(root);
        read_wake(root);
        out_.fine = flag_of(root, "fine", true);
        out_.eraser = flag_of(root, "eraser", false);
        if (root.contains("silence_ms")) out_.silence_ms = whole(root["silence_ms"], "silence_ms", 5, 5000);
        if (root.contains("barrel_buttons"))
            out_.barrel_buttons = whole(root["barrel_buttons"], "barrel_buttons", 0, 3);
        if (out_.parser == "fields" && out_.layouts.empty()) fail("reports", "is missing, and the parser is fields");
        if (!fault_.empty()) return core::unexpected(core::ErrorCode::BadFormat, fault_, out_.file);
        return std::move(out_);
    }

  private:
    void read_claims(const json& root) {
        if (!root.contains("claims")) return fail("claims", "is missing");
        for (const json& claim : list(root, "claims")) {
            if (!claim.is_object()) return fail("claims", "holds something else than objects");
            only(claim, "claims", {"vendor", "products", "interface", "firmware"});
            DeviceClaim c;
            c.vendor = hex_of(claim, "vendor");
            c.firmware = text_of(claim, "firmware", false);
            if (claim.contains("interface")) c.interface = whole(claim["interface"], "interface", 0, 31);
            if (list(claim, "products").empty()) fail("claims", "has no products");
            for (const json& product : list(claim, "products")) {
                const auto number = product.is_string() ? hex(product.get<std::string>()) : std::nullopt;
                if (!number) return fail("products", "needs numbers of four hexadecimal digits, as texts");
                c.product = *number;
                out_.claims.push_back(c);
            }
        }
    }

    void read_reports(const json& root) {
        for (const json& report : list(root, "reports")) {
            if (!report.is_object()) return fail("reports", "holds something else than objects");
            only(report, "reports", {"id", "bytes", "when", "fields", "axes", "axes_from", "pressure_needs_tip"});
            FileLayout l;
            const std::string id = text_of(report, "id", true);
            const auto number = number_of_text<std::uint8_t>(id, 16);
            if (!number) return fail("id", "needs two hexadecimal digits");
            l.layout.report_id = *number;
            l.layout.name = out_.name + ", report " + std::to_string(*number);
            l.layout.bytes = static_cast<std::size_t>(whole(report.value("bytes", json()), "bytes", 2, 512));
            l.layout.pressure_needs_tip = flag_of(report, "pressure_needs_tip", false);
            if (report.contains("when")) read_condition(report["when"], l.layout);
            read_fields(report.value("fields", json()), l.layout);
            if (report.contains("axes")) l.layout.axes = axes_of(report["axes"], "axes");
            const std::string from = text_of(report, "axes_from", false);
            if (from == "string 100") l.axes_from = AxesFrom::String100;
            if (from == "string 200") l.axes_from = AxesFrom::String200;
            if (from == "size of string 100") l.axes_from = AxesFrom::SizeOfString100;
            if (!from.empty() && l.axes_from == AxesFrom::Descriptor) {
                fail("axes_from", "is none of string 100, string 200, size of string 100");
            }
            out_.layouts.push_back(std::move(l));
        }
    }

    void read_condition(const json& when, PenLayout& layout) {
        if (!when.is_object()) return fail("when", "is no object");
        only(when, "when", {"byte", "mask", "value"});
        layout.match_byte = static_cast<std::size_t>(whole(when.value("byte", json()), "byte", 0, 511));
        const auto mask = number_of_text<std::uint8_t>(text_of(when, "mask", true), 16);
        const auto value = number_of_text<std::uint8_t>(text_of(when, "value", true), 16);
        if (!mask || !value || *mask == 0 || (*value & ~*mask) != 0) {
            return fail("when", "needs mask and value of two hexadecimal digits, the value within the mask");
        }
        layout.match_mask = *mask;
        layout.match_value = *value;
    }

    void read_fields(const json& fields, PenLayout& layout) {
        if (!fields.is_object()) return fail("fields", "is missing");
        for (const auto& [name, spec] : fields.items()) {
            const auto role = std::find_if(kRoleNames.begin(), kRoleNames.end(),
                                           [&, n = name](const RoleName& r) { return r.name == n; });
            if (role == kRoleNames.end()) return fail("fields", "has a name that is not known: " + name);
            const auto field = spec.is_string() ? parse_field_spec(spec.get<std::string>()) : std::nullopt;
            if (!field) return fail("fields", name + " is no place in a report");
            const std::size_t end =
                std::max(field->bit_offset + field->bit_size, field->high_offset + field->high_size);
            if (end > layout.bytes * 8) return fail("fields", name + " lies behind the end of the report");
            PenField f = *field;
            f.role = role->role;
            layout.fields.push_back(f);
        }
        if (!layout.has(PenRole::X) || !layout.has(PenRole::Y)) fail("fields", "has no x and y");
    }

    PenAxes axes_of(const json& axes, const char* member) {
        PenAxes a;
        if (!axes.is_object()) {
            fail(member, "is no object");
            return a;
        }
        only(axes, member, {"x", "y", "pressure", "tilt_x", "tilt_y", "rotation", "distance", "wheel"});
        for (const auto& [name, axis] : kNamedAxes) {
            if (axes.contains(name)) a.*axis = range_of(axes[name], name);
        }
        return a;
    }

    AxisRange range_of(const json& range, const char* member) {
        const bool pair = range.is_array() && (range.size() == 2 || range.size() == 3);
        if (!pair || !std::all_of(range.begin(), range.end(), [](const json& v) { return v.is_number(); })) {
            fail(member, "needs [minimum, maximum] or [minimum, maximum, steps per mm or radian]");
            return {};
        }
        AxisRange r{whole(range[0], member, INT32_MIN, INT32_MAX), whole(range[1], member, INT32_MIN, INT32_MAX),
                    range.size() == 3 ? range[2].get<double>() : 0.0};
        if (r.max <= r.min || r.per_unit < 0.0 || r.per_unit > 1e6) fail(member, "is an empty range, or of no sense");
        return r;
    }

    std::array<double, 2> size_of(const json& size) {
        const bool pair = size.is_array() && size.size() == 2 && size[0].is_number() && size[1].is_number();
        std::array<double, 2> mm{};
        if (pair) mm = {size[0].get<double>(), size[1].get<double>()};
        if (!pair || mm[0] < 20 || mm[1] < 20 || mm[0] > 2500 || mm[1] > 2500) {
            fail("size_mm", "needs [width, height] between 20 and 2500");
        }
        return mm;
    }

    void read_wake(const json& root) {
        for (const json& step : list(root, "wake")) {
            if (!step.is_object()) return fail("wake", "holds something else than objects");
            only(step, "wake", {"read_string", "set_feature", "write", "interface"});
            WakeStep w;
            if (step.contains("interface")) w.interface = whole(step["interface"], "interface", 0, 31);
            if (step.contains("read_string")) {
                w.string = static_cast<std::uint8_t>(whole(step["read_string"], "read_string", 1, 255));
            } else {
                const bool feature = step.contains("set_feature");
                w.kind = feature ? WakeStep::Kind::SetFeature : WakeStep::Kind::WriteOutput;
                const std::string bytes = text_of(step, feature ? "set_feature" : "write", true);
                if (!append_hex_bytes(bytes, w.bytes, 64) || w.bytes.empty())
                    fail("wake", "needs bytes in hexadecimal");
            }
            out_.wake.push_back(std::move(w));
        }
    }

    static json list(const json& object, const char* member) {
        const json value = object.value(member, json::array());
        return value.is_array() ? value : json::array({value});
    }

    void only(const json& object, const std::string& where, std::initializer_list<std::string_view> members) {
        for (const auto& [name, value] : object.items()) {
            if (std::find(members.begin(), members.end(), name) == members.end()) {
                fail(where.empty() ? name.c_str() : where.c_str(),
                     where.empty() ? "is not known" : "has a member that is not known: " + name);
            }
        }
    }

    std::string text_of(const json& object, const char* member, bool needed) {
        const auto found = object.find(member);
        if (found == object.end() && !needed) return {};
        if (found == object.end() || !found->is_string() || found->get<std::string>().empty()) {
            fail(member, "needs a text");
            return {};
        }
        return found->get<std::string>();
    }

    bool flag_of(const json& object, const char* member, bool otherwise) {
        const auto found = object.find(member);
        if (found == object.end()) return otherwise;
        if (!found->is_boolean()) fail(member, "needs true or false");
        return found->is_boolean() && found->get<bool>();
    }

    int whole(const json& value, const char* member, std::int64_t low, std::int64_t high) {
        if (!value.is_number_integer() || value.get<std::int64_t>() < low || value.get<std::int64_t>() > high) {
            fail(member, "needs a whole number from " + std::to_string(low) + " to " + std::to_string(high));
            return static_cast<int>(std::max<std::int64_t>(low, 0));
        }
        return static_cast<int>(value.get<std::int64_t>());
    }

    static std::optional<std::uint16_t> hex(const std::string& text) {
        return text.size() == 4 ? number_of_text<std::uint16_t>(text, 16) : std::nullopt;
    }
    std::uint16_t hex_of(const json& object, const char* member) {
        const auto number = hex(text_of(object, member, true));
        if (!number) fail(member, "needs four hexadecimal digits");
        return number.value_or(0);
    }

    void fail(const char* member, const std::string& what) {
        if (fault_.empty()) fault_ = std::string(member) + " " + what;
    }
    core::Unexpected fault_error(const char* member, const std::string& what) {
        fail(member, what);
        return core::unexpected(core::ErrorCode::BadFormat, fault_, out_.file);
    }

    DeviceFile out_;
    std::string fault_;
};

std::vector<DeviceFile> load_embedded() {
    std::vector<DeviceFile> files;
    for (const EmbeddedFile& embedded : embedded_device_files()) {
        core::Result<DeviceFile> file = parse_device_file(embedded.text, std::string(embedded.name));
        if (file) files.push_back(std::move(*file));
    }
    return files;
}

/// 0 no match; more for a claim that says more.
int score(const DeviceClaim& claim, const DeviceIdentity& device) {
    if (claim.vendor != device.vendor || claim.product != device.product) return 0;
    if (claim.interface >= 0 && device.interface >= 0 && claim.interface != device.interface) return 0;
    if (!claim.firmware.empty() && !device.firmware.starts_with(claim.firmware)) return 0;
    return 1 + (claim.interface >= 0 ? 1 : 0) + (claim.firmware.empty() ? 0 : 2);
}

}  // namespace

core::Result<DeviceFile> parse_device_file(std::string_view text, std::string file) {
    return Reader(std::move(file)).run(text);
}

std::span<const DeviceFile> device_files() {
    static const std::vector<DeviceFile> files = load_embedded();
    return files;
}

const DeviceFile* find_device_file(const DeviceIdentity& device, std::span<const DeviceFile> files) {
    const DeviceFile* best = nullptr;
    int best_score = 0;
    for (const DeviceFile& file : files) {
        for (const DeviceClaim& claim : file.claims) {
            const int s = score(claim, device);
            if (s > best_score) {
                best = &file;
                best_score = s;
            }
        }
    }
    return best;
}

const DeviceFile* find_device_file_by_name(std::string_view name, std::span<const DeviceFile> files) {
    for (const DeviceFile& file : files) {
        if (std::find(file.names.begin(), file.names.end(), name) != file.names.end()) return &file;
    }
    return nullptr;
}

std::optional<PenField> parse_field_spec(std::string_view text) {
    PenField f;
    if (text.starts_with('-') || text.starts_with('!')) {
        f.negated = true;
        text.remove_prefix(1);
    }
    if (text.starts_with('s')) {
        f.is_signed = true;
        text.remove_prefix(1);
    }
    const auto run = [](std::string_view part, std::uint32_t& offset, std::uint8_t& size) {
        const std::size_t colon = part.find(':');
        const auto at = number_of_text<std::uint16_t>(part.substr(0, colon));
        const auto bits = colon == std::string_view::npos ? std::optional<std::uint8_t>(1)
                                                          : number_of_text<std::uint8_t>(part.substr(colon + 1));
        if (!at || !bits || *bits < 1 || *bits > 32) return false;
        offset = *at;
        size = *bits;
        return true;
    };
    const std::size_t plus = text.find('+');
    if (!run(text.substr(0, plus), f.bit_offset, f.bit_size)) return std::nullopt;
    if (plus == std::string_view::npos) return f;
    if (!run(text.substr(plus + 1), f.high_offset, f.high_size) || f.bit_size + f.high_size > 32) return std::nullopt;
    return f;
}

}  // namespace input
