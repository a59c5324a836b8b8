#include "input/parse/report_descriptor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string_view>

namespace input {
namespace {

constexpr std::size_t kMaxDepth = 32;
constexpr std::size_t kMaxPushes = 16;
constexpr std::size_t kMaxNotes = 32;

/// A number that is signed or not, depending on what comes later.
struct Number {
    std::uint32_t as_unsigned = 0;
    std::int32_t as_signed = 0;
};

struct Globals {
    std::uint32_t usage_page = 0;
    Number logical_min, logical_max, physical_min, physical_max;
    std::uint32_t unit = 0;
    std::int8_t unit_exponent = 0;
    std::uint32_t report_size = 0;
    std::uint32_t report_count = 0;
    std::uint8_t report_id = 0;
};

/// Usages as they were written: a range, or one; the page is added when the main item comes.
struct UsageRange {
    Usage first = 0, last = 0;
    bool has_page = false;
};

struct Locals {
    std::vector<UsageRange> usages;
    std::optional<UsageRange> open_minimum;
};

enum MainTag : std::uint8_t { kInput = 8, kOutput = 9, kCollection = 10, kFeature = 11, kEndCollection = 12 };

std::int32_t maximum_of(const Number& minimum, const Number& maximum) {
    if (minimum.as_signed < 0) return maximum.as_signed;
    return static_cast<std::int32_t>(std::min<std::uint32_t>(maximum.as_unsigned, 0x7fffffffU));
}

class Parser {
  public:
    explicit Parser(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    core::Result<ReportDescriptor> run() {
        if (bytes_.empty()) return core::unexpected(core::ErrorCode::BadFormat, "empty descriptor");
        if (bytes_.size() > kMaxDescriptorBytes) {
            return core::unexpected(core::ErrorCode::BadFormat, "descriptor longer than 4096 bytes");
        }
        while (at_ < bytes_.size() && fault_.empty()) item();
        if (!fault_.empty()) {
            return core::unexpected(core::ErrorCode::BadFormat, fault_, "byte " + std::to_string(item_at_));
        }
        if (open_ >= 0) note("a collection is left open at the end");
        return std::move(out_);
    }

  private:
    void item() {
        item_at_ = at_;
        const std::uint8_t prefix = bytes_[at_++];
        if (prefix == 0xFE) return long_item();
        const std::size_t size = (prefix & 3U) == 3U ? 4U : prefix & 3U;
        if (bytes_.size() - at_ < size) return fail("truncated item");
        const Number data = number(bytes_.subspan(at_, size));
        at_ += size;
        const auto tag = static_cast<std::uint8_t>(prefix >> 4U);
        switch ((prefix >> 2U) & 3U) {
            case 0:
                return main_item(tag, data.as_unsigned);
            case 1:
                return global_item(tag, data);
            case 2:
                return local_item(tag, data.as_unsigned, size);
            default:
                return note("an item of a reserved type");
        }
    }

    void long_item() {
        if (bytes_.size() - at_ < 2) return fail("truncated item");
        const std::size_t size = bytes_[at_];
        at_ += 2;
        if (bytes_.size() - at_ < size) return fail("truncated item");
        at_ += size;
        note("a long item");
    }

    static Number number(std::span<const std::uint8_t> data) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < data.size(); ++i) value |= static_cast<std::uint32_t>(data[i]) << (8 * i);
        const auto widened = static_cast<std::int32_t>(value);
        switch (data.size()) {
            case 1:
                return {value, static_cast<std::int8_t>(value)};
            case 2:
                return {value, static_cast<std::int16_t>(value)};
            default:
                return {value, widened};
        }
    }

    void main_item(std::uint8_t tag, std::uint32_t data) {
        switch (tag) {
            case kCollection:
                begin_collection(static_cast<std::uint8_t>(data));
                break;
            case kEndCollection:
                if (open_ < 0) return fail("end of a collection that was never begun");
                open_ = out_.collections[static_cast<std::size_t>(open_)].parent;
                --depth_;
                break;
            case kInput:
                add_field(HidKind::Input, data);
                break;
            case kOutput:
                add_field(HidKind::Output, data);
                break;
            case kFeature:
                add_field(HidKind::Feature, data);
                break;
            default:
                note("an unknown main item");
        }
        locals_ = {};
    }

