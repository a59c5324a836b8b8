#include "core/contour/ring_moments.hpp"

#include <algorithm>

namespace core {

double RingMoments::long_axis_rad() const {
    return 0.5 * std::atan2(2.0 * xy, xx - yy);
}

RingMoments::Spread RingMoments::spread() const {
    const double mean = 0.5 * (xx + yy), half = std::hypot(0.5 * (xx - yy), xy);
    return {std::sqrt(std::max(mean + half, 0.0)), std::sqrt(std::max(mean - half, 0.0))};
}

RingMoments ring_moments(const Polygon& ring) {
    RingMoments m;
    if (ring.empty()) return m;
    // About the first point first: far from the origin the sums would cancel.
    const Point origin = ring.front();
    double twice = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point p = ring[i] - origin, q = ring[i + 1 == ring.size() ? 0 : i + 1] - origin;
        const double c = cross(p, q);
        twice += c;
        x += c * (p.x + q.x);
        y += c * (p.y + q.y);
        xx += c * (p.x * p.x + p.x * q.x + q.x * q.x);
        yy += c * (p.y * p.y + p.y * q.y + q.y * q.y);
        xy += c * (p.x * q.y + 2.0 * p.x * p.y + 2.0 * q.x * q.y + q.x * p.y);
    }
    m.area = 0.5 * twice;
    if (m.area == 0.0) return m;
    const Point centre{x / (3.0 * twice), y / (3.0 * twice)};
    m.centroid = origin + centre;
    m.xx = xx / (6.0 * twice) - centre.x * centre.x;
    m.yy = yy / (6.0 * twice) - centre.y * centre.y;
    m.xy = xy / (12.0 * twice) - centre.x * centre.y;
    return m;
}

}  // namespace core
