#pragma once
// UC-Logic tablets (and their relatives under the names of Huion, Gaomon, XP-Pen, Ugee, Yiynova) tell what their pen
// can do in a string descriptor. Reading it also wakes their pen mode. String 200 has the newer form with 24-bit
// ranges, string 100 the older one with 16 bits.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "input/pen_axes.hpp"

namespace input {

/// Ranges of x, y (with steps per millimetre) and pressure from string 200 or 100 as the device sends it, length and
/// type in front. Nothing when it is another string: the type is not 3, it is too short, or a range is empty.
[[nodiscard]] std::optional<PenAxes> axes_of_string_200(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::optional<PenAxes> axes_of_string_100(std::span<const std::uint8_t> bytes);

/// The ASCII characters of a string descriptor, others as '?'. Empty when it is none.
[[nodiscard]] std::string text_of_string(std::span<const std::uint8_t> bytes);

}  // namespace input