    void begin_collection(std::uint8_t type) {
        if (++depth_ > kMaxDepth) return fail("collections nested deeper than 32");
        if (out_.collections.size() >= kMaxHidFields) return fail("more than 4096 fields");
        Usage usage = 0;
        if (!locals_.usages.empty()) usage = with_page(locals_.usages.front()).first;
        out_.collections.push_back({type, usage, open_});
        open_ = static_cast<int>(out_.collections.size()) - 1;
    }

    void global_item(std::uint8_t tag, const Number& data) {
        switch (tag) {
            case 0:
                globals_.usage_page = data.as_unsigned & 0xffffU;
                return;
            case 1:
                globals_.logical_min = data;
                return;
            case 2:
                globals_.logical_max = data;
                return;
            case 3:
                globals_.physical_min = data;
                return;
            case 4:
                globals_.physical_max = data;
                return;
            case 5:
                return set_exponent(data);
            case 6:
                globals_.unit = data.as_unsigned;
                return;
            case 7:
                globals_.report_size = data.as_unsigned;
                return;
            case 8:
                if (data.as_unsigned == 0) return fail("report id 0");
                if (data.as_unsigned > 255) return fail("report id above 255");
                globals_.report_id = static_cast<std::uint8_t>(data.as_unsigned);
                out_.has_report_ids = true;
                return;
            case 9:
                globals_.report_count = data.as_unsigned;
                return;
            case 10:
                if (stack_.size() >= kMaxPushes) return fail("more than 16 pushes");
                stack_.push_back(globals_);
                return;
            case 11:
                if (stack_.empty()) return fail("pop without push");
                globals_ = stack_.back();
                stack_.pop_back();
                return;
            default:
                note("an unknown global item");
        }
    }

    void set_exponent(const Number& data) {
        const std::uint32_t raw = data.as_unsigned;
        const std::int32_t value =
            raw < 16 ? (raw < 8 ? static_cast<std::int32_t>(raw) : static_cast<std::int32_t>(raw) - 16)
                     : data.as_signed;
        globals_.unit_exponent = static_cast<std::int8_t>(std::clamp(value, -32, 32));
    }

    void local_item(std::uint8_t tag, std::uint32_t data, std::size_t size) {
        const bool has_page = size == 4;
        switch (tag) {
            case 0:
                add_usage({data, data, has_page});
                return;
            case 1:
                locals_.open_minimum = UsageRange{data, data, has_page};
                return;
            case 2:
                if (!locals_.open_minimum) return note("a usage maximum without a minimum");
                close_range(data, has_page);
                return;
            default:
                return;  // designators, strings and delimiters say nothing about the bits
        }
    }

    void close_range(std::uint32_t last, bool has_page) {
        UsageRange range = *locals_.open_minimum;
        locals_.open_minimum.reset();
        if (range.has_page && !has_page) last |= range.first & 0xffff0000U;
        range.last = last;
        if (range.last < range.first || range.last - range.first > 0xffffU) return note("a usage range of no sense");
        add_usage(range);
    }

    void add_usage(const UsageRange& range) {
        if (locals_.usages.size() < kMaxHidFields) locals_.usages.push_back(range);
    }

    [[nodiscard]] UsageRange with_page(UsageRange range) const {
        if (!range.has_page) {
            range.first |= globals_.usage_page << 16U;
            range.last |= globals_.usage_page << 16U;
        }
        return range;
    }

    HidReportSize& report_of(HidKind kind) {
        for (HidReportSize& r : out_.reports) {
            if (r.kind == kind && r.report_id == globals_.report_id) return r;
        }
        return out_.reports.emplace_back(HidReportSize{kind, globals_.report_id, 0});
    }

    void add_field(HidKind kind, std::uint32_t flags) {
        HidReportSize& report = report_of(kind);
        const std::uint64_t bits =
            static_cast<std::uint64_t>(globals_.report_size) * static_cast<std::uint64_t>(globals_.report_count);
        if (bits > kMaxReportBits || report.bits + bits > kMaxReportBits) return fail("report longer than 16384 bytes");
        const std::uint32_t offset = report.bits;
        report.bits += static_cast<std::uint32_t>(bits);
        const bool constant = (flags & 1U) != 0, variable = (flags & 2U) != 0;
        if (bits == 0 || constant || locals_.usages.empty()) return;
        if (globals_.report_size > 32) return note("a value of more than 32 bits");

        HidField field = prototype(kind, flags);
        field.bit_offset = offset;
        if (variable) return add_values(field);
        field.array = true;
        field.count = static_cast<std::uint16_t>(globals_.report_count);
        field.usage = with_page(locals_.usages.front()).first;
        field.usage_max = with_page(locals_.usages.back()).last;
        push(field);
    }

