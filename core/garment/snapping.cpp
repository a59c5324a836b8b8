#include "core/garment/snapping.hpp"

#include <cmath>

namespace core {

SnapTarget snap_target(const Network& network, int layer, const std::vector<Landmark>& landmarks, Vec3 place,
                       double reach, bool to_middle) {
    using Kind = SnapTarget::Kind;
    SnapTarget target{Kind::None, place, {}};
    double least = reach;
    for (const NetworkVertex& v : network.vertices())
        if (const double d = length(v.place - place); v.alive && v.layer == layer && d < least)
            least = d, target = {Kind::Vertex, v.place, {}};
    if (target.kind != Kind::None) return target;
    for (const Landmark& l : landmarks)
        if (const double d = length(l.place - place); d < least) least = d, target = {Kind::Landmark, l.place, l.name};
    if (target.kind != Kind::None) return target;
    for (const NetworkLine& line : network.lines()) {
        if (!line.alive || line.layer != layer) continue;
        if (const NearestOnLine near = nearest_on_line(line.shape, place); near.distance < least)
            least = near.distance, target = {Kind::Line, near.place, line.name};
    }
    if (target.kind != Kind::None) return target;
    if (to_middle && std::abs(place.x) < reach) target = {Kind::Middle, {0.0, place.y, place.z}, {}};
    return target;
}

}  // namespace core
