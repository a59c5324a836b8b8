#pragma once
// Putting a model together from closed parts, and moving parts about. Parts may overlap: silhouettes do not mind.
//
// Models are made in the profile frame, x forward, y up, z towards the viewer of the profile, and turned at the end:
// `facing_front` brings +x to +z for what has a head or a prow; flat things (a key, a guitar) face +z as they are made.

#include <functional>

#include "core/mesh/triangle_mesh.hpp"
#include "core/starter/kit/palette.hpp"

namespace core::starter {

/// Appends a part's vertices, triangles and colours. The part must have one colour a vertex.
void join(TriangleMesh& into, const TriangleMesh& part);

[[nodiscard]] TriangleMesh moved(TriangleMesh mesh, Vec3 by);
/// About the origin; negative factors are not allowed (use mirrored_z).
[[nodiscard]] TriangleMesh scaled(TriangleMesh mesh, Vec3 factors);
/// Turns about the origin, anti-clockwise seen from the axis' tip. Degrees.
[[nodiscard]] TriangleMesh turned_x(TriangleMesh mesh, double degrees);
[[nodiscard]] TriangleMesh turned_y(TriangleMesh mesh, double degrees);
[[nodiscard]] TriangleMesh turned_z(TriangleMesh mesh, double degrees);
/// The mirror image at the plane z = 0, faces still outward.
[[nodiscard]] TriangleMesh mirrored_z(TriangleMesh mesh);
/// The mirror image at the plane x = 0, faces still outward.
[[nodiscard]] TriangleMesh mirrored_x(TriangleMesh mesh);
/// Turns the profile frame's +x to +z: the side view is then seen from +x and -x.
[[nodiscard]] TriangleMesh facing_front(TriangleMesh mesh);
/// The same at a share of its width: what has long sides is made narrower than life, so that the side people draw is
/// the one that shows most of it.
[[nodiscard]] TriangleMesh narrow(TriangleMesh side_view, double share);
/// Recolours every vertex by its place and present colour.
[[nodiscard]] TriangleMesh painted(TriangleMesh mesh, const std::function<Rgb(Vec3, Rgb)>& colour);
/// Moves every vertex. The function must be orientation-preserving, or faces turn inside out.
[[nodiscard]] TriangleMesh bent(TriangleMesh mesh, const std::function<Vec3(Vec3)>& place);

/// A model growing by parts.
class Assembly {
  public:
    Assembly& add(const TriangleMesh& part) {
        join(mesh_, part);
        return *this;
    }
    /// The part and its mirror image at z = 0: left and right.
    Assembly& pair(const TriangleMesh& part) { return add(part).add(mirrored_z(part)); }
    /// The part and its mirror image at x = 0.
    Assembly& pair_x(const TriangleMesh& part) { return add(part).add(mirrored_x(part)); }
    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }

  private:
    TriangleMesh mesh_;
};

}  // namespace core::starter