    /// What all values of the main item share.
    HidField prototype(HidKind kind, std::uint32_t flags) {
        HidField f;
        f.kind = kind;
        f.report_id = globals_.report_id;
        f.bit_size = static_cast<std::uint8_t>(globals_.report_size);
        f.collection = open_;
        f.logical_min = globals_.logical_min.as_signed;
        f.logical_max = maximum_of(globals_.logical_min, globals_.logical_max);
        f.physical_min = globals_.physical_min.as_signed;
        f.physical_max = maximum_of(globals_.physical_min, globals_.physical_max);
        f.unit = globals_.unit;
        f.unit_exponent = globals_.unit_exponent;
        f.relative = (flags & 4U) != 0;
        f.null_state = (flags & 64U) != 0;
        if (f.logical_max < f.logical_min) {
            note("a logical maximum below its minimum");
            std::swap(f.logical_min, f.logical_max);
        }
        return f;
    }

    /// One field for each value. Where there are fewer usages than values the last usage goes on: those are one field.
    void add_values(HidField field) {
        std::size_t range = 0;
        std::uint32_t in_range = 0;
        for (std::uint32_t i = 0; i < globals_.report_count && fault_.empty(); i += field.count) {
            const UsageRange usages = with_page(locals_.usages[range]);
            field.usage = field.usage_max = usages.first + in_range;
            const bool more_in_range = field.usage < usages.last;
            const bool more_ranges = range + 1 < locals_.usages.size();
            field.count = static_cast<std::uint16_t>(more_in_range || more_ranges ? 1 : globals_.report_count - i);
            push(field);
            field.bit_offset += field.bit_size;
            in_range = more_in_range ? in_range + 1 : 0;
            if (!more_in_range && more_ranges) ++range;
        }
    }

    void push(const HidField& field) {
        if (out_.fields.size() >= kMaxHidFields) return fail("more than 4096 fields");
        out_.fields.push_back(field);
    }

    void fail(const char* why) {
        if (fault_.empty()) fault_ = why;
    }
    void note(const char* what) {
        if (out_.notes.size() < kMaxNotes) out_.notes.push_back("byte " + std::to_string(item_at_) + ": " + what);
    }

    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0, item_at_ = 0;
    ReportDescriptor out_;
    Globals globals_;
    std::vector<Globals> stack_;
    Locals locals_;
    int open_ = -1;
    std::size_t depth_ = 0;
    std::string fault_;
};

/// The exponent of one base unit in a HID unit: nibbles are signed.
int unit_power(std::uint32_t unit, unsigned nibble) {
    const auto raw = static_cast<int>((unit >> (4 * nibble)) & 15U);
    return raw < 8 ? raw : raw - 16;
}

/// Millimetres or radians in one of the field's units; 0 for anything else.
double base_unit(std::uint32_t unit) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    if (unit_power(unit, 1) != 1) return 0.0;
    switch (unit & 15U) {
        case 1:
            return 10.0;  // centimetres
        case 2:
            return 1.0;  // radians
        case 3:
            return 25.4;  // inches
        case 4:
            return kDegree;
        default:
            return 0.0;
    }
}

struct UsageName {
    Usage usage;
    std::string_view name;
};

