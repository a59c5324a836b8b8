#pragma once
// What lies under the pen, through a view: the front-most vertex, line or piece. From the lines alone, so that it does
// not wait for cloth.

#include "core/garment/desk/desk_tool.hpp"

namespace core {

/// The vertex of the layer that is seen nearest to the pen, within `reach_cm` of it in the drawing; of those less than
/// a tenth of the reach apart the one in front.
[[nodiscard]] Pick pick_vertex(const Network& network, int layer, const DrawingView& view, Point at, double reach_cm);
/// The same for places on lines; `name` is that of the piece.
[[nodiscard]] Pick pick_line(const Network& network, int layer, const DrawingView& view, Point at, double reach_cm);

/// The region of the layer whose outline is seen around the pen; of several one that shows its outer side, then the one
/// in front. With `mirror` the image beyond x = 0 counts as the region itself.
[[nodiscard]] Pick pick_region(const Network& network, int layer, const DrawingView& view, Point at, bool mirror);

/// Of an outline in space, as pick_region judges it: whether it is seen around the pen, with its outer side to the
/// viewer, and how far in front it is there.
struct SeenOutline {
    bool around = false, outside = false;
    double depth = 0.0;
};
[[nodiscard]] SeenOutline see_outline(const SpaceLine& ring, const DrawingView& view, Point at);

/// A ring of lines as one closed line, its first point not repeated.
[[nodiscard]] SpaceLine ring_line(const Network& network, const std::vector<LineUse>& ring);

}  // namespace core
