#include "core/skeleton/skeleton.hpp"

#include "core/geometry/point_grid.hpp"
#include "core/geometry/polygon.hpp"
#include "core/silhouette/contour.hpp"
#include "core/skeleton/corners.hpp"
#include "core/skeleton/junction_blocks.hpp"
#include "core/skeleton/sampling.hpp"

namespace core {

namespace {

/// Samples lie where an index stores them, so that what is described and what is read again are the same.
Polygon on_sample_grid(Polygon samples) {
    const int grid = finest_grid(samples, kOutlineSteps);
    for (Point& p : samples) p = on_grid(p, grid);
    return samples;
}

/// Seen from its first point: such differences of samples are exact, so that nothing measured on them depends on where
/// the shape lies.
Polygon from_first(Polygon samples) {
    const Point first = samples.front();
    for (Point& p : samples) p = p - first;
    return samples;
}

}  // namespace

Result<Skeleton> skeletonise(const Polygon& contour, const ShapeParameters& p) {
    if (contour.size() < 3 || !(signed_area(contour) > 0.0)) {
        return unexpected(ErrorCode::BadOutline, "the outline encloses no area");
    }
    Skeleton s;
    s.contour = smooth_contour(contour, p.contour_points, p.contour_sigma);
    s.cornerity = cornerity(s.contour, p.window);
    s.corners = corners(s.cornerity, p.window, p.extent);
    s.samples = without_crossings(on_sample_grid(sample_outline(s.contour, s.cornerity, s.corners, p.sample_size)));
    if (s.samples.size() < 3 || !(signed_area(s.samples) > 0.0)) {
        return unexpected(ErrorCode::BadOutline, "the outline encloses no area once it is sampled");
    }
    const Polygon placed = from_first(s.samples);
    s.arcs = ArcMeasures(placed);
    const InertiaAxis axis = axis_of_least_inertia(placed);
    s.axis = {axis.centre + s.samples.front(), axis.direction};
    Result<Triangulation> triangulation = triangulate(stretched_along(placed, axis, p.scale_coef));
    if (!triangulation) return unexpected(triangulation.error());
    s.triangulation = std::move(*triangulation);
    s.profile = extended_profile(placed, s.triangulation);
    s.csp_pieces = segment(s.triangulation, s.profile.cuts());
    s.significant_pieces = without_insignificant_terminals(placed, s.arcs, s.triangulation, s.csp_pieces, p);
    s.merged_pieces = with_trimmed_junctions(placed, s.triangulation,
                                             with_merged_junctions(placed, s.triangulation, s.significant_pieces, p));
    s.pieces = with_joined_sleeves(s.triangulation, s.merged_pieces);
    s.graph = cat_graph(s.samples, s.triangulation, s.pieces);
    s.skeletal_length = skeletal_length(cat_graph(placed, s.triangulation, s.merged_pieces));
    return s;
}

}  // namespace core
