// Dogs, cats and the other four-legged animals on paws, and some on hoofs.

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

void add_pair_of_horns(Animal& a, const Quadruped& q, double out, double up, double r, Rgb colour) {
    const Vec3 root = a.head + a.head_up * (q.skull * 0.75) + Vec3{-0.02, 0, q.skull * 0.4};
    a.details.pair(
        tube({{root, r}, {root + Vec3{0.03, up * 0.35, out * 0.8}, r * 0.85}, {root + Vec3{0.08, up, out}, r * 0.2}},
             colour));
}

void add_cows(Models& models) {
    Quadruped q;
    q.length = 0.9;
    q.shoulder = q.hip = 0.72;
    q.chest = 0.25;
    q.belly = 0.26;
    q.rump = 0.24;
    q.sag = 0.03;
    q.thigh = 0.095;
    q.ankle = 0.055;
    q.stride = 0.13;
    q.neck_angle = 32;
    q.neck_length = 0.28;
    q.neck_base = 0.17;
    q.neck_top = 0.13;
    q.skull = 0.15;
    q.muzzle = 0.105;
    q.head_length = 0.3;
    q.head_angle = 38;
    q.ear = Ear::Round;
    q.ear_length = 0.15;
    q.ear_width = 0.05;
    q.tail = {{{0.03, 0, 0}, 0.03},
              {{-0.09, -0.16, 0}, 0.022},
              {{-0.1, -0.42, 0}, 0.022},
              {{-0.1, -0.5, 0}, 0.045},
              {{-0.1, -0.6, 0}, 0.012}};
    const auto cow = [](const Quadruped& shape, Rgb spot, double size, double horn_out, double horn_up, bool udder) {
        Animal a = quadruped(shape);
        add_pair_of_horns(a, shape, horn_out, horn_up, 0.034, kIvory);
        if (udder) a.body.egg({-shape.length * 0.3, shape.hip - shape.rump * 1.05, 0}, {0.13, 0.1, 0.1}, kPink);
        TriangleMesh body = painted(a.body.mesh(56), [&](Vec3 p, Rgb c) {
            const double wave = std::sin(p.x * size + 0.6) * std::sin(p.y * size * 0.9 + p.z * 2.0) +
                                0.35 * std::sin(p.z * size + p.x * 5.0);
            return c == shape.coat && wave > 0.28 ? spot : c;
        });
        join(body, a.details.mesh());
        return facing_front(body);
    };
    q.tint(kWhite);
    q.muzzle_colour = kPink;
    q.foot_colour = kSlate;
    add_model(models, "cow", "Spotted cow", cow(q, kInk, 7.0, 0.14, 0.12, true));
    Quadruped brown = q;
    brown.tint(kChestnut);
    brown.muzzle_colour = kCream;
    brown.length = 0.82;
    brown.neck_angle = 44;
    add_model(models, "cow", "Brown cow", cow(brown, kChestnut, 6.0, 0.1, 0.18, true));
    Quadruped bull = q;
    bull.tint(kCocoa);
    bull.muzzle_colour = kTan;
    bull.chest = 0.33;
    bull.shoulder = 0.78;
    bull.rump = 0.21;
    bull.belly = 0.24;
    bull.neck_base = 0.26;
    bull.neck_top = 0.18;
    bull.neck_angle = 18;
    add_model(models, "cow", "Bull", cow(bull, kCocoa, 6.0, 0.22, 0.2, false));
    Quadruped highland = q;
    highland.tint(kHoney);
    highland.shoulder = highland.hip = 0.6;
    highland.chest = highland.belly = highland.rump = 0.27;
    highland.muzzle_colour = kSand;
    add_model(models, "cow", "Highland cow", cow(highland, kOrange, 14.0, 0.38, 0.2, false));
    Quadruped calf = q;
    calf.length = 0.55;
    calf.shoulder = calf.hip = 0.62;
    calf.chest = calf.belly = calf.rump = 0.165;
    calf.thigh = 0.075;
    calf.head_length = 0.24;
    calf.neck_angle = 48;
    add_model(models, "cow", "Calf", cow(calf, kTan, 8.0, 0.05, 0.05, false));
}

