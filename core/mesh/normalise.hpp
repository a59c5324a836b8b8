#pragma once
// Brings a model of any unit and place into the frame that cameras look at (core/views/camera.hpp).

#include "core/base/result.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

/// The mesh moved and scaled evenly: the centre of its bounding box at the origin, its farthest vertex at distance 1.
/// Only vertices that a triangle uses count; the others are carried along, and lie anywhere. Moving or scaling the
/// input does not change the result but for rounding. No turning: which side is up stays as it was. No triangles give
/// EmptyMesh; all vertices in one place, a coordinate that is not finite or an index out of range give BadMesh. Linear
/// time. After thesis 7.1.1, which scales to a cube instead: that only changes the size in the image.
[[nodiscard]] Result<TriangleMesh> normalised_mesh(TriangleMesh mesh);

}  // namespace core
