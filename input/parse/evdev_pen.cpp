#include "input/parse/evdev_pen.hpp"

#include <linux/input-event-codes.h>

namespace input {
namespace {

constexpr std::array<std::pair<std::uint16_t, PenTool>, 7> kTools{{{BTN_TOOL_RUBBER, PenTool::Eraser},
                                                                   {BTN_TOOL_BRUSH, PenTool::Brush},
                                                                   {BTN_TOOL_PENCIL, PenTool::Pencil},
                                                                   {BTN_TOOL_AIRBRUSH, PenTool::Airbrush},
                                                                   {BTN_TOOL_LENS, PenTool::Lens},
                                                                   {BTN_TOOL_MOUSE, PenTool::Mouse},
                                                                   {BTN_TOOL_PEN, PenTool::Pen}}};

bool is_pen_key(std::uint16_t code) {
    return code == BTN_TOUCH || code == BTN_STYLUS || code == BTN_STYLUS2 || code == BTN_STYLUS3 ||
           (code >= BTN_TOOL_PEN && code <= BTN_TOOL_LENS);
}

std::optional<AxisRange> range_of(const EvdevDescription& d, unsigned code) {
    const auto& axis = d.axes[code];
    if (!axis || axis->max <= axis->min) return std::nullopt;
    return AxisRange{axis->min, axis->max, static_cast<double>(axis->resolution)};
}

PenAxes axes_of(const EvdevDescription& d) {
    PenAxes a;
    a.x = range_of(d, ABS_X);
    a.y = range_of(d, ABS_Y);
    a.pressure = range_of(d, ABS_PRESSURE);
    a.distance = range_of(d, ABS_DISTANCE);
    a.tilt_x = range_of(d, ABS_TILT_X);
    a.tilt_y = range_of(d, ABS_TILT_Y);
    a.rotation = range_of(d, ABS_Z);
    a.wheel = range_of(d, ABS_WHEEL);
    return a;
}

}  // namespace

bool EvdevDescription::is_pen() const {
    constexpr std::int64_t kSmallestRange = 16;  // the keys of a frame report as a tablet of one step
    const bool place =
        axes[ABS_X] && axes[ABS_Y] && std::int64_t{axes[ABS_X]->max} - axes[ABS_X]->min >= kSmallestRange;
    const bool stylus = keys[BTN_TOOL_PEN] || keys[BTN_STYLUS] || keys[BTN_TOOL_RUBBER] || keys[BTN_TOOL_LENS];
    return place && stylus && !axes[ABS_MT_SLOT];
}

std::vector<std::uint16_t> EvdevDescription::pen_keys() const {
    std::vector<std::uint16_t> out;
    for (std::size_t key = 0; key < keys.size(); ++key) {
        const auto code = static_cast<std::uint16_t>(key);
        if (keys[key] && is_pen_key(code)) out.push_back(code);
    }
    return out;
}

EvdevPen::EvdevPen(const EvdevDescription& description, const std::bitset<768>& pressed) {
    resync(description, pressed);
}

void EvdevPen::resync(const EvdevDescription& d, const std::bitset<768>& pressed) {
    axes_ = axes_of(d);
    has_touch_ = d.keys[BTN_TOUCH];
    has_tools_ = false;
    for (const auto& [code, tool] : kTools) has_tools_ = has_tools_ || d.keys[code];
    pressed_ = pressed;
    report_ = {};
    for (std::size_t code = 0; code < d.axes.size(); ++code) {
        if (d.axes[code]) set_axis(static_cast<std::uint16_t>(code), d.axes[code]->value);
    }
    report_.tool_id = 0;
    finish_frame();
    touched_ = lost_ = skipping_ = false;
}

bool EvdevPen::feed(const EvdevEvent& e) {
    if (e.type == EV_SYN && e.code == SYN_DROPPED) {
        lost_ = skipping_ = true;
        return false;
    }
    if (e.type == EV_SYN && e.code == SYN_REPORT) {
        const bool whole = touched_ && !skipping_;
        if (whole) finish_frame();
        touched_ = skipping_ = false;
        return whole;
    }
    if (skipping_) return false;
    if (e.type == EV_ABS) set_axis(e.code, e.value);
    if (e.type == EV_KEY) set_key(e.code, e.value != 0);
    if (e.type == EV_MSC && e.code == MSC_SERIAL) {
        report_.serial = static_cast<std::uint32_t>(e.value);
        touched_ = true;
    }
    return false;
}

void EvdevPen::set_axis(std::uint16_t code, std::int32_t value) {
    switch (code) {
        case ABS_X:
            report_.x = value;
            break;
        case ABS_Y:
            report_.y = value;
            break;
        case ABS_PRESSURE:
            report_.pressure = value;
            break;
        case ABS_DISTANCE:
            report_.distance = value;
            break;
        case ABS_TILT_X:
            report_.tilt_x = value;
            break;
        case ABS_TILT_Y:
            report_.tilt_y = value;
            break;
        case ABS_Z:
            report_.rotation = value;
            break;
        case ABS_WHEEL:
            report_.wheel = value;
            break;
        case ABS_MISC:
            report_.tool_id = static_cast<std::uint32_t>(value);
            break;
        default:
            return;
    }
    touched_ = true;
}

void EvdevPen::set_key(std::uint16_t code, bool on) {
    if (code >= pressed_.size()) return;
    if (!is_pen_key(code)) return;
    pressed_[code] = on;
    touched_ = true;
}

void EvdevPen::finish_frame() {
    bool tool_near = false;
    for (const auto& [code, tool] : kTools) {
        if (!pressed_[code]) continue;
        report_.tool = tool;
        tool_near = true;
        break;
    }
    const bool pressing = report_.pressure && axes_.pressure && *report_.pressure > axes_.pressure->min;
    report_.tip = has_touch_ ? pressed_[BTN_TOUCH] : pressing;
    report_.in_range = has_tools_ ? tool_near : true;
    report_.buttons = (pressed_[BTN_STYLUS] ? kBarrel1 : 0) | (pressed_[BTN_STYLUS2] ? kBarrel2 : 0) |
                      (pressed_[BTN_STYLUS3] ? kBarrel3 : 0);
}

}  // namespace input
