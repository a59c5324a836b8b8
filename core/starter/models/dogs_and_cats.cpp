// Dogs and cats, on their feet and face to face.

#include <cmath>

#include "core/starter/kit/face.hpp"
#include "core/starter/kit/quadruped.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

TriangleMesh finished(const Quadruped& q) {
    return facing_front(quadruped(q).mesh());
}

Quadruped dog_shape() {
    Quadruped q;
    q.length = 0.72;
    q.shoulder = q.hip = 0.66;
    q.chest = 0.19;
    q.belly = 0.155;
    q.rump = 0.165;
    q.thigh = 0.085;
    q.ankle = 0.05;
    q.foot = 0.06;
    q.stride = 0.12;
    q.neck_angle = 58;
    q.neck_length = 0.26;
    q.neck_base = 0.13;
    q.neck_top = 0.11;
    q.skull = 0.145;
    q.muzzle = 0.075;
    q.head_length = 0.29;
    q.head_angle = 14;
    q.ear = Ear::Floppy;
    q.ear_length = 0.21;
    q.ear_width = 0.07;
    q.eye = 0.026;
    q.nose = true;
    q.tail = {{{0.02, 0, 0}, 0.045}, {{-0.12, 0.1, 0}, 0.04}, {{-0.2, 0.27, 0}, 0.03}, {{-0.19, 0.38, 0}, 0.015}};
    q.tint(kHoney);
    q.foot_colour = q.muzzle_colour = kCream;
    q.ear_colour = kWalnut;
    return q;
}

void add_dogs(Models& models) {
    const Quadruped q = dog_shape();
    add_model(models, "dog", "Friendly dog", finished(q));
    Quadruped dachshund = q;
    dachshund.length = 1.05;
    dachshund.shoulder = dachshund.hip = 0.38;
    dachshund.chest = dachshund.belly = dachshund.rump = 0.155;
    dachshund.stride = 0.08;
    dachshund.head_length = 0.36;
    dachshund.ear_length = 0.24;
    dachshund.tail = {{{0.02, 0, 0}, 0.04}, {{-0.2, 0.06, 0}, 0.03}, {{-0.4, 0.16, 0}, 0.012}};
    dachshund.tint(kChestnut);
    dachshund.ear_colour = kCocoa;
    dachshund.foot_colour = dachshund.muzzle_colour = kTan;
    add_model(models, "dog", "Dachshund", finished(dachshund));
    Quadruped shepherd = q;
    shepherd.length = 0.8;
    shepherd.shoulder = 0.76;
    shepherd.hip = 0.7;
    shepherd.ear = Ear::Pointed;
    shepherd.ear_length = 0.2;
    shepherd.ear_width = 0.06;
    shepherd.head_length = 0.34;
    shepherd.tail = {
        {{0.02, 0, 0}, 0.05}, {{-0.14, -0.1, 0}, 0.06}, {{-0.22, -0.32, 0}, 0.05}, {{-0.3, -0.42, 0}, 0.015}};
    shepherd.tint(kTan);
    shepherd.muzzle_colour = kCocoa;
    shepherd.ear_colour = kCocoa;
    shepherd.tail_colour = kCocoa;
    shepherd.coat = kWalnut;
    add_model(models, "dog", "Shepherd dog", finished(shepherd));
    Quadruped poodle = q;
    poodle.tint(kPink);
    poodle.foot_colour = kPink;
    poodle.muzzle_colour = kPink;
    poodle.length = 0.58;
    poodle.shoulder = poodle.hip = 0.7;
    poodle.thigh = 0.06;
    poodle.ankle = 0.04;
    poodle.stride = 0.13;
    poodle.neck_angle = 70;
    poodle.neck_length = 0.34;
    poodle.neck_base = 0.11;
    poodle.neck_top = 0.08;
    poodle.skull = 0.12;
    poodle.muzzle = 0.055;
    poodle.tail = {{{0.02, 0, 0}, 0.025}, {{-0.1, 0.14, 0}, 0.025}, {{-0.13, 0.26, 0}, 0.025}};
    Animal curly = quadruped(poodle);
    curly.details.add(ball(curly.rump + Vec3{-0.14, 0.32, 0}, 0.1, kRose))
        .add(ball(curly.head + Vec3{-0.02, 0.15, 0}, {0.13, 0.12, 0.13}, kRose));
    for (const double x : {-1.0, 1.0})
        for (const double side : {1.0, -1.0})
            curly.details.add(
                ball({x * poodle.length / 2 + side * poodle.stride * 0.85, 0.16, side * poodle.spread}, 0.09, kRose));
    add_model(models, "dog", "Poodle", facing_front(curly.mesh()));
    const Face face{.width = 0.42,
                    .height = 0.46,
                    .ear = FaceEar::Hanging,
                    .ear_length = 0.52,
                    .ear_width = 0.13,
                    .ear_place = 58,
                    .ear_lean = 122,
                    .muzzle = 0.2,
                    .coat = kHoney,
                    .inner_ear = kWalnut,
                    .nose = kInk};
    add_model(models, "dog", "Dog's face", animal_face(face));
    Face spaniel = face;
    spaniel.width = 0.38;
    spaniel.chin = 0.16;
    spaniel.ear_length = 0.68;
    spaniel.ear_width = 0.16;
    spaniel.ear_lean = 148;
    spaniel.coat = kWhite;
    spaniel.inner_ear = kChestnut;
    add_model(models, "dog", "Spaniel's face", animal_face(spaniel));
    Face puppy = face;
    puppy.body = 0.72;
    puppy.width = 0.4;
    puppy.height = 0.38;
    puppy.ear_length = 0.36;
    puppy.ear_lean = 132;
    puppy.coat = kTan;
    puppy.inner_ear = kCocoa;
    add_model(models, "dog", "Sitting puppy", animal_face(puppy));
}

