#pragma once
// An animal's head seen from the front, as most people draw it: a cat is a round face with two ears and whiskers.
// The face looks to +z; with a body it is a toy animal that sits and looks at the viewer.

#include "core/mesh/triangle_mesh.hpp"
#include "core/starter/kit/palette.hpp"

namespace core::starter {

/// A draped ear leaves the crown sideways and hangs from there, apart from the cheek.
enum class FaceEar { Pointed, Round, Long, Hanging, Draped };

/// Lengths in units of a head about 1 wide; angles in degrees.
struct Face {
    double width = 0.46, height = 0.42, depth = 0.26;  ///< half sizes of the head
    double chin = 0.0;                                 ///< how far the jaw reaches below the head
    FaceEar ear = FaceEar::Pointed;
    double ear_length = 0.3, ear_width = 0.15;  ///< from the head's surface to the tip; half width at the root
    double ear_place = 38;                      ///< from the crown to the ear's root, along the head
    double ear_lean = 22;                       ///< of the ear, away from straight up
    double muzzle = 0.17;                       ///< radius of the light part round the nose; 0: none
    double whiskers = 0.0;                      ///< length beyond the cheek
    double body = 0.0;                          ///< height of the body below the head; 0: the head alone
    Rgb coat = kOrange, light = kCream, inner_ear = kPink, nose = kRose;
};

[[nodiscard]] TriangleMesh animal_face(const Face& f);

}  // namespace core::starter
