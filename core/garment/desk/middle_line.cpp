#include "core/garment/desk/middle_line.hpp"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr double kSided = 0.35;  // share of the way out that must lead forward or back
constexpr double kLeastOff_cm = 0.5, kMostOff_cm = 1.5;
constexpr int kPushes = 6;

}  // namespace

bool is_one_side(const Obstacle& body, Vec3 a, Vec3 b) {
    const double front_a = normalised(body.sample(a).gradient).z, front_b = normalised(body.sample(b).gradient).z;
    if (std::abs(front_a) < kSided || std::abs(front_b) < kSided) return true;
    return (front_a > 0.0) == (front_b > 0.0);
}

SketchStroke middle_stroke(const Obstacle& body, Vec3 from, Vec3 to) {
    const int steps = std::max(2, static_cast<int>(std::lround(length(to - from))));
    const double off = std::clamp(std::min(body.distance(from), body.distance(to)), kLeastOff_cm, kMostOff_cm);
    StrokePart part;
    part.view = *named_view("left");
    part.tool = {DrawingTool::Kind::PlaneYZ, 0.0};
    for (int k = 0; k <= steps; ++k) {
        Vec3 place = from + (to - from) * (static_cast<double>(k) / steps);
        for (int push = 0; push < kPushes && k > 0 && k < steps; ++push) {
            const FieldSample at = body.sample(place);
            if (at.distance >= off) break;
            const Vec3 out = normalised({0.0, at.gradient.y, at.gradient.z});
            place = place + out * (off - at.distance);
        }
        part.points.push_back(part.view.project({0.0, place.y, place.z}));
    }
    return {std::move(part)};
}

bool runs_along(const Network& network, int layer, const std::string& name, const SpaceLine& shape,
                const Obstacle& body) {
    const double reach = network.options().snap_cm;
    double low = 1e9, high = -1e9;
    Vec3 some;
    for (const NetworkLine& line : network.lines()) {
        if (!line.alive || line.layer != layer || line.name != name) continue;
        for (const Vec3& p : line.shape) {
            if (std::abs(p.x) > reach) return false;
            low = std::min(low, p.y);
            high = std::max(high, p.y);
        }
        some = line.shape[line.shape.size() / 2];
    }
    for (const Vec3& end : {shape.front(), shape.back()})
        if (end.y < low - reach || end.y > high + reach) return false;
    return low < high && is_one_side(body, some, shape[shape.size() / 2]);
}

}  // namespace core