/// A dog on its haunches, seen from the side.
TriangleMesh sitting_dog(Rgb coat, Rgb ear, Rgb light) {
    Blob b(0.07);
    b.limb({-0.2, 0.24, 0}, {0.1, 0.68, 0}, 0.22, 0.15, coat)
        .egg_pair({-0.1, 0.17, 0.14}, {0.21, 0.17, 0.1}, coat, 15)
        .limb({0.1, 0.68, 0}, {0.14, 0.9, 0}, 0.13, 0.12, coat)
        .egg({0.18, 1.0, 0}, {0.19, 0.17, 0.16}, coat)
        .limb({0.26, 0.95, 0}, {0.5, 0.9, 0}, 0.1, 0.075, light);
    b.blending(0.03)
        .limb_pair({0.14, 0.55, 0.08}, {0.2, 0.06, 0.1}, 0.075, 0.055, coat)
        .limb_pair({0.2, 0.05, 0.1}, {0.3, 0.05, 0.1}, 0.055, 0.05, light)
        .limb_pair({-0.08, 0.05, 0.17}, {0.08, 0.05, 0.18}, 0.06, 0.055, light);
    Assembly a;
    a.add(b.mesh(46))
        .pair(ear_shape({0.08, 1.1, 0.14}, {-0.12, -0.34, 0.06}, 0.085, 0.035, Ear::Floppy, ear))
        .pair(ball({0.3, 1.06, 0.12}, 0.026, kInk, 8))
        .add(ball({0.57, 0.93, 0}, 0.04, kInk, 8))
        .add(tube({{{-0.32, 0.16, 0}, 0.05}, {{-0.52, 0.18, 0}, 0.045}, {{-0.66, 0.34, 0}, 0.025}}, coat));
    return facing_front(a.mesh());
}

/// A dog's head from the side: a long muzzle, and the ear hanging behind the cheek.
TriangleMesh dog_head_in_profile(double muzzle, double ear, Rgb coat, Rgb ear_colour, Rgb light) {
    Blob b(0.07);
    b.egg({0, 0, 0}, {0.34, 0.31, 0.22}, coat)
        .limb({0.15, -0.06, 0}, {0.28 + muzzle, -0.14, 0}, 0.19, 0.13, light)
        .limb({-0.1, -0.1, 0}, {-0.18, -0.5, 0}, 0.22, 0.26, coat);
    b.blending(0.02).limb_pair({-0.06, 0.2, 0.17}, {-0.22, -0.04, 0.23}, 0.07, 0.1, ear_colour);
    b.limb_pair({-0.22, -0.04, 0.23}, {-0.34, -ear, 0.25}, 0.1, 0.11, ear_colour);
    Assembly a;
    a.add(b.mesh(46))
        .pair(ball({0.16, 0.1, 0.17}, 0.04, kInk, 8))
        .add(ball({0.38 + muzzle, -0.06, 0}, 0.065, kInk, 10))
        .add(ring({-0.2, -0.5, 0}, {0, 1, 0}, 0.25, 0.03, kRed, 30));
    return facing_front(a.mesh());
}

