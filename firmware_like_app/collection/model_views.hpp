#pragma once
// A model's two views: fifty cameras, silhouettes, descriptors, and the choice among them (thesis 7.1).

#include <stop_token>

#include "core/base/result.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "core/parts/describe.hpp"
#include "core/views/picture_render.hpp"
#include "db/stores/two_view_index.hpp"

namespace app {

struct ViewParameters {
    int silhouette_px = 256;               ///< side of the image in which a silhouette is drawn
    int longest = 10;                      ///< N of 7.1.2
    std::size_t display_triangles = 6000;  ///< at most, of the mesh kept for the screen
    core::PictureSize thumbnail;           ///< of the picture kept of each view
    core::ShapeParameters shape;
};

/// All parameters as text: a model described with another text is stale.
[[nodiscard]] std::string parameters_text(const ViewParameters& parameters);

/// Fills in views (thumbnails too) and display mesh of the record; the other fields are the caller's. BadMesh or
/// EmptyMesh when the model shows no silhouette from anywhere; Cancelled when a stop is requested, which is looked at
/// before each camera.
[[nodiscard]] core::Result<void> describe_model(core::TriangleMesh mesh, const ViewParameters& parameters,
                                                db::ModelRecord& record, const std::stop_token& stop = {});

}  // namespace app
