#pragma once
// Surfaces that follow a line: tubes of changing width along splines, turned profiles, rings. All closed, facing
// outward.

#include <vector>

#include "core/mesh/triangle_mesh.hpp"
#include "core/starter/kit/palette.hpp"

namespace core::starter {

/// One place along a tube.
struct Station {
    Vec3 at;
    double r = 0.1;      ///< half height, in the plane of the profile
    double side = -1.0;  ///< half width across the profile; negative: as r
};

enum class Cap { Flat, Round };

struct TubeOptions {
    int sides = 14;
    int steps = 6;  ///< rings between two stations
    Cap cap = Cap::Round;
    bool straight = false;  ///< no spline: stations joined by straight pieces
};

/// A tube through the stations (two at least), Catmull-Rom between them. "Side" is across the xy plane wherever the
/// line does not run along z itself.
[[nodiscard]] TriangleMesh tube(const std::vector<Station>& stations, Rgb colour, TubeOptions options = {});
/// A straight round bar from a to b.
[[nodiscard]] TriangleMesh rod(Vec3 a, Vec3 b, double r, Rgb colour, Cap cap = Cap::Round);
/// A straight bar with two radii.
[[nodiscard]] TriangleMesh cone(Vec3 a, Vec3 b, double ra, double rb, Rgb colour, Cap cap = Cap::Flat);
/// A closed tube through the points, of constant radius: handles, rims, hoops.
[[nodiscard]] TriangleMesh loop(const std::vector<Vec3>& points, double r, Rgb colour, int steps = 8, int sides = 10);
/// A ring about the z axis direction turned to `axis` (unit), of radius R and thickness r.
[[nodiscard]] TriangleMesh ring(Vec3 centre, Vec3 axis, double radius, double r, Rgb colour, int around = 36);

/// A surface of revolution about the y axis: points are (radius, height), from the bottom's axis around the outside to
/// the end. Ends with a radius above 0 get flat lids. Sharp profile corners stay sharp.
[[nodiscard]] TriangleMesh lathe(const std::vector<Point>& profile, Rgb colour, int sides = 32);
/// The same with a spline through the points.
[[nodiscard]] TriangleMesh lathe_smooth(const std::vector<Point>& profile, Rgb colour, int sides = 32, int steps = 6);
/// An ellipsoid.
[[nodiscard]] TriangleMesh ball(Vec3 centre, Vec3 radii, Rgb colour, int detail = 12);
[[nodiscard]] inline TriangleMesh ball(Vec3 centre, double r, Rgb colour, int detail = 12) {
    return ball(centre, {r, r, r}, colour, detail);
}

/// Catmull-Rom through the points, `steps` pieces between two of them; the first and last point are kept.
[[nodiscard]] std::vector<Point> spline(const std::vector<Point>& points, int steps);
/// The same for a closed ring.
[[nodiscard]] std::vector<Point> closed_spline(const std::vector<Point>& points, int steps);

}  // namespace core::starter
