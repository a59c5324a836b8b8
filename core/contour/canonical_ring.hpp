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
};

/// Evenly spaced points of the smoothed outline, anti-clockwise, about its centroid. The first lies at the end of the
/// outline's first-harmonic ellipse, at the one of its two ends that is farther from the centroid: this moves with the
/// shape, so that a turned, scaled or mirrored shape is sampled at the same places. (Of a round outline the ellipse has
/// no ends; its first point then is arbitrary, and the same for the same pixels.) The shape is made less slender before
/// sampling, along its axis of inertia: length / width becomes its power `slenderness`.
/// The ring must enclose an area, `moments` are its own. Linear in points of the ring plus `count`.
[[nodiscard]] Polygon canonical_ring(const Polygon& ring, const RingMoments& moments, const CanonicalSampling& options);

}  // namespace core
