#pragma once
// The report descriptor of a HID device: the table by which it says what its reports hold.
//
//     const auto descriptor = input::parse_report_descriptor(bytes);
//     if (!descriptor) …                     // one of the malformations below, with its place
//     for (const input::HidField& f : descriptor->fields) …
//
// After "Device Class Definition for Human Interface Devices 1.11", section 6.2.2. Where that leaves a choice we do
// what Linux does: a maximum is signed only when its minimum is negative, and a unit exponent below 16 is a nibble.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace input {

/// Usage page in the upper 16 bits, usage in the lower.
using Usage = std::uint32_t;

enum class HidKind : std::uint8_t { Input, Output, Feature };

struct HidCollection {
    std::uint8_t type = 0;  ///< 0 physical, 1 application, 2 logical, …
    Usage usage = 0;
    int parent = -1;  ///< index of the collection around it; -1 at the top
};

/// One value of a report; or `count` values of the same usage side by side; or a list (`array`) in which each of
/// `count` places names a usage that is on. Padding is not listed.
struct HidField {
    HidKind kind = HidKind::Input;
    std::uint8_t report_id = 0;    ///< 0 where the device has no report ids
    std::uint32_t bit_offset = 0;  ///< from the first bit after the report id
    std::uint8_t bit_size = 0;     ///< 1 … 32
    std::uint16_t count = 1;       ///< of places or values of this size, side by side
    Usage usage = 0;               ///< of a value; the first usage of an array
    Usage usage_max = 0;           ///< the last usage of an array, else usage
    int collection = -1;           ///< index of the innermost collection
    std::int32_t logical_min = 0, logical_max = 0;
    std::int32_t physical_min = 0, physical_max = 0;  ///< as given; both 0 means "as the logical ones"
    std::uint32_t unit = 0;
    std::int8_t unit_exponent = 0;
    bool array = false, relative = false, null_state = false;
};

struct HidReportSize {
    HidKind kind = HidKind::Input;
    std::uint8_t report_id = 0;
    std::uint32_t bits = 0;  ///< without the report id
};

struct ReportDescriptor {
    std::vector<HidCollection> collections;
    std::vector<HidField> fields;        ///< in the order of the descriptor
    std::vector<HidReportSize> reports;  ///< in the order in which they first appear
    bool has_report_ids = false;
    std::vector<std::string> notes;  ///< what is wrong with it but could be passed over, one phrase each

    /// The outermost collection around a field; -1 for a field outside of all.
    [[nodiscard]] int application_of(const HidField& field) const;
    /// Bytes of a report on the wire, with its id where there are ids; 0 for a report that is not described.
    [[nodiscard]] std::size_t report_bytes(HidKind kind, std::uint8_t report_id) const;
};

/// Bounds that keep a hostile descriptor small. Real ones stay far below.
inline constexpr std::size_t kMaxDescriptorBytes = 4096;
inline constexpr std::size_t kMaxHidFields = 4096;
inline constexpr std::uint32_t kMaxReportBits = 8 * 16384;

/// ErrorCode::BadFormat with one of: "empty descriptor", "descriptor longer than 4096 bytes", "truncated item", "end of
/// a collection that was never begun", "collections nested deeper than 32", "pop without push", "more than 16 pushes",
/// "report longer than 16384 bytes", "more than 4096 fields", "report id 0" or "report id above 255"; `where` says at
/// which byte. What is odd but harmless becomes a note: an unknown item, a collection left open, a maximum below its
/// minimum, a value of more than 32 bits (left out). Linear time; memory is bounded by the limits above.
[[nodiscard]] core::Result<ReportDescriptor> parse_report_descriptor(std::span<const std::uint8_t> bytes);

/// `bits` of a report, little-endian as HID has them; bits past its end are 0. 1 <= bits <= 32.
[[nodiscard]] std::uint32_t extract_bits(std::span<const std::uint8_t> data, std::uint32_t bit_offset, unsigned bits);

/// The same, with the sign that the field's logical minimum implies.
[[nodiscard]] std::int32_t field_value(std::span<const std::uint8_t> data, const HidField& field);

/// How many logical steps make one millimetre (for a length) or one radian (for an angle); 0 where the field's unit is
/// neither, or its ranges are empty.
[[nodiscard]] double steps_per_unit(const HidField& field);

/// "Digitizers/Pen" and the like; the numbers where the name is not known.
[[nodiscard]] std::string usage_name(Usage usage);

}  // namespace input
