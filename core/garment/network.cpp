#include "core/garment/network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "core/mesh/mesh_welder.hpp"

namespace core {
namespace {

constexpr std::size_t kFewestCorners = 2;
constexpr double kHandSpacing_cm = 0.5;  // of a line's shape
/// What splits a line: folds are drawn as waves, which turn as far but not as fast.
constexpr double kPlainCorner_rad = 1.1;  // a corner however near the next one is
constexpr double kSharpTurn_rad = 0.9, kSharpReach_cm = 1.25;
constexpr int kSmoothingPasses = 60;

Unexpected bad(std::string what) {
    return unexpected(ErrorCode::BadArgument, std::move(what));
}
Unexpected bad_outline(std::string what) {
    return unexpected(ErrorCode::BadOutline, std::move(what));
}
std::string in_quotes(const std::string& name) {
    return "\"" + name + "\"";
}

Vec3 newell(const SpaceLine& ring) {
    Vec3 sum;
    for (std::size_t i = 0; i < ring.size(); ++i) sum = sum + cross(ring[i], ring[(i + 1) % ring.size()]);
    return sum;
}

}  // namespace

int Network::edge_count(const NetworkLine& line) const {
    return 2 * std::max(1, static_cast<int>(std::lround(line_length(line.shape) / (2.0 * options_.edge_cm))));
}

int Network::add_vertex(Vec3 place) {
    vertices_.push_back({place, layer_, true});
    return static_cast<int>(vertices_.size()) - 1;
}

int Network::nearest_vertex(Vec3 place, double reach) const {
    int best = -1;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
        const double distance = length(vertices_[v].place - place);
        if (!vertices_[v].alive || vertices_[v].layer != layer_ || distance > reach) continue;
        reach = std::nextafter(distance, 0.0);  // the first of equally near ones stays
        best = static_cast<int>(v);
    }
    return best;
}

/// Splits a line into two of its name; regions that pass it pass both. Returns the new vertex.
int Network::split_at(int line, double along) {
    const NetworkLine whole = lines_[static_cast<std::size_t>(line)];
    SplitLine halves = split_line(whole.shape, along);
    const int middle = add_vertex(halves.after.front());
    const int second = static_cast<int>(lines_.size());
    lines_[static_cast<std::size_t>(line)].shape = std::move(halves.before);
    lines_[static_cast<std::size_t>(line)].to = middle;
    lines_.push_back({whole.name, middle, whole.to, std::move(halves.after), whole.layer, true});
    vertices_.back().layer = whole.layer;
    for (NetworkRegion& region : regions_)
        for (std::size_t i = 0; i < region.ring.size(); ++i) {
            if (region.ring[i].line != line) continue;
            const bool reversed = region.ring[i].reversed;
            region.ring.insert(region.ring.begin() + static_cast<std::ptrdiff_t>(i) + (reversed ? 0 : 1),
                               {second, reversed});
            ++i;
        }
    return middle;
}

/// The vertex that an end drawn here belongs to: one near by, a new one in the middle of a line near by, or a new one.
int Network::vertex_for_end(Vec3 place) {
    const int near = nearest_vertex(place, options_.snap_cm);
    if (near >= 0) return near;
    int best = -1;
    NearestOnLine nearest{0.0, options_.snap_cm, {}};
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (!lines_[i].alive || lines_[i].layer != layer_) continue;
        const NearestOnLine here = nearest_on_line(lines_[i].shape, place);
        if (here.distance < nearest.distance) nearest = here, best = static_cast<int>(i);
    }
    return best >= 0 ? split_at(best, nearest.along) : add_vertex(place);
}

void Network::link(const std::string& name, int from, int to, SpaceLine shape) {
    pull_ends(shape, vertices_[static_cast<std::size_t>(from)].place, vertices_[static_cast<std::size_t>(to)].place);
    lines_.push_back({name, from, to, std::move(shape), layer_, true});
}

Result<void> Network::add_line(const std::string& name, SpaceLine points, bool to_middle) {
    if (name.empty()) return bad("A line needs a name.");
    for (const Vec3& p : points)
        if (!is_usable(p)) return bad("The line " + in_quotes(name) + " has a coordinate that is no finite number.");
    if (points.size() < 2 || line_length(points) < 0.5 * options_.edge_cm)
        return bad("The line " + in_quotes(name) + " is too short: draw it longer.");
    for (Vec3* end : {&points.front(), &points.back()})
        if (to_middle && std::abs(end->x) < options_.snap_cm) end->x = 0.0;
    const bool closed =
        length(points.front() - points.back()) < options_.snap_cm && line_length(points) > 4.0 * options_.snap_cm;
    SpaceLine shape =
        resampled(points, std::max(2, static_cast<int>(std::lround(line_length(points) / kHandSpacing_cm))));
    std::vector<double> breaks = sharp_turns(shape, kSharpTurn_rad, kSharpReach_cm);
    const double total = line_length(shape);
    if (closed && breaks.empty()) breaks = {total / 2.0};
    const int first = vertex_for_end(shape.front());
    const int last = closed ? first : vertex_for_end(shape.back());
    if (first == last && breaks.empty())
        return bad("The line " + in_quotes(name) + " ends where it starts: draw it longer, or closed.");
    int from = first;
    double passed = 0.0;
    for (const double at : breaks) {
        SplitLine halves = split_line(shape, at - passed);
        const int middle = add_vertex(halves.before.back());
        link(name, from, middle, std::move(halves.before));
        shape = std::move(halves.after);
        passed = at;
        from = middle;
    }
    link(name, from, last, std::move(shape));
    return {};
}

