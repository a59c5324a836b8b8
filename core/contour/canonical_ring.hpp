#pragma once
// The same points on an outline whatever point it is listed from, and on its mirror image the mirrored ones.

#include "core/contour/ring_moments.hpp"
#include "core/geometry/point.hpp"

namespace core {

struct CanonicalSampling {
    int count = 320;     ///< points, even
    double sigma = 1.2;  ///< of the Gaussian that smooths the outline, in points
    /// What the ratio of length to width is raised to: 1 leaves it, 0 makes all shapes round.
    double slenderness = 0.7;
    /// How much the spacing follows the thickness of the shape: at 0 it is even, at 1 points are as dense as the shape
    /// is thick there. So a tail takes fewer points the longer it is in proportion, and moves those of the body less.
    double thickness = 0.3;
    /// No place counts for thicker than this times the radius of the disc of equal area.
    double greatest_thickness = 1.5;
};

/// Points of the smoothed outline, anti-clockwise, about its centroid, spaced as `thickness` says. The first lies at
/// the end of the outline's first-harmonic ellipse, at the one of its two ends that is farther from the centroid: this
/// moves with the shape, so that a turned, scaled or mirrored shape is sampled at the same places. (Of a round outline
/// the ellipse has no ends; its first point then is arbitrary, and the same for the same pixels.) The shape is made
/// less slender before sampling, along its axis of inertia: length / width becomes its power `slenderness`. The ring
/// must enclose an area, `moments` are its own. Linear in points of the ring, plus about 0.1 ms for 320 points.
[[nodiscard]] Polygon canonical_ring(const Polygon& ring, const RingMoments& moments, const CanonicalSampling& options);

}  // namespace core
