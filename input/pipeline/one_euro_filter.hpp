#pragma once
// The 1 € filter on a pen's place. See SmoothingOptions for source and values.

#include <cstdint>
#include <optional>

#include "input/pen_sample.hpp"
#include "input/pipeline/options.hpp"

namespace input {

/// A low-pass whose cutoff grows with the speed. One number, one filter.
class OneEuroFilter {
  public:
    OneEuroFilter(double least_cutoff_hz, double cutoff_per_unit_s, double speed_cutoff_hz)
        : least_cutoff_hz_(least_cutoff_hz), cutoff_per_unit_s_(cutoff_per_unit_s), speed_cutoff_hz_(speed_cutoff_hz) {}

    /// The first value, and one whose time does not grow, come out as they went in.
    [[nodiscard]] double apply(double value, std::int64_t time_ns);
    void reset() { time_ns_.reset(); }

  private:
    double least_cutoff_hz_, cutoff_per_unit_s_, speed_cutoff_hz_;
    std::optional<std::int64_t> time_ns_;
    double value_ = 0.0, raw_ = 0.0, speed_ = 0.0;
};

/// Both coordinates of a pen. A stroke begins unsmoothed: the filter starts anew when the pen comes into range and when
/// the tip touches, so that a stroke's first point is where the pen was.
class SmoothPlace {
  public:
    /// `width_mm` of the sheet, for tablets with a size; speeds are in mm/s either way.
    SmoothPlace(const SmoothingOptions& options, std::optional<double> width_mm, std::optional<double> height_mm);
    [[nodiscard]] PenSample apply(PenSample sample);

  private:
    bool on_;
    double width_mm_, height_mm_;
    OneEuroFilter x_, y_;
    bool was_near_ = false, was_tip_ = false;
};

}  // namespace input
