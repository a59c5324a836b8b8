#pragma once
// Whether a ring touches itself, by looking at all pairs of edges. Exact for coordinates of few bits (grids and half
// grids).

#include <algorithm>

#include "core/geometry/point.hpp"

namespace support {

inline int side_of(core::Point a, core::Point b, core::Point c) {
    const double v = core::cross(b - a, c - a);
    return v > 0 ? 1 : v < 0 ? -1 : 0;
}

/// Whether p lies on the closed segment from a to b.
inline bool lies_on(core::Point a, core::Point b, core::Point p) {
    return side_of(a, b, p) == 0 && core::dot(p - a, p - b) <= 0.0;
}

inline bool segments_meet(core::Point a, core::Point b, core::Point c, core::Point d) {
    if (lies_on(a, b, c) || lies_on(a, b, d) || lies_on(c, d, a) || lies_on(c, d, b)) return true;
    return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

/// Neighbouring edges share their common point and nothing else; other edges share nothing.
inline bool is_simple(const core::Polygon& ring) {
    const std::size_t n = ring.size();
    if (n < 3) return false;
    const auto at = [&](std::size_t i) { return ring[i % n]; };
    for (std::size_t i = 0; i < n; ++i) {
        if (at(i) == at(i + 1) || lies_on(at(i), at(i + 1), at(i + 2)) || lies_on(at(i + 1), at(i + 2), at(i)))
            return false;
        for (std::size_t j = i + 2; j < n; ++j) {
            if ((j + 1) % n != i && segments_meet(at(i), at(i + 1), at(j), at(j + 1))) return false;
        }
    }
    return true;
}

}  // namespace support