int Network::start_of(LineUse use) const {
    const NetworkLine& line = lines_[static_cast<std::size_t>(use.line)];
    return use.reversed ? line.to : line.from;
}

SpaceLine Network::shape_of(LineUse use) const {
    SpaceLine shape = lines_[static_cast<std::size_t>(use.line)].shape;
    if (use.reversed) std::reverse(shape.begin(), shape.end());
    return shape;
}

/// The living lines of the layer with this name, in order; of "hem/2" the second of "hem".
std::vector<int> Network::pieces_of(const std::string& name) const {
    const auto named = [&](const std::string& whole) {
        std::vector<int> found;
        for (std::size_t i = 0; i < lines_.size(); ++i)
            if (lines_[i].alive && lines_[i].layer == layer_ && lines_[i].name == whole)
                found.push_back(static_cast<int>(i));
        return found;
    };
    const std::size_t slash = name.rfind('/');
    std::vector<int> found = named(name);
    if (!found.empty() || slash == std::string::npos || slash + 1 == name.size() || name.size() - slash > 5)
        return found;
    std::size_t number = 0;
    for (std::size_t i = slash + 1; i < name.size(); ++i) {
        if (name[i] < '0' || name[i] > '9') return {};
        number = 10 * number + static_cast<std::size_t>(name[i] - '0');
    }
    found = named(name.substr(0, slash));
    if (number < 1 || number > found.size()) return {};
    return {found[number - 1]};
}

int Network::line_named(const std::string& piece) const {
    const std::vector<int> found = pieces_of(piece);
    return found.size() == 1 ? found.front() : -1;
}

std::string Network::piece_name(int line) const {
    const NetworkLine& own = lines_[static_cast<std::size_t>(line)];
    std::size_t number = 0, count = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (!lines_[i].alive || lines_[i].layer != own.layer || lines_[i].name != own.name) continue;
        ++count;
        if (static_cast<int>(i) == line) number = count;
    }
    return count > 1 ? own.name + "/" + std::to_string(number) : own.name;
}

/// One ring of the lines with these names. Starts with the first name's first line, in its own direction.
Result<std::vector<LineUse>> Network::ring_of(const std::string& region, const std::vector<std::string>& names) const {
    std::vector<int> candidates;
    for (const std::string& name : names) {
        const std::vector<int> pieces = pieces_of(name);
        candidates.insert(candidates.end(), pieces.begin(), pieces.end());
        if (pieces.empty())
            return bad_outline("The region " + in_quotes(region) + " names the line " + in_quotes(name) +
                               ", which does not exist.");
    }
    const auto line = [&](int i) -> const NetworkLine& { return lines_[static_cast<std::size_t>(i)]; };
    std::map<int, int> degree;
    for (const int i : candidates) ++degree[line(i).from], ++degree[line(i).to];
    std::string loose;
    for (bool changed = true; changed;) {  // pieces that lead nowhere
        changed = false;
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            const NetworkLine& l = line(candidates[k]);
            if (degree[l.from] != 1 && degree[l.to] != 1) continue;
            if (loose.empty()) loose = l.name;
            --degree[l.from], --degree[l.to];
            candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(k));
            changed = true;
            break;
        }
    }
    if (candidates.empty())
        return bad_outline("The region " + in_quotes(region) + " is not closed: the line " + in_quotes(loose) +
                           " has an end that meets no other of its lines.");
    std::vector<LineUse> ring{{candidates.front(), false}};
    std::set<int> used{candidates.front()};
    const int start = line(candidates.front()).from;
    for (int at = line(candidates.front()).to; at != start;) {
        const auto next = std::find_if(candidates.begin(), candidates.end(), [&](int i) {
            return used.count(i) == 0 && (line(i).from == at || line(i).to == at);
        });
        if (next == candidates.end() || degree[at] != 2)
            return bad_outline("The lines of the region " + in_quotes(region) +
                               " make no simple ring: at an end of the line " + in_quotes(line(ring.back().line).name) +
                               " meet " + std::to_string(degree[at]) + " of them.");
        ring.push_back({*next, line(*next).from != at});
        used.insert(*next);
        at = ring.back().reversed ? line(*next).from : line(*next).to;
    }
    if (used.size() != candidates.size())
        return bad_outline("The lines of the region " + in_quotes(region) + " make more than one ring.");
    return ring;
}

