#include "core/geometry/point_grid.hpp"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

bool fits(double low, double high, int exponent, std::int64_t most_steps) {
    const double first = grid_line(low, exponent);
    const double last = grid_line(high, exponent);
    const auto farthest = static_cast<double>(kFarthestGridLine);
    return first >= -farthest && last <= farthest && last - first <= static_cast<double>(most_steps);
}

}  // namespace

double grid_line(double value, int exponent) {
    return std::round(std::ldexp(value, -exponent));
}

Point on_grid(Point p, int exponent) {
    return {std::ldexp(grid_line(p.x, exponent), exponent), std::ldexp(grid_line(p.y, exponent), exponent)};
}

int finest_grid(const std::vector<Point>& points, std::int64_t most_steps) {
    if (points.empty()) return kFinestGrid;
    Point low = points.front(), high = points.front();
    for (const Point& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    int exponent = kFinestGrid;
    while (exponent < kCoarsestGrid &&
           !(fits(low.x, high.x, exponent, most_steps) && fits(low.y, high.y, exponent, most_steps))) {
        ++exponent;
    }
    return exponent;
}

}  // namespace core
