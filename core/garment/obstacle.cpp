#include "core/garment/obstacle.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace core {
namespace {

constexpr double kLayerCell_cm = 0.7, kLayerReach_cm = 2.5;  // cloth is worn close to what is below

}  // namespace

Result<Obstacle> Obstacle::of_body(const TriangleMesh& body) {
    DressForm form;
    form.mesh = body;
    return of_body(form);
}

Result<Obstacle> Obstacle::of_body(const DressForm& form) {
    const TriangleMesh& body = form.mesh;
    Result<DistanceGrid> grid = DistanceGrid::of_body(body, {});
    if (!grid) return unexpected(grid.error());
    Obstacle obstacle(std::move(*grid), PartSurface(form));
    QuadMesh surface{body.vertices, {}};
    for (const auto& t : body.triangles) surface.quads.push_back({t[0], t[1], t[2], t[2]});
    obstacle.surfaces_.push_back(std::move(surface));
    return obstacle;
}

void Obstacle::add_layer(const QuadMesh& cloth) {
    layers_.push_back(DistanceGrid::of_sheet(cloth, {kLayerCell_cm, 0.0, kLayerReach_cm}));
    surfaces_.push_back(cloth);
}

FieldSample Obstacle::sample(Vec3 p) const {
    FieldSample least = body_.sample(p);
    for (const DistanceGrid& layer : layers_) {
        const double d = layer.distance(p);
        if (d < least.distance) least = layer.sample(p);
    }
    return least;
}

FieldSample Obstacle::quick_sample(Vec3 p) const {
    FieldSample least = body_.quick_sample(p);
    for (const DistanceGrid& layer : layers_)
        if (const FieldSample s = layer.quick_sample(p); s.distance < least.distance) least = s;
    return least;
}

double Obstacle::distance(Vec3 p) const {
    double least = body_.distance(p);
    for (const DistanceGrid& layer : layers_) least = std::min(least, layer.distance(p));
    return least;
}

std::optional<Vec3> Obstacle::first_hit(Vec3 origin, Vec3 direction, double offset, double reach) const {
    double before = 0.0;
    for (double at = 0.0; at <= reach;) {
        const double d = distance(origin + direction * at) - offset;
        if (d <= 0.0) {
            for (int k = 0; k < 40 && at - before > 1e-7; ++k) {
                const double middle = 0.5 * (before + at);
                (distance(origin + direction * middle) - offset > 0.0 ? before : at) = middle;
            }
            return origin + direction * at;
        }
        before = at;
        at += std::clamp(0.7 * d, 0.05, kLayerReach_cm);  // a layer is not felt from farther away
    }
    return std::nullopt;
}

Vec3 Obstacle::nearest_pass(Vec3 origin, Vec3 direction, double reach) const {
    double least = std::numeric_limits<double>::max(), best = 0.0;
    for (double at = 0.0; at <= reach; at += 0.5) {
        const double d = distance(origin + direction * at);
        if (d < least) least = d, best = at;
    }
    return origin + direction * best;
}

}  // namespace core