constexpr std::array<UsageName, 46> kUsageNames{{{0x000D0001, "Digitizer"},
                                                 {0x000D0002, "Pen"},
                                                 {0x000D0003, "Light Pen"},
                                                 {0x000D0004, "Touch Screen"},
                                                 {0x000D0005, "Touch Pad"},
                                                 {0x000D0006, "White Board"},
                                                 {0x000D0020, "Stylus"},
                                                 {0x000D0021, "Puck"},
                                                 {0x000D0022, "Finger"},
                                                 {0x000D0030, "Tip Pressure"},
                                                 {0x000D0031, "Barrel Pressure"},
                                                 {0x000D0032, "In Range"},
                                                 {0x000D0036, "Sense"},
                                                 {0x000D003B, "Battery Strength"},
                                                 {0x000D003C, "Invert"},
                                                 {0x000D003D, "X Tilt"},
                                                 {0x000D003E, "Y Tilt"},
                                                 {0x000D003F, "Azimuth"},
                                                 {0x000D0040, "Altitude"},
                                                 {0x000D0041, "Twist"},
                                                 {0x000D0042, "Tip Switch"},
                                                 {0x000D0043, "Secondary Tip Switch"},
                                                 {0x000D0044, "Barrel Switch"},
                                                 {0x000D0045, "Eraser"},
                                                 {0x000D0046, "Tablet Pick"},
                                                 {0x000D0051, "Contact Identifier"},
                                                 {0x000D0054, "Contact Count"},
                                                 {0x000D0056, "Scan Time"},
                                                 {0x000D005A, "Secondary Barrel Switch"},
                                                 {0x000D005B, "Transducer Serial Number"},
                                                 {0x000D005C, "Transducer Serial Number, second part"},
                                                 {0x000D0077, "Tool Type"},
                                                 {0x00010001, "Pointer"},
                                                 {0x00010002, "Mouse"},
                                                 {0x00010006, "Keyboard"},
                                                 {0x00010007, "Keypad"},
                                                 {0x00010030, "X"},
                                                 {0x00010031, "Y"},
                                                 {0x00010032, "Z"},
                                                 {0x00010033, "Rx"},
                                                 {0x00010034, "Ry"},
                                                 {0x00010037, "Dial"},
                                                 {0x00010038, "Wheel"},
                                                 {0x00010080, "System Control"},
                                                 {0x000C0001, "Consumer Control"},
                                                 {0x000C0238, "AC Pan"}}};

}  // namespace

int ReportDescriptor::application_of(const HidField& field) const {
    int at = field.collection;
    while (at >= 0 && collections[static_cast<std::size_t>(at)].parent >= 0) {
        at = collections[static_cast<std::size_t>(at)].parent;
    }
    return at;
}

std::size_t ReportDescriptor::report_bytes(HidKind kind, std::uint8_t report_id) const {
    for (const HidReportSize& r : reports) {
        if (r.kind == kind && r.report_id == report_id) return (r.bits + 7) / 8 + (has_report_ids ? 1 : 0);
    }
    return 0;
}

core::Result<ReportDescriptor> parse_report_descriptor(std::span<const std::uint8_t> bytes) {
    return Parser(bytes).run();
}

std::uint32_t extract_bits(std::span<const std::uint8_t> data, std::uint32_t bit_offset, unsigned bits) {
    std::uint64_t value = 0;
    const std::size_t first = bit_offset / 8;
    for (std::size_t i = 0; i < 5 && first + i < data.size(); ++i) {
        value |= static_cast<std::uint64_t>(data[first + i]) << (8 * i);
    }
    value >>= bit_offset % 8;
    return static_cast<std::uint32_t>(value & ((std::uint64_t{1} << bits) - 1));
}

std::int32_t field_value(std::span<const std::uint8_t> data, const HidField& field) {
    const std::uint32_t raw = extract_bits(data, field.bit_offset, field.bit_size);
    if (field.logical_min >= 0 || field.bit_size >= 32) return static_cast<std::int32_t>(raw);
    const std::uint32_t sign = 1U << (field.bit_size - 1U);
    return static_cast<std::int32_t>((raw ^ sign) - sign);
}

double steps_per_unit(const HidField& field) {
    const double unit = base_unit(field.unit) * std::pow(10.0, field.unit_exponent);
    const bool given = field.physical_min != 0 || field.physical_max != 0;
    const double low = given ? field.physical_min : field.logical_min;
    const double high = given ? field.physical_max : field.logical_max;
    const double logical = static_cast<double>(field.logical_max) - field.logical_min;
    if (unit <= 0.0 || high <= low || logical <= 0.0) return 0.0;
    return logical / ((high - low) * unit);
}

std::string usage_name(Usage usage) {
    for (const UsageName& n : kUsageNames) {
        if (n.usage == usage) return std::string(n.name);
    }
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%04X:%04X", usage >> 16U, usage & 0xffffU);
    return text.data();
}

}  // namespace input
