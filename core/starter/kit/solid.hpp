#pragma once
// Boxes with rounded edges and slabs cut from an outline. All closed, facing outward.

#include <vector>

#include "core/mesh/triangle_mesh.hpp"
#include "core/starter/kit/palette.hpp"

namespace core::starter {

/// A box about its centre. `round` is the radius of its edges, at most half the smallest side.
[[nodiscard]] TriangleMesh box(Vec3 centre, Vec3 size, double round, Rgb colour);
/// A box from one corner to the opposite one.
[[nodiscard]] TriangleMesh box_between(Vec3 low, Vec3 high, double round, Rgb colour);

/// A plate with the given outline (a simple ring in the xy plane, either direction), `thickness` deep about z = 0, its
/// edges cut by `bevel`. The outline's smallest details should be larger than the bevel.
[[nodiscard]] TriangleMesh slab(std::vector<Point> outline, double thickness, double bevel, Rgb colour);

/// Outlines for slabs.
[[nodiscard]] std::vector<Point> circle_outline(Point centre, double rx, double ry, int points = 28);
[[nodiscard]] std::vector<Point> rounded_rectangle(Point low, Point high, double round);
/// n points on a star or flower: radii alternate between outer and inner.
[[nodiscard]] std::vector<Point> star_outline(Point centre, int tips, double outer, double inner, double start_degrees);

}  // namespace core::starter
