#pragma once
// A region of cloth: a closed outline in space, cut into sides at its corners, and the quads that fill it.
//
//     const auto filled = core::fill_region({{side_0, side_1, side_2}}, core::kCoonsAlpha);

#include <vector>

#include "core/base/result.hpp"
#include "core/garment/fill_topology.hpp"
#include "core/garment/permanence_patch.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

/// 2 to 8 sides in order, each a polyline of 2 points or more that starts where the one before ends; the last ends
/// where the first starts. Any unit. Anti-clockwise seen from the outer side of the cloth.
struct RegionOutline {
    std::vector<std::vector<Vec3>> sides;
};

/// How far the end of a side may lie from the start of the next, as a share of the outline's size.
inline constexpr double kJoinTolerance = 1e-6;

/// The boundary as one ring, each side without its last point. ErrorCode::BadOutline, with the number of the side from
/// 1 on, for a wrong number of sides, a side of one point or of no length, two points in a row at one place, a
/// coordinate that is not finite, sides that do not join, and an outline that meets itself. n log n for outlines of
/// usual shape.
[[nodiscard]] Result<std::vector<Vec3>> outline_ring(const RegionOutline& outline);

/// fill_topology for the sides of an outline.
[[nodiscard]] Result<RegionTopology> outline_topology(const RegionOutline& outline);

struct FilledRegion {
    RegionTopology topology;
    QuadMesh mesh;       ///< its first topology.boundary vertices are the outline's points
    double alpha = 0.0;  ///< in use, see fill_ring
};

/// Places the inner vertices of `topology` for a boundary ring. Near alpha = -1/4 the patch of a region with irregular
/// vertices may fold over itself or swing far out of its outline: where a plane ring gives folded quads, or an inner
/// vertex leaves the ring's bounding box by a twentieth of its size, or an edge is four times as long as the ring's,
/// the nearest alpha of a short list towards 0 is used that does neither; on a circle 0 never folds (Tutte 1963). A
/// grid of four sides may leave the box: there -1/4 is the Coons patch, which does so where opposite sides arch. Cost:
/// PermanencePatch, more than once only there.
[[nodiscard]] FilledRegion fill_ring(RegionTopology topology, const std::vector<Vec3>& ring, double alpha);

/// The three above in turn.
[[nodiscard]] Result<FilledRegion> fill_region(const RegionOutline& outline, double alpha);

}  // namespace core
