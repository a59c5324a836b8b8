#pragma once
// Pictures of quad meshes, drawn without a GPU: shaded, with or without the edges of their quads.

#include <vector>

#include "core/mesh/quad_mesh.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "core/silhouette/image.hpp"

namespace support {

struct PictureMesh {
    const core::QuadMesh* mesh = nullptr;
    core::Rgb colour{};
    bool wire = true;
};

/// Parallel projection. yaw 0 looks along -z (from the front), 90 along -x (from +x); pitch > 0 looks down.
struct PictureView {
    double yaw_degrees = 0.0, pitch_degrees = 0.0;
    int width = 600, height = 800;
};

/// All meshes together fill the picture; both sides of a quad are lit. White ground.
[[nodiscard]] core::RgbaImage draw_meshes(const std::vector<PictureMesh>& meshes, const PictureView& view);

/// Pictures of one height next to each other.
[[nodiscard]] core::RgbaImage side_by_side(const std::vector<core::RgbaImage>& pictures);

}  // namespace support
