#pragma once
// How the figure lies in a picture: a view of the garment engine with a scale. The same numbers lift the pen's strokes
// and draw the figure, so a line appears where the pen drew it.

#include "core/garment/drawing.hpp"
#include "ui/draw/palette.hpp"

namespace ui {

/// Views that are parallel keep lengths; those with an eye show what is in the plane through their centre at
/// `scale_px`.
struct FigureCamera {
    core::DrawingView view;
    double scale_px = 4;    ///< pixels a centimetre
    core::Point centre_px;  ///< where the view's centre appears, y down

    /// Where a place appears. A place level with the eye or behind it has no picture; it is put far outside.
    [[nodiscard]] core::Point to_px(core::Vec3 place) const;
    /// Centimetres to the right and up from the view's centre, as core::DrawingView::ray takes them.
    [[nodiscard]] core::Point to_drawing(core::Point px) const;
    /// Centimetres towards the viewer from the view's centre.
    [[nodiscard]] double nearness(core::Vec3 place) const { return core::dot(view.toward, place - view.centre); }
    friend bool operator==(const FigureCamera& a, const FigureCamera& b) {
        return a.view.centre == b.view.centre && a.view.right == b.view.right && a.view.up == b.view.up &&
               a.view.toward == b.view.toward && a.view.eye_distance == b.view.eye_distance &&
               a.scale_px == b.scale_px && a.centre_px == b.centre_px;
    }
};

/// The view with a figure of this height in the middle of a box: all of it is seen, with room beside for wide skirts.
[[nodiscard]] FigureCamera framed(const core::DrawingView& view, const Rect& box, double height_cm);

/// The view in perspective, turned about the body: azimuth 0 from the front, growing to the body's left; both radians.
[[nodiscard]] core::DrawingView solid_view(double azimuth_rad, double elevation_rad, double height_cm);

}  // namespace ui
