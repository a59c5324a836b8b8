#include "core/skeleton/chord_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/polygon.hpp"

namespace core {

namespace {

int third_vertex(const Triangle& t, const Chord& c) {
    for (const int v : t.vertices) {
        if (v != c.u && v != c.v) return v;
    }
    return c.u;  // unreachable for a triangle of the chord
}

double angle_at(Point apex, Point a, Point b) {
    return std::atan2(std::abs(cross(a - apex, b - apex)), dot(a - apex, b - apex));
}

/// Samples strictly inside the arc from `from` to `to` when the disc over the chord holds all of them, else 0.
int samples_in_half_disk(const Polygon& samples, int from, int to) {
    const int n = static_cast<int>(samples.size());
    const Point a = samples[static_cast<std::size_t>(from)], b = samples[static_cast<std::size_t>(to)];
    int count = 0;
    for (int i = (from + 1) % n; i != to; i = (i + 1) % n) {
        const Point p = samples[static_cast<std::size_t>(i)];
        if (dot(p - a, p - b) > 0.0) return 0;
        ++count;
    }
    return count;
}

double arc_length(const Polygon& samples, int from, int to) {
    const int n = static_cast<int>(samples.size());
    double total = 0.0;
    for (int i = from; i != to; i = (i + 1) % n) {
        total += distance(samples[static_cast<std::size_t>(i)], samples[static_cast<std::size_t>((i + 1) % n)]);
    }
    return total;
}

}  // namespace

ChordMeasures measure_chords(const Polygon& samples, const Triangulation& triangulation) {
    ChordMeasures m;
    const auto point = [&samples](int i) { return samples[static_cast<std::size_t>(i)]; };
    const double whole = perimeter(samples);
    for (const Chord& c : triangulation.chords) {
        const Point u = point(c.u), v = point(c.v);
        const Point in = point(third_vertex(triangulation.triangles[static_cast<std::size_t>(c.inner)], c));
        const Point out = point(third_vertex(triangulation.triangles[static_cast<std::size_t>(c.outer)], c));
        m.strength.push_back(1.0 - (angle_at(in, u, v) + angle_at(out, u, v)) / std::numbers::pi);
        const Polygon quadrilateral{u, in, v, out};
        const double p = perimeter(quadrilateral), a = std::abs(signed_area(quadrilateral));
        m.compactness.push_back(a > 0.0 ? p * p / a : std::numeric_limits<double>::max());
        const bool inner_is_smaller = arc_length(samples, c.u, c.v) * 2.0 <= whole;
        m.half_disk.push_back(inner_is_smaller ? samples_in_half_disk(samples, c.u, c.v)
                                               : samples_in_half_disk(samples, c.v, c.u));
    }
    return m;
}

std::vector<char> local_maxima(const std::vector<int>& order, const std::vector<double>& value) {
    std::vector<char> selected(value.size(), 0);
    const std::size_t n = order.size();
    const auto at = [&](std::size_t i) { return value[static_cast<std::size_t>(order[i % n])]; };
    for (std::size_t i = 0; i < n; ++i) {
        const double before = at(i + n - 1), here = at(i), after = at(i + 1);
        if (here >= before && here >= after && (here > before || here > after)) {
            selected[static_cast<std::size_t>(order[i])] = 1;
        }
    }
    return selected;
}

std::vector<char> ChordProfile::cuts() const {
    std::vector<char> any(by_strength.size(), 0);
    for (std::size_t i = 0; i < any.size(); ++i) any[i] = by_strength[i] | by_compactness[i] | by_half_disk[i];
    return any;
}

ChordProfile extended_profile(const Polygon& samples, const Triangulation& triangulation) {
    const ChordMeasures m = measure_chords(samples, triangulation);
    const std::vector<int> order = chords_along_outline(triangulation, static_cast<int>(samples.size()));
    return {local_maxima(order, m.strength), local_maxima(order, m.compactness), local_maxima(order, m.half_disk)};
}

}  // namespace core
