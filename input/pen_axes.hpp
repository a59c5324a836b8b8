#pragma once
// What a device can report, and the way from its own numbers to a PenSample.

#include <array>
#include <cstdint>
#include <optional>

#include "input/pen_sample.hpp"

namespace input {

/// The numbers an axis can take. `per_unit` is how many of them make a millimetre (x, y) or a radian (tilt, rotation);
/// 0 where the device does not say. min < max.
struct AxisRange {
    std::int32_t min = 0;
    std::int32_t max = 0;
    double per_unit = 0.0;

    [[nodiscard]] double span() const { return static_cast<double>(max) - static_cast<double>(min); }
    friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

struct PenAxes {
    std::optional<AxisRange> x, y, pressure, tilt_x, tilt_y, rotation, distance, wheel;

    /// Size of the active area; nothing where the device gives no resolution.
    [[nodiscard]] std::optional<double> width_mm() const { return length_mm(x); }
    [[nodiscard]] std::optional<double> height_mm() const { return length_mm(y); }
    friend bool operator==(const PenAxes&, const PenAxes&) = default;

  private:
    [[nodiscard]] static std::optional<double> length_mm(const std::optional<AxisRange>& a) {
        if (!a || a->per_unit <= 0.0) return std::nullopt;
        return a->span() / a->per_unit;
    }
};

/// The axes by the names that files give them.
struct NamedAxis {
    const char* name;
    std::optional<AxisRange> PenAxes::*range;
};
inline constexpr std::array<NamedAxis, 8> kNamedAxes{{{"x", &PenAxes::x},
                                                      {"y", &PenAxes::y},
                                                      {"pressure", &PenAxes::pressure},
                                                      {"tilt_x", &PenAxes::tilt_x},
                                                      {"tilt_y", &PenAxes::tilt_y},
                                                      {"rotation", &PenAxes::rotation},
                                                      {"distance", &PenAxes::distance},
                                                      {"wheel", &PenAxes::wheel}}};

/// A pen's state in the device's own numbers.
struct PenReport {
    std::optional<std::int32_t> x, y, pressure, tilt_x, tilt_y, rotation, distance, wheel;
    PenTool tool = PenTool::Pen;
    std::uint64_t serial = 0;
    std::uint32_t tool_id = 0;
    bool in_range = false;
    bool tip = false;
    std::uint32_t buttons = 0;
    friend bool operator==(const PenReport&, const PenReport&) = default;
};

/// The report in units. A value outside its range is brought back into it; a value whose axis has no range is dropped.
/// Tilt and rotation without a resolution are taken as degrees when their range is at most 360 wide, else as spanning
/// ±60° (tilt) and a full turn (rotation). A pen that is out of range has no axes, buttons, serial and tool: devices
/// send anything there.
[[nodiscard]] PenSample to_sample(const PenReport& report, const PenAxes& axes, std::int64_t time_ns,
                                  std::uint32_t device);

}  // namespace input
