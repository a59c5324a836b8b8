#include "input/parse/pen_layout.hpp"

#include <algorithm>
#include <array>
#include <bitset>

namespace input {
namespace {

constexpr Usage kDesktop = 0x00010000, kDigitizer = 0x000D0000, kButton = 0x00090000;
constexpr Usage kMouse = kDesktop | 0x02, kPointer = kDesktop | 0x01;
constexpr double kSmallestArea_mm = 30.0, kLargestArea_mm = 2500.0;

/// Wacom's page 0xFF0D repeats the digitizer page, and in its second hundred the generic desktop page.
Usage standard_usage(Usage usage) {
    if (usage >> 16U != 0xFF0DU) return usage;
    const Usage low = usage & 0xFFU;
    switch ((usage >> 8U) & 0xFFU) {
        case 0x00:
            return kDigitizer | low;
        case 0x01:
            return low == 0x32 ? (kDigitizer | 0xF032U) : (kDesktop | low);  // 0xFF0D0132 is the distance
        default:
            return usage;
    }
}

struct RoleOfUsage {
    Usage usage;
    PenRole role;
};

constexpr std::array<RoleOfUsage, 19> kRoles{{{kDesktop | 0x30, PenRole::X},
                                              {kDesktop | 0x31, PenRole::Y},
                                              {kDesktop | 0x32, PenRole::Distance},
                                              {kDesktop | 0x36, PenRole::Wheel},
                                              {kDigitizer | 0x30, PenRole::Pressure},
                                              {kDigitizer | 0x32, PenRole::InRange},
                                              {kDigitizer | 0x3C, PenRole::Invert},
                                              {kDigitizer | 0x3D, PenRole::TiltX},
                                              {kDigitizer | 0x3E, PenRole::TiltY},
                                              {kDigitizer | 0x41, PenRole::Rotation},
                                              {kDigitizer | 0x42, PenRole::Tip},
                                              {kDigitizer | 0x43, PenRole::Barrel2},
                                              {kDigitizer | 0x44, PenRole::Barrel1},
                                              {kDigitizer | 0x45, PenRole::Eraser},
                                              {kDigitizer | 0x5A, PenRole::Barrel2},
                                              {kDigitizer | 0x5B, PenRole::SerialLow},
                                              {kDigitizer | 0x5C, PenRole::SerialHigh},
                                              {kDigitizer | 0x77, PenRole::ToolId},
                                              {kDigitizer | 0xF032, PenRole::Distance}}};

std::optional<PenRole> role_of(Usage usage) {
    usage = standard_usage(usage);
    for (const RoleOfUsage& r : kRoles) {
        if (r.usage == usage) return r.role;
    }
    return std::nullopt;
}

/// A tablet that is still a mouse: its first button is the tip, the next two are on the barrel.
std::optional<PenRole> role_in_mouse(Usage usage) {
    switch (usage) {
        case kButton | 1U:
            return PenRole::Tip;
        case kButton | 2U:
            return PenRole::Barrel1;
        case kButton | 3U:
            return PenRole::Barrel2;
        case kDesktop | 0x30U:
            return PenRole::X;
        case kDesktop | 0x31U:
            return PenRole::Y;
        case kDigitizer | 0x30U:
            return PenRole::Pressure;
        case kDigitizer | 0x32U:
            return PenRole::InRange;
        case kDigitizer | 0x3DU:
            return PenRole::TiltX;
        case kDigitizer | 0x3EU:
            return PenRole::TiltY;
        default:
            return std::nullopt;
    }
}

bool is_number(PenRole role) {
    return role <= PenRole::Wheel;
}

std::optional<AxisRange>& axis_of(PenAxes& axes, PenRole role) {
    switch (role) {
        case PenRole::X:
            return axes.x;
        case PenRole::Y:
            return axes.y;
        case PenRole::Pressure:
            return axes.pressure;
        case PenRole::TiltX:
            return axes.tilt_x;
        case PenRole::TiltY:
            return axes.tilt_y;
        case PenRole::Rotation:
            return axes.rotation;
        case PenRole::Distance:
            return axes.distance;
        default:
            return axes.wheel;
    }
}

/// What kind of thing the collections around a field describe.
enum class Kind { None, Pen, Puck, Mouse };

Kind kind_of(const ReportDescriptor& descriptor, int collection) {
    Kind kind = Kind::None;
    for (int at = collection; at >= 0; at = descriptor.collections[static_cast<std::size_t>(at)].parent) {
        const Usage usage = standard_usage(descriptor.collections[static_cast<std::size_t>(at)].usage);
        if (usage == (kDigitizer | 0x21U)) return Kind::Puck;
        if (usage == (kDigitizer | 0x22U) || usage == (kDigitizer | 0x04U) || usage == (kDigitizer | 0x05U)) {
            return usage == (kDigitizer | 0x04U) && kind == Kind::Pen ? Kind::Pen : Kind::None;  // a stylus on a screen
        }
        if (usage == (kDigitizer | 0x20U) || usage == (kDigitizer | 0x01U) || usage == (kDigitizer | 0x02U) ||
            usage == (kDigitizer | 0x03U)) {
            kind = Kind::Pen;
        } else if (kind == Kind::None && (usage == kMouse || usage == kPointer)) {
            kind = Kind::Mouse;
        }
    }
    return kind;
}

class LayoutFinder {
  public:
    explicit LayoutFinder(const ReportDescriptor& descriptor) : descriptor_(descriptor) {}