void add_pigs(Models& models) {
    Quadruped q;
    q.length = 0.62;
    q.shoulder = q.hip = 0.44;
    q.chest = 0.25;
    q.belly = 0.27;
    q.rump = 0.25;
    q.thigh = 0.085;
    q.ankle = 0.058;
    q.foot = 0.06;
    q.stride = 0.1;
    q.neck_angle = 15;
    q.neck_length = 0.16;
    q.neck_base = q.neck_top = 0.19;
    q.skull = 0.19;
    q.muzzle = 0.1;
    q.head_length = 0.3;
    q.head_angle = 10;
    q.ear_length = 0.17;
    q.ear_width = 0.075;
    q.tail = {{{0.02, 0.03, 0}, 0.022},      {{-0.08, 0.06, 0.03}, 0.02},  {{-0.1, 0.14, 0}, 0.019},
              {{-0.04, 0.12, -0.03}, 0.018}, {{-0.08, 0.05, 0.02}, 0.017}, {{-0.17, 0.1, 0.02}, 0.01}};
    q.tint(kPink);
    q.muzzle_colour = kRose;
    q.foot_colour = kRose;
    const auto pig = [](const Quadruped& shape, Rgb patch, double tusk) {
        Animal a = quadruped(shape);
        const Vec3 snout = a.muzzle_tip + a.head_forward * (shape.muzzle * 0.55) - a.head_up * (0.25 * shape.skull);
        a.details.add(rod(snout, snout + a.head_forward * 0.05, shape.muzzle * 0.95, shape.muzzle_colour));
        a.details.pair(ball(snout + a.head_forward * 0.13 + Vec3{0, 0, 0.035}, {0.03, 0.03, 0.018}, kWine, 8));
        if (tusk > 0)
            a.details.pair(
                tube({{snout + Vec3{-0.06, -0.04, 0.08}, 0.022}, {snout + Vec3{0.0, tusk, 0.13}, 0.006}}, kCream));
        TriangleMesh body = painted(
            a.body.mesh(52), [&](Vec3 p, Rgb c) { return c == shape.coat && p.x > -0.12 && p.x < 0.16 ? patch : c; });
        join(body, a.details.mesh());
        return facing_front(body);
    };
    add_model(models, "pig", "Pink pig", pig(q, kPink, 0));
    Quadruped saddle = q;
    saddle.tint(kSlate);
    saddle.muzzle_colour = kRose;
    saddle.length = 0.75;
    saddle.ear = Ear::Floppy;
    saddle.ear_length = 0.22;
    add_model(models, "pig", "Saddleback pig", pig(saddle, kPink, 0));
    Quadruped boar = q;
    boar.tint(kWalnut);
    boar.muzzle_colour = kCocoa;
    boar.foot_colour = kInk;
    boar.chest = 0.29;
    boar.rump = 0.2;
    boar.shoulder = 0.54;
    boar.hip = 0.48;
    boar.head_length = 0.4;
    boar.head_angle = 24;
    add_model(models, "pig", "Wild boar", pig(boar, kWalnut, 0.14));
    Quadruped piglet = q;
    piglet.length = 0.4;
    piglet.shoulder = piglet.hip = 0.36;
    piglet.chest = piglet.belly = piglet.rump = 0.19;
    piglet.tint(kCoral);
    piglet.coat = piglet.underside = piglet.leg_colour = mixed(kPink, kCoral, 0.4);
    add_model(models, "pig", "Piglet", pig(piglet, piglet.coat, 0));
    Quadruped sow = q;
    sow.length = 0.85;
    sow.belly = 0.31;
    sow.sag = 0.03;
    sow.shoulder = sow.hip = 0.46;
    add_model(models, "pig", "Big sow", pig(sow, kPink, 0));
}

