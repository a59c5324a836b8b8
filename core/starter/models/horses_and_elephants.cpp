// Horses and elephants.

#include <algorithm>
#include <cmath>

#include "core/starter/kit/quadruped.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

/// A crest of hair along the neck, from the crown down to the withers.
TriangleMesh mane(const Animal& a, double height, double thickness, Rgb colour, double neck_radius) {
    const Vec3 along = a.head - a.neck_base;
    const Vec3 off = a.neck_up * (neck_radius * 0.8);
    std::vector<Station> stations;
    for (int k = 0; k <= 4; ++k) {
        const double t = k / 4.0;
        stations.push_back({a.neck_base + along * (0.15 + 0.95 * t) + off * (1.35 - 0.45 * t),
                            height * (0.45 + 0.75 * std::sin(3.0 * (0.1 + 0.85 * t))), thickness});
    }
    return tube(stations, colour);
}

TriangleMesh make_horse(Quadruped q, Rgb hair) {
    q.tail_colour = hair;
    Animal a = quadruped(q);
    a.details.add(mane(a, 0.065, 0.035, hair, q.neck_base * 0.85));
    a.details.add(tube({{a.head + a.head_up * q.skull, 0.03, 0.03},
                        {a.head + a.head_up * (q.skull * 1.05) + a.head_forward * 0.07, 0.028, 0.03},
                        {a.head + a.head_up * (q.skull * 0.85) + a.head_forward * 0.15, 0.008, 0.01}},
                       hair));
    return facing_front(a.mesh());
}

Quadruped horse_shape() {
    Quadruped q;
    q.length = 0.86;
    q.shoulder = 0.98;
    q.hip = 0.99;
    q.chest = 0.2;
    q.belly = 0.18;
    q.rump = 0.205;
    q.sag = 0.02;
    q.thigh = 0.085;
    q.ankle = 0.042;
    q.foot = 0.058;
    q.neck_angle = 52;
    q.neck_length = 0.52;
    q.neck_base = 0.15;
    q.neck_top = 0.085;
    q.skull = 0.1;
    q.muzzle = 0.068;
    q.head_length = 0.34;
    q.head_angle = 42;
    q.ear_length = 0.13;
    q.ear_width = 0.036;
    q.tail = {{{0.03, 0.02, 0}, 0.035}, {{-0.12, 0.02, 0}, 0.05}, {{-0.2, -0.22, 0}, 0.065}, {{-0.2, -0.5, 0}, 0.02}};
    return q;
}

