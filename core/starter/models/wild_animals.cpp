// Camels, zebras, bears, rhinoceroses, rabbits, kangaroos and mice.

#include <cmath>

#include "core/starter/kit/quadruped.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

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

TriangleMesh finished(const Quadruped& q) {
    return facing_front(quadruped(q).mesh());
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

void add_wild_animals(Models& models) {
    add_camels(models);
    add_zebras(models);
    add_bears(models);
    add_rhinoceroses(models);
    add_rabbits(models);
    add_kangaroos(models);
    add_mice(models);
}

}  // namespace core::starter
