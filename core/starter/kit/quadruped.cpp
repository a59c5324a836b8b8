#include "core/starter/kit/quadruped.hpp"

#include <cmath>
#include <numbers>

namespace core::starter {

void Quadruped::tint(Rgb colour) {
    coat = underside = leg_colour = ear_colour = tail_colour = colour;
}

namespace {

Vec3 heading(double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle), 0.0};
}

/// One leg from the body to the ground: thigh, shank, foot. `bend` moves the middle joint forward.
void add_leg(Blob& body, const Quadruped& q, double x, double top, double foot_x, double z, double bend, double blend) {
    const Vec3 joint{x, top, z * 0.75};
    const Vec3 knee{x + (foot_x - x) * 0.5 + bend, top * 0.5, z};
    const Vec3 ankle{foot_x, q.foot * 1.2, z};
    body.limb(joint, knee, q.thigh, (q.thigh + q.ankle) * 0.5, q.leg_colour);
    body.blending(q.ankle * 0.5);
    body.limb(knee, ankle, (q.thigh + q.ankle) * 0.5, q.ankle, q.leg_colour);
    body.limb({foot_x - 0.1 * q.foot, q.foot, z}, {foot_x + 0.6 * q.foot, q.foot * 0.85, z}, q.foot, q.foot * 0.85,
              q.foot_colour);
    body.blending(blend);
}

void add_legs(Blob& body, const Quadruped& q, double blend) {
    const double half = q.length / 2;
    for (const double side : {1.0, -1.0}) {
        const double step = side * q.stride;
        add_leg(body, q, half - 0.1 * q.chest, q.shoulder - 0.35 * q.chest, half + step - 0.03, side * q.spread, 0.015,
                blend);
        add_leg(body, q, -half, q.hip - 0.25 * q.rump, -half + step - 0.01, side * q.spread, -0.035, blend);
    }
}

void add_ears(Animal& animal, const Quadruped& q) {
    if (q.ear == Ear::None) return;
    const bool hanging = q.ear == Ear::Floppy;
    const Vec3 root = animal.head + animal.head_up * (0.7 * q.skull) - animal.head_forward * (0.45 * q.skull) +
                      Vec3{0.0, 0.0, 0.6 * q.skull};
    const Vec3 upward = normalised(animal.head_up * 0.9 + Vec3{-0.15, 0.5, 0.35});
    const Vec3 along = hanging ? Vec3{-0.35, -1.0, 0.3} : upward;
    animal.details.pair(
        ear_shape(root, normalised(along) * q.ear_length, q.ear_width, q.ear_width * 0.4, q.ear, q.ear_colour));
}

}  // namespace

TriangleMesh ear_shape(Vec3 root, Vec3 along, double width, double thickness, Ear shape, Rgb colour) {
    const auto at = [&](double t) { return root + along * t; };
    switch (shape) {
        case Ear::Round:
            return tube({{at(-0.1), width * 0.6, thickness},
                         {at(0.4), width, thickness},
                         {at(0.8), width * 0.75, thickness},
                         {at(1.0), width * 0.3, thickness * 0.6}},
                        colour);
        case Ear::Floppy:
            return tube({{at(0.0), width * 0.5, thickness},
                         {at(0.35), width * 0.9, thickness},
                         {at(0.75), width, thickness},
                         {at(1.0), width * 0.45, thickness * 0.6}},
                        colour);
        default:
            return tube({{at(-0.15), width, thickness},
                         {at(0.35), width * 0.85, thickness},
                         {at(0.75), width * 0.45, thickness * 0.7},
                         {at(1.0), width * 0.1, thickness * 0.2}},
                        colour);
    }
}

Animal quadruped(const Quadruped& q, double blend) {
    Animal animal{Blob(blend), {}, {}, {}, {}, {}, {}, {}, {}, {}};
    const double half = q.length / 2;
    const Vec3 front{half, q.shoulder, 0.0}, back{-half, q.hip, 0.0};
    const Vec3 middle{0.0, (q.shoulder + q.hip) / 2 - q.sag, 0.0};
    animal.body.limb(back, middle, q.rump, q.belly, q.coat).limb(middle, front, q.belly, q.chest, q.coat);
    if (!(q.underside == q.coat))
        animal.body.limb(middle + Vec3{-half * 0.6, -q.belly * 0.42, 0}, middle + Vec3{half * 0.6, -q.belly * 0.42, 0},
                         q.belly * 0.7, q.belly * 0.7, q.underside);
    add_legs(animal.body, q, blend);

    animal.neck_forward = heading(q.neck_angle);
    animal.neck_up = heading(q.neck_angle + 90);
    animal.neck_base = front + animal.neck_forward * (0.35 * q.chest);
    animal.head = front + animal.neck_forward * (q.neck_length + 0.5 * q.chest);
    animal.body.limb(animal.neck_base, animal.head, q.neck_base, q.neck_top, q.coat);

    animal.head_forward = heading(-q.head_angle);
    animal.head_up = heading(90 - q.head_angle);
    animal.muzzle_tip = animal.head + animal.head_forward * q.head_length;
    animal.body.egg(animal.head, {q.skull * 1.08, q.skull, q.skull * 0.9}, q.coat, -q.head_angle);
    const Vec3 bridge = animal.head + animal.head_forward * (0.62 * q.head_length) - animal.head_up * (0.2 * q.skull);
    animal.body.limb(animal.head, bridge, q.skull * 0.8, q.muzzle, q.coat);
    animal.body.limb(bridge, animal.muzzle_tip - animal.head_up * (0.25 * q.skull), q.muzzle, q.muzzle * 0.9,
                     q.muzzle_colour);

    add_ears(animal, q);
    animal.rump = back + Vec3{-q.rump * 0.85, q.rump * 0.35, 0.0};
    if (!q.tail.empty()) {
        std::vector<Station> tail = q.tail;
        for (Station& s : tail) s.at = s.at + animal.rump;
        animal.details.add(tube(tail, q.tail_colour));
    }
    const Vec3 eye = animal.head + animal.head_forward * (0.45 * q.skull) + animal.head_up * (0.3 * q.skull) +
                     Vec3{0.0, 0.0, 0.74 * q.skull};
    animal.details.pair(ball(eye, q.eye, kInk, 8));
    if (q.nose)
        animal.details.add(ball(animal.muzzle_tip + animal.head_forward * (q.muzzle * 0.55), q.muzzle * 0.5, kInk, 8));
    return animal;
}

TriangleMesh Animal::mesh(int cells) const {
    TriangleMesh all = body.mesh(cells);
    join(all, details.mesh());
    return all;
}

}  // namespace core::starter