    std::vector<PenLayout> run() {
        std::vector<PenLayout> found;
        for (const HidReportSize& report : descriptor_.reports) {
            if (report.kind != HidKind::Input) continue;
            for (const Kind kind : {Kind::Pen, Kind::Puck, Kind::Mouse}) {
                PenLayout layout = layout_of(report, kind);
                if (!is_a_pen(layout, kind)) continue;
                found.push_back(std::move(layout));
                break;
            }
        }
        return found;
    }

  private:
    PenLayout layout_of(const HidReportSize& report, Kind kind) {
        PenLayout layout;
        layout.report_id = report.report_id;
        layout.bytes = descriptor_.report_bytes(HidKind::Input, report.report_id);
        layout.mouse_puck = kind == Kind::Puck;
        for (const HidField& field : descriptor_.fields) {
            if (field.kind != HidKind::Input || field.report_id != report.report_id) continue;
            if (kind_of(descriptor_, field.collection) != kind) continue;
            if (layout.name.empty()) layout.name = name_of(field);
            if (field.array) {
                add_array(layout, field);
            } else if (const auto role = kind == Kind::Mouse ? role_in_mouse(field.usage) : role_of(field.usage)) {
                add(layout, field, *role);
            }
        }
        // An eraser bit belongs to a pen that can be turned over; a pen that never says it was turned has a button.
        layout.eraser_is_button = layout.has(PenRole::Eraser) && !layout.has(PenRole::Invert);
        drop_senseless_size(layout.axes);
        return layout;
    }

    std::string name_of(const HidField& field) const {
        const int at = descriptor_.application_of(field);
        std::string name =
            at < 0 ? "no collection" : usage_name(descriptor_.collections[static_cast<std::size_t>(at)].usage);
        if (descriptor_.has_report_ids) name += ", report " + std::to_string(field.report_id);
        return name;
    }

    [[nodiscard]] std::uint32_t id_bits() const { return descriptor_.has_report_ids ? 8 : 0; }

    void add(PenLayout& layout, const HidField& field, PenRole role) {
        if (layout.has(role)) return;
        if (field.relative && is_number(role)) return;
        PenField f;
        f.role = role;
        f.bit_offset = field.bit_offset + id_bits();
        f.bit_size = field.bit_size;
        f.is_signed = field.logical_min < 0;
        if (is_number(role))
            axis_of(layout.axes, role) = AxisRange{field.logical_min, field.logical_max, scale(field, role)};
        layout.fields.push_back(f);
    }

