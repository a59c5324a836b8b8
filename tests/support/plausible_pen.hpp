#pragma once
// Whether decoded samples look like what a recording's name says was done: the pen swept over the tablet, pressed,
// tilted, had its buttons pressed.

#include <string>
#include <vector>

#include "input/formats/decode_capture.hpp"

namespace support {

/// What was done, after the name of the file.
enum class PenAction { None, Sweep, Hover, Press, Tilt, Buttons, Other };

/// None for recordings of keys, wheels and mice, Other where the name says nothing.
[[nodiscard]] PenAction action_of(const std::string& path);

struct Plausibility {
    double x_span = 0, y_span = 0;  ///< of 1
    double least_pressure = 0, most_pressure = 0;
    double tilt_span_deg = 0;  ///< the wider of both
    int tips = 0, buttons_pressed = 0, buttons_released = 0, leaves = 0;
    double share_outside = 0;  ///< of samples with a coordinate at an end of its range, a sign of a wrong range
};
[[nodiscard]] Plausibility look_at(const std::vector<input::PenSample>& samples);

/// Empty when the samples show the action, else what is missing.
[[nodiscard]] std::string what_is_missing(PenAction action, const Plausibility& seen, const input::PenAxes& axes);

}  // namespace support
