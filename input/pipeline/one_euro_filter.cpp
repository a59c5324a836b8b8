#include "input/pipeline/one_euro_filter.hpp"

#include <cmath>
#include <numbers>

namespace input {
namespace {

/// Share of the new value that a low-pass of this cutoff takes after this time.
double share(double cutoff_hz, double seconds) {
    const double r = 2.0 * std::numbers::pi * cutoff_hz * seconds;
    return r / (r + 1.0);
}

}  // namespace

double OneEuroFilter::apply(double value, std::int64_t time_ns) {
    if (!time_ns_ || time_ns <= *time_ns_) {
        if (!time_ns_) speed_ = 0.0;
        time_ns_ = time_ns;
        raw_ = value_ = value;
        return value;
    }
    const double seconds = static_cast<double>(time_ns - *time_ns_) * 1e-9;
    time_ns_ = time_ns;
    speed_ += share(speed_cutoff_hz_, seconds) * ((value - raw_) / seconds - speed_);
    raw_ = value;
    value_ += share(least_cutoff_hz_ + cutoff_per_unit_s_ * std::abs(speed_), seconds) * (value - value_);
    return value_;
}

SmoothPlace::SmoothPlace(const SmoothingOptions& options, std::optional<double> width_mm,
                         std::optional<double> height_mm)
    : on_(options.on),
      width_mm_(width_mm.value_or(options.unsized_width_mm)),
      height_mm_(height_mm.value_or(options.unsized_width_mm)),
      x_(options.least_cutoff_hz, options.cutoff_per_mm_s, options.speed_cutoff_hz),
      y_(options.least_cutoff_hz, options.cutoff_per_mm_s, options.speed_cutoff_hz) {}

PenSample SmoothPlace::apply(PenSample s) {
    if (!on_ || !s.x || !s.y) {
        was_near_ = was_tip_ = false;
        return s;
    }
    if (!was_near_ || (s.tip && !was_tip_)) {
        x_.reset();
        y_.reset();
    }
    was_near_ = true;
    was_tip_ = s.tip;
    const double x_mm = x_.apply(*s.x * width_mm_, s.time_ns), y_mm = y_.apply(*s.y * height_mm_, s.time_ns);
    s.x = x_mm / width_mm_;
    s.y = y_mm / height_mm_;
    if (s.x_mm) s.x_mm = x_mm;
    if (s.y_mm) s.y_mm = y_mm;
    return s;
}

}  // namespace input