/// Faces whose ears come from the crown, as people draw a dog, and dogs that sit.
void add_more_dogs(Models& models) {
    const Face beagle{.width = 0.34,
                      .height = 0.42,
                      .ear = FaceEar::Draped,
                      .ear_length = 0.62,
                      .ear_width = 0.11,
                      .ear_place = 36,
                      .ear_lean = 76,
                      .muzzle = 0.17,
                      .coat = kWhite,
                      .inner_ear = kHoney,
                      .nose = kInk};
    add_model(models, "dog", "Beagle's face", animal_face(beagle));
    Face hound = beagle;
    hound.chin = 0.12;
    hound.ear_length = 0.78;
    hound.ear_width = 0.12;
    hound.ear_place = 44;
    hound.ear_lean = 104;
    hound.coat = kChestnut;
    hound.light = kTan;
    hound.inner_ear = kCocoa;
    add_model(models, "dog", "Bloodhound's face", animal_face(hound));
    add_model(models, "dog", "Sitting dog", sitting_dog(kTan, kWalnut, kCream));
    add_model(models, "dog", "Hound's head", dog_head_in_profile(0.34, 0.5, kHoney, kWalnut, kCream));
    Quadruped stout = dog_shape();
    stout.length = 0.66;
    stout.shoulder = stout.hip = 0.46;
    stout.chest = stout.belly = stout.rump = 0.2;
    stout.thigh = 0.09;
    stout.ankle = 0.07;
    stout.foot = 0.08;
    stout.neck_length = 0.18;
    stout.neck_base = 0.16;
    stout.neck_top = 0.15;
    stout.skull = 0.19;
    stout.ear_length = 0.3;
    stout.ear_width = 0.09;
    stout.tail = {{{0.02, 0.04, 0}, 0.04}, {{-0.08, 0.16, 0}, 0.04}, {{-0.1, 0.3, 0}, 0.02}};
    stout.tint(kWhite);
    stout.ear_colour = kInk;
    stout.foot_colour = stout.muzzle_colour = kCream;
    add_model(models, "dog", "Stout puppy", facing_front(quadruped(stout).mesh(48)));
    Quadruped corgi = stout;
    corgi.length = 0.84;
    corgi.shoulder = corgi.hip = 0.4;
    corgi.chest = corgi.belly = corgi.rump = 0.17;
    corgi.ear = Ear::Pointed;
    corgi.ear_length = 0.24;
    corgi.ear_width = 0.075;
    corgi.neck_length = 0.24;
    corgi.tint(kOrange);
    corgi.foot_colour = corgi.muzzle_colour = kWhite;
    corgi.tail = {{{0.02, 0.04, 0}, 0.05}, {{-0.14, 0.1, 0}, 0.05}, {{-0.26, 0.22, 0}, 0.02}};
    add_model(models, "dog", "Corgi", facing_front(quadruped(corgi).mesh(48)));
}

Quadruped cat_shape() {
    Quadruped q = dog_shape();
    q.length = 0.6;
    q.shoulder = q.hip = 0.5;
    q.chest = 0.15;
    q.belly = 0.155;
    q.rump = 0.16;
    q.thigh = 0.07;
    q.ankle = 0.046;
    q.foot = 0.055;
    q.stride = 0.1;
    q.neck_angle = 52;
    q.neck_length = 0.17;
    q.neck_base = q.neck_top = 0.11;
    q.skull = 0.165;
    q.muzzle = 0.075;
    q.head_length = 0.17;
    q.head_angle = 12;
    q.ear = Ear::Pointed;
    q.ear_length = 0.17;
    q.ear_width = 0.07;
    q.tail = {{{0.03, 0.02, 0}, 0.045},
              {{-0.14, 0.06, 0}, 0.042},
              {{-0.24, 0.26, 0}, 0.04},
              {{-0.2, 0.48, 0}, 0.038},
              {{-0.28, 0.62, 0}, 0.03}};
    q.tint(kOrange);
    q.foot_colour = q.muzzle_colour = kCream;
    return q;
}

/// Whiskers and, seen from the front, the face of a cat.
TriangleMesh make_cat(const Quadruped& q, Rgb stripe, int stripes) {
    Animal a = quadruped(q, 0.07);
    for (const double up : {-0.5, 0.0, 0.5}) {
        const Vec3 from = a.muzzle_tip + Vec3{-0.01, 0.0, q.muzzle * 0.6};
        a.details.pair(tube({{from, 0.005}, {from + Vec3{-0.03, 0.06 * up, 0.17}, 0.004}}, kCream, {.sides = 5}));
    }
    TriangleMesh body = painted(a.body.mesh(56), [&](Vec3 p, Rgb c) {
        const bool back = p.y > q.hip && p.x < q.length * 0.42;
        return stripes > 0 && back && std::sin(p.x * stripes + 1.0) > 0.45 ? stripe : c;
    });
    join(body, painted(a.details.mesh(), [&](Vec3 p, Rgb c) {
             return stripes > 0 && c == q.tail_colour && p.x < a.rump.x && std::sin((p.y - p.x) * stripes) > 0.45
                        ? stripe
                        : c;
         }));
    return facing_front(body);
}