Vec3 Network::ring_normal(const std::vector<LineUse>& ring) const {
    SpaceLine points;
    for (const LineUse use : ring) {
        const SpaceLine shape = shape_of(use);
        points.insert(points.end(), shape.begin(), shape.end() - 1);
    }
    return newell(points);
}

void Network::turn_outward(std::vector<LineUse>& ring, const Obstacle& body) const {
    Vec3 away, middle;
    double count = 0.0;
    for (const LineUse use : ring)
        for (const Vec3& p : resampled(shape_of(use), 8)) {
            away = away + body.sample(p).gradient;
            middle = middle + p;
            count += 1.0;
        }
    away = away * (1.0 / count) + body.sample(middle * (1.0 / count)).gradient * 2.0;
    if (dot(away, ring_normal(ring)) >= 0.0) return;
    std::reverse(ring.begin(), ring.end());
    for (LineUse& use : ring) use.reversed = !use.reversed;
}

/// Where the ring turns, of two slight turns near each other the sharper. At least two: without, the sharpest turns
/// there are, four if it has as many vertices.
std::set<int> Network::detected_corners(const std::vector<LineUse>& ring) const {
    struct Turn {
        double angle, along;
        int vertex;
    };
    std::vector<Turn> turns;
    double total = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        SpaceLine before = shape_of(ring[(i + ring.size() - 1) % ring.size()]);
        const SpaceLine after = shape_of(ring[i]);
        std::reverse(before.begin(), before.end());
        const double reach = options_.edge_cm;
        const Vec3 in = normalised(before.front() - place_along(before, reach));
        const Vec3 on = normalised(place_along(after, reach) - after.front());
        turns.push_back({std::acos(std::clamp(dot(in, on), -1.0, 1.0)), total, start_of(ring[i])});
        total += line_length(after);
    }
    std::stable_sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.angle > b.angle; });
    std::vector<Turn> chosen;
    const double apart = std::min(2.5 * options_.edge_cm, total / 8.0);
    for (const Turn& turn : turns) {
        if (turn.angle <= options_.corner_rad || chosen.size() == kMostSides) break;
        const bool near = std::any_of(chosen.begin(), chosen.end(), [&](const Turn& other) {
            const double gap = std::abs(turn.along - other.along);
            return std::min(gap, total - gap) < apart;
        });
        if (!near || turn.angle > kPlainCorner_rad) chosen.push_back(turn);
    }
    if (chosen.size() < kFewestCorners)
        chosen.assign(turns.begin(),
                      turns.begin() + std::min<std::ptrdiff_t>(4, static_cast<std::ptrdiff_t>(turns.size())));
    std::set<int> corners;
    for (const Turn& turn : chosen) corners.insert(turn.vertex);
    return corners;
}

Result<void> Network::add_region(const std::string& name, const std::vector<std::string>& lines, const Obstacle* body) {
    if (name.empty() || find_region(name) != nullptr)
        return bad("A region needs a name that no other has; " + in_quotes(name) + " is none.");
    Result<std::vector<LineUse>> ring = ring_of(name, lines);
    if (!ring) return unexpected(ring.error());
    if (body != nullptr) turn_outward(*ring, *body);
    if (ring->size() < kFewestCorners) {  // one closed line: a vertex on its far side makes two
        const NetworkLine& line = lines_[static_cast<std::size_t>((*ring)[0].line)];
        const int before = static_cast<int>(lines_.size());
        const bool reversed = (*ring)[0].reversed;
        (void)split_at((*ring)[0].line, 0.5 * line_length(line.shape));
        ring->insert(reversed ? ring->begin() : ring->end(), {before, reversed});
    }
    NetworkRegion region{name, std::move(*ring), {}, kCoonsAlpha, layer_, true, 0};
    region.corners = detected_corners(region.ring);
    regions_.push_back(std::move(region));
    return {};
}

/// The vertex of a region's ring at the place nearest to `place`; the ring is split there if it is in the middle of a
/// line.
int Network::vertex_on_ring(const NetworkRegion& region, Vec3 place) {
    int best = 0;
    NearestOnLine nearest{0.0, std::numeric_limits<double>::max(), {}};
    for (const LineUse use : region.ring) {
        const NearestOnLine here = nearest_on_line(lines_[static_cast<std::size_t>(use.line)].shape, place);
        if (here.distance < nearest.distance) nearest = here, best = use.line;
    }
    const NetworkLine& line = lines_[static_cast<std::size_t>(best)];
    const double total = line_length(line.shape), near = std::min(options_.snap_cm, 0.4 * total);
    if (nearest.along < near) return line.from;
    if (nearest.along > total - near) return line.to;
    return split_at(best, nearest.along);
}

