#pragma once
// Cuts of a mesh with a plane, and how long a tape laid around one is.

#include <vector>

#include "core/geometry/point.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

/// `right` and `up` are unit vectors in the plane, perpendicular to each other.
struct CutPlane {
    Vec3 origin, right, up;
};

/// The pieces of the cut that hang together, each as its points in plane coordinates (right, up), in no order. Quads
/// count as two triangles. Linear in the quads.
[[nodiscard]] std::vector<std::vector<Point>> plane_section(const QuadMesh& mesh, const CutPlane& plane);

/// The length of a tape around the piece of the cut whose hull holds the plane's origin, or else around the nearest:
/// the circumference of its convex hull. 0 when the plane misses the mesh.
[[nodiscard]] double tape_length(const QuadMesh& mesh, const CutPlane& plane);

/// The circumference of the convex hull of points.
[[nodiscard]] double hull_length(std::vector<Point> points);

}  // namespace core
