#pragma once
// Where in a report a pen's values lie: the one form to which HID descriptors and the layouts of our device files come.
//
//     const std::vector<input::PenLayout> pens = input::find_pens(*descriptor);
//     input::PenReport report;
//     if (pens[0].decode(bytes, report)) …

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "input/parse/report_descriptor.hpp"
#include "input/pen_axes.hpp"

namespace input {

enum class PenRole : std::uint8_t {
    X,
    Y,
    Pressure,
    TiltX,
    TiltY,
    Rotation,
    Distance,
    Wheel,
    Tip,
    Barrel1,
    Barrel2,
    Barrel3,
    InRange,
    Invert,  ///< the eraser end is turned to the tablet
    Eraser,  ///< the eraser end touches
    SerialLow,
    SerialHigh,
    ToolId,
    ButtonCode,  ///< a number for what is pressed: 1 tip, 2 first button, 3 second button
};

/// A value made of one or two runs of bits, counted from the first bit of the report WITH its id byte.
struct PenField {
    PenRole role = PenRole::X;
    std::uint32_t bit_offset = 0;
    std::uint8_t bit_size = 1;      ///< 1 … 32, both runs together at most 32
    std::uint32_t high_offset = 0;  ///< where the upper bits lie when they lie elsewhere
    std::uint8_t high_size = 0;     ///< 0: one run
    bool is_signed = false;
    bool negated = false;             ///< of a flag: the bit says the opposite; of a number: it runs the other way
    std::optional<Usage> in_array{};  ///< the flag is on when one of `array_count` places holds this usage
    std::uint16_t array_count = 0;
    Usage array_first = 0;  ///< usage that the array's logical minimum stands for
    std::int32_t array_min = 0;
};

/// Which reports a layout reads: those with this id and at least this many bytes where (byte & mask) == value holds.
struct PenLayout {
    std::string name;            ///< "Digitizers/Pen, report 7"
    std::uint8_t report_id = 0;  ///< first byte of the report; 0 where there are no ids
    std::size_t bytes = 0;       ///< of the whole report; a shorter one is not decoded
    std::size_t match_byte = 0;
    std::uint8_t match_mask = 0;  ///< 0: every report
    std::uint8_t match_value = 0;
    bool eraser_is_button = false;    ///< the bit that is called Eraser is the second button of the barrel
    bool pressure_needs_tip = false;  ///< the pressure of a report without tip is noise and counts as none
    bool mouse_puck = false;          ///< what it reports is a cursor, not a pen
    PenAxes axes;
    std::vector<PenField> fields;

    [[nodiscard]] bool has(PenRole role) const;
    /// Whether the device says when the pen leaves; where it does not, silence must do (pipeline/proximity.hpp).
    [[nodiscard]] bool reports_range() const { return has(PenRole::InRange) || has(PenRole::Invert); }
    [[nodiscard]] bool fits(std::span<const std::uint8_t> report) const;

    /// False, with `out` untouched, for a report of another kind. In range is what the device says or implies by tip or
    /// eraser; a device without such a bit is in range with every report. Without a tip switch any pressure is a touch.
    [[nodiscard]] bool decode(std::span<const std::uint8_t> report, PenReport& out) const;
};

/// The pens of a descriptor: collections of pages 0x0D (digitizers) and 0xFF0D (the same with Wacom's numbering), and
/// mice that report absolute positions with pressure or range, as tablets do before their pen mode is switched on. One
/// layout for each input report; empty where there is no pen. Where a usage comes twice the first counts.
[[nodiscard]] std::vector<PenLayout> find_pens(const ReportDescriptor& descriptor);

}  // namespace input
