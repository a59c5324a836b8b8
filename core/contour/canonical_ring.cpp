#include "core/contour/canonical_ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contour/thickness.hpp"
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

/// `count` points, evenly spaced by the sum of what edges are worth, the first at ring[0]. Some edge is worth more than
/// nought.
Polygon resample_by_worth(const Polygon& ring, const std::vector<double>& worth, int count) {
    double whole = 0.0, before = 0.0;
    for (const double w : worth) whole += w;
    Polygon out;
    out.reserve(static_cast<std::size_t>(count));
    std::size_t edge = 0;
    for (int k = 0; k < count; ++k) {
        const double target = whole * k / count;
        for (; edge + 1 < ring.size() && before + worth[edge] <= target; ++edge) before += worth[edge];
        const double part = worth[edge] > 0.0 ? std::clamp((target - before) / worth[edge], 0.0, 1.0) : 0.0;
        out.push_back(ring[edge] + (ring[(edge + 1) % ring.size()] - ring[edge]) * part);
    }
    return out;
}

/// Of an even ring: points close together where it is thick. A shape is as thick as at every other point of it.
Polygon denser_where_thick(const Polygon& ring, const CanonicalSampling& options) {
    const double radius = std::sqrt(std::max(signed_area(ring), 0.0) / std::numbers::pi);
    Polygon every_other;
    for (std::size_t i = 0; i < ring.size(); i += 2) every_other.push_back(ring[i]);
    const std::vector<double> thick = thickness_along(every_other, options.greatest_thickness * radius);
    double mean = 0.0;
    for (const double t : thick) mean += t / static_cast<double>(thick.size());
    if (!(mean > 0.0)) return ring;
    std::vector<double> worth(ring.size());
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const double relative = thick[(k + 1) / 2 % thick.size()] / mean;
        worth[k] = 1.0 + options.thickness * (relative - 1.0);
    }
    return resample_by_worth(ring, worth, options.count);
}

}  // namespace

Polygon canonical_ring(const Polygon& ring, const RingMoments& moments, const CanonicalSampling& options) {
    const Polygon smooth =
        smooth_contour(less_slender(ring, moments, options.slenderness), options.count, options.sigma);
    double share = ellipse_end(smooth);
    const double other = share < 0.5 ? share + 0.5 : share - 0.5;
    if (length(at_share(smooth, other)) > length(at_share(smooth, share))) share = other;
    const Polygon even = resample_ring(started_at(smooth, share), options.count);
    return options.thickness > 0.0 ? denser_where_thick(even, options) : even;
}

}  // namespace core
