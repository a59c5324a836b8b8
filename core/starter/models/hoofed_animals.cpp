// Horses, giraffes, elephants and other animals on hoofs.

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
}

bool on_patch(Vec3 p, double size, double gap) {
    // Cells of a jittered lattice: near a cell's middle is a patch.
    double best = 1e9, second = 1e9;
    const int bx = static_cast<int>(std::floor(p.x / size)), by = static_cast<int>(std::floor(p.y / size)),
              bz = static_cast<int>(std::floor(p.z / size));
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            for (int k = -1; k <= 1; ++k) {
                const double x = bx + i, y = by + j, z = bz + k;
                const Vec3 middle{(x + 0.5 + 0.35 * std::sin(12.9 * x + 78.2 * y + 37.7 * z)) * size,
                                  (y + 0.5 + 0.35 * std::sin(39.3 * x + 11.1 * y + 83.1 * z)) * size,
                                  (z + 0.5 + 0.35 * std::sin(73.1 * x + 52.2 * y + 9.1 * z)) * size};
                const double d = length(p - middle);
                if (d < best) {
                    second = best;
                    best = d;
                } else {
                    second = std::min(second, d);
                }
            }
    return second - best > gap;
}

TriangleMesh make_giraffe(const Quadruped& q, Rgb patch, double patch_size) {
    Animal a = quadruped(q);
    a.details.add(mane(a, 0.035, 0.025, darker(patch), q.neck_base * 0.75));
    const Vec3 crown = a.head + a.head_up * (q.skull * 0.7);
    a.details.pair(rod(crown + Vec3{0, 0, 0.035}, crown + a.head_up * 0.15 + Vec3{-0.03, 0, 0.045}, 0.018, q.coat));
    a.details.pair(ball(crown + a.head_up * 0.16 + Vec3{-0.03, 0, 0.047}, 0.03, kCocoa, 8));
    TriangleMesh body = painted(a.body.mesh(84), [&](Vec3 p, Rgb c) {
        const bool coat = c == q.coat && p.y > 0.5 && length(p - a.head) > q.skull * 1.2;
        return coat && on_patch(p, patch_size, patch_size * 0.16) ? patch : c;
    });
    join(body, a.details.mesh());
    return facing_front(body);
}

void add_giraffes(Models& models) {
    Quadruped q;
    q.length = 0.62;
    q.shoulder = 1.12;
    q.hip = 1.0;
    q.chest = 0.19;
    q.belly = 0.17;
    q.rump = 0.165;
    q.thigh = 0.075;
    q.ankle = 0.04;
    q.foot = 0.055;
    q.stride = 0.13;
    q.neck_angle = 66;
    q.neck_length = 0.95;
    q.neck_base = 0.13;
    q.neck_top = 0.065;
    q.skull = 0.085;
    q.muzzle = 0.055;
    q.head_length = 0.27;
    q.head_angle = 28;
    q.ear_length = 0.11;
    q.ear_width = 0.032;
    q.tail = {{{0.02, 0, 0}, 0.022},
              {{-0.1, -0.14, 0}, 0.016},
              {{-0.12, -0.36, 0}, 0.016},
              {{-0.12, -0.46, 0}, 0.04},
              {{-0.12, -0.54, 0}, 0.01}};
    q.tint(kIvory);
    q.underside = kIvory;
    q.foot_colour = kCocoa;
    q.muzzle_colour = kSand;
    q.tail_colour = kCocoa;
    add_model(models, "giraffe", "Giraffe", make_giraffe(q, kHoney, 0.17));
    Quadruped calf = q;
    calf.length = 0.5;
    calf.shoulder = 0.86;
    calf.hip = 0.8;
    calf.neck_length = 0.55;
    calf.skull = 0.1;
    calf.head_length = 0.25;
    calf.ear_length = 0.14;
    add_model(models, "giraffe", "Giraffe calf", make_giraffe(calf, kOrange, 0.14));
    Quadruped tall = q;
    tall.neck_angle = 80;
    tall.neck_length = 1.15;
    tall.length = 0.55;
    tall.shoulder = 1.2;
    tall.head_angle = 12;
    add_model(models, "giraffe", "Tall giraffe", make_giraffe(tall, kChestnut, 0.2));
    Quadruped walker = q;
    walker.neck_angle = 48;
    walker.stride = 0.26;
    walker.head_angle = 40;
    add_model(models, "giraffe", "Walking giraffe", make_giraffe(walker, kTan, 0.15));
    Quadruped grazer = q;
    grazer.neck_angle = 26;
    grazer.neck_length = 0.85;
    grazer.head_angle = 50;
    grazer.length = 0.7;
    add_model(models, "giraffe", "Browsing giraffe", make_giraffe(grazer, kWalnut, 0.18));
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

}  // namespace

void add_hoofed_animals(Models& models) {
    add_horses(models);
    add_giraffes(models);
    add_elephants(models);
}

}  // namespace core::starter
