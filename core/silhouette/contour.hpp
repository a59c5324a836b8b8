#pragma once
// From a binary image to the outline of its largest object.

#include "core/base/result.hpp"
#include "core/geometry/point.hpp"
#include "core/silhouette/image.hpp"

namespace core {

/// Separates object from page at half grey. Either polarity: the page is what most border pixels show.
/// Returns 1 for the object. A page of one shade gives an image without a single 1.
[[nodiscard]] BinaryImage object_mask(const GrayImage& image);

/// The outer contour of the largest object (by the area that it encloses, holes filled), as the ring of the midpoints
/// of its pixel edges: anti-clockwise, y UP (y = -row), in pixels, so that lines along 0, 45 and 90 degrees come out
/// straight and even a line one pixel wide has two sides that never touch. Pixels that meet at a corner only belong
/// together. The ring starts at its lowest, then leftmost vertex whatever the order of the pixels, and moves with the
/// object exactly. TooSmall when no object encloses at least `least_area` square pixels; EmptyDrawing when there is no
/// object at all. Linear in the number of pixels.
[[nodiscard]] Result<Polygon> largest_contour(const BinaryImage& image, double least_area = 4.0);

/// The contour in the form that the skeleton reads: smoothed along the ring by a Gaussian of `sigma` of its points,
/// then `count` points evenly spaced from near an end of its first-harmonic ellipse on (core/geometry/ring_start.hpp);
/// scale and position kept. It does not depend on where the ring starts, moves exactly with a ring of pixel edges, and
/// the points stay on the same places of a shape that is turned or mirrored. About 1200 points and sigma 6 (reading
/// notes: 400 and 2). Linear in the points and count * sigma.
[[nodiscard]] Polygon smooth_contour(const Polygon& contour, int count, double sigma);

}  // namespace core
