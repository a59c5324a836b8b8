#include "core/garment/pattern/allowance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace core {
namespace {

constexpr double kMostMitre = 3.0;
constexpr double kParallel = 0.05;  // sine

Point outward(Point from, Point to) {
    const Point along = to - from;
    const double size = length(along);
    return size > 0.0 ? Point{along.y / size, -along.x / size} : Point{};
}

/// Where two open segments cross.
std::optional<Point> crossing(Point a, Point b, Point c, Point d) {
    const Point ab = b - a, cd = d - c;
    const double turn = cross(ab, cd);
    if (std::abs(turn) < 1e-14) return std::nullopt;
    const double s = cross(c - a, cd) / turn, t = cross(c - a, ab) / turn;
    if (s <= 0.0 || s >= 1.0 || t <= 0.0 || t >= 1.0) return std::nullopt;
    return a + ab * s;
}

/// Of two parts of a ring that meet in a crossing, the one that is kept goes around most.
Polygon without_loops(Polygon ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t reach = ring.size() / 2;
        for (std::size_t step = std::min(reach, ring.size() - 1); step >= 2; --step) {
            const std::size_t j = (i + step) % ring.size();
            const std::optional<Point> at =
                crossing(ring[i], ring[(i + 1) % ring.size()], ring[j], ring[(j + 1) % ring.size()]);
            if (!at) continue;
            Polygon kept;  // from after j round to i, then the crossing
            for (std::size_t k = (j + 1) % ring.size();; k = (k + 1) % ring.size()) {
                kept.push_back(ring[k]);
                if (k == i) break;
            }
            kept.push_back(*at);
            ring = std::move(kept);
            i = static_cast<std::size_t>(-1);  // the ring begins anew
            break;
        }
    }
    return ring;
}

}  // namespace

Polygon moved_outward(const Polygon& ring, const std::vector<double>& away) {
    Polygon out;
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = (i + n - 1) % n;
        const Point n1 = outward(ring[before], ring[i]), n2 = outward(ring[i], ring[(i + 1) % n]);
        const double d1 = away[before], d2 = away[i], turn = cross(n1, n2);
        if (std::abs(turn) < kParallel) {
            out.push_back(ring[i] + n1 * d1);
            if (std::abs(d1 - d2) > 1e-9) out.push_back(ring[i] + n2 * d2);
            continue;
        }
        // the place that is d1 from the one edge's line and d2 from the other's
        const Point mitre = Point{d1 * n2.y - d2 * n1.y, d2 * n1.x - d1 * n2.x} * (1.0 / turn);
        if (length(mitre) > kMostMitre * std::max({d1, d2, 1e-9})) {
            out.push_back(ring[i] + n1 * d1);
            out.push_back(ring[i] + n2 * d2);
        } else {
            out.push_back(ring[i] + mitre);
        }
    }
    return without_loops(std::move(out));
}

}  // namespace core
