#include "core/garment/desk/network_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace core {

std::vector<LineUse> way_along(const Network& network, int layer, int from, int to,
                               const std::function<bool(const NetworkLine&)>& may_take) {  // Dijkstra 1959
    std::map<int, double> reached{{from, 0.0}};
    std::map<int, LineUse> by;
    std::set<std::pair<double, int>> open{{0.0, from}};
    while (!open.empty()) {
        const auto [far, at] = *open.begin();
        open.erase(open.begin());
        if (at == to) break;
        for (std::size_t i = 0; i < network.lines().size(); ++i) {
            const NetworkLine& line = network.lines()[i];
            const auto number = static_cast<int>(i);
            if (!line.alive || line.layer != layer || !may_take(line)) continue;
            if (line.from != at && line.to != at) continue;
            const bool reversed = line.from != at;
            const int next = reversed ? line.from : line.to;
            const double there = far + line_length(line.shape);
            const auto known = reached.find(next);
            if (known != reached.end() && known->second <= there) continue;
            if (known != reached.end()) open.erase({known->second, next});
            reached[next] = there;
            by[next] = {number, reversed};
            open.insert({there, next});
        }
    }
    std::vector<LineUse> way;
    for (int at = to; at != from;) {
        const auto step = by.find(at);
        if (step == by.end()) return {};
        way.push_back(step->second);
        const NetworkLine& line = network.lines()[static_cast<std::size_t>(step->second.line)];
        at = step->second.reversed ? line.to : line.from;
    }
    std::reverse(way.begin(), way.end());
    return way;
}

std::optional<std::vector<LineUse>> ring_with_line(const Network& network, int layer, const std::string& name) {
    std::vector<LineUse> ring;
    int from = -1, to = -1;
    for (std::size_t i = 0; i < network.lines().size(); ++i) {
        const NetworkLine& line = network.lines()[i];
        if (!line.alive || line.layer != layer || line.name != name) continue;
        if (from < 0) from = line.from;
        to = line.to;
        ring.push_back({static_cast<int>(i), false});
    }
    if (from < 0 || from == to) return std::nullopt;
    const std::vector<LineUse> back =
        way_along(network, layer, to, from, [&](const NetworkLine& line) { return line.name != name; });
    if (back.empty()) return std::nullopt;
    ring.insert(ring.end(), back.begin(), back.end());
    return ring;
}

namespace {

constexpr double kApart_cm = 1.5;
constexpr double kSamePlace_cm = 0.1;  // crossings nearer than this are one

/// Where the segments p q and r s cross when seen along `out`: how far along each.
std::optional<std::pair<double, double>> crossing_of(Vec3 p, Vec3 q, Vec3 r, Vec3 s, Vec3 out) {
    const Vec3 a = q - p, b = s - r, from = r - p;
    const double det = dot(out, cross(a, b));
    if (std::abs(det) < 1e-9) return std::nullopt;
    const double t = dot(out, cross(from, b)) / det, u = dot(out, cross(from, a)) / det;
    if (t < 0.0 || t > 1.0 || u < 0.0 || u > 1.0) return std::nullopt;
    if (std::abs(dot(out, p + a * t - r - b * u)) > kApart_cm) return std::nullopt;
    return std::pair{t, u};
}

/// Whether a place lies near a vertex that both lines have: there they meet already.
bool meet_there(const Network& network, int line, int other, Vec3 place) {
    const NetworkLine &a = network.lines()[static_cast<std::size_t>(line)],
                      &b = network.lines()[static_cast<std::size_t>(other)];
    for (const int v : {a.from, a.to})
        if ((v == b.from || v == b.to) &&
            length(network.vertices()[static_cast<std::size_t>(v)].place - place) < network.options().snap_cm)
            return true;
    return false;
}

std::optional<LineCrossing> crossing_with(const Network& network, int line, int other, const Obstacle& body,
                                          const std::vector<Vec3>& refused) {
    const SpaceLine &own = network.lines()[static_cast<std::size_t>(line)].shape,
                    &shape = network.lines()[static_cast<std::size_t>(other)].shape;
    constexpr std::size_t kApart = 8;  // segments of one line that cannot cross
    for (std::size_t i = 0; i + 1 < own.size(); ++i) {
        std::optional<Vec3> out;
        const double reach = 2.0 * kApart_cm + length(own[i + 1] - own[i]);
        for (std::size_t k = line == other ? i + kApart : 0; k + 1 < shape.size(); ++k) {
            if (length(shape[k] - own[i]) > reach + length(shape[k + 1] - shape[k])) continue;
            if (!out) out = normalised(body.sample(own[i]).gradient);
            const auto met = crossing_of(own[i], own[i + 1], shape[k], shape[k + 1], *out);
            if (!met) continue;
            const Vec3 at = own[i] + (own[i + 1] - own[i]) * met->first,
                       to = shape[k] + (shape[k + 1] - shape[k]) * met->second;
            const bool known = std::any_of(refused.begin(), refused.end(),
                                           [&](Vec3 place) { return length(place - at) < kSamePlace_cm; });
            if (!known && !meet_there(network, line, other, at)) return LineCrossing{line, other, at, to};
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<LineCrossing> first_crossing(const Network& network, int layer, const std::string& name,
                                           const Obstacle& body, const std::vector<Vec3>& refused) {
    const auto count = static_cast<int>(network.lines().size());
    for (int i = 0; i < count; ++i) {
        const NetworkLine& line = network.lines()[static_cast<std::size_t>(i)];
        if (!line.alive || line.layer != layer || line.name != name) continue;
        for (int k = 0; k < count; ++k) {
            const NetworkLine& other = network.lines()[static_cast<std::size_t>(k)];
            if (!other.alive || other.layer != layer) continue;
            if (std::optional<LineCrossing> found = crossing_with(network, i, k, body, refused); found) return found;
        }
    }
    return std::nullopt;
}

SpaceLine stretch_between(const SpaceLine& line, Vec3 from, Vec3 to) {
    double a = nearest_on_line(line, from).along, b = nearest_on_line(line, to).along;
    if (a > b) std::swap(a, b);
    SpaceLine out{place_along(line, a)};
    double passed = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        passed += length(line[i + 1] - line[i]);
        if (passed > a && passed < b) out.push_back(line[i + 1]);
    }
    out.push_back(place_along(line, b));
    return out;
}

const NetworkRegion* region_at_corner(const Network& network, int layer, const Pick& vertex, const Pick& line,
                                      const Pick& region) {
    const auto passes = [&](const NetworkRegion& candidate) {
        return std::any_of(candidate.ring.begin(), candidate.ring.end(), [&](LineUse use) {
            const NetworkLine& own = network.lines()[static_cast<std::size_t>(use.line)];
            return vertex.kind == Pick::Kind::Vertex ? own.from == vertex.index || own.to == vertex.index
                                                     : use.line == line.index;
        });
    };
    if (vertex.kind == Pick::Kind::None && line.kind == Pick::Kind::None) return nullptr;
    if (const NetworkRegion* under = network.find_region(region.name); under != nullptr && passes(*under)) return under;
    for (const NetworkRegion& other : network.regions())
        if (other.alive && other.layer == layer && passes(other)) return &other;
    return nullptr;
}

}  // namespace core
