#pragma once
// A four-legged animal from its proportions. Profile frame: head towards +x, feet on y = 0, legs apart in the profile.

#include <vector>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/blob.hpp"

namespace core::starter {

enum class Ear { None, Pointed, Round, Floppy };

/// Lengths in units of a body about 1 long; angles in degrees.
struct Quadruped {
    double length = 0.9;                             ///< hip to shoulder
    double shoulder = 0.95, hip = 0.95;              ///< heights of the body's axis
    double chest = 0.2, belly = 0.18, rump = 0.2;    ///< radii of the body
    double sag = 0.0;                                ///< how far the belly hangs below the axis
    double thigh = 0.1, ankle = 0.045, foot = 0.06;  ///< radii of the leg
    double stride = 0.16;                            ///< feet before and behind the joint
    double spread = 0.11;                            ///< feet from the middle plane
    double neck_angle = 50, neck_length = 0.5, neck_base = 0.14, neck_top = 0.09;
    double skull = 0.11, muzzle = 0.065, head_length = 0.3, head_angle = 40;  ///< head_angle: down from level
    Ear ear = Ear::Pointed;
    double ear_length = 0.14, ear_width = 0.05;
    std::vector<Station> tail;  ///< relative to the end of the rump; tube stations
    double eye = 0.022;
    bool nose = false;  ///< a dark ball at the muzzle's tip
    Rgb coat = kChestnut, underside = kChestnut, leg_colour = kChestnut, foot_colour = kInk, muzzle_colour = kCocoa,
        tail_colour = kInk, ear_colour = kChestnut;

    /// One colour for all but feet and muzzle.
    void tint(Rgb colour);
};

/// The animal before its surface is made, with the places where horns, manes and trunks go.
struct Animal {
    Blob body;
    Assembly details;  ///< ears, eyes, tail
    Vec3 neck_base, head, muzzle_tip, rump;
    Vec3 head_forward;  ///< unit, from skull to muzzle
    Vec3 head_up;       ///< unit, across it in the profile plane
    Vec3 neck_forward, neck_up;

    /// The finished mesh, still in the profile frame.
    [[nodiscard]] TriangleMesh mesh(int cells = 60) const;
};

[[nodiscard]] Animal quadruped(const Quadruped& q, double blend = 0.09);

/// A flat ear or leaf: from `root` along `along` (with its length), `width` half wide in the profile plane.
[[nodiscard]] TriangleMesh ear_shape(Vec3 root, Vec3 along, double width, double thickness, Ear shape, Rgb colour);

}  // namespace core::starter
