#include "core/garment/desk/pick.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace core {
namespace {

/// Candidates in turn: nearer to the pen by a step of the reach, then in front.
struct Nearest {
    double step;
    int rank = std::numeric_limits<int>::max();
    double depth = 0.0;

    explicit Nearest(double reach) : step(0.1 * reach) {}
    bool take(double away, double in_front) {
        const int own = static_cast<int>(away / step);
        if (std::tie(rank, depth) <= std::make_tuple(own, -in_front)) return false;
        rank = own;
        depth = -in_front;
        return true;
    }
};

}  // namespace

Pick pick_vertex(const Network& network, int layer, const DrawingView& view, Point at, double reach_cm) {
    Pick pick;
    Nearest nearest(reach_cm);
    for (std::size_t v = 0; v < network.vertices().size(); ++v) {
        const NetworkVertex& vertex = network.vertices()[v];
        if (!vertex.alive || vertex.layer != layer) continue;
        const double away = distance(view.project(vertex.place), at);
        if (!(away <= reach_cm) || !nearest.take(away, view.depth(vertex.place))) continue;
        pick = {Pick::Kind::Vertex, static_cast<int>(v), {}, vertex.place, layer};
    }
    return pick;
}

Pick pick_line(const Network& network, int layer, const DrawingView& view, Point at, double reach_cm) {
    Pick pick;
    Nearest nearest(reach_cm);
    for (std::size_t i = 0; i < network.lines().size(); ++i) {
        const NetworkLine& line = network.lines()[i];
        if (!line.alive || line.layer != layer) continue;
        for (std::size_t k = 0; k + 1 < line.shape.size(); ++k) {
            const Point a = view.project(line.shape[k]), ab = view.project(line.shape[k + 1]) - a;
            const double square = dot(ab, ab);
            const double t = square > 0.0 ? std::clamp(dot(at - a, ab) / square, 0.0, 1.0) : 0.0;
            const double away = distance(a + ab * t, at);
            if (!(away <= reach_cm)) continue;
            const Vec3 place = line.shape[k] + (line.shape[k + 1] - line.shape[k]) * t;
            if (nearest.take(away, view.depth(place))) pick = {Pick::Kind::Line, static_cast<int>(i), {}, place, layer};
        }
    }
    if (pick.index >= 0) pick.name = network.piece_name(pick.index);
    return pick;
}

SpaceLine ring_line(const Network& network, const std::vector<LineUse>& ring) {
    SpaceLine out;
    for (const LineUse use : ring) {
        SpaceLine shape = network.lines()[static_cast<std::size_t>(use.line)].shape;
        if (use.reversed) std::reverse(shape.begin(), shape.end());
        out.insert(out.end(), shape.begin(), shape.end() - 1);
    }
    return out;
}

SeenOutline see_outline(const SpaceLine& ring, const DrawingView& view, Point at) {
    SeenOutline seen;
    double area = 0.0, weights = 0.0, depths = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = view.project(ring[i]), b = view.project(ring[(i + 1) % ring.size()]);
        area += cross(a, b);
        if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x))
            seen.around = !seen.around;
        const double away = distance(a, at), weight = 1.0 / (1e-6 + away * away);
        weights += weight;
        depths += weight * view.depth(ring[i]);
    }
    seen.outside = area > 0.0;
    seen.depth = weights > 0.0 ? depths / weights : 0.0;
    return seen;
}

Pick pick_region(const Network& network, int layer, const DrawingView& view, Point at, bool mirror) {
    Pick pick;
    SeenOutline best;
    for (std::size_t r = 0; r < network.regions().size(); ++r) {
        const NetworkRegion& region = network.regions()[r];
        if (!region.alive || region.layer != layer) continue;
        SpaceLine ring = ring_line(network, region.ring);
        for (const bool image : {false, true}) {
            if (image && !mirror) break;
            if (image) {
                for (Vec3& p : ring) p.x = -p.x;
                std::reverse(ring.begin(), ring.end());
            }
            const SeenOutline seen = see_outline(ring, view, at);
            if (!seen.around) continue;
            if (pick.index >= 0 &&
                std::make_tuple(seen.outside, seen.depth) <= std::make_tuple(best.outside, best.depth))
                continue;
            best = seen;
            const DrawingView::Ray ray = view.ray(at);
            const Vec3 on_plane = ray.origin;  // moved along the ray to the outline's depth
            const double away = dot(on_plane - view.centre, view.toward) - seen.depth;
            const double along = away / std::max(1e-9, -dot(ray.direction, view.toward));
            pick = {Pick::Kind::Region, static_cast<int>(r), region.name, ray.origin + ray.direction * along, layer};
        }
    }
    return pick;
}

}  // namespace core
