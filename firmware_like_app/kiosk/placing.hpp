#pragma once
// Where a drawing lies when it is laid into a rectangle.

#include "core/stroke/stroke.hpp"
#include "ui/draw/ink_curve.hpp"

namespace app {

/// Box of all samples, y down; all 0 for an empty drawing.
struct Extent {
    double left = 0, right = 0, top = 0, bottom = 0;
    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return bottom - top; }
};
[[nodiscard]] Extent extent_of(const core::Drawing& drawing);

/// Largest placement of the drawing in that many pixels that keeps a margin, a share of the smaller side; centred.
[[nodiscard]] ui::InkFrame fit_drawing(const core::Drawing& drawing, double width, double height, double margin);

}  // namespace app