NetworkRegion* Network::region_named(const std::string& name) {
    for (NetworkRegion& region : regions_)
        if (region.alive && region.name == name) return &region;
    return nullptr;
}

const NetworkRegion* Network::find_region(const std::string& name) const {
    return const_cast<Network*>(this)->region_named(name);  // NOLINT: reads only
}

namespace {

/// Corners of a part of a region: those that the region had, and at `fresh` vertices what was found.
std::set<int> kept_corners(const std::set<int>& found, const std::vector<int>& ring, const std::set<int>& old,
                           const std::set<int>& fresh) {
    std::set<int> kept;
    for (const int vertex : ring)
        if ((fresh.count(vertex) != 0 ? found : old).count(vertex) != 0) kept.insert(vertex);
    return kept.size() < kFewestCorners || kept.size() > static_cast<std::size_t>(kMostSides) ? found : kept;
}

}  // namespace

/// Parts a ring along lines that lead from its vertex `from` to its vertex `to`.
Result<void> Network::part_ring(int index, const std::vector<int>& lines, int from, int to,
                                const std::string& new_name) {
    NetworkRegion& region = regions_[static_cast<std::size_t>(index)];
    std::vector<LineUse> left, right;  // of the cut, seen from the outer side
    std::vector<LineUse> ring = region.ring;
    const auto start = std::find_if(ring.begin(), ring.end(), [&](LineUse u) { return start_of(u) == to; });
    std::rotate(ring.begin(), start, ring.end());
    bool second = false;
    for (const LineUse use : ring) {
        second = second || start_of(use) == from;
        (second ? right : left).push_back(use);
    }
    for (const int line : lines) left.push_back({line, false});
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) right.push_back({*line, true});
    NetworkRegion other{new_name, right, {}, region.alpha, region.layer, true, region.parts};
    const std::set<int> old = region.corners;
    const auto corners = [&](const std::vector<LineUse>& part) {
        std::vector<int> passed;
        for (const LineUse use : part) passed.push_back(start_of(use));
        return kept_corners(detected_corners(part), passed, old, {from, to});
    };
    region.ring = left;
    region.corners = corners(left);
    other.corners = corners(right);
    regions_.push_back(std::move(other));
    return {};
}

Result<void> Network::cut(const std::string& name, SpaceLine points, const std::string& new_name) {
    NetworkRegion* region = region_named(name);
    if (region == nullptr) return bad("There is no region " + in_quotes(name) + " to cut.");
    if (new_name.empty() || find_region(new_name) != nullptr)
        return bad("The second half of " + in_quotes(name) + " needs a name that no other region has.");
    if (points.size() < 2) return bad("The cut through " + in_quotes(name) + " has fewer than two points.");
    const auto index = static_cast<int>(region - regions_.data());
    const int from = vertex_on_ring(*region, points.front());
    const int to = vertex_on_ring(regions_[static_cast<std::size_t>(index)], points.back());
    if (from == to) return bad("The cut through " + in_quotes(name) + " starts and ends at one place of its edge.");
    const int line = static_cast<int>(lines_.size());
    link(new_name + " cut", from, to,
         resampled(points, std::max(2, static_cast<int>(std::lround(line_length(points) / kHandSpacing_cm)))));
    return part_ring(index, {line}, from, to, new_name);
}

