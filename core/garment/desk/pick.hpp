#pragma once
// What lies under the pen, through a view: the front-most vertex, line or piece.

#include <memory>
#include <vector>

#include "core/garment/desk/build_request.hpp"

namespace core {

/// The vertex of the layer under the pen, within `reach_cm` of it in the drawing; of several the nearest to the pen,
/// and of equally near ones (to a tenth of the reach) the one in front. Hidden behind the body counts as behind.
[[nodiscard]] Pick pick_vertex(const Network& network, int layer, const DrawingView& view, Point at, double reach_cm);
[[nodiscard]] Pick pick_line(const Network& network, int layer, const DrawingView& view, Point at, double reach_cm);

/// The piece of cloth that a ray through the pen meets first; layers of `hidden` are seen through. Mirror images count
/// as their originals.
[[nodiscard]] Pick pick_region(const Network& network, const std::vector<BuiltLayer>& layers,
                               const std::vector<bool>& hidden, const DrawingView& view, Point at);

}  // namespace core
