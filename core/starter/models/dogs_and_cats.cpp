// Dogs and cats, great and small.

#include <cmath>

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
    Quadruped bulldog = q;
    bulldog.length = 0.55;
    bulldog.shoulder = 0.48;
    bulldog.hip = 0.46;
    bulldog.chest = 0.235;
    bulldog.belly = 0.2;
    bulldog.rump = 0.18;
    bulldog.thigh = 0.1;
    bulldog.ankle = 0.07;
    bulldog.foot = 0.075;
    bulldog.spread = 0.15;
    bulldog.neck_angle = 40;
    bulldog.neck_length = 0.2;
    bulldog.neck_base = 0.18;
    bulldog.neck_top = 0.17;
    bulldog.skull = 0.19;
    bulldog.muzzle = 0.12;
    bulldog.head_length = 0.22;
    bulldog.ear_length = 0.13;
    bulldog.tail = {{{0.03, 0, 0}, 0.04}, {{-0.06, 0.06, 0}, 0.035}};
    bulldog.tint(kCream);
    bulldog.ear_colour = kHoney;
    bulldog.muzzle_colour = kIvory;
    bulldog.foot_colour = kIvory;
    add_model(models, "dog", "Bulldog", finished(bulldog));
    Quadruped greyhound = q;
    greyhound.length = 0.8;
    greyhound.shoulder = greyhound.hip = 0.84;
    greyhound.chest = 0.18;
    greyhound.belly = 0.105;
    greyhound.rump = 0.13;
    greyhound.thigh = 0.07;
    greyhound.ankle = 0.034;
    greyhound.foot = 0.045;
    greyhound.stride = 0.24;
    greyhound.neck_length = 0.36;
    greyhound.neck_base = 0.09;
    greyhound.neck_top = 0.07;
    greyhound.skull = 0.095;
    greyhound.muzzle = 0.05;
    greyhound.head_length = 0.33;
    greyhound.ear_length = 0.13;
    greyhound.ear_width = 0.04;
    greyhound.tail = {
        {{0.02, 0, 0}, 0.03}, {{-0.1, -0.2, 0}, 0.022}, {{-0.26, -0.42, 0}, 0.016}, {{-0.42, -0.4, 0}, 0.008}};
    greyhound.tint(kSlate);
    greyhound.foot_colour = greyhound.muzzle_colour = kStone;
    add_model(models, "dog", "Greyhound", finished(greyhound));
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
    Quadruped kitten = q;
    kitten.tint(kHoney);
    kitten.length = 0.38;
    kitten.shoulder = kitten.hip = 0.34;
    kitten.chest = kitten.belly = kitten.rump = 0.125;
    kitten.stride = 0.06;
    kitten.skull = 0.17;
    kitten.ear_length = 0.16;
    kitten.tail = {{{0.03, 0.02, 0}, 0.035}, {{-0.07, 0.16, 0}, 0.035}, {{-0.08, 0.36, 0}, 0.02}};
    add_model(models, "cat", "Kitten", make_cat(kitten, kCream, 40));
    Quadruped stalking = q;
    stalking.tint(kInk);
    stalking.coat = stalking.underside = stalking.leg_colour = stalking.ear_colour = stalking.tail_colour =
        mixed(kInk, kSlate, 0.35);
    stalking.muzzle_colour = stalking.foot_colour = kSlate;
    stalking.length = 0.82;
    stalking.shoulder = 0.42;
    stalking.neck_angle = 8;
    stalking.stride = 0.2;
    add_model(models, "cat", "Black cat on the prowl", make_cat(stalking, kInk, 0));
}

