#pragma once
// The 50 cameras from which a model is looked at, evenly placed round it (thesis 7.1.1).
//
// One Catmull-Clark step on the cube gives 26 vertices and 24 faces; the vertices and the centroids of the faces, moved
// radially to the unit sphere, are the directions. Their numbers, which indexes store, never change:
//
//      0 …  7   the cube's corners       (x, y, z) from (-,-,-) to (+,+,+), z changing fastest
//      8 … 13   its face centres         -x, +x, -y, +y, -z, +z
//     14 … 25   its edge midpoints       along x, then y, then z
//     26 … 49   the centroids of the 24 subdivided faces, four a cube face in the order of the faces, one a corner
//
// Models have y up and face +z, as is usual. The image's up is the y axis seen from the camera; the cameras above and
// below, which see no y axis, take -z: so it is for a viewer in front who tilts the model towards himself.
//
// The cameras come in 25 opposite pairs. Under parallel projection a silhouette seen from behind is the mirror image of
// the one from the front, left and right swapped, and both cameras of a pair share their up vector: to render and
// describe one of each pair is enough, and representative_cameras() names it.

#include <array>
#include <cstddef>

#include "core/views/camera.hpp"

namespace core {

inline constexpr int kCameraCount = 50;
inline constexpr int kCameraPairs = 25;

/// The cameras by number. Computed once; safe from any thread.
[[nodiscard]] const std::array<Camera, kCameraCount>& cameras();

/// The number of the camera opposite to `camera`, 0 … 49: an involution without fixed points.
[[nodiscard]] int opposite_camera(int camera);

/// One camera of each pair, ascending: the one that looks from above; of level ones that from the front; of the two
/// sides that from +x. So pictures taken by them show a model as people are used to see it.
[[nodiscard]] const std::array<int, kCameraPairs>& representative_cameras();

/// The camera of representative_cameras() that shows what `camera` shows, as it is or mirrored.
[[nodiscard]] int representative_of(int camera);

/// The unit camera in a direction other than 0, with up chosen by the rule above.
[[nodiscard]] Camera camera_from(Vec3 direction);

}  // namespace core
