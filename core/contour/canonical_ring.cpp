#include "core/contour/canonical_ring.hpp"

#include <algorithm>
#include <complex>
#include <numbers>

#include "core/geometry/polygon.hpp"
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

/// Where the first-harmonic ellipse of evenly spaced points has an end, as a share of the ring in [0, 1). The other end
/// lies half a ring on.
double ellipse_end(const Polygon& even) {
    std::complex<double> forwards, backwards;
    const double step = 2.0 * std::numbers::pi / static_cast<double>(even.size());
    for (std::size_t k = 0; k < even.size(); ++k) {
        const std::complex<double> z(even[k].x, even[k].y);
        const std::complex<double> turn = std::polar(1.0, step * static_cast<double>(k));
        forwards += z * std::conj(turn);
        backwards += z * turn;
    }
    const double share = (std::arg(backwards) - std::arg(forwards)) / (4.0 * std::numbers::pi);
    return share - std::floor(share);
}

Point at_share(const Polygon& ring, double share) {
    const auto n = static_cast<double>(ring.size());
    const double position = share * n, whole = std::floor(position);
    const std::size_t k = static_cast<std::size_t>(whole) % ring.size();
    const Point p = ring[k], q = ring[(k + 1) % ring.size()];
    return p + (q - p) * (position - whole);
}

/// The ring with its point at `share` put in front.
Polygon started_at(const Polygon& ring, double share) {
    const auto n = static_cast<double>(ring.size());
    const std::size_t next = (static_cast<std::size_t>(share * n) + 1) % ring.size();
    Polygon out{at_share(ring, share)};
    out.insert(out.end(), ring.begin() + static_cast<std::ptrdiff_t>(next), ring.end());
    out.insert(out.end(), ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(next));
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
