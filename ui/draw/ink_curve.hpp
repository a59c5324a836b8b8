#pragma once
// From pen samples to the tapered pieces that ink is drawn with: a smooth curve through every sample.

#include <cstddef>
#include <vector>

#include "core/stroke/stroke.hpp"

namespace ui {

/// A capsule from one end to the other, in pixels, y down.
struct InkPiece {
    float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    float r0 = 1, r1 = 1;
    friend bool operator==(const InkPiece&, const InkPiece&) = default;
};

/// How the drawing lies on the picture: pixel = unit * scale + offset.
struct InkFrame {
    double scale = 1.0;
    double offset_x = 0.0;
    double offset_y = 0.0;
    [[nodiscard]] core::Point to_px(core::Point p) const { return {p.x * scale + offset_x, p.y * scale + offset_y}; }
    [[nodiscard]] core::Point from_px(core::Point p) const {
        return {(p.x - offset_x) / scale, (p.y - offset_y) / scale};
    }
    friend bool operator==(const InkFrame&, const InkFrame&) = default;
};

/// Half the width of the line at a pressure of 0 … 1; `width_px` is the width at full pressure.
[[nodiscard]] double ink_radius_px(double pressure, double width_px);

/// Appends the pieces of span `span`, which joins samples span and span + 1 (for a single sample, span 0 is a dot).
/// A centripetal Catmull-Rom curve (Yuksel, Schaefer, Keyser 2011) that looks one sample back and one ahead, with a
/// corner kept where the line turns by more than 70 degrees. Constant time.
void append_ink_span(const std::vector<core::PenSample>& samples, std::size_t span, const InkFrame& frame,
                     double width_px, std::vector<InkPiece>& out);

/// Spans of a stroke: one fewer than samples, one for a dot.
[[nodiscard]] std::size_t ink_span_count(const std::vector<core::PenSample>& samples);

}  // namespace ui
