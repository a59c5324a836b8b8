#pragma once
// The colours of a model's parts as a picture in the image plane of the camera that saw them, to be laid on the mesh.

#include <vector>

#include "core/geometry/point.hpp"
#include "core/silhouette/image.hpp"

namespace ui {

/// One part of a silhouette in the image plane, [-1, 1] both ways, y up.
struct PartRegion {
    int colour = -1;  ///< index into palette::parts(); -1: a part that stays clay
    core::Polygon ring;
};

/// Which part is seen where: size x size pixels, top row first, the part's colour, palette::kPartCount for a part that
/// stays clay, 255 where there is none. Of overlapping rings the later one; each reaches a little beyond its ring.
/// Time: size squared.
[[nodiscard]] core::GrayImage part_labels(const std::vector<PartRegion>& parts, int size);

/// size x size pixels, top row first: the part's colour premultiplied by its weight. Neighbouring colours blend over
/// `blend` (in plane units, 1.2 % of the model's height by the design); every part reaches a little beyond its ring,
/// so that no clay shows along the edge of the silhouette. Time: size squared times (parts + 9).
[[nodiscard]] core::RgbaImage bake_part_map(const std::vector<PartRegion>& parts, int size, double blend);

}  // namespace ui
