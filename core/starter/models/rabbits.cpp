// Rabbits, from the side and face to face.

#include <cmath>

#include "core/starter/kit/face.hpp"
#include "core/starter/kit/quadruped.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

TriangleMesh rabbit(double body, double ear, double lean, Rgb coat, Rgb light) {
    Blob b(0.07);
    b.egg({-0.18, 0.26, 0}, {0.28 * body, 0.24 * body, 0.2 * body}, coat, 15)
        .limb({-0.02, 0.3, 0}, {0.16, 0.38 + lean, 0}, 0.18, 0.13, coat);
    const Vec3 head{0.28, 0.52 + lean, 0};
    b.egg(head, {0.155, 0.135, 0.12}, coat, -12)
        .limb(head + Vec3{0.08, -0.03, 0}, head + Vec3{0.14, -0.04, 0}, 0.08, 0.065, light);
    b.egg({-0.45 * body, 0.24, 0}, {0.09, 0.09, 0.09}, light).blending(0.03);
    b.egg_pair({-0.2, 0.17, 0.14 * body}, {0.17, 0.14, 0.08}, coat, 10)
        .limb_pair({-0.22, 0.04, 0.15}, {0.06, 0.04, 0.15}, 0.048, 0.045, light);
    b.limb_pair({0.13, 0.28, 0.08}, {0.2, 0.05, 0.09}, 0.06, 0.04, coat)
        .limb_pair({0.2, 0.04, 0.09}, {0.26, 0.04, 0.09}, 0.042, 0.038, light);
    Assembly a;
    a.add(b.mesh(58))
        .pair(ball(head + Vec3{0.07, 0.04, 0.095}, 0.026, kInk, 8))
        .add(ball(head + Vec3{0.21, -0.03, 0}, 0.022, kRose, 8));
    a.pair(tube({{head + Vec3{-0.05, 0.08, 0.05}, 0.035, 0.025},
                 {head + Vec3{-0.1, 0.1 + ear * 0.45, 0.08}, 0.065, 0.028},
                 {head + Vec3{-0.13, 0.1 + ear, 0.1}, 0.02, 0.012}},
                coat));
    return facing_front(a.mesh());
}

/// A rabbit's head from the side, its ears laid back or up.
TriangleMesh rabbit_head(double back, Rgb coat, Rgb light) {
    Blob b(0.06);
    b.egg({0, 0, 0}, {0.34, 0.27, 0.2}, coat, -12).limb({0.12, -0.04, 0}, {0.34, -0.1, 0}, 0.16, 0.11, coat);
    b.egg({0.36, -0.12, 0}, {0.1, 0.09, 0.1}, light);
    Assembly a;
    for (const double side : {1.0, -1.0})
        a.add(tube({{{-0.14, 0.16, 0.08 * side}, 0.06, 0.04},
                    {{-0.18 - back * (0.4 + 0.12 * side), 0.52, 0.12 * side}, 0.11, 0.05},
                    {{-0.22 - back * (1.0 + 0.3 * side), 0.92, 0.14 * side}, 0.03, 0.02}},
                   side > 0 ? coat : darker(coat, 0.1)));
    a.add(b.mesh(42)).pair(ball({0.12, 0.06, 0.17}, 0.04, kInk, 8)).add(ball({0.46, -0.1, 0}, 0.035, kRose, 8));
    return facing_front(a.mesh());
}

/// A rabbit that stands upright and looks at the viewer: a head on a rounder body.
TriangleMesh upright_rabbit(double belly, double ear_lean, Rgb coat, Rgb light) {
    const Face face{.width = 0.27,
                    .height = 0.24,
                    .depth = 0.22,
                    .ear = FaceEar::Long,
                    .ear_length = 0.52,
                    .ear_width = 0.085,
                    .ear_place = 28,
                    .ear_lean = ear_lean,
                    .muzzle = 0.1,
                    .coat = coat,
                    .light = light,
                    .inner_ear = kPink};
    Blob b(0.04);
    b.egg({0, -0.52, 0}, {belly, 0.36, 0.2}, coat).egg({0, -0.54, 0.1}, {belly * 0.6, 0.26, 0.14}, light);
    b.blending(0.02);
    for (const double side : {1.0, -1.0})
        b.egg({side * belly * 0.65, -0.86, 0.06}, {0.15, 0.08, 0.13}, light)
            .limb({side * belly * 0.8, -0.38, 0.04}, {side * (belly + 0.14), -0.5, 0.08}, 0.07, 0.06, coat);
    Assembly a;
    a.add(animal_face(face)).add(scaled(b.mesh(36), {1, 1, 0.7}));
    return a.mesh();
}

}  // namespace

void add_rabbits(Models& models) {
    add_model(models, "rabbit", "Brown rabbit", rabbit(1.0, 0.34, 0.0, kTan, kCream));
    add_model(models, "rabbit", "White rabbit", rabbit(1.12, 0.3, 0.04, kWhite, kPink));
    const Face face{.width = 0.36,
                    .height = 0.35,
                    .depth = 0.24,
                    .ear = FaceEar::Long,
                    .ear_length = 0.62,
                    .ear_width = 0.11,
                    .ear_place = 22,
                    .ear_lean = 9,
                    .muzzle = 0.14,
                    .coat = kStone,
                    .light = kWhite,
                    .inner_ear = kPink};
    add_model(models, "rabbit", "Rabbit's face", animal_face(face));
    Face lop = face;
    lop.ear_lean = 26;
    lop.ear_width = 0.13;
    lop.ear_length = 0.5;
    lop.whiskers = 0.14;
    lop.coat = kHoney;
    add_model(models, "rabbit", "Hare's face", animal_face(lop));
    Face sitting = face;
    sitting.body = 0.62;
    sitting.ear_length = 0.5;
    sitting.coat = kWhite;
    sitting.light = kCream;
    add_model(models, "rabbit", "Sitting rabbit", animal_face(sitting));
    Face toy = face;
    toy.width = 0.42;
    toy.height = 0.36;
    toy.ear_length = 0.42;
    toy.ear_width = 0.14;
    toy.ear_place = 30;
    toy.ear_lean = 16;
    toy.coat = kCocoa;
    toy.light = kTan;
    add_model(models, "rabbit", "Chocolate rabbit", animal_face(toy));
    Face apart = face;
    apart.ear_length = 0.7;
    apart.ear_width = 0.14;
    apart.ear_place = 40;
    apart.ear_lean = 36;
    apart.coat = kCream;
    apart.light = kWhite;
    add_model(models, "rabbit", "Rabbit with ears apart", animal_face(apart));
    Face slim = face;
    slim.width = 0.33;
    slim.height = 0.38;
    slim.ear_length = 0.82;
    slim.ear_width = 0.13;
    slim.ear_place = 30;
    slim.ear_lean = 6;
    slim.coat = kGrey;
    add_model(models, "rabbit", "Long-eared rabbit", animal_face(slim));
    add_model(models, "rabbit", "Rabbit's head", rabbit_head(0.3, kTan, kCream));
    add_model(models, "rabbit", "Easter bunny", upright_rabbit(0.34, 22, kHoney, kCream));
}

}  // namespace core::starter
