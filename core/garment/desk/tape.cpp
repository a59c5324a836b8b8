#include "core/garment/desk/tape.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace core {
namespace {

/// The convex hull, anti-clockwise (Andrew 1979).
std::vector<Point> hull_of(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Point> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t start = hull.size();
        for (const Point p : points) {
            while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// How far the origin lies outside of an anti-clockwise hull; 0 inside.
double distance_outside(const std::vector<Point>& hull) {
    double nearest = std::numeric_limits<double>::max();
    bool inside = hull.size() > 2;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point a = hull[i], edge = hull[(i + 1) % hull.size()] - a;
        inside = inside && cross(edge, a * -1.0) >= 0.0;
        const double square = dot(edge, edge);
        const double t = square > 0.0 ? std::clamp(-dot(a, edge) / square, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, length(a + edge * t));
    }
    return inside ? 0.0 : nearest;
}

}  // namespace

TapeReading girth_of(const QuadMesh& mesh, const CutPlane& plane) {
    std::vector<Point> best;
    double least = std::numeric_limits<double>::max();
    for (std::vector<Point>& piece : plane_section(mesh, plane)) {
        std::vector<Point> hull = hull_of(std::move(piece));
        const double away = distance_outside(hull);
        if (hull.size() < 3 || away >= least) continue;
        least = away;
        best = std::move(hull);
    }
    TapeReading reading{0.0, true, {}};
    for (std::size_t i = 0; i < best.size(); ++i) {
        reading.cm += distance(best[i], best[(i + 1) % best.size()]);
        reading.tape.push_back(plane.origin + plane.right * best[i].x + plane.up * best[i].y);
    }
    if (!reading.tape.empty()) reading.tape.push_back(reading.tape.front());
    return reading;
}

TapeReading length_of(SpaceLine line) {
    const double cm = line_length(line);
    return {cm, false, std::move(line)};
}

}  // namespace core