void add_horses(Models& models) {
    Quadruped q = horse_shape();
    add_model(models, "horse", "Chestnut horse", make_horse(q, kCocoa));

    Quadruped foal = q;
    foal.length = 0.6;
    foal.chest = foal.rump = 0.16;
    foal.belly = 0.15;
    foal.thigh = 0.07;
    foal.neck_length = 0.36;
    foal.neck_angle = 58;
    foal.neck_base = 0.11;
    foal.skull = 0.105;
    foal.head_length = 0.26;
    foal.ear_length = 0.15;
    foal.tail = {{{0.03, 0.02, 0}, 0.03}, {{-0.09, 0.0, 0}, 0.035}, {{-0.14, -0.2, 0}, 0.02}};
    foal.tint(kHoney);
    foal.muzzle_colour = kCream;
    add_model(models, "horse", "Foal", make_horse(foal, kIvory));

    Quadruped draught = q;
    draught.shoulder = draught.hip = 0.92;
    draught.chest = draught.rump = 0.25;
    draught.belly = 0.235;
    draught.thigh = 0.115;
    draught.ankle = 0.065;
    draught.foot = 0.095;
    draught.neck_base = 0.2;
    draught.neck_top = 0.12;
    draught.neck_angle = 46;
    draught.skull = 0.12;
    draught.muzzle = 0.08;
    draught.tint(kSlate);
    draught.foot_colour = kCream;
    draught.muzzle_colour = kStone;
    add_model(models, "horse", "Draught horse", make_horse(draught, kCream));

    Quadruped pony = q;
    pony.shoulder = pony.hip = 0.7;
    pony.length = 0.74;
    pony.chest = pony.rump = 0.2;
    pony.belly = 0.2;
    pony.sag = 0.04;
    pony.stride = 0.12;
    pony.neck_length = 0.34;
    pony.neck_angle = 44;
    pony.head_length = 0.3;
    pony.tint(kTan);
    add_model(models, "horse", "Shaggy pony", make_horse(pony, kIvory));

    Quadruped racer = q;
    racer.stride = 0.34;
    racer.length = 0.95;
    racer.thigh = 0.075;
    racer.belly = 0.15;
    racer.neck_angle = 34;
    racer.neck_length = 0.58;
    racer.head_angle = 26;
    racer.tail = {
        {{0.03, 0.02, 0}, 0.035}, {{-0.18, 0.1, 0}, 0.05}, {{-0.42, 0.02, 0}, 0.055}, {{-0.6, -0.14, 0}, 0.015}};
    racer.tint(kBrick);
    add_model(models, "horse", "Galloping horse", make_horse(racer, kInk));

    Quadruped toy = q;
    toy.length = 0.86;
    toy.shoulder = toy.hip = 0.66;
    toy.chest = toy.belly = toy.rump = 0.2;
    toy.sag = 0.0;
    toy.thigh = 0.075;
    toy.ankle = toy.foot = 0.06;
    toy.stride = 0.1;
    toy.neck_angle = 58;
    toy.neck_length = 0.4;
    toy.neck_base = 0.16;
    toy.neck_top = 0.12;
    toy.skull = 0.12;
    toy.muzzle = 0.09;
    toy.head_length = 0.3;
    toy.head_angle = 22;
    toy.tail = {{{0.03, 0.04, 0}, 0.05}, {{-0.14, 0.02, 0}, 0.06}, {{-0.22, -0.24, 0}, 0.07}, {{-0.24, -0.5, 0}, 0.04}};
    toy.tint(kWood);
    add_model(models, "horse", "Toy horse", make_horse(toy, kCream));

    Quadruped slim = toy;
    slim.length = 1.0;
    slim.shoulder = slim.hip = 0.78;
    slim.chest = slim.belly = slim.rump = 0.16;
    slim.thigh = 0.055;
    slim.ankle = slim.foot = 0.045;
    slim.stride = 0.12;
    slim.neck_angle = 44;
    slim.neck_base = 0.12;
    slim.neck_top = 0.08;
    slim.skull = 0.1;
    slim.muzzle = 0.065;
    slim.head_length = 0.34;
    slim.head_angle = 30;
    slim.tail = {
        {{0.03, 0.04, 0}, 0.03}, {{-0.2, 0.08, 0}, 0.05}, {{-0.38, -0.16, 0}, 0.06}, {{-0.42, -0.46, 0}, 0.02}};
    slim.tint(kWhite);
    add_model(models, "horse", "White mare", make_horse(slim, kStone));
}

struct Trunk {
    std::vector<Station> line;  ///< relative to the head
    double tusk = 0.22;
};

TriangleMesh make_elephant(const Quadruped& q, const Trunk& trunk, double ear, Rgb inner_ear) {
    Animal a = quadruped(q, 0.1);
    std::vector<Station> line = trunk.line;
    for (Station& s : line) s.at = s.at + a.head;
    a.body.chain(line, q.coat);
    if (trunk.tusk > 0) {
        const Vec3 root = a.head + Vec3{q.skull * 0.75, -q.skull * 0.65, q.skull * 0.45};
        a.details.pair(tube({{root, 0.034},
                             {root + Vec3{0.55, -0.5, 0.15} * trunk.tusk, 0.03},
                             {root + Vec3{1.1, -0.45, 0.2} * trunk.tusk, 0.008}},
                            kCream));
    }
    const TriangleMesh flap = slab(
        closed_spline(
            {{0.05, 0.75}, {-0.55, 0.8}, {-0.95, 0.2}, {-0.75, -0.5}, {-0.35, -0.95}, {0.0, -0.45}, {0.1, 0.2}}, 5),
        0.16, 0.05, q.ear_colour);
    const TriangleMesh painted_flap = painted(flap, [&](Vec3 p, Rgb c) {
        return p.z > 0.05 && length(p - Vec3{-0.4, 0, p.z}) < 0.7 ? inner_ear : c;
    });
    a.details.pair(
        moved(turned_y(scaled(painted_flap, {ear, ear, ear}), 14), a.head + Vec3{-0.02, 0.04, q.skull * 0.92}));
    return facing_front(a.mesh(54));
}