void add_sheep(Models& models) {
    Quadruped q;
    q.length = 0.56;
    q.shoulder = q.hip = 0.56;
    q.chest = q.belly = q.rump = 0.2;
    q.thigh = 0.06;
    q.ankle = 0.042;
    q.foot = 0.05;
    q.stride = 0.1;
    q.neck_angle = 40;
    q.neck_length = 0.22;
    q.neck_base = q.neck_top = 0.1;
    q.skull = 0.12;
    q.muzzle = 0.075;
    q.head_length = 0.25;
    q.head_angle = 35;
    q.ear = Ear::Floppy;
    q.ear_length = 0.14;
    q.ear_width = 0.045;
    q.tint(kInk);
    const auto sheep = [](Quadruped shape, Rgb wool, Rgb skin, double fluff, double horns) {
        shape.tint(skin);
        shape.muzzle_colour = skin;
        shape.foot_colour = darker(skin);
        Animal a = quadruped(shape);
        a.body.blending(0.03);
        for (int k = 0; k < 34; ++k) {  // curls on a spiral round the body
            const double t = (k + 0.5) / 34, height = 1.0 - 2.0 * t, turn = 2.399963 * k,
                         wide = std::sqrt(1.0 - height * height);
            a.body.egg({(shape.length * 0.5 + fluff * 0.8) * wide * std::cos(turn),
                        shape.hip + 0.05 + fluff * height * 0.95, fluff * 0.85 * wide * std::sin(turn)},
                       {0.12, 0.12, 0.12}, wool);
        }
        a.body.egg({0, shape.hip + 0.05, 0}, {shape.length * 0.5 + fluff * 0.8, fluff, fluff * 0.85}, wool)
            .egg(a.head + Vec3{-0.04, 0.11, 0}, {0.1, 0.09, 0.1}, wool)
            .egg(a.rump + Vec3{-0.1, 0.02, 0}, {0.09, 0.1, 0.08}, wool);
        if (horns > 0)
            a.details.pair(tube({{a.head + Vec3{-0.03, 0.08, 0.1}, 0.045},
                                 {a.head + Vec3{-0.15, 0.1, 0.17}, 0.045},
                                 {a.head + Vec3{-0.2, -0.05, 0.2}, 0.04},
                                 {a.head + Vec3{-0.08, -0.14, 0.23}, 0.03},
                                 {a.head + Vec3{0.04, -0.06, 0.27}, 0.012}},
                                kSand));
        return facing_front(a.mesh(56));
    };
    add_model(models, "sheep", "White sheep", sheep(q, kCream, kInk, 0.25, 0));
    Quadruped ram = q;
    ram.shoulder = ram.hip = 0.62;
    ram.length = 0.66;
    add_model(models, "sheep", "Ram", sheep(ram, kIvory, kTan, 0.24, 1));
    Quadruped lamb = q;
    lamb.length = 0.36;
    lamb.ankle = 0.035;
    lamb.neck_angle = 60;
    add_model(models, "sheep", "Lamb", sheep(lamb, kWhite, kPink, 0.18, 0));
    Quadruped black = q;
    black.length = 0.6;
    black.shoulder = black.hip = 0.48;
    add_model(models, "sheep", "Black sheep", sheep(black, kSlate, kStone, 0.28, 0));
    Quadruped grazing = q;
    grazing.neck_angle = -30;
    grazing.neck_length = 0.3;
    grazing.head_angle = 70;
    add_model(models, "sheep", "Grazing sheep", sheep(grazing, kCream, kCocoa, 0.24, 0));
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
        for (int k = 0; k < 12 && size > 0; ++k) {
            const double turn = 2.0 * 3.14159265 * k / 12;
            const Vec3 out =
                Vec3{0.3 * std::cos(turn), std::cos(turn), 0} * size + Vec3{0, 0, std::sin(turn) * size * 0.95};
            a.body.limb(a.head + Vec3{-0.1, -0.02, 0}, a.head + Vec3{-0.1, -0.02, 0} + out, 0.1, 0.07, mane);
        }
        return facing_front(a.mesh(60));
    };
    add_model(models, "lion", "Lion", lion(q, kStraw, kChestnut, 0.28));
    add_model(models, "lion", "Lioness", lion(q, kSand, kSand, 0.0));
    Quadruped old = q;
    old.length = 0.95;
    old.neck_angle = 20;
    old.stride = 0.24;
    add_model(models, "lion", "Walking lion", lion(old, kHoney, kCocoa, 0.3));
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

