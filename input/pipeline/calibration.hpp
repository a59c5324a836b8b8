#pragma once
// From the tablet's active area to the sheet.

#include <array>
#include <optional>

#include "input/pen_sample.hpp"
#include "input/pipeline/options.hpp"

namespace input {

struct TabletSize {
    double width_mm = 0.0, height_mm = 0.0;
};

class Calibration {
  public:
    /// `size` of the whole active area; without it the aspect is not kept.
    explicit Calibration(const CalibrationOptions& options, std::optional<TabletSize> size = {});

    /// x and y of the sheet, 0 … 1, brought back to its edge outside the area; x_mm and y_mm from the sheet's corner;
    /// tilt and rotation turned with it. A sample without x and y stays as it is. Constant time, remembers nothing.
    [[nodiscard]] PenSample apply(PenSample sample) const;

    /// The part of the tablet that is used: left, top, right, bottom, after it was cut to the sheet's shape.
    [[nodiscard]] const std::array<double, 4>& area() const { return area_; }

  private:
    std::array<double, 4> area_;
    std::array<double, 6> align_;
    int turns_;
    std::optional<TabletSize> sheet_;  ///< before it is turned
};

}  // namespace input
