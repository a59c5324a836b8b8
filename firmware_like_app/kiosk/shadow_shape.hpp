#pragma once
// The outline of a found model laid over the drawing that found it, as a soft shadow.

#include <optional>

#include "core/geometry/point.hpp"
#include "core/silhouette/image.hpp"
#include "firmware_like_app/kiosk/placing.hpp"
#include "firmware_like_app/kiosk/searcher.hpp"

namespace app {

/// Where the image plane of the view that matched lies on the drawing: a turn, a scale, a shift, and before them a flip
/// where the mirror image matched.
struct ViewPlace {
    double scale = 1;     ///< units of the drawing a unit of the plane
    double turn_rad = 0;  ///< clockwise, as y runs down on a drawing
    core::Point origin;   ///< of the plane, on the drawing
    bool mirrored = false;
    [[nodiscard]] core::Point to_drawing(core::Point plane) const;
    [[nodiscard]] core::Point to_plane(core::Point drawing) const;
};

/// By the parts that both have: their areas give the scale, their middles the shift and, where they say so plainly, the
/// turn. Nothing where no part has a partner or one of them no area.
[[nodiscard]] std::optional<ViewPlace> place_of_view(const FoundModel& model);

struct ShadowShape {
    core::GrayImage coverage;                         ///< 0 … 255, at most 400 pixels a side
    double left = 0, top = 0, width = 0, height = 0;  ///< units of the drawing
};

/// Placed by the parts; where that puts it beside the drawing, or far larger or smaller than it is, as few small parts
/// can, it has the drawing's middle and size. `drawing`: the box of all ink. A few milliseconds: the mesh's triangles
/// and the pixels. Empty where there is nothing to place.
[[nodiscard]] ShadowShape shadow_shape(const FoundModel& model, const Extent& drawing);

}  // namespace app