Result<void> Network::cut_hole(const std::string& name, SpaceLine loop, const std::string& new_name) {
    NetworkRegion* region = region_named(name);
    if (region == nullptr) return bad("There is no region " + in_quotes(name) + " to cut a hole into.");
    if (new_name.empty() || find_region(new_name) != nullptr)
        return bad("The second half of " + in_quotes(name) + " needs a name that no other region has.");
    if (loop.size() < 4 || line_length(loop) < 2.0 * options_.edge_cm)
        return bad("The hole in " + in_quotes(name) + " is too small: draw it larger.");
    if (length(loop.front() - loop.back()) > 1e-9) loop.push_back(loop.front());
    const auto index = static_cast<std::size_t>(region - regions_.data());
    if (dot(newell(loop), ring_normal(region->ring)) < 0.0) std::reverse(loop.begin(), loop.end());
    // from the place of the hole that is nearest to the ring, and from the one opposite
    const double total = line_length(loop);
    double start = 0.0, nearest = std::numeric_limits<double>::max();
    for (int k = 0; k < 32; ++k)
        for (const LineUse use : region->ring) {
            const double d =
                nearest_on_line(lines_[static_cast<std::size_t>(use.line)].shape, place_along(loop, total * k / 32))
                    .distance;
            if (d < nearest) nearest = d, start = total * k / 32;
        }
    const auto along_loop = [&](double at) { return place_along(loop, std::fmod(at, total)); };
    SpaceLine first, second;
    for (int k = 0; k <= 32; ++k) {
        first.push_back(along_loop(start + total * k / 64));
        second.push_back(along_loop(start + total * (k + 32) / 64));
    }
    const int a = vertex_on_ring(*region, first.front());
    const int b = vertex_on_ring(regions_[index], second.front());
    if (a == b) return bad("The hole in " + in_quotes(name) + " lies too near to a corner to be cut: draw it smaller.");
    const int near = add_vertex(first.front()), far = add_vertex(second.front());
    const std::string hole = new_name + " hole";
    const int line = static_cast<int>(lines_.size());
    link(hole, near, far, first);   // line
    link(hole, far, near, second);  // line + 1
    const auto straight = [&](int p, int q) {
        return resampled({vertices_[static_cast<std::size_t>(p)].place, vertices_[static_cast<std::size_t>(q)].place},
                         8);
    };
    link(new_name + " cut", a, near, straight(a, near));  // line + 2
    link(new_name + " cut", far, b, straight(far, b));    // line + 3
    // the cut from a to b passes the hole on either side: one path for each half
    NetworkRegion& whole = regions_[index];
    std::vector<LineUse> ring = whole.ring;
    std::rotate(ring.begin(), std::find_if(ring.begin(), ring.end(), [&](LineUse u) { return start_of(u) == b; }),
                ring.end());
    std::vector<LineUse> left, right;
    bool past = false;
    for (const LineUse use : ring) {
        past = past || start_of(use) == a;
        (past ? right : left).push_back(use);
    }
    // the hole runs anti-clockwise, so the cloth beside it passes it against its direction
    left.insert(left.end(), {{line + 2, false}, {line + 1, true}, {line + 3, false}});
    right.insert(right.end(), {{line + 3, true}, {line, true}, {line + 2, true}});
    NetworkRegion other{new_name, right, {}, whole.alpha, whole.layer, true, whole.parts};
    const auto corners = [&, old = whole.corners](const std::vector<LineUse>& part) {
        std::vector<int> passed;
        for (const LineUse use : part) passed.push_back(start_of(use));
        return kept_corners(detected_corners(part), passed, old, {a, b, near, far});
    };
    other.corners = corners(right);
    whole.ring = left;
    whole.corners = corners(left);
    regions_.push_back(std::move(other));
    // the hole itself is a region that was taken away: nothing fills it by itself
    regions_.push_back({hole, {{line, false}, {line + 1, false}}, {}, kCoonsAlpha, layer_, false, 0});
    return {};
}

void Network::release_region(const std::string& name) {
    NetworkRegion* region = region_named(name);
    if (region == nullptr) return;
    region->alive = false;
    region->ring.clear();
}

Result<void> Network::remove_region(const std::string& name) {
    NetworkRegion* region = region_named(name);
    if (region == nullptr) return bad("There is no region " + in_quotes(name) + " to remove.");
    region->alive = false;
    for (const LineUse use : region->ring) {
        bool used = false;
        for (const NetworkRegion& other : regions_)
            for (const LineUse u : other.ring) used = used || (other.alive && u.line == use.line);
        lines_[static_cast<std::size_t>(use.line)].alive = used;
    }
    drop_unused_vertices();
    return {};
}

void Network::drop_unused_vertices() {
    std::vector<bool> used(vertices_.size(), false);
    for (const NetworkLine& line : lines_)
        if (line.alive) used[static_cast<std::size_t>(line.from)] = used[static_cast<std::size_t>(line.to)] = true;
    for (std::size_t v = 0; v < vertices_.size(); ++v) vertices_[v].alive = vertices_[v].alive && used[v];
}

Result<void> Network::set_corner(const std::string& name, Vec3 place, bool corner) {
    NetworkRegion* region = region_named(name);
    if (region == nullptr) return bad("There is no region " + in_quotes(name) + ".");
    const auto index = static_cast<std::size_t>(region - regions_.data());
    const int vertex = vertex_on_ring(*region, place);
    std::set<int>& corners = regions_[index].corners;
    if (corner) {
        if (corners.size() >= kMostSides && corners.count(vertex) == 0)
            return bad("The region " + in_quotes(name) + " has 8 corners already: take one away first.");
        corners.insert(vertex);
    } else {
        if (corners.size() <= kFewestCorners && corners.count(vertex) != 0)
            return bad("The region " + in_quotes(name) + " needs two corners: set another one first.");
        corners.erase(vertex);
    }
    return {};
}