/// A cat on its haunches: the profile children draw most after the standing one.
TriangleMesh sitting_cat(Rgb coat, Rgb light) {
    Blob b(0.08);
    b.limb({-0.16, 0.22, 0}, {0.08, 0.6, 0}, 0.23, 0.15, coat)
        .egg_pair({-0.06, 0.17, 0.15}, {0.2, 0.17, 0.1}, coat, 20);
    b.limb({0.08, 0.6, 0}, {0.14, 0.82, 0}, 0.13, 0.12, coat).egg({0.17, 0.88, 0}, {0.18, 0.165, 0.17}, coat);
    b.limb({0.24, 0.83, 0}, {0.33, 0.81, 0}, 0.08, 0.06, light).blending(0.03);
    b.limb_pair({0.1, 0.5, 0.08}, {0.19, 0.06, 0.09}, 0.07, 0.05, coat)
        .limb_pair({0.19, 0.05, 0.09}, {0.26, 0.05, 0.09}, 0.055, 0.05, light);
    b.limb_pair({-0.06, 0.05, 0.17}, {0.08, 0.05, 0.18}, 0.06, 0.055, light);
    Assembly a;
    a.add(b.mesh(56))
        .pair(ear_shape({0.13, 1.0, 0.09}, {-0.02, 0.17, 0.05}, 0.07, 0.03, Ear::Pointed, coat))
        .pair(ball({0.3, 0.92, 0.11}, 0.026, kInk, 8))
        .add(ball({0.385, 0.83, 0}, 0.025, kRose, 8));
    a.add(tube({{{-0.3, 0.1, 0}, 0.05}, {{-0.52, 0.07, 0}, 0.045}, {{-0.66, 0.2, 0}, 0.04}, {{-0.6, 0.36, 0}, 0.03}},
               coat));
    return facing_front(a.mesh());
}

void add_cats(Models& models) {
    const Quadruped q = cat_shape();
    add_model(models, "cat", "Ginger cat", make_cat(q, kBrick, 34));
    add_model(models, "cat", "Sitting cat", sitting_cat(kSlate, kWhite));
    Quadruped siamese = q;
    siamese.tint(kCream);
    siamese.leg_colour = siamese.ear_colour = siamese.tail_colour = siamese.muzzle_colour = siamese.foot_colour =
        kCocoa;
    siamese.shoulder = siamese.hip = 0.58;
    siamese.chest = siamese.belly = siamese.rump = 0.125;
    siamese.ear_length = 0.22;
    siamese.skull = 0.14;
    siamese.tail = {
        {{0.03, 0.02, 0}, 0.03}, {{-0.2, 0.02, 0}, 0.028}, {{-0.4, 0.1, 0}, 0.026}, {{-0.5, 0.28, 0}, 0.022}};
    add_model(models, "cat", "Siamese cat", make_cat(siamese, kCocoa, 0));
    Quadruped fluffy = q;
    fluffy.tint(kStone);
    fluffy.chest = fluffy.belly = fluffy.rump = 0.21;
    fluffy.shoulder = fluffy.hip = 0.48;
    fluffy.skull = 0.19;
    fluffy.tail = {
        {{0.03, 0.02, 0}, 0.08}, {{-0.16, 0.12, 0}, 0.11}, {{-0.26, 0.34, 0}, 0.12}, {{-0.24, 0.55, 0}, 0.07}};
    add_model(models, "cat", "Fluffy cat", make_cat(fluffy, kGrey, 0));
    const Face face{.whiskers = 0.3};
    add_model(models, "cat", "Cat's face", animal_face(face));
    Face black = face;
    black.width = 0.5;
    black.height = 0.4;
    black.ear_length = 0.36;
    black.ear_place = 42;
    black.ear_lean = 28;
    black.whiskers = 0.22;
    black.coat = mixed(kInk, kSlate, 0.4);
    black.light = kStone;
    add_model(models, "cat", "Black cat's face", animal_face(black));
    Face white = face;
    white.width = 0.42;
    white.height = 0.42;
    white.ear_length = 0.34;
    white.ear_width = 0.13;
    white.ear_lean = 14;
    white.whiskers = 0.0;
    white.coat = kWhite;
    white.light = kCream;
    add_model(models, "cat", "Kitten's face", animal_face(white));
    Face looking = face;
    looking.body = 0.7;
    looking.whiskers = 0.18;
    looking.coat = kGrey;
    add_model(models, "cat", "Cat looking up", animal_face(looking));
}

}  // namespace

void add_dogs_and_cats(Models& models) {
    add_dogs(models);
    add_more_dogs(models);
    add_cats(models);
}

}  // namespace core::starter
