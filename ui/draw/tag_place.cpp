#include "ui/draw/tag_place.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/polygon.hpp"

namespace ui {

core::Point tag_place(const core::Polygon& ring) {
    const core::Point mean = core::centroid_of_points(ring);
    std::vector<double> crossings;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const core::Point p = ring[i], q = ring[(i + 1) % ring.size()];
        if ((p.y > mean.y) == (q.y > mean.y)) continue;
        crossings.push_back(p.x + (q.x - p.x) * (mean.y - p.y) / (q.y - p.y));
    }
    std::sort(crossings.begin(), crossings.end());
    core::Point place = mean;
    double widest = 0.0;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        if (crossings[i] <= mean.x && mean.x <= crossings[i + 1]) return mean;
        if (crossings[i + 1] - crossings[i] <= widest) continue;
        widest = crossings[i + 1] - crossings[i];
        place.x = (crossings[i] + crossings[i + 1]) / 2.0;
    }
    return place;
}

void spread_tags(std::vector<core::Point>& places, double apart) {
    constexpr int kPasses = 60;
    bool moved = true;
    for (int pass = 0; pass < kPasses && moved; ++pass) {
        moved = false;
        for (std::size_t i = 0; i < places.size(); ++i) {
            for (std::size_t j = i + 1; j < places.size(); ++j) {
                core::Point way = places[j] - places[i];
                const double distance = std::hypot(way.x, way.y);
                if (distance >= apart - 1e-6) continue;
                way = distance > 1e-6 ? way * (1 / distance) : core::Point{1, 0};
                const core::Point step = way * ((apart - distance) / 2);
                places[i] = places[i] - step;
                places[j] = places[j] + step;
                moved = true;
            }
        }
    }
}

}  // namespace ui