void add_elephants(Models& models) {
    Quadruped q;
    q.length = 0.72;
    q.shoulder = 0.88;
    q.hip = 0.84;
    q.chest = 0.3;
    q.belly = 0.31;
    q.rump = 0.28;
    q.sag = 0.02;
    q.thigh = 0.13;
    q.ankle = 0.1;
    q.foot = 0.115;
    q.stride = 0.15;
    q.spread = 0.16;
    q.neck_angle = 30;
    q.neck_length = 0.24;
    q.neck_base = 0.2;
    q.neck_top = 0.18;
    q.skull = 0.22;
    q.muzzle = 0.12;
    q.head_length = 0.16;
    q.head_angle = 60;
    q.ear = Ear::None;
    q.eye = 0.024;
    q.tint(mixed(kGrey, kSky, 0.22));
    q.foot_colour = kStone;
    q.tail = {{{0.05, 0.0, 0}, 0.03},
              {{-0.08, -0.14, 0}, 0.022},
              {{-0.1, -0.36, 0}, 0.018},
              {{-0.1, -0.42, 0}, 0.034},
              {{-0.1, -0.5, 0}, 0.01}};
    const Trunk hanging{{{{0.14, -0.1, 0}, 0.11},
                         {{0.3, -0.3, 0}, 0.085},
                         {{0.34, -0.56, 0}, 0.068},
                         {{0.36, -0.74, 0}, 0.055},
                         {{0.46, -0.82, 0}, 0.05}},
                        0.24};
    const Trunk raised{{{{0.14, -0.06, 0}, 0.11},
                        {{0.34, -0.16, 0}, 0.085},
                        {{0.5, -0.06, 0}, 0.07},
                        {{0.56, 0.16, 0}, 0.058},
                        {{0.52, 0.36, 0}, 0.05},
                        {{0.6, 0.44, 0}, 0.048}},
                       0.24};
    const Trunk curled{{{{0.14, -0.1, 0}, 0.1},
                        {{0.28, -0.3, 0}, 0.08},
                        {{0.4, -0.44, 0}, 0.066},
                        {{0.56, -0.44, 0}, 0.056},
                        {{0.62, -0.3, 0}, 0.05}},
                       0.0};
    add_model(models, "elephant", "Elephant", make_elephant(q, hanging, 0.32, kStone));
    add_model(models, "elephant", "Trumpeting elephant", make_elephant(q, raised, 0.38, kRose));
    Quadruped baby = q;
    baby.length = 0.46;
    baby.shoulder = 0.6;
    baby.hip = 0.56;
    baby.chest = 0.24;
    baby.belly = 0.25;
    baby.rump = 0.22;
    baby.stride = 0.11;
    baby.skull = 0.21;
    baby.thigh = 0.11;
    baby.neck_length = 0.22;
    baby.tint(mixed(kSky, kStone, 0.55));
    add_model(models, "elephant", "Baby elephant", make_elephant(baby, curled, 0.3, kPink));
    Quadruped mammoth = q;
    mammoth.shoulder = 1.0;
    mammoth.chest = 0.34;
    mammoth.hip = 0.78;
    mammoth.neck_angle = 20;
    mammoth.tint(kWalnut);
    Trunk long_tusks = hanging;
    long_tusks.tusk = 0.5;
    add_model(models, "elephant", "Mammoth", make_elephant(mammoth, long_tusks, 0.18, kCocoa));
    Quadruped walking = q;
    walking.stride = 0.26;
    walking.length = 0.82;
    walking.neck_angle = 12;
    add_model(
        models, "elephant", "Walking elephant",
        make_elephant(
            walking,
            {{{{0.14, -0.1, 0}, 0.11}, {{0.32, -0.28, 0}, 0.085}, {{0.44, -0.46, 0}, 0.066}, {{0.62, -0.52, 0}, 0.055}},
             0.3},
            0.28, kStone));
}

