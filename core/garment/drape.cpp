#include "core/garment/drape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "core/garment/design.hpp"

namespace core {
namespace {

constexpr double kStep_s = 1.0 / 60.0;
constexpr double kThickShare = 0.8;  // of the mean edge: spheres that leave no gap for a vertex to slip through
constexpr double kMostThickness_cm = 1.0;
constexpr double kReachShare = 1.75;    // contacts are looked for this many thicknesses away
constexpr double kDriftShare = 0.5;     // a vertex may move so many before they are looked for again: two that meet
                                        // are found before they passed each other
constexpr double kMostMoveShare = 0.4;  // of the thickness, in a substep
constexpr double kCurve_cm = 2.0;       // radius of the body's curves that quads must not cut

constexpr std::size_t kMostCells = std::size_t{1} << 20;
constexpr double kSteepest = 1.75;    // change of the body's field along a centimetre, at the most: it is interpolated
constexpr double kMostFree_cm = 2.0;  // layers below are felt from 4 cm on

constexpr double kBand_cm = 1.5, kBandHeight_cm = 8.0;

using Pair = std::pair<std::uint32_t, std::uint32_t>;

Pair pair_of(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

std::vector<Pair> edges_once(const QuadMesh& mesh) {
    std::vector<Pair> edges;
    for (const Quad& q : mesh.quads)
        for (std::size_t k = 0; k < 4; ++k) edges.push_back(pair_of(q[k], q[(k + 1) % 4]));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

/// Vertices on the far sides of the two quads at an edge: what bends when the edge does.
std::vector<Pair> spans(const QuadMesh& mesh) {
    std::map<Pair, std::array<std::uint32_t, 2>> first;  // of an edge: opposite its lower, its upper end
    std::vector<Pair> out;
    for (const Quad& q : mesh.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t a = q[k], b = q[(k + 1) % 4], beyond_b = q[(k + 2) % 4], beyond_a = q[(k + 3) % 4];
            const std::array<std::uint32_t, 2> beyond =
                a < b ? std::array{beyond_a, beyond_b} : std::array{beyond_b, beyond_a};
            const auto [at, fresh] = first.emplace(pair_of(a, b), beyond);
            if (fresh) continue;
            for (std::size_t i = 0; i < 2; ++i)
                if (at->second[i] != beyond[i]) out.push_back(pair_of(at->second[i], beyond[i]));
        }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

}  // namespace

Drape::Drape(const QuadMesh& cloth, const Obstacle& obstacle, const DrapeOptions& options, std::vector<bool> held,
             std::vector<SewnVertex> sewn)
    : rest_(cloth),
      obstacle_(obstacle),
      options_(options),
      weight_(cloth.vertices.size(), 0.0),
      sewn_(std::move(sewn)) {
    std::vector<double> area(cloth.vertices.size(), 0.0);
    double sum = 0.0;
    for (const Quad& q : rest_.quads) {
        const auto& v = rest_.vertices;
        const double quarter = 0.125 * length(cross(v[q[2]] - v[q[0]], v[q[3]] - v[q[1]]));
        for (const std::uint32_t i : q) area[i] += quarter;
        sum += 4.0 * quarter;
    }
    const double mean = sum / static_cast<double>(std::max<std::size_t>(1, area.size()));
    for (std::size_t i = 0; i < area.size(); ++i)
        if (area[i] > 0.0) weight_[i] = std::clamp(mean / area[i], 0.25, 4.0);
    for (const SewnVertex& s : sewn_)
        if (s.vertex < held.size()) held[s.vertex] = false;  // it goes where its cloth goes
    for (std::size_t i = 0; i < std::min(held.size(), weight_.size()); ++i)
        if (held[i]) weight_[i] = 0.0;
    add_links();
    reset();
}

void Drape::add_links() {
    const auto add = [&](Pair p, double softness) {
        links_.push_back({p.first, p.second, length(rest_.vertices[p.second] - rest_.vertices[p.first]), softness});
    };
    const std::vector<Pair> edges = edges_once(rest_);
    double sum = 0.0;
    for (const Pair& e : edges) {
        add(e, 0.0);
        sum += links_.back().rest;
    }
    const double mean = edges.empty() ? 1.0 : sum / static_cast<double>(edges.size());
    thickness_ = std::min(kThickShare * mean, kMostThickness_cm);
    clearance_ = options_.clearance_cm + mean * mean / (8.0 * kCurve_cm);
    for (const Quad& q : rest_.quads) {
        add(pair_of(q[0], q[2]), options_.shear_softness);
        add(pair_of(q[1], q[3]), options_.shear_softness);
    }
    for (const Pair& s : spans(rest_)) add(s, options_.bend_softness);
    // near in memory is near in the cloth: links in the order of their vertices
    std::stable_sort(links_.begin(), links_.end(), [](const Link& x, const Link& y) { return x.a < y.a; });
    linked_start_.assign(rest_.vertices.size() + 1, 0);
    for (const Link& link : links_) ++linked_start_[link.a + 1];
    for (std::size_t v = 0; v < rest_.vertices.size(); ++v) linked_start_[v + 1] += linked_start_[v];
}

void Drape::reset() {
    at_ = before_ = rest_.vertices;
    speed_.assign(at_.size(), {});
    free_.assign(at_.size(), 0.0);
    contacts_.clear();
    searched_ = false;
}

double Drape::mean_speed_cm_s() const {
    double sum = 0.0;
    for (const Vec3& v : speed_) sum += length(v);
    return speed_.empty() ? 0.0 : sum / static_cast<double>(speed_.size());
}

/// Pairs of vertices that may come to touch before the next search, in order. What was nearer than the thickness when
/// drawn may stay as near.
void Drape::find_contacts() {
    contacts_.clear();
    since_search_ = 0.0;
    searched_ = true;
    if (at_.empty() || thickness_ <= 0.0) return;
    sort_by_cell(kReachShare * thickness_);
    for (std::uint32_t i = 0; i < at_.size(); ++i) add_contacts(i);
}

/// Those with a greater number. Cells in a row lie in a row: nine stretches hold all that is near.
void Drape::add_contacts(std::uint32_t vertex) {
    const Vec3 p = at_[vertex];
    const double reach = kReachShare * thickness_;
    for (std::size_t k = 0; k < 9; ++k) {
        const std::size_t first = cell_[vertex] - 1 + (k % 3) * nx_ + (k / 3) * nx_ * ny_ - nx_ - nx_ * ny_;
        for (std::uint32_t s = cell_start_[first]; s < cell_start_[first + 3]; ++s) {
            const Sorted& other = sorted_[s];
            const Vec3 d = other.at - p;
            if (dot(d, d) >= reach * reach || other.vertex <= vertex || is_linked(vertex, other.vertex)) continue;
            const double drawn = length(rest_.vertices[other.vertex] - rest_.vertices[vertex]);
            contacts_.push_back({vertex, other.vertex, std::min(thickness_, 0.95 * drawn)});
        }
    }
}

/// Links keep their vertices apart themselves.
bool Drape::is_linked(std::uint32_t low, std::uint32_t high) const {
    for (std::uint32_t k = linked_start_[low]; k < linked_start_[low + 1]; ++k)
        if (links_[k].b == high) return true;
    return false;
}

std::size_t Drape::cell_of(Vec3 p) const {
    const auto number = [&](double v) { return static_cast<std::size_t>(v / cell_size_) + 1; };
    return (number(p.z - low_.z) * ny_ + number(p.y - low_.y)) * nx_ + number(p.x - low_.x);
}

void Drape::sort_by_cell(double size) {
    Vec3 high = low_ = at_.front();
    for (const Vec3& p : at_) {
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 span = high - low_;
    const auto cells_along = [&](double length) { return static_cast<std::size_t>(length / cell_size_) + 3; };
    std::size_t count = 0;
    for (cell_size_ = size;; cell_size_ *= 1.5) {  // what lies far apart gets larger cells
        nx_ = cells_along(span.x), ny_ = cells_along(span.y);
        count = nx_ * ny_ * cells_along(span.z);
        if (count <= kMostCells) break;
    }
    cell_start_.assign(count + 1, 0);
    cell_.resize(at_.size());
    sorted_.resize(at_.size());
    for (std::size_t i = 0; i < at_.size(); ++i) {
        cell_[i] = cell_of(at_[i]);
        ++cell_start_[cell_[i]];
    }
    std::uint32_t sum = 0;  // each cell's number becomes its end, and then, as it fills backwards, its start
    for (std::uint32_t& start : cell_start_) start = sum += start;
    for (std::size_t i = at_.size(); i-- > 0;)
        sorted_[--cell_start_[cell_[i]]] = {at_[i], static_cast<std::uint32_t>(i)};
}

void Drape::step() {
    const double dt = kStep_s / options_.substeps;
    for (int k = 0; k < options_.substeps; ++k) {
        if (!searched_ || since_search_ > kDriftShare * thickness_) find_contacts();
        substep(dt);
    }
}

void Drape::substep(double dt) {
    const double most = kMostMoveShare * std::max(thickness_, 0.1) / dt;
    const double slowed = std::max(0.0, 1.0 - options_.drag_per_s * dt);
    for (std::size_t i = 0; i < at_.size(); ++i) {
        before_[i] = at_[i];
        if (weight_[i] == 0.0) continue;
        Vec3 v = speed_[i] * slowed;
        v.y -= options_.gravity_cm_s2 * dt;
        const double speed = length(v);
        if (speed > most) v = v * (most / speed);
        at_[i] = at_[i] + v * dt;
    }
    keep_lengths();
    keep_sewn();
    keep_apart();
    keep_outside();
    stay_above_floor();
    double farthest = 0.0;
    for (std::size_t i = 0; i < at_.size(); ++i) {
        const Vec3 moved = at_[i] - before_[i];
        farthest = std::max(farthest, dot(moved, moved));
        speed_[i] = moved * (1.0 / dt);
    }
    since_search_ += std::sqrt(farthest);
}

void Drape::keep_lengths() {
    for (const Link& link : links_) {
        const double wa = weight_[link.a], wb = weight_[link.b], sum = wa + wb + link.softness;
        if (wa + wb == 0.0) continue;
        const Vec3 d = at_[link.b] - at_[link.a];
        const double now = length(d);
        if (now < 1e-9) continue;
        const Vec3 pull = d * ((now - link.rest) / (now * sum));
        at_[link.a] = at_[link.a] + pull * wa;
        at_[link.b] = at_[link.b] - pull * wb;
    }
}

/// Each over its place on the other cloth, as far off as it was drawn.
void Drape::keep_sewn() {
    for (const SewnVertex& s : sewn_) {
        const std::array<Vec3, 3> p{at_[s.on[0]], at_[s.on[1]], at_[s.on[2]]};
        const TriangleAxes axes = axes_of_triangle(p[0], p[1], p[2]);
        Vec3 to = axes.along * s.off.x + axes.across * s.off.y + axes.normal * s.off.z;
        double sum = weight_[s.vertex];
        for (std::size_t k = 0; k < 3; ++k) {
            to = to + p[k] * s.share[k];
            sum += s.share[k] * s.share[k] * weight_[s.on[k]];
        }
        if (sum == 0.0) continue;
        const Vec3 pull = (to - at_[s.vertex]) * (1.0 / sum);
        at_[s.vertex] = at_[s.vertex] + pull * weight_[s.vertex];
        for (std::size_t k = 0; k < 3; ++k) at_[s.on[k]] = at_[s.on[k]] - pull * (s.share[k] * weight_[s.on[k]]);
    }
}

void Drape::keep_apart() {
    for (const Contact& c : contacts_) {
        const Vec3 d = at_[c.b] - at_[c.a];
        const double square = dot(d, d);
        if (square >= c.least * c.least || square < 1e-18) continue;
        const double wa = weight_[c.a], wb = weight_[c.b], sum = wa + wb;
        if (sum == 0.0) continue;
        const double now = std::sqrt(square);
        const Vec3 push = d * ((c.least - now) / (now * sum));
        at_[c.a] = at_[c.a] - push * wa;
        at_[c.b] = at_[c.b] + push * wb;
        // the two take on some of their common speed
        const Vec3 ma = at_[c.a] - before_[c.a], mb = at_[c.b] - before_[c.b];
        const Vec3 apart = (mb - ma) * (0.5 * options_.cloth_friction);
        if (wa > 0.0) at_[c.a] = at_[c.a] + apart;
        if (wb > 0.0) at_[c.b] = at_[c.b] - apart;
    }
}

void Drape::keep_outside() {
    for (std::size_t i = 0; i < at_.size(); ++i) {
        if (weight_[i] == 0.0) continue;
        free_[i] -= kSteepest * length(at_[i] - before_[i]);
        if (free_[i] > 0.0) continue;
        const FieldSample s = obstacle_.quick_sample(at_[i]);
        const double depth = clearance_ - s.distance;
        free_[i] = std::clamp(-depth, 0.0, kMostFree_cm);
        if (depth <= 0.0) continue;
        at_[i] = at_[i] + s.gradient * depth;
        const Vec3 moved = at_[i] - before_[i];
        const Vec3 along = moved - s.gradient * dot(moved, s.gradient);
        const double size = length(along), stop = options_.body_friction * depth;
        at_[i] = size <= stop ? at_[i] - along : at_[i] - along * (stop / size);
    }
}

/// As the body does, with a field that only rises.
void Drape::stay_above_floor() {
    const double least = options_.floor_cm + options_.clearance_cm;
    for (std::size_t i = 0; i < at_.size(); ++i) {
        if (at_[i].y >= least || weight_[i] == 0.0) continue;
        const double depth = least - at_[i].y;
        at_[i].y = least;
        const Vec3 along{at_[i].x - before_[i].x, 0.0, at_[i].z - before_[i].z};
        const double size = length(along), stop = options_.body_friction * depth;
        at_[i] = size <= stop ? at_[i] - along : at_[i] - along * (stop / size);
    }
}

QuadMesh joined_layers(const std::vector<FinishedLayer>& layers) {
    QuadMesh all;
    for (const FinishedLayer& layer : layers) {
        const auto shift = static_cast<std::uint32_t>(all.vertices.size());
        const QuadMesh& mesh = layer.fitted.mesh;
        all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (const Quad& q : mesh.quads) all.quads.push_back({q[0] + shift, q[1] + shift, q[2] + shift, q[3] + shift});
    }
    return all;
}

std::vector<bool> banded(const std::vector<FinishedLayer>& layers, const Obstacle& body) {
    std::vector<bool> held;
    double beneath = 0.0;  // layers lie over each other
    for (const FinishedLayer& layer : layers) {
        const Cloth& cloth = layer.fitted;
        beneath += kBand_cm;
        double top = -std::numeric_limits<double>::max();
        for (const Vec3& p : cloth.mesh.vertices) top = std::max(top, p.y);
        const std::size_t first = held.size();
        held.resize(first + cloth.mesh.vertices.size(), false);
        for (const auto& hem : edges_of(cloth).hems)
            for (const std::uint32_t v : hem) {
                const Vec3 p = cloth.mesh.vertices[v];
                if (p.y > top - kBandHeight_cm && body.distance(p) < beneath) held[first + v] = true;
            }
    }
    return held;
}

void put_places(const std::vector<Vec3>& places, std::vector<FinishedLayer>& layers) {
    std::size_t at = 0;
    for (FinishedLayer& layer : layers)
        for (Vec3& v : layer.fitted.mesh.vertices) v = places[at++];
}

}  // namespace core
