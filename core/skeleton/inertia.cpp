#include "core/skeleton/inertia.hpp"

#include "core/geometry/polygon.hpp"

namespace core {

InertiaAxis axis_of_least_inertia(const Polygon& ring) {
    InertiaAxis axis;
    const double area = signed_area(ring);
    if (area == 0.0) return axis;
    const Point origin = ring.front();
    double mx = 0.0, my = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i] - origin, b = ring[(i + 1) % ring.size()] - origin;
        const double w = cross(a, b);
        mx += w * (a.x + b.x);
        my += w * (a.y + b.y);
        sxx += w * (a.x * a.x + a.x * b.x + b.x * b.x);
        syy += w * (a.y * a.y + a.y * b.y + b.y * b.y);
        sxy += w * (a.x * b.y + 2.0 * a.x * a.y + 2.0 * b.x * b.y + b.x * a.y);
    }
    const Point mean{mx / (6.0 * area), my / (6.0 * area)};
    sxx = sxx / (12.0 * area) - mean.x * mean.x;
    syy = syy / (12.0 * area) - mean.y * mean.y;
    sxy = sxy / (24.0 * area) - mean.x * mean.y;
    axis.centre = origin + mean;
    const double anisotropy = std::hypot(sxx - syy, 2.0 * sxy);
    if (anisotropy > 1e-9 * (sxx + syy)) {
        const double angle = 0.5 * std::atan2(2.0 * sxy, sxx - syy);
        axis.direction = {std::cos(angle), std::sin(angle)};
    }
    return axis;
}

Polygon stretched_along(const Polygon& ring, const InertiaAxis& axis, double factor) {
    Polygon out = ring;
    for (Point& p : out) p = p + axis.direction * (dot(p - axis.centre, axis.direction) * (factor - 1.0));
    return out;
}

}  // namespace core
