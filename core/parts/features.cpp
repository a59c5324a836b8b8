#include "core/parts/features.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/polygon.hpp"

namespace core {

namespace {

float& feature(Part& part, Feature f) {
    return part.features[static_cast<std::size_t>(f)];
}
double feature(const Part& part, Feature f) {
    return part.features[static_cast<std::size_t>(f)];
}

/// The samples of the arc, both ends included, seen from its start: such differences are exact, so that no feature
/// depends on where the shape lies.
Polyline chain_of(const Polygon& samples, const ArcMeasures& arcs, Arc arc) {
    const int n = arcs.count();
    const Point start = samples[static_cast<std::size_t>(arc.from)];
    Polyline chain;
    for (int k = 0; k <= arcs.steps(arc.from, arc.to); ++k) {
        chain.push_back(samples[static_cast<std::size_t>((arc.from + k) % n)] - start);
    }
    return chain;
}

/// Height away from the body over width along it. The rectangle's side that the chord projects on longest lies along
/// the body.
double eccentricity(const OrientedRectangle& box, Point chord) {
    const double on_along = std::abs(dot(chord, box.axis)), on_across = std::abs(cross(box.axis, chord));
    double width = on_along >= on_across ? box.along : box.across;
    double height = on_along >= on_across ? box.across : box.along;
    if (on_along == 0.0 && on_across == 0.0) {  // the whole outline: no chord
        height = std::max(box.along, box.across);
        width = std::min(box.along, box.across);
    }
    constexpr double kFlattest = 1e-3;  // a part of one line has a width of 0
    return height / std::max(width, kFlattest * std::max(height, 1e-12));
}

Point area_centroid(const Polygon& ring) {
    double twice = 0.0;
    Point moment;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const double w = cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
        twice += w;
        moment = moment + (ring[i] + ring[i + 1] - ring[0] * 2.0) * (w / 3.0);
    }
    return std::abs(twice) > 0.0 ? ring[0] + moment * (1.0 / twice) : centroid_of_points(ring);
}

void fill_signature(Part& part, const Polyline& chain, const Polygon& ring, double unit) {
    const Point centre = area_centroid(ring);
    const Polyline even = resample_chain(chain, static_cast<int>(kSignatureSize));
    for (std::size_t i = 0; i < kSignatureSize; ++i) {
        part.signature[i] = static_cast<float>(distance(even[i], centre) / unit);
    }
}

}  // namespace

Part measure_part(const Polygon& samples, const ArcMeasures& arcs, Arc arc, const ShapeParameters& p) {
    Part part;
    part.start_sample = arc.from;
    part.end_sample = arc.to;
    const Polyline chain = chain_of(samples, arcs, arc);
    Polygon ring = chain;
    if (arc.from == arc.to) ring.pop_back();
    const Point chord = ring.back() - ring.front();
    const double chord_length = arc.from == arc.to ? 0.0 : length(chord);
    const double arc_length = arcs.length(arc.from, arc.to);
    const double area = std::abs(signed_area(ring));
    const double around = arc_length + chord_length;
    const Polygon hull = convex_hull(ring);
    const OrientedRectangle box = least_rectangle(hull);
    const double hull_area = std::max(signed_area(hull), area);
    const double raggedness =
        static_cast<double>(ring.size()) / static_cast<double>(std::max<std::size_t>(hull.size(), 1));
    const auto set = [&part](Feature f, double v) { feature(part, f) = static_cast<float>(v); };
    set(Feature::Area, 100.0 * area / arcs.area());
    set(Feature::Perimeter, 100.0 * arc_length / arcs.perimeter());
    set(Feature::Eccentricity, eccentricity(box, arc.from == arc.to ? Point{} : chord));
    set(Feature::Circularity, 4.0 * 3.14159265358979323846 * area / (around * around));
    set(Feature::Rectangularity, box.area() > 0.0 ? area / box.area() : 1.0);
    set(Feature::Convexity, std::max(0.0, 1.0 - perimeter(hull) / around) * raggedness);
    set(Feature::Solidity, hull_area > 0.0 ? (1.0 - area / hull_area) * raggedness : 0.0);
    set(Feature::BendingEnergy, arcs.bending(arc.from, arc.to));
    set(Feature::ChordLengthRatio, chord_length / arc_length);
    fill_signature(part, chain, ring, arcs.perimeter() / p.signature_unit);
    return part;
}

namespace {

/// Pockets between the part and its hull that are larger than SmallArea in area and in length.
int pockets(const Polygon& ring, const ArcMeasures& arcs, double small_share) {
    const Polygon hull = convex_hull(ring);
    std::vector<std::size_t> on_hull;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (std::find(hull.begin(), hull.end(), ring[i]) != hull.end()) on_hull.push_back(i);
    }
    int count = 0;
    for (std::size_t k = 0; k < on_hull.size(); ++k) {
        const std::size_t from = on_hull[k];
        const std::size_t to = on_hull[(k + 1) % on_hull.size()];
        Polygon pocket{ring[from]};
        for (std::size_t i = from; i != to; i = (i + 1) % ring.size()) pocket.push_back(ring[(i + 1) % ring.size()]);
        const bool large = std::abs(signed_area(pocket)) > small_share * arcs.area() &&
                           perimeter(pocket) > small_share * arcs.perimeter();
        count += pocket.size() > 2 && large ? 1 : 0;
    }
    return count;
}

}  // namespace

bool is_salient(const Polygon& samples, const ArcMeasures& arcs, const Part& part, const ShapeParameters& p) {
    const double around = feature(part, Feature::Perimeter);
    const double eccentricity = feature(part, Feature::Eccentricity);
    if (feature(part, Feature::Area) >= p.large_t || around >= p.large_t) return true;
    if (around >= p.small_long_t && eccentricity >= p.small_et) return true;
    if (around >= p.large_long_t && eccentricity >= p.large_et) return true;
    if (around < p.size_bent_t) return false;
    const Polygon ring = chain_of(samples, arcs, {part.start_sample, part.end_sample});
    const double convexity = perimeter(convex_hull(ring)) / perimeter(ring);
    return convexity <= p.convexity_t && pockets(ring, arcs, p.small_area) >= p.n_pockets;
}

}  // namespace core
