#pragma once
// What is drawn over the figure: the lines of the layer that is worked on, their handles, open ends and notes, as the
// screen shows them. Projected anew when the design, the camera or the cloth changed.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/garment/desk/garment_desk.hpp"
#include "firmware_like_app/kiosk/figure_views.hpp"
#include "ui/screens/garment_screen.hpp"

namespace app {

struct SheetDrawing {
    std::vector<ui::SheetLine> lines;
    std::vector<core::Point> handles_px, open_ends_px;
    /// One of several ends on the middle plane that wait for a line along it: a tap on one draws it.
    std::optional<core::Vec3> open_middle;
};

struct SheetWishes {
    bool shaping = false;       ///< a tool that changes lines is in hand: all lines strong, with handles
    std::string selected_line;  ///< by name; empty: none
};

/// Hems and seams of all cloth that is shown, then the lines of the layer that is worked on. Cost: some look-ups in
/// the depth map a point of a line.
[[nodiscard]] SheetDrawing draw_sheet(const core::GarmentDesk& desk, FigureViews& views, const SheetWishes& wishes);

/// Ends on the middle plane that wait for a line along it.
[[nodiscard]] std::vector<core::DeskNote> open_middles(const core::GarmentDesk& desk);

/// A line in space as the screen shows it: in stretches that are seen and stretches that are hidden.
void add_projected(std::vector<ui::SheetLine>& out, const core::SpaceLine& line, FigureViews& views,
                   ui::SheetLine::Kind kind, bool selected);

/// Corners of a plane as it is shown, `half_cm` to each side of its origin.
[[nodiscard]] std::vector<core::Point> projected_plane(const core::StrokePreview::Plane& plane,
                                                       const ui::FigureCamera& camera, double half_cm);

/// Regions whose cloth is not there yet: their outline on the screen and the layer.
struct WaitingRegion {
    std::string name;
    core::Polygon outline_px;
};
[[nodiscard]] std::vector<WaitingRegion> waiting_regions(const core::GarmentDesk& desk, const FigureViews& views);

}  // namespace app