void add_lions_and_tigers(Models& models) {
    Quadruped q = cat_shape();
    q.length = 0.85;
    q.shoulder = 0.66;
    q.hip = 0.62;
    q.chest = 0.2;
    q.belly = 0.165;
    q.rump = 0.18;
    q.thigh = 0.095;
    q.ankle = 0.06;
    q.foot = 0.072;
    q.stride = 0.15;
    q.neck_length = 0.24;
    q.neck_base = 0.16;
    q.neck_top = 0.14;
    q.skull = 0.18;
    q.muzzle = 0.1;
    q.head_length = 0.25;
    q.ear = Ear::Round;
    q.ear_length = 0.12;
    q.ear_width = 0.065;
    q.tail = {{{0.03, 0.02, 0}, 0.032},   {{-0.14, -0.08, 0}, 0.028}, {{-0.26, -0.26, 0}, 0.025},
              {{-0.42, -0.28, 0}, 0.025}, {{-0.5, -0.2, 0}, 0.055},   {{-0.56, -0.12, 0}, 0.01}};
    const auto lion = [](Quadruped shape, Rgb coat, Rgb mane, double size) {
        shape.tint(coat);
        shape.foot_colour = coat;
        shape.muzzle_colour = lighter(coat);
        Animal a = quadruped(shape);
        a.body.blending(0.04);
        const Vec3 middle = a.head + Vec3{-0.13, -0.03, 0};
        if (size > 0) a.body.egg(middle, {0.16, size * 0.95, size * 0.9}, mane, 12);
        for (int k = 0; k < 12 && size > 0; ++k) {
            const double turn = 2.0 * 3.14159265 * k / 12;
            const Vec3 out = Vec3{-0.1 - 0.2 * std::cos(turn), std::cos(turn), std::sin(turn) * 0.95} * size;
            a.body.limb(middle, middle + out, 0.12, 0.075, mane);
        }
        return facing_front(a.mesh(60));
    };
    add_model(models, "lion", "Lion", lion(q, kStraw, kChestnut, 0.31));
    add_model(models, "lion", "Lioness", lion(q, kSand, kSand, 0.0));
    Quadruped old = q;
    old.length = 0.95;
    old.neck_angle = 20;
    old.stride = 0.24;
    add_model(models, "lion", "Walking lion", lion(old, kHoney, kCocoa, 0.33));
    Quadruped cub = q;
    cub.length = 0.5;
    cub.shoulder = cub.hip = 0.42;
    cub.chest = cub.belly = cub.rump = 0.15;
    cub.stride = 0.1;
    cub.tail = {{{0.03, 0.02, 0}, 0.025},
                {{-0.14, 0.04, 0}, 0.022},
                {{-0.24, 0.2, 0}, 0.022},
                {{-0.26, 0.28, 0}, 0.04},
                {{-0.26, 0.35, 0}, 0.01}};
    add_model(models, "lion", "Lion cub", lion(cub, kStraw, kHoney, 0.17));

    Quadruped tiger = q;
    tiger.length = 1.0;
    tiger.neck_angle = 30;
    tiger.tint(kOrange);
    tiger.muzzle_colour = tiger.foot_colour = kCream;
    tiger.tail = {{{0.03, 0.02, 0}, 0.045},
                  {{-0.16, -0.06, 0}, 0.042},
                  {{-0.3, -0.22, 0}, 0.04},
                  {{-0.48, -0.2, 0}, 0.036},
                  {{-0.56, -0.06, 0}, 0.03}};
    add_model(models, "tiger", "Tiger", make_cat(tiger, kInk, 36));
    Quadruped white = tiger;
    white.tint(kWhite);
    white.stride = 0.24;
    white.length = 1.08;
    add_model(models, "tiger", "White tiger", make_cat(white, kSlate, 34));
    Quadruped young = tiger;
    young.length = 0.62;
    young.shoulder = young.hip = 0.5;
    young.stride = 0.12;
    young.chest = young.belly = young.rump = 0.16;
    add_model(models, "tiger", "Tiger cub", make_cat(young, kCocoa, 40));
}

}  // namespace

void add_dogs_and_cats(Models& models) {
    add_dogs(models);
    add_cats(models);
    add_lions_and_tigers(models);
}

}  // namespace core::starter
