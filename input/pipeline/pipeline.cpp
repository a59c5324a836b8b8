#include "input/pipeline/pipeline.hpp"

#include <algorithm>

namespace input {

PenPipeline::Steps PenPipeline::make_steps(const PenAxes& axes, bool reports_range) const {
    std::optional<TabletSize> size;
    if (axes.width_mm() && axes.height_mm()) size = TabletSize{*axes.width_mm(), *axes.height_mm()};
    Calibration calibration(options_.calibration, size);
    std::optional<double> width, height;
    if (size) {
        const std::array<double, 4>& area = calibration.area();
        const bool sideways = options_.calibration.turn == Turn::Right || options_.calibration.turn == Turn::Left;
        width = size->width_mm * (area[2] - area[0]);
        height = size->height_mm * (area[3] - area[1]);
        if (sideways) std::swap(width, height);
    }
    return {OrderGuard(),
            ProximityTimeout(options_.proximity, reports_range),
            TipThreshold(options_.tip),
            calibration,
            SmoothPlace(options_.smoothing, width, height),
            PenPredictor(options_.prediction, options_.smoothing.unsized_width_mm)};
}

void PenPipeline::attach(std::uint32_t device, const PenAxes& axes, bool reports_range) {
    devices_.insert_or_assign(device, make_steps(axes, reports_range));
}

std::optional<PenSample> PenPipeline::detach(std::uint32_t device, std::int64_t now_ns) {
    const auto found = devices_.find(device);
    if (found == devices_.end()) return std::nullopt;
    const bool near = found->second.near;
    duplicates_before_ += found->second.order.duplicates();
    out_of_order_before_ += found->second.order.out_of_order();
    devices_.erase(found);
    if (!near) return std::nullopt;
    PenSample gone;
    gone.time_ns = now_ns;
    gone.device = device;
    return gone;
}

std::optional<PenSample> PenPipeline::feed(const PenSample& sample) {
    auto found = devices_.find(sample.device);
    if (found == devices_.end()) found = devices_.emplace(sample.device, make_steps({}, false)).first;
    Steps& steps = found->second;
    steps.proximity.see(sample);  // a duplicate is a sign of life, too
    const std::optional<PenSample> passed = steps.order.pass(sample);
    if (!passed) return std::nullopt;
    return after_order(steps, *passed);
}

PenSample PenPipeline::after_order(Steps& steps, const PenSample& sample) const {
    PenSample s = steps.calibration.apply(steps.tip.apply(sample));
    s = apply_pressure(steps.smooth.apply(s), options_.pressure);
    steps.near = s.in_range;
    steps.predictor.see(s);
    return s;
}

std::vector<PenSample> PenPipeline::expire(std::int64_t now_ns) {
    std::vector<PenSample> gone;
    for (auto& [device, steps] : devices_) {
        const std::optional<PenSample> silent = steps.proximity.expire(now_ns);
        if (!silent) continue;
        if (const auto passed = steps.order.pass(*silent)) gone.push_back(after_order(steps, *passed));
    }
    return gone;
}

std::optional<std::int64_t> PenPipeline::due_ns() const {
    std::optional<std::int64_t> due;
    for (const auto& [device, steps] : devices_) {
        const std::optional<std::int64_t> d = steps.proximity.due_ns();
        if (d && (!due || *d < *due)) due = d;
    }
    return due;
}

std::optional<PenSample> PenPipeline::predict(std::uint32_t device) const {
    const auto found = devices_.find(device);
    return found == devices_.end() ? std::nullopt : found->second.predictor.predict();
}

std::uint64_t PenPipeline::duplicates() const {
    std::uint64_t sum = duplicates_before_;
    for (const auto& [device, steps] : devices_) sum += steps.order.duplicates();
    return sum;
}

std::uint64_t PenPipeline::out_of_order() const {
    std::uint64_t sum = out_of_order_before_;
    for (const auto& [device, steps] : devices_) sum += steps.order.out_of_order();
    return sum;
}

}  // namespace input
