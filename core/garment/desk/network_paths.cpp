#include "core/garment/desk/network_paths.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace core {
namespace {

/// From one vertex to another along lines that are not `without`; empty when there is no way (Dijkstra 1959).
std::vector<LineUse> shortest_way(const Network& network, int layer, int from, int to, const std::set<int>& without) {
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
            if (!line.alive || line.layer != layer || without.count(number) != 0) continue;
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

}  // namespace

std::optional<std::vector<LineUse>> ring_with_line(const Network& network, int layer, const std::string& name) {
    std::vector<LineUse> ring;
    std::set<int> own;
    int from = -1, to = -1;
    for (std::size_t i = 0; i < network.lines().size(); ++i) {
        const NetworkLine& line = network.lines()[i];
        if (!line.alive || line.layer != layer || line.name != name) continue;
        if (from < 0) from = line.from;
        to = line.to;
        own.insert(static_cast<int>(i));
        ring.push_back({static_cast<int>(i), false});
    }
    if (from < 0 || from == to) return std::nullopt;
    const std::vector<LineUse> back = shortest_way(network, layer, to, from, own);
    if (back.empty()) return std::nullopt;
    ring.insert(ring.end(), back.begin(), back.end());
    return ring;
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