void add_camels(Models& models) {
    Quadruped q;
    q.length = 0.8;
    q.shoulder = q.hip = 1.0;
    q.chest = 0.2;
    q.belly = 0.2;
    q.rump = 0.18;
    q.thigh = 0.09;
    q.ankle = 0.045;
    q.foot = 0.075;
    q.stride = 0.15;
    q.neck_angle = 12;
    q.neck_length = 0.3;
    q.neck_base = 0.13;
    q.neck_top = 0.1;
    q.skull = 0.11;
    q.muzzle = 0.08;
    q.head_length = 0.3;
    q.head_angle = 8;
    q.ear_length = 0.09;
    q.ear_width = 0.035;
    q.tail = {{{0.03, 0, 0}, 0.028}, {{-0.09, -0.14, 0}, 0.02}, {{-0.1, -0.34, 0}, 0.03}, {{-0.1, -0.44, 0}, 0.01}};
    const auto camel = [](Quadruped shape, int humps, double hump, Rgb coat) {
        shape.tint(coat);
        shape.foot_colour = darker(coat, 0.4);
        shape.muzzle_colour = lighter(coat);
        Animal a = quadruped(shape);
        const double half = shape.length / 2;
        a.body.limb({half + 0.08, shape.shoulder - 0.1, 0}, {half + 0.32, shape.shoulder - 0.02, 0}, 0.13, 0.11, coat)
            .limb({half + 0.32, shape.shoulder - 0.02, 0}, a.head, 0.11, shape.neck_top, coat);
        for (int k = 0; k < humps; ++k) {
            const double x = humps == 1 ? -0.02 : -0.2 + 0.42 * k;
            a.body.limb({x, shape.hip + 0.08, 0}, {x - 0.01, shape.hip + hump, 0}, 0.19, 0.085, darker(coat, 0.12));
        }
        return facing_front(a.mesh(64));
    };
    q.neck_angle = 46;
    q.neck_length = 0.62;
    q.neck_base = 0.09;
    add_model(models, "camel", "Dromedary", camel(q, 1, 0.32, kSand));
    add_model(models, "camel", "Bactrian camel", camel(q, 2, 0.3, kTan));
    Quadruped tall = q;
    tall.shoulder = tall.hip = 1.15;
    tall.neck_angle = 56;
    tall.stride = 0.22;
    add_model(models, "camel", "Racing camel", camel(tall, 1, 0.26, kCream));
    Quadruped young = q;
    young.length = 0.6;
    young.shoulder = young.hip = 0.9;
    young.chest = young.belly = young.rump = 0.15;
    young.neck_length = 0.5;
    add_model(models, "camel", "Young camel", camel(young, 2, 0.22, kHoney));
}

