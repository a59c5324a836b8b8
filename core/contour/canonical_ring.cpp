#include "core/contour/canonical_ring.hpp"

#include <algorithm>

#include "core/geometry/polygon.hpp"
#include "core/geometry/ring_start.hpp"
#include "core/silhouette/contour.hpp"

namespace core {

namespace {

/// About the centroid, stretched across the long axis.
Polygon less_slender(const Polygon& ring, const RingMoments& m, double slenderness) {
    const RingMoments::Spread spread = m.spread();
    const double ratio = spread.along / std::max(spread.across, 1e-5 * spread.along);
    const double angle = m.long_axis_rad(), stretch = std::pow(ratio, 1.0 - slenderness);
    const Point along{std::cos(angle), std::sin(angle)}, across{-along.y, along.x};
    Polygon out(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point p = ring[i] - m.centroid;
        out[i] = along * dot(p, along) + across * (dot(p, across) * stretch);
    }
    return out;
}

}  // namespace

Polygon canonical_ring(const Polygon& ring, const RingMoments& moments, const CanonicalSampling& options) {
    const Polygon smooth =
        smooth_contour(less_slender(ring, moments, options.slenderness), options.count, options.sigma);
    double share = ellipse_end(smooth);
    const double other = share < 0.5 ? share + 0.5 : share - 0.5;
    if (length(at_share(smooth, other)) > length(at_share(smooth, share))) share = other;
    return resample_ring(started_at(smooth, share), options.count);
}

}  // namespace core
