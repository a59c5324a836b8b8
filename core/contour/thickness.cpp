#include "core/contour/thickness.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/polygon.hpp"

namespace core {

namespace {

constexpr double kNotAcross = 1.42, kAcross = 1.9;  // along the outline against straight across
constexpr double kSteep = 0.5;                      // sine of the angle to the tangent from which a place lies across
constexpr std::size_t kNeighbours = 2;              // nothing is across that near; the tangent joins these
constexpr double kAveraged = 36.0;                  // of this share of the points, to either side

double least_across(const Polygon& ring, std::size_t i, double step, double greatest) {
    const std::size_t n = ring.size();
    const Point tangent = ring[(i + kNeighbours) % n] - ring[(i + n - kNeighbours) % n];
    const double steep = kSteep * length(tangent);
    double least = greatest;
    for (std::size_t on = kNeighbours + 1; on + kNeighbours < n; ++on) {
        const Point there = ring[(i + on) % n] - ring[i];
        const double height = cross(tangent, there);
        const double straight_squared = dot(there, there);
        if (height <= 0.0 || straight_squared >= least * least) continue;
        const double straight = std::sqrt(straight_squared);
        const double excess = step * static_cast<double>(std::min(on, n - on)) - kNotAcross * straight;
        if (excess <= 0.0) continue;
        const double farther = std::max(1.0, (kAcross - kNotAcross) * straight / excess);
        least = std::min(least, straight * farther * std::max(1.0, steep * straight / height));
    }
    return least;
}

}  // namespace

std::vector<double> thickness_along(const Polygon& ring, double greatest) {
    const std::size_t n = ring.size();
    const auto reach = static_cast<std::size_t>(std::lround(static_cast<double>(n) / kAveraged));
    const double step = perimeter(ring) / static_cast<double>(n);
    std::vector<double> across(n), averaged(n);
    for (std::size_t i = 0; i < n; ++i) across[i] = least_across(ring, i, step, greatest);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k <= 2 * reach; ++k) averaged[i] += across[(i + n - reach + k) % n];
        averaged[i] /= static_cast<double>(2 * reach + 1);
    }
    return averaged;
}

}  // namespace core