void add_zebras(Models& models) {
    Quadruped q;
    q.length = 0.8;
    q.shoulder = q.hip = 0.84;
    q.chest = q.rump = 0.205;
    q.belly = 0.2;
    q.thigh = 0.085;
    q.stride = 0.14;
    q.neck_angle = 48;
    q.neck_length = 0.42;
    q.head_length = 0.31;
    q.ear_length = 0.14;
    q.ear_width = 0.045;
    q.ear = Ear::Round;
    q.tail = {
        {{0.03, 0.02, 0}, 0.028}, {{-0.1, -0.1, 0}, 0.022}, {{-0.14, -0.3, 0}, 0.035}, {{-0.14, -0.44, 0}, 0.012}};
    q.tint(kWhite);
    q.muzzle_colour = kSlate;
    const auto zebra = [](const Quadruped& shape, double pitch) {
        Animal a = quadruped(shape);
        const Vec3 along = a.head - a.neck_base;
        a.details.add(tube({{a.neck_base + along * 0.15 + a.neck_up * 0.16, 0.05, 0.03},
                            {a.neck_base + along * 0.6 + a.neck_up * 0.13, 0.09, 0.03},
                            {a.head + a.neck_up * 0.13, 0.06, 0.03}},
                           kInk));
        TriangleMesh body = painted(a.body.mesh(66), [&](Vec3 p, Rgb c) {
            if (!(c == shape.coat) || p.y < 0.1) return c;
            double phase = p.x;
            if (p.y < shape.hip - shape.rump * 0.95) phase = p.y;
            if (p.x > shape.length / 2 && p.y > shape.shoulder) phase = dot(p, a.neck_forward);
            return std::sin(phase * pitch + 0.8 * std::sin(p.y * 6.0)) > 0.1 ? kInk : c;
        });
        join(body, a.details.mesh());
        return facing_front(body);
    };
    add_model(models, "zebra", "Zebra", zebra(q, 46));
    Quadruped foal = q;
    foal.length = 0.55;
    foal.shoulder = foal.hip = 0.78;
    foal.chest = foal.belly = foal.rump = 0.155;
    foal.neck_length = 0.34;
    add_model(models, "zebra", "Zebra foal", zebra(foal, 58));
    Quadruped running = q;
    running.stride = 0.32;
    running.neck_angle = 32;
    running.length = 0.92;
    add_model(models, "zebra", "Running zebra", zebra(running, 38));
}

void add_bears(Models& models) {
    Quadruped q;
    q.length = 0.72;
    q.shoulder = 0.58;
    q.hip = 0.56;
    q.chest = 0.27;
    q.belly = 0.26;
    q.rump = 0.27;
    q.thigh = 0.13;
    q.ankle = 0.095;
    q.foot = 0.1;
    q.stride = 0.14;
    q.spread = 0.15;
    q.neck_angle = 22;
    q.neck_length = 0.26;
    q.neck_base = 0.2;
    q.neck_top = 0.17;
    q.skull = 0.19;
    q.muzzle = 0.09;
    q.head_length = 0.32;
    q.head_angle = 18;
    q.ear = Ear::Round;
    q.ear_length = 0.12;
    q.ear_width = 0.07;
    q.nose = true;
    q.tail = {{{0.02, 0, 0}, 0.06}, {{-0.06, 0.02, 0}, 0.05}};
    q.tint(kWalnut);
    q.muzzle_colour = kTan;
    q.foot_colour = kCocoa;
    add_model(models, "bear", "Brown bear", finished(q));
    Quadruped polar = q;
    polar.tint(kWhite);
    polar.muzzle_colour = polar.foot_colour = kCream;
    polar.length = 0.9;
    polar.neck_length = 0.42;
    polar.neck_base = 0.19;
    polar.neck_top = 0.14;
    polar.skull = 0.15;
    polar.ear_length = 0.09;
    add_model(models, "bear", "Polar bear", finished(polar));
    Quadruped cub = q;
    cub.tint(kHoney);
    cub.length = 0.42;
    cub.shoulder = cub.hip = 0.42;
    cub.chest = cub.belly = cub.rump = 0.19;
    cub.thigh = 0.1;
    cub.stride = 0.1;
    cub.ear_length = 0.15;
    add_model(models, "bear", "Bear cub", finished(cub));
    Quadruped grizzly = q;
    grizzly.tint(kChestnut);
    grizzly.shoulder = 0.7;
    grizzly.chest = 0.34;
    grizzly.neck_angle = -5;
    grizzly.stride = 0.2;
    add_model(models, "bear", "Grizzly", finished(grizzly));
}

