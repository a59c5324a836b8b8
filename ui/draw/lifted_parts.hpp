#pragma once
// Part colours on a whole model, lifted from the view that matched: the surface that its camera sees takes the part it
// is seen in, and is clay between the parts; hidden surface takes that of the nearest surface along the mesh, and
// borders blend. For models that are turned; for the matched view alone bake_part_map does.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ui/draw/model_geometry.hpp"
#include "ui/draw/palette.hpp"
#include "ui/draw/part_map.hpp"

namespace ui {

/// Where a part's number points to on the model.
struct LiftedAnchor {
    int colour = 0;
    core::Vec3 place, normal;  ///< normalised frame; the normal is unit and points out
};

struct LiftedModel {
    ModelGeometry geometry;             ///< with the parts' colours mixed into clay as its own
    std::vector<LiftedAnchor> anchors;  ///< one a coloured part that is seen anywhere, in the order of colours

    // for recolour()
    std::vector<std::uint32_t> vertex_of;                                ///< of each corner
    std::vector<std::array<std::uint8_t, palette::kPartCount>> weights;  ///< of each vertex, 255: all this part
};

/// Cuts triangles until none is longer than a few hundredths of the model, so that borders are fine on coarse meshes,
/// at most about 15,000. Faces keep their smooth normals. Without coloured parts all is clay. 10 to 60 ms.
[[nodiscard]] LiftedModel lift_parts(const ModelGeometry& geometry, const core::Camera& camera,
                                     const std::vector<PartRegion>& parts);

/// Writes the colours of the geometry anew; with `only`, the other parts keep a quarter of theirs.
void recolour(LiftedModel& model, std::optional<int> only);

}  // namespace ui
