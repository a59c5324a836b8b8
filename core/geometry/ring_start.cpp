#include "core/geometry/ring_start.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "core/geometry/polygon.hpp"

namespace core {

double ellipse_end(const Polygon& ring) {
    const double around = perimeter(ring);
    if (!(around > 0.0)) return 0.0;
    // The coefficients of exp(i t) and exp(-i t) of the ring as a function of t, 0 to 2 pi once round: edges are
    // straight, so each adds its direction times what the exponential changes along it.
    std::complex<double> forwards, backwards, from{1.0, 0.0};
    double along = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point edge = ring[(k + 1) % ring.size()] - ring[k];
        const double size = length(edge);
        if (!(size > 0.0)) continue;
        along += size;
        const std::complex<double> to = std::polar(1.0, 2.0 * std::numbers::pi * along / around);
        const std::complex<double> direction(edge.x / size, edge.y / size);
        forwards += direction * std::conj(to - from);
        backwards += direction * (to - from);
        from = to;
    }
    const double share = (std::arg(backwards) - std::arg(forwards)) / (4.0 * std::numbers::pi);
    return share - std::floor(share);
}

namespace {

/// A place on the edge from ring[index] to the next point.
struct EdgePlace {
    std::size_t index = 0;
    Point point;
};

EdgePlace place_at(const Polygon& ring, double share) {
    double left = share * perimeter(ring);
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point a = ring[k], b = ring[(k + 1) % ring.size()];
        const double size = distance(a, b);
        if (left < size) return {k, a + (b - a) * (left / size)};
        left -= size;
    }
    return {ring.size() - 1, ring.front()};
}

}  // namespace

Point at_share(const Polygon& ring, double share) {
    return place_at(ring, share).point;
}

Polygon started_at(const Polygon& ring, double share) {
    const EdgePlace start = place_at(ring, share);
    Polygon out{start.point};
    for (std::size_t k = 1; k <= ring.size(); ++k) out.push_back(ring[(start.index + k) % ring.size()]);
    return out;
}

}  // namespace core
