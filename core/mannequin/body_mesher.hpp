#pragma once
// The surface of a body's field as quads.

#include "core/mannequin/body_shape.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

/// A closed mesh with quads of about `cell_cm`, the same on both sides of x = 0; its vertices lie on the surface.
[[nodiscard]] QuadMesh mesh_body(const BodyShape& shape, double cell_cm);

/// Puts the vertices of a mesh near the surface onto it: a few steps along the gradient. Those on x = 0 stay there.
void settle_on(const BodyShape& shape, QuadMesh& mesh);

}  // namespace core
