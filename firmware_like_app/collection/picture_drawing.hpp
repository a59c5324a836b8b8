#pragma once
// A picture as a pen would draw it: once around what it shows. For replaying pictures where pens are replayed.

#include "core/base/result.hpp"
#include "core/silhouette/image.hpp"
#include "core/stroke/stroke.hpp"

namespace app {

/// One closed stroke along the outline of the silhouette that a query reads from the picture (find_silhouette), in the
/// picture's pixels, y down, at an even pace of four seconds and of at most 800 samples. What lies inside the outline,
/// holes and inner lines, is not drawn. Errors of find_silhouette and largest_contour.
[[nodiscard]] core::Result<core::Drawing> drawing_of_picture(const core::GrayImage& picture);

}  // namespace app