Result<void> Network::set_alpha(const std::string& name, double alpha) {
    NetworkRegion* region = region_named(name);
    if (region == nullptr) return bad("There is no region " + in_quotes(name) + ".");
    if (!(alpha >= kCoonsAlpha && alpha <= kHarmonicAlpha)) return bad("alpha must lie between -0.25 and 0.");
    region->alpha = alpha;
    return {};
}

Result<void> Network::associate(const std::string& name, PartSet parts) {
    NetworkRegion* region = region_named(name);
    if (region == nullptr) return bad("There is no region " + in_quotes(name) + ".");
    region->parts = parts;
    return {};
}

Result<void> Network::move(Vec3 from, Vec3 to, double radius, bool keeps_middle) {
    if (!is_usable(from) || !is_usable(to) || !std::isfinite(radius)) return bad("A vertex cannot be moved there.");
    const int vertex = nearest_vertex(from, options_.snap_cm);
    Vec3 centre = from;
    if (vertex >= 0) {
        centre = vertices_[static_cast<std::size_t>(vertex)].place;
    } else {
        double least = options_.snap_cm;
        for (const NetworkLine& line : lines_) {
            if (!line.alive || line.layer != layer_) continue;
            if (const NearestOnLine near = nearest_on_line(line.shape, from); near.distance < least)
                least = near.distance, centre = near.place;
        }
        if (least == options_.snap_cm) return bad("There is no vertex to move there.");
    }
    const Vec3 shift = to - centre;
    const auto follows = [&](Vec3 p) {
        const double d = length(p - centre);
        if (d >= std::max(radius, 1e-9)) return d > 0.0 ? p : p + shift;
        const double w = 1.0 - d * d / (radius * radius);
        return p + shift * (w * w);
    };
    const auto moved = [&](Vec3 p) {
        Vec3 q = follows(p);
        if (keeps_middle && p.x == 0.0) q.x = 0.0;
        return q;
    };
    for (NetworkVertex& v : vertices_)
        if (v.layer == layer_) v.place = moved(v.place);
    for (NetworkLine& line : lines_) {
        if (line.layer != layer_) continue;
        for (Vec3& p : line.shape) p = moved(p);
        // a radius shorter than the lines' spacing would tear them off
        pull_ends(line.shape, vertices_[static_cast<std::size_t>(line.from)].place,
                  vertices_[static_cast<std::size_t>(line.to)].place);
    }
    return {};
}

Result<void> Network::weld(Vec3 keep, Vec3 move) {
    const double reach = options_.snap_cm;
    const int stays = nearest_vertex(keep, reach), goes = nearest_vertex(move, reach);
    if (stays < 0 || goes < 0 || stays == goes) return bad("There are no two vertices to join there.");
    return weld_vertices(stays, goes);
}

Result<void> Network::weld_vertices(int stays, int goes) {
    for (const NetworkLine& line : lines_)
        if (line.alive && std::minmax(line.from, line.to) == std::minmax(stays, goes))
            return bad("The two ends of the line " + in_quotes(line.name) + " cannot be joined.");
    for (NetworkLine& line : lines_) {
        if (line.from != goes && line.to != goes) continue;
        if (line.from == goes) line.from = stays;
        if (line.to == goes) line.to = stays;
        pull_ends(line.shape, vertices_[static_cast<std::size_t>(line.from)].place,
                  vertices_[static_cast<std::size_t>(line.to)].place);
    }
    for (NetworkRegion& region : regions_)
        if (region.corners.erase(goes) != 0) region.corners.insert(stays);
    vertices_[static_cast<std::size_t>(goes)].alive = false;
    return {};
}

Result<void> Network::erase_line(const std::string& piece) {
    const int line = line_named(piece);
    if (line < 0) return bad("There is no line " + in_quotes(piece) + " to erase.");
    for (NetworkRegion& region : regions_)
        for (const LineUse use : region.ring) region.alive = region.alive && use.line != line;
    lines_[static_cast<std::size_t>(line)].alive = false;
    drop_unused_vertices();
    return {};
}

Result<void> Network::join(Vec3 end, const std::string& piece) {
    const int line = line_named(piece), goes = nearest_vertex(end, options_.snap_cm);
    if (line < 0 || goes < 0) return bad("There is no line end to join to " + in_quotes(piece) + " there.");
    const NetworkLine& own = lines_[static_cast<std::size_t>(line)];
    if (own.from == goes || own.to == goes) return bad("The line " + in_quotes(piece) + " cannot be joined to itself.");
    const Vec3 place = vertices_[static_cast<std::size_t>(goes)].place;
    const NearestOnLine near = nearest_on_line(own.shape, place);
    return weld_vertices(vertex_along(line, near.along), goes);
}