void add_rhinoceroses(Models& models) {
    Quadruped q;
    q.length = 0.85;
    q.shoulder = q.hip = 0.64;
    q.chest = 0.29;
    q.belly = 0.3;
    q.rump = 0.28;
    q.thigh = 0.12;
    q.ankle = 0.09;
    q.foot = 0.1;
    q.stride = 0.14;
    q.spread = 0.15;
    q.neck_angle = 5;
    q.neck_length = 0.32;
    q.neck_base = 0.22;
    q.neck_top = 0.17;
    q.skull = 0.17;
    q.muzzle = 0.11;
    q.head_length = 0.4;
    q.head_angle = 30;
    q.ear_length = 0.14;
    q.ear_width = 0.05;
    q.tail = {{{0.03, 0, 0}, 0.028}, {{-0.07, -0.14, 0}, 0.022}, {{-0.08, -0.34, 0}, 0.026}};
    const auto rhino = [](Quadruped shape, double front, double rear, Rgb skin) {
        shape.tint(skin);
        shape.foot_colour = shape.muzzle_colour = darker(skin, 0.15);
        Animal a = quadruped(shape);
        const auto horn = [&](double along, double size) {
            const Vec3 root = a.head + a.head_forward * along + a.head_up * (shape.muzzle * 0.55);
            a.details.add(tube({{root, size * 0.3, size * 0.24},
                                {root + a.head_up * (size * 0.5) + a.head_forward * (size * 0.05), size * 0.2},
                                {root + a.head_up * size - a.head_forward * (size * 0.2), size * 0.04}},
                               kIvory));
        };
        horn(shape.head_length * 0.95, front);
        if (rear > 0) horn(shape.head_length * 0.5, rear);
        return facing_front(a.mesh(56));
    };
    add_model(models, "rhinoceros", "White rhinoceros", rhino(q, 0.34, 0.17, kStone));
    Quadruped indian = q;
    indian.length = 0.75;
    indian.neck_length = 0.24;
    add_model(models, "rhinoceros", "Indian rhinoceros", rhino(indian, 0.22, 0.0, kGrey));
    Quadruped charging = q;
    charging.stride = 0.28;
    charging.neck_angle = -18;
    charging.length = 0.95;
    add_model(models, "rhinoceros", "Charging rhinoceros", rhino(charging, 0.42, 0.2, kSlate));
}

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

void add_rabbits(Models& models) {
    add_model(models, "rabbit", "Brown rabbit", rabbit(1.0, 0.34, 0.0, kTan, kCream));
    add_model(models, "rabbit", "White rabbit", rabbit(1.12, 0.3, 0.04, kWhite, kPink));
    add_model(models, "rabbit", "Hare", rabbit(0.85, 0.48, 0.2, kHoney, kIvory));
    add_model(models, "rabbit", "Dwarf rabbit", rabbit(1.05, 0.16, -0.04, kStone, kWhite));
    add_model(models, "rabbit", "Chocolate rabbit", rabbit(0.92, 0.4, 0.1, kCocoa, kChestnut));
}

