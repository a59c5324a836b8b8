#pragma once
// One state of one pen, whatever it came from: a HID report, an evdev frame, a trace, a mouse.
//
// A sample is a state, not a change: whoever wants "down" compares it with the one before
// (pipeline/stroke_builder.hpp).

#include <cstdint>
#include <optional>

#include "core/stroke/stroke.hpp"

namespace input {

enum class PenTool : std::uint8_t { Pen, Eraser, Brush, Pencil, Airbrush, Lens, Mouse, Touch };

/// Buttons on the barrel, from the tip upwards.
inline constexpr std::uint32_t kBarrel1 = 1, kBarrel2 = 2, kBarrel3 = 4;

/// An axis without a value is one that the device lacks, or that it did not know at this moment.
struct PenSample {
    std::int64_t time_ns = 0;  ///< monotonic; of the report, not of the moment it was looked at
    std::uint32_t device = 0;  ///< which tablet, a number that the source gives; never 0 for a real one

    std::optional<double> x{}, y{};        ///< 0 … 1 from the left and from the top of the active area
    std::optional<double> x_mm{}, y_mm{};  ///< the same from the left and top edge, where the size of the area is known
    std::optional<double> pressure{};      ///< 0 … 1 of what the device can report
    std::optional<double> tilt_x_rad{};    ///< from upright, positive when the pen leans to the right
    std::optional<double> tilt_y_rad{};    ///< from upright, positive when the pen leans towards the user
    std::optional<double> rotation_rad{};  ///< about the pen's own axis, clockwise, -π … π
    std::optional<double> distance{};      ///< 0 touches … 1 the farthest that the device can report
    std::optional<double> wheel{};         ///< 0 … 1, the slider of an airbrush

    PenTool tool = PenTool::Pen;
    std::uint64_t serial = 0;   ///< of the very pen; 0 where the device does not say
    std::uint32_t tool_id = 0;  ///< the vendor's number for this model of pen; 0 where the device does not say
    bool in_range = false;      ///< the device sees the pen
    bool tip = false;           ///< the device says that the tip touches; never without in_range
    std::uint32_t buttons = 0;  ///< kBarrel1 | …

    [[nodiscard]] bool hover() const { return in_range && !tip; }
    [[nodiscard]] bool eraser() const { return tool == PenTool::Eraser; }

    friend bool operator==(const PenSample&, const PenSample&) = default;
};

/// For the sheet: in millimetres where the device has a size, else in thousandths of the area. Time in microseconds
/// from `start_ns`. Only for samples with x and y.
[[nodiscard]] inline core::PenSample to_core(const PenSample& s, std::int64_t start_ns) {
    const bool sized = s.x_mm && s.y_mm;
    return {(s.time_ns - start_ns) / 1000, sized ? *s.x_mm : 1000.0 * s.x.value_or(0.0),
            sized ? *s.y_mm : 1000.0 * s.y.value_or(0.0), s.pressure.value_or(1.0)};
}

}  // namespace input
