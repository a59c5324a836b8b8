#pragma once
// From samples to strokes: a stroke is what one pen draws between touching and lifting.

#include <cstdint>
#include <optional>
#include <vector>

#include "input/pen_sample.hpp"

namespace input {

struct PenStroke {
    std::uint32_t device = 0;
    PenTool tool = PenTool::Pen;
    std::vector<PenSample> samples;  ///< all with tip, never empty
    friend bool operator==(const PenStroke&, const PenStroke&) = default;
};

/// Strokes end when the tip lifts, the pen leaves, another end of it comes, or the device is gone. Several devices draw
/// at once without disturbing each other; strokes come out in the order in which they end.
class StrokeBuilder {
  public:
    /// What the sample did: the stroke that ended with it, if one did.
    std::optional<PenStroke> add(const PenSample& sample);
    /// The device is gone: its stroke ends as it is.
    std::optional<PenStroke> end(std::uint32_t device);
    /// Everything that is still being drawn ends, in the order of the devices' numbers.
    [[nodiscard]] std::vector<PenStroke> finish();

  private:
    std::vector<PenStroke> open_;
};

/// All strokes of a list of samples, erasing ends included.
[[nodiscard]] std::vector<PenStroke> strokes_of(const std::vector<PenSample>& samples);

/// The strokes that draw, as a drawing with times from the first sample: millimetres where the device has a size.
/// Strokes of erasers, lenses and mice are left out.
[[nodiscard]] core::Drawing drawing_of(const std::vector<PenStroke>& strokes);

}  // namespace input