TriangleMesh kangaroo(double size, double tail, Rgb coat, bool joey) {
    Blob b(0.08);
    b.limb({-0.12, 0.46, 0}, {0.1, 0.86, 0}, 0.23 * size, 0.13, coat)
        .limb({0.1, 0.86, 0}, {0.2, 1.1, 0}, 0.11, 0.075, coat)
        .egg({0.24, 1.16, 0}, {0.11, 0.095, 0.085}, coat, -15)
        .limb({0.28, 1.15, 0}, {0.4, 1.11, 0}, 0.075, 0.045, coat);
    b.limb({-0.2, 0.4, 0}, {-0.5, 0.12, 0}, 0.15, 0.08, coat)
        .limb({-0.5, 0.12, 0}, {-0.55 - tail, 0.06, 0}, 0.08, 0.035, coat);
    b.blending(0.04)
        .limb_pair({-0.08, 0.4, 0.15}, {0.1, 0.3, 0.18}, 0.15, 0.08, coat)
        .limb_pair({0.1, 0.3, 0.18}, {-0.1, 0.08, 0.18}, 0.07, 0.05, coat)
        .limb_pair({-0.12, 0.045, 0.18}, {0.2, 0.04, 0.19}, 0.05, 0.04, darker(coat));
    b.limb_pair({0.12, 0.84, 0.1}, {0.24, 0.7, 0.14}, 0.05, 0.04, coat)
        .limb_pair({0.24, 0.7, 0.14}, {0.36, 0.74, 0.11}, 0.035, 0.032, darker(coat));
    if (joey)
        b.egg({0.14, 0.52, 0}, {0.12, 0.15, 0.13}, lighter(coat))
            .egg({0.24, 0.7, 0}, {0.075, 0.07, 0.06}, lighter(coat));
    Assembly a;
    a.add(b.mesh(64))
        .pair(ear_shape({0.2, 1.22, 0.05}, {-0.06, 0.2, 0.06}, 0.045, 0.02, Ear::Round, coat))
        .pair(ball({0.3, 1.18, 0.07}, 0.02, kInk, 8))
        .add(ball({0.44, 1.12, 0}, 0.025, kInk, 8));
    return facing_front(a.mesh());
}

void add_kangaroos(Models& models) {
    add_model(models, "kangaroo", "Red kangaroo", kangaroo(1.0, 0.35, kHoney, false));
    add_model(models, "kangaroo", "Mother kangaroo", kangaroo(1.12, 0.25, kTan, true));
    add_model(models, "kangaroo", "Wallaby", kangaroo(0.85, 0.5, kStone, false));
}

TriangleMesh mouse(double ear, double tail, double body, Rgb coat) {
    Blob b(0.05);
    b.egg({-0.05, 0.2, 0}, {0.3 * body, 0.19, 0.19}, coat, 8).limb({0.1, 0.22, 0}, {0.36, 0.17, 0}, 0.14, 0.05, coat);
    for (const double x : {-0.2, 0.14}) b.limb_pair({x, 0.08, 0.1}, {x + 0.06, 0.035, 0.12}, 0.05, 0.035, kPink);
    Assembly a;
    a.add(b.mesh(52)).pair(ball({0.25, 0.24, 0.085}, 0.022, kInk, 8)).add(ball({0.41, 0.17, 0}, 0.03, kRose, 8));
    a.pair(moved(turned_y(ball({0, 0, 0}, {ear, ear, 0.025}, coat, 12), 25), {0.14, 0.33 + ear * 0.35, 0.1}));
    a.add(tube({{{-0.3 * body, 0.14, 0}, 0.028},
                {{-0.3 * body - tail * 0.35, 0.06, 0}, 0.022},
                {{-0.3 * body - tail * 0.7, 0.14, 0}, 0.018},
                {{-0.3 * body - tail, 0.24, 0}, 0.01}},
               kRose));
    return facing_front(a.mesh());
}

void add_mice(Models& models) {
    add_model(models, "mouse", "Grey mouse", mouse(0.12, 0.5, 1.0, kGrey));
    add_model(models, "mouse", "Field mouse", mouse(0.09, 0.7, 1.1, kHoney));
    add_model(models, "mouse", "White mouse", mouse(0.16, 0.35, 0.9, kWhite));
}

}  // namespace

void add_pets_and_wild_animals(Models& models) {
    add_dogs(models);
    add_cats(models);
    add_cows(models);
    add_pigs(models);
    add_sheep(models);
    add_lions_and_tigers(models);
    add_camels(models);
    add_zebras(models);
    add_bears(models);
    add_rhinoceroses(models);
    add_rabbits(models);
    add_kangaroos(models);
    add_mice(models);
}

}  // namespace core::starter