/// The end of a line that is near to a place along it, or a new vertex there.
int Network::vertex_along(int line, double along) {
    const NetworkLine& own = lines_[static_cast<std::size_t>(line)];
    const double total = line_length(own.shape), margin = std::min(options_.snap_cm, 0.4 * total);
    return along < margin ? own.from : along > total - margin ? own.to : split_at(line, along);
}

Result<void> Network::meet(const std::string& one, Vec3 at, const std::string& other, Vec3 to) {
    const int a = line_named(one), b = line_named(other);
    if (a < 0 || b < 0 || !is_usable(at) || !is_usable(to))
        return bad("There are no two lines " + in_quotes(one) + " and " + in_quotes(other) + " that cross.");
    const auto along = [&](int line, Vec3 place) {
        return nearest_on_line(lines_[static_cast<std::size_t>(line)].shape, place).along;
    };
    if (a != b) {
        const int stays = vertex_along(a, along(a, at));  // first, whatever the compiler: both may make a vertex
        return weld_vertices(stays, vertex_along(b, along(b, to)));
    }
    // a line that crosses itself: the loop between the two places gets a vertex of its own
    const double here = along(a, at), there = along(a, to);
    const double first = std::min(here, there), last = std::max(here, there);
    if (last - first < 2.0 * options_.edge_cm)
        return bad("The line " + in_quotes(one) + " crosses itself in too small a loop.");
    const int end = vertex_along(a, last);
    (void)split_at(a, 0.5 * (first + last));
    return weld_vertices(vertex_along(a, first), end);
}

namespace {

struct Stretch {
    double from = 0.0, to = 0.0;  // along the line
};

/// Between the places of a line nearest to two others, in its direction.
Stretch stretch_of(const SpaceLine& line, Vec3 at, Vec3 to) {
    const double a = nearest_on_line(line, at).along, b = nearest_on_line(line, to).along;
    return {std::min(a, b), std::max(a, b)};
}

}  // namespace

Result<void> Network::smooth(const std::string& piece, Vec3 at, Vec3 to) {
    const int line = line_named(piece);
    if (line < 0) return bad("There is no line " + in_quotes(piece) + " to smooth.");
    if (!is_usable(at) || !is_usable(to)) return bad("A line cannot be smoothed there.");
    SpaceLine& shape = lines_[static_cast<std::size_t>(line)].shape;
    const Stretch part = stretch_of(shape, at, to);
    if (part.to - part.from < options_.edge_cm)
        return bad("The stretch of " + in_quotes(piece) + " is too short to smooth: draw along it.");
    const double total = line_length(shape);
    SpaceLine out = resampled(shape, std::max(8, static_cast<int>(std::lround(total / kHandSpacing_cm))));
    const double step = total / static_cast<double>(out.size() - 1);
    for (int pass = 0; pass < kSmoothingPasses; ++pass) {
        SpaceLine next = out;
        for (std::size_t i = 1; i + 1 < out.size(); ++i) {
            const double along = step * static_cast<double>(i);
            if (along < part.from || along > part.to) continue;
            next[i] = (out[i - 1] + out[i + 1]) * 0.25 + out[i] * 0.5;
        }
        out = std::move(next);
    }
    shape = std::move(out);
    return {};
}

Result<void> Network::bump(const std::string& piece, Vec3 at, Vec3 to, double wave, double depth,
                           const std::function<Vec3(Vec3)>& outward) {
    const int line = line_named(piece);
    if (line < 0) return bad("There is no line " + in_quotes(piece) + " to lay folds into.");
    if (!is_usable(at) || !is_usable(to) || !(wave >= kHandSpacing_cm) || !(wave <= 1000.0) || !(depth > 0.0) ||
        !(depth <= 100.0))
        return bad("Folds need a length of 0.5 cm at least and a depth above 0.");
    SpaceLine& shape = lines_[static_cast<std::size_t>(line)].shape;
    const Stretch part = stretch_of(shape, at, to);
    const double stretch = part.to - part.from, total = line_length(shape);
    if (stretch < 0.75 * wave)
        return bad("The stretch of " + in_quotes(piece) + " is too short for a fold: draw farther along it.");
    const double waves = std::max(1.0, std::round(stretch / wave));
    SpaceLine out = resampled(shape, std::max(8, static_cast<int>(std::lround(total / kHandSpacing_cm))));
    const SpaceLine before = out;
    const double step = total / static_cast<double>(out.size() - 1);
    for (std::size_t i = 1; i + 1 < out.size(); ++i) {
        const double t = (step * static_cast<double>(i) - part.from) / stretch;
        if (t <= 0.0 || t >= 1.0) continue;
        const Vec3 along = normalised(before[i + 1] - before[i - 1]), way = outward(before[i]);
        const double fade = std::min({1.0, 2.0 * t * waves, 2.0 * (1.0 - t) * waves});
        const double height = depth * fade * std::sin(2.0 * std::numbers::pi * waves * t);
        out[i] = before[i] + normalised(way - along * dot(way, along)) * height;
        if (before[i].x == 0.0) out[i].x = 0.0;
    }
    shape = std::move(out);
    return {};
}

