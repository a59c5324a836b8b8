#include "core/skeleton/corners.hpp"

#include "core/geometry/polygon.hpp"

namespace core {

std::vector<double> cornerity(const Polygon& contour, int window) {
    const int n = static_cast<int>(contour.size());
    const int half = window / 2;
    std::vector<double> value(contour.size());
    for (int i = 0; i < n; ++i) {
        const Point before = contour[static_cast<std::size_t>(((i - half) % n + n) % n)];
        const Point here = contour[static_cast<std::size_t>(i)];
        const Point after = contour[static_cast<std::size_t>((i + half) % n)];
        // The centroid minus the point itself, summed as differences so that the place of the shape does not matter.
        value[static_cast<std::size_t>(i)] = length(((before - here) + (after - here)) * (1.0 / 3.0));
    }
    return value;
}

namespace {

/// Cornerity differences below this share of the largest one are the noise of rounding, not of shape.
constexpr double kTie = 1e-9;

}  // namespace

std::vector<int> corners(const std::vector<double>& cornerity, int window, double extent) {
    const int n = static_cast<int>(cornerity.size());
    const int half = window / 2;
    double largest = 0.0;
    for (const double c : cornerity) largest = std::max(largest, c);
    const double tie = largest * kTie;
    std::vector<int> found;
    for (int i = 0; i < n; ++i) {
        const double here = cornerity[static_cast<std::size_t>(i)];
        int less = 0;
        bool is_maximum = true;
        for (int k = 1; k <= half && is_maximum; ++k) {
            const double before = cornerity[static_cast<std::size_t>(((i - k) % n + n) % n)];
            const double after = cornerity[static_cast<std::size_t>((i + k) % n)];
            less += (before < here - tie ? 1 : 0) + (after < here - tie ? 1 : 0);
            // On a plateau its first point stands for all.
            is_maximum = before < here - tie && after <= here + tie;
        }
        if (is_maximum && less > extent * window) found.push_back(i);
    }
    return found;
}

}  // namespace core
