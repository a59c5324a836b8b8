#include "core/geometry/polygon.hpp"

#include <algorithm>
#include <limits>

namespace core {

double signed_area(const Polygon& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[(i + 1) % ring.size()]);
    return twice * 0.5;
}

double perimeter(const Polygon& ring) {
    if (ring.size() < 2) return 0.0;
    return chain_length(ring) + distance(ring.back(), ring.front());
}

double chain_length(const Polyline& chain) {
    double total = 0.0;
    for (std::size_t i = 1; i < chain.size(); ++i) total += distance(chain[i - 1], chain[i]);
    return total;
}

Point centroid_of_points(const std::vector<Point>& points) {
    Point sum;
    for (const Point& p : points) sum = sum + p;
    return sum * (1.0 / static_cast<double>(points.size()));
}

Polygon convex_hull(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    Polygon hull;
    const auto extend = [&hull](Point p, std::size_t floor) {
        while (hull.size() > floor && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
            hull.pop_back();
        hull.push_back(p);
    };
    for (const Point& p : points) extend(p, 1);
    const std::size_t lower = hull.size();
    for (auto it = points.rbegin() + 1; it != points.rend(); ++it) extend(*it, lower);
    hull.pop_back();
    return hull;
}

OrientedRectangle least_rectangle(const Polygon& hull) {
    OrientedRectangle best;
    double best_area = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point edge = hull[(i + 1) % hull.size()] - hull[i];
        const double len = length(edge);
        if (len <= 0.0) continue;
        const Point axis = edge * (1.0 / len);
        double low = 0.0, high = 0.0, up_low = 0.0, up_high = 0.0;
        for (const Point& p : hull) {
            const Point d = p - hull[i];
            low = std::min(low, dot(axis, d));
            high = std::max(high, dot(axis, d));
            up_low = std::min(up_low, cross(axis, d));
            up_high = std::max(up_high, cross(axis, d));
        }
        const OrientedRectangle candidate{axis, high - low, up_high - up_low};
        if (candidate.area() < best_area) {
            best_area = candidate.area();
            best = candidate;
        }
    }
    return best;
}

namespace {

/// Walks `chain` (with its closing edge when it is a ring) and puts a point at every multiple of `step`.
Polyline walk(const Polyline& chain, double step, int count) {
    Polyline out;
    out.reserve(static_cast<std::size_t>(count));
    std::size_t edge = 0;
    double before = 0.0;  // arc length at the start of the current edge
    const std::size_t n = chain.size();
    double edge_length = n > 1 ? distance(chain[0], chain[1 % n]) : 0.0;
    for (int k = 0; k < count; ++k) {
        const double target = step * k;
        while (edge + 1 < n && before + edge_length < target) {
            before += edge_length;
            ++edge;
            edge_length = distance(chain[edge], chain[(edge + 1) % n]);
        }
        const double t = edge_length > 0.0 ? std::clamp((target - before) / edge_length, 0.0, 1.0) : 0.0;
        out.push_back(chain[edge] + (chain[(edge + 1) % n] - chain[edge]) * t);
    }
    return out;
}

}  // namespace

Polygon resample_ring(const Polygon& ring, int count) {
    return walk(ring, perimeter(ring) / count, count);
}

Polyline resample_chain(const Polyline& chain, int count) {
    Polyline out = walk(chain, chain_length(chain) / (count - 1), count);
    out.back() = chain.back();
    return out;
}

}  // namespace core