/// An elephant's face: two ears as large as the head, and the trunk between them. `swing` is how far the trunk curls
/// aside.
TriangleMesh elephant_face(double ear, double trunk, double swing, Rgb coat, Rgb inner_ear) {
    Blob b(0.06);
    b.egg({0, 0, 0}, {0.36, 0.4, 0.24}, coat);
    for (const double side : {1.0, -1.0})
        b.egg({side * (0.3 + ear * 0.75), 0.04, -0.04}, {ear * 0.85, ear * 1.15, 0.09}, coat, side * 14)
            .egg({side * (0.32 + ear * 0.75), 0.02, 0.02}, {ear * 0.6, ear * 0.85, 0.06}, inner_ear, side * 14);
    b.blending(0.04).chain({{{0, -0.1, 0.16}, 0.15},
                            {{0, -0.4, 0.2}, 0.12},
                            {{swing * 0.15, -0.4 - trunk * 0.5, 0.2}, 0.1},
                            {{swing * 0.5, -0.4 - trunk, 0.2}, 0.085},
                            {{swing, -0.36 - trunk * 0.95, 0.2}, 0.075}},
                           coat);
    Assembly a;
    a.add(b.mesh(50));
    a.pair_x(ball({0.16, 0.1, 0.22}, {0.045, 0.06, 0.03}, kInk, 8))
        .pair_x(tube({{{0.16, -0.24, 0.16}, 0.04}, {{0.24, -0.46, 0.22}, 0.03}, {{0.3, -0.56, 0.26}, 0.01}}, kCream));
    return scaled(a.mesh(), {1.0, 1.0, 0.65});
}

/// A toy elephant: the head as big as the body, no tusks, and legs like posts.
Quadruped toy_elephant() {
    Quadruped q;
    q.length = 0.62;
    q.shoulder = 0.5;
    q.hip = 0.46;
    q.chest = q.belly = 0.23;
    q.rump = 0.21;
    q.thigh = q.ankle = 0.085;
    q.foot = 0.095;
    q.stride = 0.06;
    q.spread = 0.13;
    q.neck_angle = 38;
    q.neck_length = 0.3;
    q.neck_base = q.neck_top = 0.18;
    q.skull = 0.27;
    q.muzzle = 0.1;
    q.head_length = 0.2;
    q.head_angle = 60;
    q.ear = Ear::None;
    q.eye = 0.03;
    q.tint(mixed(kBlue, kStone, 0.55));
    q.foot_colour = kCream;
    q.tail = {{{0.05, 0.0, 0}, 0.03}, {{-0.12, 0.04, 0}, 0.025}, {{-0.2, 0.16, 0}, 0.03}};
    return q;
}

void add_more_elephants(Models& models) {
    add_model(models, "elephant", "Elephant's face", elephant_face(0.42, 0.5, 0.0, mixed(kGrey, kSky, 0.25), kRose));
    add_model(models, "elephant", "Elephant's face, trunk aside",
              elephant_face(0.34, 0.34, 0.34, mixed(kStone, kLilac, 0.3), kPink));
    const Trunk forward{{{{0.18, -0.12, 0}, 0.11},
                         {{0.36, -0.3, 0}, 0.085},
                         {{0.56, -0.36, 0}, 0.07},
                         {{0.76, -0.24, 0}, 0.06},
                         {{0.84, -0.06, 0}, 0.055}},
                        0.0};
    add_model(models, "elephant", "Toy elephant", make_elephant(toy_elephant(), forward, 0.3, kRose));
    Quadruped bulky = toy_elephant();
    bulky.length = 0.84;
    bulky.shoulder = bulky.hip = 0.62;
    bulky.chest = bulky.belly = bulky.rump = 0.3;
    bulky.stride = 0.09;
    bulky.skull = 0.23;
    bulky.neck_angle = 24;
    bulky.tint(mixed(kGrey, kWalnut, 0.25));
    const Trunk down{
        {{{0.16, -0.1, 0}, 0.12}, {{0.26, -0.34, 0}, 0.1}, {{0.25, -0.52, 0}, 0.085}, {{0.32, -0.62, 0}, 0.075}}, 0.0};
    add_model(models, "elephant", "Bulky elephant", make_elephant(bulky, down, 0.36, kStone));
}

}  // namespace

void add_horses_and_elephants(Models& models) {
    add_horses(models);
    add_elephants(models);
    add_more_elephants(models);
}

}  // namespace core::starter
