#include "input/pipeline/cleaning.hpp"

#include <algorithm>
#include <cmath>

namespace input {

std::optional<PenSample> OrderGuard::pass(const PenSample& sample) {
    if (last_) {
        if (sample.time_ns < last_->time_ns) {
            ++out_of_order_;
            return std::nullopt;
        }
        PenSample same = sample;
        same.time_ns = last_->time_ns;
        if (same == *last_) {
            ++duplicates_;
            return std::nullopt;
        }
    }
    last_ = sample;
    return sample;
}

std::optional<PenSample> ProximityTimeout::expire(std::int64_t now_ns) {
    const std::optional<std::int64_t> due = due_ns();
    if (!due || now_ns < *due) return std::nullopt;
    PenSample gone;
    gone.time_ns = *due;
    gone.device = last_->device;
    last_ = gone;
    return gone;
}

std::optional<std::int64_t> ProximityTimeout::due_ns() const {
    if (!last_ || !last_->in_range) return std::nullopt;
    return last_->time_ns + limit_ns_;
}

PenSample TipThreshold::apply(PenSample sample) {
    if (!sample.tip || !sample.pressure) {
        down_ = sample.tip;
        return sample;
    }
    down_ = *sample.pressure >= (down_ ? options_.up : options_.down);
    sample.tip = down_;
    return sample;
}

PenSample apply_pressure(PenSample sample, const PressureOptions& options) {
    if (!sample.pressure) return sample;
    const double share = std::clamp((*sample.pressure - options.low) / (options.high - options.low), 0.0, 1.0);
    sample.pressure = options.power == 1.0 ? share : std::pow(share, options.power);
    return sample;
}

}  // namespace input
