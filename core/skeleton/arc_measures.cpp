#include "core/skeleton/arc_measures.hpp"

#include "core/geometry/polygon.hpp"

namespace core {

ArcMeasures::ArcMeasures(const Polygon& samples) : samples_(samples) {
    const std::size_t n = samples_.size();
    // From the first sample first: differences of samples are exact, and so the place of the shape does not matter.
    const Point first = n > 0 ? samples_.front() : Point{};
    for (Point& p : samples_) p = p - first;
    const Point centre = n > 0 ? centroid_of_points(samples_) : Point{};
    double radius = 0.0;
    for (Point& p : samples_) {
        p = p - centre;
        radius = std::max(radius, core::length(p));
    }
    length_.assign(n + 1, 0.0);
    cross_.assign(n + 1, 0.0);
    bending_.assign(n + 1, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        const Point a = samples_[(i + n - 1) % n], b = samples_[i], c = samples_[(i + 1) % n];
        length_[i + 1] = length_[i] + distance(b, c);
        cross_[i + 1] = cross_[i] + core::cross(b, c);
        const double product = distance(a, b) * distance(b, c) * distance(a, c);
        const double curvature = product > 0.0 ? std::abs(core::cross(b - a, c - b)) / product : 0.0;
        bending_[i + 1] = bending_[i] + curvature * radius;  // curvature is 1 / length
    }
}

double ArcMeasures::span(const std::vector<double>& sums, int from, int to) const {
    const double ahead = sums[static_cast<std::size_t>(to)] - sums[static_cast<std::size_t>(from)];
    return from < to ? ahead : ahead + sums.back();
}

int ArcMeasures::steps(int from, int to) const {
    return from < to ? to - from : to - from + count();
}

double ArcMeasures::length(int from, int to) const {
    return span(length_, from, to);
}

double ArcMeasures::area(int from, int to) const {
    return 0.5 * (span(cross_, from, to) +
                  core::cross(samples_[static_cast<std::size_t>(to)], samples_[static_cast<std::size_t>(from)]));
}

double ArcMeasures::bending(int from, int to) const {
    const auto end = static_cast<std::size_t>(to);
    return span(bending_, from, to) + (from == to ? 0.0 : bending_[end + 1] - bending_[end]);
}

}  // namespace core