Result<void> Network::set_edge(double cm) {
    if (!(cm >= kLeastEdge_cm && cm <= kMostEdge_cm)) return bad("Quads must be 0.3 to 20 cm long.");
    options_.edge_cm = cm;
    return {};
}

Result<void> Network::rename_region(const std::string& name, const std::string& new_name) {
    NetworkRegion* region = region_named(name);
    if (region == nullptr) return bad("There is no region " + in_quotes(name) + ".");
    if (new_name.empty() || (new_name != name && find_region(new_name) != nullptr))
        return bad("A region needs a name that no other has; " + in_quotes(new_name) + " is none.");
    region->name = new_name;
    return {};
}

void Network::carry(const std::function<Vec3(Vec3)>& map) {
    const auto carried = [&](Vec3 p) {
        const Vec3 q = map(p);
        return p.x == 0.0 ? Vec3{0.0, q.y, q.z} : q;
    };
    for (NetworkVertex& v : vertices_) v.place = carried(v.place);
    for (NetworkLine& line : lines_)
        for (Vec3& p : line.shape) p = carried(p);
}

/// The ring from the corner where its sides' numbers of edges read least: the same outline is filled in the same way
/// wherever its ring was begun.
std::vector<LineUse> Network::ring_in_order(const NetworkRegion& region) const {
    std::vector<LineUse> ring = region.ring;
    const auto is_corner = [&](LineUse use) { return region.corners.count(start_of(use)) != 0; };
    std::rotate(ring.begin(), std::find_if(ring.begin(), ring.end(), is_corner), ring.end());
    std::vector<int> counts;
    std::vector<std::ptrdiff_t> starts;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (is_corner(ring[i])) {
            counts.push_back(0);
            starts.push_back(static_cast<std::ptrdiff_t>(i));
        }
        counts.back() += edge_count(lines_[static_cast<std::size_t>(ring[i].line)]);
    }
    std::size_t best = 0;
    std::vector<int> least = counts;
    for (std::size_t k = 1; k < starts.size(); ++k) {
        std::rotate(counts.begin(), counts.begin() + 1, counts.end());
        if (counts < least) least = counts, best = k;
    }
    std::rotate(ring.begin(), ring.begin() + starts[best], ring.end());
    return ring;
}

Result<RegionBoundary> Network::boundary(const NetworkRegion& region) const {
    const bool has_corner = std::any_of(region.ring.begin(), region.ring.end(),
                                        [&](LineUse u) { return region.corners.count(start_of(u)) != 0; });
    if (!has_corner) return bad_outline("The region " + in_quotes(region.name) + " has no corners: mark two at least.");
    const std::vector<LineUse> ring = ring_in_order(region);
    RegionBoundary out;
    for (const LineUse use : ring) {
        const NetworkLine& line = lines_[static_cast<std::size_t>(use.line)];
        const int start = start_of(use), edges = edge_count(line);
        SpaceLine points = resampled(line.shape, edges);
        if (use.reversed) std::reverse(points.begin(), points.end());
        if (region.corners.count(start) != 0) out.outline.sides.emplace_back().push_back(points.front());
        auto& side = out.outline.sides.back();
        side.insert(side.end(), points.begin() + 1, points.end());
        out.keys.push_back({start, -1, 0});
        for (int k = 1; k < edges; ++k) out.keys.push_back({-1, use.line, use.reversed ? edges - k : k});
    }
    return out;
}

std::string Network::inconsistency() const {
    for (const NetworkLine& line : lines_) {
        if (!line.alive) continue;
        const NetworkVertex &from = vertices_[static_cast<std::size_t>(line.from)],
                            &to = vertices_[static_cast<std::size_t>(line.to)];
        if (!from.alive || !to.alive) return line.name + " ends at a vertex that is gone";
        if (line.shape.front() != from.place || line.shape.back() != to.place)
            return line.name + " misses its vertices";
    }
    for (const NetworkRegion& region : regions_) {
        if (!region.alive) continue;
        for (std::size_t i = 0; i < region.ring.size(); ++i) {
            const LineUse use = region.ring[i], next = region.ring[(i + 1) % region.ring.size()];
            if (!lines_[static_cast<std::size_t>(use.line)].alive) return region.name + " uses a line that is gone";
            if (start_of({use.line, !use.reversed}) != start_of(next)) return region.name + " is torn";
        }
        for (const int corner : region.corners)
            if (std::none_of(region.ring.begin(), region.ring.end(), [&](LineUse u) { return start_of(u) == corner; }))
                return region.name + " has a corner off its ring";
    }
    return {};
}

}  // namespace core