    static double scale(const HidField& field, PenRole role) {
        const bool angle = role == PenRole::TiltX || role == PenRole::TiltY || role == PenRole::Rotation;
        const bool length = role == PenRole::X || role == PenRole::Y;
        const unsigned system = field.unit & 15U;
        if ((angle && (system == 2 || system == 4)) || (length && (system == 1 || system == 3)))
            return steps_per_unit(field);
        return 0.0;
    }

    /// Flags that are listed by usage where they are on.
    void add_array(PenLayout& layout, const HidField& field) {
        if (field.usage_max < field.usage || field.usage_max - field.usage > 255) return;
        const Usage count = field.usage_max - field.usage + 1;  // the last usage of all may be among them
        for (Usage i = 0; i < count; ++i) {
            const Usage usage = field.usage + i;
            const std::optional<PenRole> role = role_of(usage);
            if (!role || is_number(*role) || layout.has(*role)) continue;
            PenField f;
            f.role = *role;
            f.bit_offset = field.bit_offset + id_bits();
            f.bit_size = field.bit_size;
            f.in_array = usage;
            f.array_count = field.count;
            f.array_first = field.usage;
            f.array_min = field.logical_min;
            layout.fields.push_back(f);
        }
    }

    /// A resolution that makes an area smaller than a stamp or larger than a wall is a mistake in the descriptor.
    static void drop_senseless_size(PenAxes& axes) {
        const auto sensible = [](std::optional<double> mm) {
            return mm && *mm >= kSmallestArea_mm && *mm <= kLargestArea_mm;
        };
        if (sensible(axes.width_mm()) && sensible(axes.height_mm())) return;
        if (axes.x) axes.x->per_unit = 0.0;
        if (axes.y) axes.y->per_unit = 0.0;
    }

    static bool is_a_pen(const PenLayout& layout, Kind kind) {
        if (!layout.has(PenRole::X) || !layout.has(PenRole::Y)) return false;
        if (kind == Kind::Mouse) return layout.has(PenRole::Pressure) || layout.has(PenRole::InRange);
        return layout.has(PenRole::Tip) || layout.has(PenRole::Pressure) || layout.has(PenRole::InRange);
    }

    const ReportDescriptor& descriptor_;
};

std::uint32_t bits_of(std::span<const std::uint8_t> report, const PenField& f) {
    const std::uint32_t low = extract_bits(report, f.bit_offset, f.bit_size);
    if (f.high_size == 0) return low;
    return low | extract_bits(report, f.high_offset, f.high_size) << f.bit_size;
}

bool is_listed(std::span<const std::uint8_t> report, const PenField& f) {
    for (std::uint32_t i = 0; i < f.array_count; ++i) {
        const std::uint32_t value = extract_bits(report, f.bit_offset + i * f.bit_size, f.bit_size);
        if (static_cast<std::int64_t>(value) - f.array_min + f.array_first == *f.in_array) return true;
    }
    return false;
}

bool flag_of(std::span<const std::uint8_t> report, const PenField& f) {
    return (f.in_array ? is_listed(report, f) : bits_of(report, f) != 0) != f.negated;
}

std::int32_t number_of(std::span<const std::uint8_t> report, const PenField& f) {
    const std::uint32_t raw = bits_of(report, f);
    const unsigned size = f.bit_size + f.high_size;
    auto value = static_cast<std::int32_t>(raw);
    if (f.is_signed && size < 32) {
        const std::uint32_t sign = 1U << (size - 1U);
        value = static_cast<std::int32_t>((raw ^ sign) - sign);
    }
    return f.negated && value != INT32_MIN ? -value : value;
}

/// The member of a report that a number goes to; the roles of numbers come first, in this order.
constexpr std::array<std::optional<std::int32_t> PenReport::*, 8> kNumbers{
    {&PenReport::x, &PenReport::y, &PenReport::pressure, &PenReport::tilt_x, &PenReport::tilt_y, &PenReport::rotation,
     &PenReport::distance, &PenReport::wheel}};

/// The flags of one report, before they are made sense of, by their roles.
struct Flags {
    std::bitset<32> there, on;

