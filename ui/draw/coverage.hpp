#pragma once
// How much of each pixel a polygon covers: exact area, so edges come out smooth at any angle.

#include "core/geometry/point.hpp"
#include "core/silhouette/image.hpp"

namespace ui {

/// A grey picture that covers only the pixels it needs.
struct CoverageImage {
    int x = 0, y = 0;  ///< place of its top left pixel
    core::GrayImage coverage;
};

/// Coverage (0 … 255) of the ring inside the page [0, width) x [0, height); y down, either direction of travel. Rings
/// that cross themselves are filled by winding, clamped. Empty for fewer than three points or a ring off the page.
/// Linear in pixels of the ring's box and in ring edges times the rows they cross.
[[nodiscard]] CoverageImage fill_polygon(const core::Polygon& ring_px, int width, int height);

}  // namespace ui
