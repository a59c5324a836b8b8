#include "plausible_pen.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>

namespace support {
namespace {

constexpr double kRadian_deg = 180.0 / std::numbers::pi;

struct Span {
    double low = 1e9, high = -1e9;
    void add(double v) {
        low = std::min(low, v);
        high = std::max(high, v);
    }
    [[nodiscard]] double width() const { return std::max(0.0, high - low); }
};

}  // namespace

PenAction action_of(const std::string& path) {
    std::string name = std::filesystem::path(path).filename().string();
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto holds = [&](const char* part) { return name.find(part) != std::string::npos; };
    for (const char* other : {"frame", "mouse", "wheel", "ring", "dial", "swipe", "panel", "wb-", "bw-", "mode", "pad",
                              "finger", "touch.", "note", "lsusb", "init", "connect", "relative", "soft"}) {
        if (holds(other) && !holds("pen")) return PenAction::None;
    }
    if (holds("tilt")) return PenAction::Tilt;
    if (holds("pressure") || holds("tip")) return PenAction::Press;
    if (holds("coord") || holds("bounds") || holds("axis")) return PenAction::Sweep;
    if (holds("hover") || holds("stylus-move")) return PenAction::Hover;
    if (holds("button") || holds("stylus1") || holds("stylus2") || holds("btn")) return PenAction::Buttons;
    return PenAction::Other;
}

Plausibility look_at(const std::vector<input::PenSample>& samples) {
    Plausibility p;
    Span x, y, pressure, tilt_x, tilt_y;
    std::size_t near = 0, at_end = 0;
    bool was_near = false, was_tip = false;
    std::uint32_t buttons = 0;
    for (const input::PenSample& s : samples) {
        if (!s.in_range) {
            p.leaves += was_near ? 1 : 0;
            p.buttons_released += buttons != 0 ? 1 : 0;
            was_near = was_tip = false;
            buttons = 0;
            continue;
        }
        ++near;
        if (s.x) x.add(*s.x);
        if (s.y) y.add(*s.y);
        at_end += (s.x && (*s.x <= 0.0 || *s.x >= 1.0)) || (s.y && (*s.y <= 0.0 || *s.y >= 1.0)) ? 1 : 0;
        if (s.pressure) pressure.add(*s.pressure);
        if (s.tilt_x_rad) tilt_x.add(*s.tilt_x_rad * kRadian_deg);
        if (s.tilt_y_rad) tilt_y.add(*s.tilt_y_rad * kRadian_deg);
        p.tips += s.tip && !was_tip ? 1 : 0;
        p.buttons_pressed += (s.buttons & ~buttons) != 0 ? 1 : 0;
        p.buttons_released += (buttons & ~s.buttons) != 0 ? 1 : 0;
        was_near = true;
        was_tip = s.tip;
        buttons = s.buttons;
    }
    p.x_span = x.width();
    p.y_span = y.width();
    p.least_pressure = pressure.low > 1 ? 0 : pressure.low;
    p.most_pressure = std::max(0.0, pressure.high);
    p.tilt_span_deg = std::max(tilt_x.width(), tilt_y.width());
    p.share_outside = near == 0 ? 0 : static_cast<double>(at_end) / static_cast<double>(near);
    return p;
}

std::string what_is_missing(PenAction action, const Plausibility& seen, const input::PenAxes& axes) {
    switch (action) {
        case PenAction::Sweep:
            if (seen.x_span < 0.5 || seen.y_span < 0.5) return "the pen does not sweep the area";
            if (seen.share_outside > 0.7) return "coordinates lie at the ends of their ranges";
            return "";
        case PenAction::Hover:
            if (seen.x_span < 0.2 && seen.y_span < 0.2) return "the pen does not move";
            return seen.tips == 0 ? "" : "the tip touches";
        case PenAction::Press:
            if (!axes.pressure) return "no pressure in these reports";
            if (seen.most_pressure < 0.5 || seen.least_pressure > 0.1) return "pressure does not rise and fall";
            return seen.tips > 0 ? "" : "the tip never touches";
        case PenAction::Tilt:
            if (!axes.tilt_x) return "no tilt in these reports";
            return seen.tilt_span_deg >= 20 ? "" : "tilt does not change";
        case PenAction::Buttons:
            if (seen.buttons_pressed == 0) return "no button is pressed";
            return seen.buttons_released > 0 ? "" : "no button is released";
        case PenAction::Other:
            return seen.x_span > 0.005 || seen.y_span > 0.005 ? "" : "the pen does not move";
        case PenAction::None:
            break;
    }
    return "";
}

}  // namespace support