    void set(PenRole role, bool value) {
        there.set(static_cast<std::size_t>(role));
        on.set(static_cast<std::size_t>(role), value);
    }
    [[nodiscard]] bool has(PenRole role) const { return there[static_cast<std::size_t>(role)]; }
    [[nodiscard]] bool operator[](PenRole role) const { return on[static_cast<std::size_t>(role)]; }
};

/// 1 the tip, 2 and 3 the buttons.
void read_button_code(std::uint32_t code, Flags& flags) {
    flags.set(PenRole::Tip, code == 1);
    flags.set(PenRole::Barrel1, code == 2);
    flags.set(PenRole::Barrel2, code == 3);
}

void read_field(std::span<const std::uint8_t> report, const PenField& f, PenReport& r, Flags& flags) {
    if (is_number(f.role)) {
        r.*kNumbers[static_cast<std::size_t>(f.role)] = number_of(report, f);
        return;
    }
    switch (f.role) {
        case PenRole::SerialLow:
            r.serial |= bits_of(report, f);
            break;
        case PenRole::SerialHigh:
            r.serial |= static_cast<std::uint64_t>(bits_of(report, f)) << 32U;
            break;
        case PenRole::ToolId:
            r.tool_id = bits_of(report, f);
            break;
        case PenRole::ButtonCode:
            read_button_code(bits_of(report, f), flags);
            break;
        default:
            flags.set(f.role, flag_of(report, f));
    }
}

/// What the flags say of the pen, as Linux takes them: whoever turns the pen over erases only with the eraser's own
/// flag.
void make_sense(const PenLayout& layout, Flags flags, PenReport& r) {
    if (layout.eraser_is_button && flags.has(PenRole::Eraser)) {
        flags.set(PenRole::Barrel2, flags[PenRole::Barrel2] || flags[PenRole::Eraser]);
        flags.there.reset(static_cast<std::size_t>(PenRole::Eraser));
        flags.on.reset(static_cast<std::size_t>(PenRole::Eraser));
    }
    const bool turned = flags[PenRole::Invert] || flags[PenRole::Eraser];
    const bool says_range = flags.has(PenRole::InRange) || flags.has(PenRole::Invert);
    const bool presses = r.pressure && layout.axes.pressure && *r.pressure > layout.axes.pressure->min;
    const bool tip = flags.has(PenRole::Tip) ? flags[PenRole::Tip] : presses;
    r.tool = layout.mouse_puck ? PenTool::Mouse : turned ? PenTool::Eraser : PenTool::Pen;
    r.in_range = !says_range || flags[PenRole::InRange] || turned || flags[PenRole::Tip];
    r.tip = turned && flags.has(PenRole::Eraser) ? flags[PenRole::Eraser] : tip;
    r.buttons = (flags[PenRole::Barrel1] ? kBarrel1 : 0) | (flags[PenRole::Barrel2] ? kBarrel2 : 0) |
                (flags[PenRole::Barrel3] ? kBarrel3 : 0);
}

}  // namespace

bool PenLayout::has(PenRole role) const {
    return std::any_of(fields.begin(), fields.end(), [&](const PenField& f) { return f.role == role; });
}

bool PenLayout::fits(std::span<const std::uint8_t> report) const {
    if (report.empty() || report.size() < bytes) return false;
    if (report_id != 0 && report[0] != report_id) return false;
    return match_mask == 0 || (match_byte < report.size() && (report[match_byte] & match_mask) == match_value);
}

bool PenLayout::decode(std::span<const std::uint8_t> report, PenReport& out) const {
    if (!fits(report)) return false;
    PenReport r;
    Flags flags;
    for (const PenField& f : fields) read_field(report, f, r, flags);
    make_sense(*this, flags, r);
    if (pressure_needs_tip && !r.tip && r.pressure && axes.pressure) r.pressure = axes.pressure->min;
    out = r;
    return true;
}

std::vector<PenLayout> find_pens(const ReportDescriptor& descriptor) {
    return LayoutFinder(descriptor).run();
}

}  // namespace input
