#include "input/sources/pointer_source.hpp"

#include <algorithm>
#include <utility>

namespace input {

PointerSource::PointerSource(PointerSourceOptions options) : options_(options), palm_(options.palm) {}

void PointerSource::pen(const PenSample& sample) {
    for (const std::int64_t finger : palm_.see(sample)) {
        if (drawing_finger_ != finger) continue;
        push_gone(touch_.number, sample.time_ns);
        drawing_finger_.reset();
        cancelled_ = true;
    }
}

void PointerSource::pen_detached(std::uint32_t device, std::int64_t now_ns) {
    palm_.forget(device, now_ns);
}

void PointerSource::mouse(double x, double y, bool pressed, std::int64_t time_ns) {
    attach(mouse_, "mouse", time_ns);
    push(mouse_.number, x, y, pressed, PenTool::Pen, std::nullopt, time_ns);
}

void PointerSource::mouse_left(std::int64_t time_ns) {
    if (mouse_.number != 0) push_gone(mouse_.number, time_ns);
}

void PointerSource::touch_down(std::int64_t finger, double x, double y, std::optional<double> pressure,
                               std::int64_t time_ns) {
    if (!palm_.touch_began(finger, time_ns) || drawing_finger_) return;
    attach(touch_, "touch", time_ns);
    drawing_finger_ = finger;
    push(touch_.number, x, y, true, PenTool::Touch, pressure, time_ns);
}

void PointerSource::touch_move(std::int64_t finger, double x, double y, std::optional<double> pressure,
                               std::int64_t time_ns) {
    if (drawing_finger_ == finger) push(touch_.number, x, y, true, PenTool::Touch, pressure, time_ns);
}

void PointerSource::touch_up(std::int64_t finger, std::int64_t time_ns) {
    palm_.touch_ended(finger);
    if (drawing_finger_ != finger) return;
    drawing_finger_.reset();
    push_gone(touch_.number, time_ns);
}

bool PointerSource::take_cancelled() {
    return std::exchange(cancelled_, false);
}

void PointerSource::drain(std::vector<SourceEvent>& out) {
    out.insert(out.end(), events_.begin(), events_.end());
    events_.clear();
}

TraceDevice PointerSource::device(std::uint32_t number) const {
    if (number == mouse_.number) return mouse_;
    if (number == touch_.number) return touch_;
    return {};
}

void PointerSource::push(std::uint32_t device, double x, double y, bool tip, PenTool tool,
                         std::optional<double> pressure, std::int64_t time_ns) {
    SourceEvent e;
    e.device = device;
    e.time_ns = time_ns;
    e.sample.device = device;
    e.sample.time_ns = time_ns;
    e.sample.x = std::clamp(x, 0.0, 1.0);
    e.sample.y = std::clamp(y, 0.0, 1.0);
    if (options_.width_mm > 0.0 && options_.height_mm > 0.0) {
        e.sample.x_mm = *e.sample.x * options_.width_mm;
        e.sample.y_mm = *e.sample.y * options_.height_mm;
    }
    e.sample.pressure = pressure;
    e.sample.tool = tool;
    e.sample.in_range = true;
    e.sample.tip = tip;
    e.sample_valid = true;
    events_.push_back(e);
}

void PointerSource::push_gone(std::uint32_t device, std::int64_t time_ns) {
    SourceEvent e;
    e.device = device;
    e.time_ns = time_ns;
    e.sample.device = device;
    e.sample.time_ns = time_ns;
    e.sample_valid = true;
    events_.push_back(e);
}

void PointerSource::attach(TraceDevice& device, const char* name, std::int64_t time_ns) {
    if (device.number != 0) return;
    device.number = options_.numbers->next();
    device.identity.name = name;
    device.source = device.parser = "pointer";
    SourceEvent e;
    e.kind = SourceEventKind::Attached;
    e.device = device.number;
    e.time_ns = time_ns;
    events_.push_back(e);
}

}  // namespace input
