// Cows and sheep.

#include <cmath>

#include "core/starter/kit/quadruped.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

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

}  // namespace

void add_farm_animals(Models& models) {
    add_cows(models);
    add_sheep(models);
}

}  // namespace core::starter
