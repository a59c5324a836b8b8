#include "input/devices/uclogic_strings.hpp"

#include <numbers>

namespace input {
namespace {

constexpr std::uint8_t kStringType = 3;
constexpr double kMillimetresPerInch = 25.4;
constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr std::size_t kTiltAt = 17;  ///< the widest tilt in degrees; 0 where the pen has none

std::int32_t little_endian(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t count) {
    std::int32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value |= bytes[at + i] << (8 * i);
    return value;
}

bool is_string(std::span<const std::uint8_t> bytes, std::size_t least) {
    return bytes.size() >= least && bytes[0] >= least && bytes[1] == kStringType;
}

std::optional<PenAxes> axes(std::int32_t x, std::int32_t y, std::int32_t pressure, std::int32_t per_inch) {
    constexpr std::int32_t kMostPerInch = 20'000;
    if (x < 256 || y < 256 || pressure < 63 || per_inch < 100 || per_inch > kMostPerInch) return std::nullopt;
    PenAxes a;
    a.x = AxisRange{0, x, per_inch / kMillimetresPerInch};
    a.y = AxisRange{0, y, per_inch / kMillimetresPerInch};
    a.pressure = AxisRange{0, pressure, 0.0};
    return a;
}

}  // namespace

std::optional<PenAxes> axes_of_string_200(std::span<const std::uint8_t> bytes) {
    if (!is_string(bytes, 12)) return std::nullopt;
    std::optional<PenAxes> a = axes(little_endian(bytes, 2, 3), little_endian(bytes, 5, 3), little_endian(bytes, 8, 2),
                                    little_endian(bytes, 10, 2));
    if (!a || bytes.size() <= kTiltAt || bytes[kTiltAt] == 0 || bytes[kTiltAt] > 90) return a;
    const std::int32_t degrees = bytes[kTiltAt];
    a->tilt_x = a->tilt_y = AxisRange{-degrees, degrees, kDegreesPerRadian};
    return a;
}

std::optional<PenAxes> axes_of_string_100(std::span<const std::uint8_t> bytes) {
    if (!is_string(bytes, 12)) return std::nullopt;
    return axes(little_endian(bytes, 2, 2), little_endian(bytes, 4, 2), little_endian(bytes, 8, 2),
                little_endian(bytes, 10, 2));
}

std::string text_of_string(std::span<const std::uint8_t> bytes) {
    if (!is_string(bytes, 2)) return {};
    std::string text;
    for (std::size_t i = 2; i + 1 < bytes.size() && i + 1 < bytes[0]; i += 2) {
        const bool plain = bytes[i + 1] == 0 && bytes[i] >= 0x20 && bytes[i] < 0x7f;
        text += plain ? static_cast<char>(bytes[i]) : '?';
    }
    return text;
}

}  // namespace input
