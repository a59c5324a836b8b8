#pragma once
// Soft bodies: capsules and ellipsoids that flow into each other, meshed at one resolution. Made for animals.
//
// The field is a polynomial smooth minimum of distances (I. Quilez, "smooth minimum" and "distance functions"); the
// surface is found by surface nets (Gibson 1998), which give a closed, consistently oriented mesh with even triangles;
// each vertex then takes one step along the gradient onto the surface and the colour of the nearest primitive.

#include <vector>

#include "core/mesh/triangle_mesh.hpp"
#include "core/starter/kit/palette.hpp"
#include "core/starter/kit/sweep.hpp"

namespace core::starter {

class Blob {
  public:
    /// `blend`: how far from a joint two primitives flow into each other.
    explicit Blob(double blend) : blend_(blend) {}

    /// Changes the blend for the primitives added from here on: how they flow into what is there already.
    Blob& blending(double blend) {
        blend_ = blend;
        return *this;
    }
    /// A capsule with a radius at either end.
    Blob& limb(Vec3 a, Vec3 b, double ra, double rb, Rgb colour);
    /// Capsules through the stations ("side" is not used).
    Blob& chain(const std::vector<Station>& stations, Rgb colour);
    /// An ellipsoid, turned about its own z axis by `tilt_degrees`.
    Blob& egg(Vec3 centre, Vec3 radii, Rgb colour, double tilt_degrees = 0.0);
    /// As above, once more at -z.
    Blob& limb_pair(Vec3 a, Vec3 b, double ra, double rb, Rgb colour);
    Blob& egg_pair(Vec3 centre, Vec3 radii, Rgb colour, double tilt_degrees = 0.0);

    /// The surface, with cells of 1 / `cells` of the longest side of the bounding box. Time grows with cells squared
    /// times the number of primitives. Details thinner than two cells may vanish.
    /// Cells are made larger where the surface would
    /// have more than about `kMostTriangles`.
    [[nodiscard]] TriangleMesh mesh(int cells = 64) const;
    static constexpr std::size_t kMostTriangles = 7000;

  private:
    TriangleMesh meshed(int cells) const;
    /// The primitives that can matter within `radius` of a place, as a body of their own: the same field there.
    Blob nearby(Vec3 place, double radius) const;
    double longest_blend() const;

    struct Primitive {
        bool is_egg = false;
        Vec3 a, b;  ///< capsule: its ends; ellipsoid: centre and radii
        double ra = 0.0, rb = 0.0;
        double cosine = 1.0, sine = 0.0;  ///< ellipsoid: tilt
        Rgb colour;
        double blend = 0.0;
    };
    static double distance_to(const Primitive& primitive, Vec3 p);
    double field(Vec3 p) const;
    Vec3 gradient(Vec3 p, double step) const;
    Rgb colour_at(Vec3 p, double softness) const;

    double blend_;
    std::vector<Primitive> primitives_;
};

}  // namespace core::starter
