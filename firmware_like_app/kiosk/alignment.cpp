#include "firmware_like_app/kiosk/alignment.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kMostMiss = 0.02;                     // of the screen's height: 6 mm of a 24-inch screen
constexpr double kLeastScale = 0.7, kMostScale = 1.4;  // what a used part of a tablet may differ from the whole
constexpr double kMostShear = 0.15;                    // 8 degrees
constexpr double kLeastSpread = 1e-4;                  // of the hits, squared shares

bool is_near_itself(const std::array<double, 6>& a) {
    const auto scale = [](double v) { return v >= kLeastScale && v <= kMostScale; };
    return scale(a[0]) && scale(a[4]) && std::abs(a[1]) <= kMostShear && std::abs(a[3]) <= kMostShear;
}

}  // namespace

core::Point cross_at(std::size_t index) {
    const auto share = [](std::size_t i) { return 0.1 + 0.4 * static_cast<double>(i); };
    return {share(index % 3), share(index / 3 % 3)};
}

AlignmentFit fit_alignment(const std::vector<CrossHit>& hits, double aspect) {
    AlignmentFit fit;
    fit.fault = AlignmentFit::Fault::Missed;
    if (hits.size() < 4) return fit;
    core::Point pen, cross;
    const double share = 1.0 / static_cast<double>(hits.size());
    for (const CrossHit& hit : hits) {
        pen = pen + hit.pen * share;
        cross = cross + hit.cross * share;
    }
    // about the centres, two numbers for each axis remain
    double xx = 0, xy = 0, yy = 0, x_to_x = 0, y_to_x = 0, x_to_y = 0, y_to_y = 0;
    for (const CrossHit& hit : hits) {
        const core::Point p = hit.pen - pen, c = hit.cross - cross;
        xx += p.x * p.x;
        xy += p.x * p.y;
        yy += p.y * p.y;
        x_to_x += p.x * c.x;
        y_to_x += p.y * c.x;
        x_to_y += p.x * c.y;
        y_to_y += p.y * c.y;
    }
    const double spread = xx * yy - xy * xy;
    if (spread < kLeastSpread) return fit;
    const double a = (x_to_x * yy - y_to_x * xy) / spread, b = (y_to_x * xx - x_to_x * xy) / spread;
    const double d = (x_to_y * yy - y_to_y * xy) / spread, e = (y_to_y * xx - x_to_y * xy) / spread;
    fit.align = {a, b, cross.x - a * pen.x - b * pen.y, d, e, cross.y - d * pen.x - e * pen.y};
    for (const CrossHit& hit : hits) {
        const double x = fit.align[0] * hit.pen.x + fit.align[1] * hit.pen.y + fit.align[2];
        const double y = fit.align[3] * hit.pen.x + fit.align[4] * hit.pen.y + fit.align[5];
        fit.worst = std::max(fit.worst, std::hypot((x - hit.cross.x) * aspect, y - hit.cross.y));
    }
    if (fit.worst > kMostMiss) return fit;
    fit.fault = is_near_itself(fit.align) ? AlignmentFit::Fault::None : AlignmentFit::Fault::FarOff;
    return fit;
}

}  // namespace app
