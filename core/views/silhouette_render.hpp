#pragma once
// The silhouette of a mesh seen by a camera, drawn by our own rasteriser, for which faces have no front and no back.

#include "core/geometry/point.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "core/silhouette/image.hpp"
#include "core/views/camera.hpp"

namespace core {

/// Empty pixels that a normalised model leaves at each side of its image.
inline constexpr int kViewMarginPx = 2;

/// How many pixels of an image of `size_px` pixels a side show a length of 1 in the image plane.
[[nodiscard]] constexpr double pixels_per_unit(int size_px) {
    return (size_px - 2 * kViewMarginPx) * 0.5;
}

/// Between image plane (x right, y up, the square [-1, 1] x [-1, 1]) and image (x right, y down, in pixels; pixel (i,
/// j) is the square from (i, j) to (i+1, j+1), its centre at (i+0.5, j+0.5)). Each undoes the other.
[[nodiscard]] constexpr Point to_image_px(Point plane, int size_px) {
    const double scale = pixels_per_unit(size_px), middle = size_px * 0.5;
    return {middle + plane.x * scale, middle - plane.y * scale};
}
[[nodiscard]] constexpr Point to_image_plane(Point image_px, int size_px) {
    const double scale = pixels_per_unit(size_px), middle = size_px * 0.5;
    return {(image_px.x - middle) / scale, (middle - image_px.y) / scale};
}

/// The square image of `size_px` pixels a side (more than 2 kViewMarginPx) in which the object is 1.
/// A pixel belongs to it when its cross meets a triangle: the unit-long segments, level and upright, through its
/// centre. Hence, whatever way the surface is cut into triangles, the image is the same; what hangs together in the
/// model hangs together in the image (8-connected), be it thinner than a pixel, seen edge-on, or without any area; and
/// an outline lies at most half a pixel outside the true one, never inside. Only what hides between four pixel centres
/// (a speck) is lost. The mesh should be normalised (core/mesh/normalise.hpp); what lies outside [-1, 1] is cut off at
/// the image's edge. Triangles with an index out of range or a point not finite are passed over. Linear in triangles
/// plus pixels crossed; nothing is allocated but the image. Safe from several threads.
[[nodiscard]] BinaryImage render_silhouette(const TriangleMesh& normalised, const Camera& camera, int size_px);

/// The image with left and right swapped: what the opposite camera sees.
[[nodiscard]] BinaryImage mirrored(const BinaryImage& image);

}  // namespace core
