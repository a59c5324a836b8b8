// Octopuses, crabs, turtles, snails, snakes and crocodiles.

#include <algorithm>
#include <cmath>

#include "core/starter/kit/quadruped.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

constexpr double kTurn = 6.283185307179586;

TriangleMesh fin(const std::vector<Point>& outline, Rgb colour, double thickness = 0.05) {
    return slab(closed_spline(outline, 5), thickness, thickness * 0.3, colour);
}

TriangleMesh octopus(double head, double reach, double curl, Rgb skin) {
    Blob b(0.07);
    b.egg({0, 0.62, 0}, {head, head * 1.2, head}, skin).limb({0, 0.2, 0}, {0, 0.45, 0}, 0.22, 0.2, skin);
    for (int k = 0; k < 8; ++k) {
        const double turn = kTurn * (k + 0.5) / 8, c = std::cos(turn), s = std::sin(turn);
        const auto at = [&](double r, double y) { return Vec3{c * r, y, s * r * 0.8}; };
        b.chain({{at(0.12, 0.2), 0.1},
                 {at(reach * 0.45, 0.1), 0.085},
                 {at(reach * 0.8, 0.05), 0.06},
                 {at(reach, 0.1 + curl * 0.5), 0.045},
                 {at(reach * 0.95, 0.12 + curl), 0.03}},
                skin);
    }
    Assembly a;
    a.add(b.mesh(46));
    a.pair_x(ball({head * 0.4, 0.52, head * 0.86}, {0.08, 0.09, 0.05}, kWhite, 10))
        .pair_x(ball({head * 0.4, 0.52, head * 0.86 + 0.04}, 0.04, kInk, 8));
    return a.mesh();
}

TriangleMesh crab(double width, double claw, double lift, Rgb shell) {
    Assembly a;
    a.add(ball({0, 0.26, 0}, {width, 0.17, 0.28}, shell, 16));
    for (const double side : {1.0, -1.0}) {
        for (int k = 0; k < 3; ++k) {
            const double z = 0.12 - 0.14 * k, x = side * width;
            a.add(tube({{{x * 0.8, 0.22, z}, 0.05},
                        {{x + side * 0.22, 0.34 - 0.04 * k, z * 1.6}, 0.04},
                        {{x + side * (0.36 + 0.04 * k), 0.02, z * 2.0}, 0.015}},
                       darker(shell, 0.12)));
        }
        const Vec3 elbow{side * (width + 0.22), 0.3 + lift * 0.4, 0.3}, hand{side * (width + 0.12), 0.42 + lift, 0.42};
        a.add(tube({{{side * width * 0.75, 0.28, 0.16}, 0.06}, {elbow, 0.055}, {hand, 0.06}}, shell));
        a.add(moved(ball({0, 0.08, 0}, {claw * 0.6, claw * 0.75, claw * 0.4}, shell, 12), hand));
        a.add(tube({{hand + Vec3{side * claw * 0.3, 0.1, 0}, claw * 0.3, claw * 0.22},
                    {hand + Vec3{side * claw * 0.5, 0.1 + claw * 0.9, 0}, claw * 0.22, 0.05},
                    {hand + Vec3{side * claw * 0.05, 0.1 + claw * 1.5, 0}, 0.015}},
                   shell));
        a.add(tube({{hand + Vec3{-side * claw * 0.35, 0.1, 0}, claw * 0.24, claw * 0.2},
                    {hand + Vec3{-side * claw * 0.55, 0.1 + claw * 0.8, 0}, claw * 0.16, 0.05},
                    {hand + Vec3{-side * claw * 0.2, 0.1 + claw * 1.25, 0}, 0.012}},
                   shell));
        a.add(rod({side * 0.12, 0.38, 0.2}, {side * 0.13, 0.52, 0.22}, 0.025, shell))
            .add(ball({side * 0.13, 0.55, 0.23}, 0.05, kWhite, 8))
            .add(ball({side * 0.13, 0.56, 0.27}, 0.025, kInk, 8));
    }
    return a.mesh();
}

TriangleMesh turtle(double shell_height, double flipper, double neck, Rgb shell, Rgb skin) {
    Assembly a;
    a.add(painted(lathe_smooth({{0, -0.06},
                                {0.4, -0.05},
                                {0.5, 0.02},
                                {0.42, shell_height * 0.6},
                                {0.2, shell_height * 0.95},
                                {0, shell_height}},
                               shell, 40),
                  [&](Vec3 p, Rgb c) {
                      if (p.y < 0.0) return kCream;
                      const double turn = std::atan2(p.z, p.x), r = std::hypot(p.x, p.z);
                      return std::abs(std::sin(turn * 3.0)) < 0.12 * (0.5 / (r + 0.15)) || std::abs(r - 0.24) < 0.025
                                 ? darker(c, 0.35)
                                 : c;
                  }));
    TriangleMesh body = scaled(a.mesh(), {1.2, 1.0, 1.0});
    Assembly b;
    b.add(body);
    b.add(tube({{{0.45, 0.0, 0}, 0.1},
                {{0.57 + neck * 0.5, 0.05, 0}, 0.1},
                {{0.71 + neck, 0.1, 0}, 0.12},
                {{0.84 + neck, 0.09, 0}, 0.085}},
               skin));
    b.pair(ball({0.74 + neck, 0.17, 0.1}, 0.024, kInk, 8));
    b.pair(moved(
        turned_x(turned_x(fin({{0.12, 0}, {0.1, flipper * 0.6}, {-0.12, flipper}, {-0.18, flipper * 0.6}, {-0.08, 0}},
                              skin, 0.07),
                          90),
                 28),
        {0.34, -0.02, 0.34}));
    b.pair(moved(
        turned_x(turned_x(fin({{0.08, 0}, {-0.04, flipper * 0.4}, {-0.2, flipper * 0.5}, {-0.12, 0}}, skin, 0.06), 90),
                 25),
        {-0.4, -0.03, 0.28}));
    b.add(cone({-0.55, -0.01, 0}, {-0.72, -0.04, 0}, 0.05, 0.015, skin, Cap::Round));
    return facing_front(b.mesh());
}

TriangleMesh snail(double turns, double shell, double body, double stalk, Rgb shell_colour, Rgb skin) {
    Assembly a;
    a.add(tube({{{-0.6 * body, 0.05, 0}, 0.03, 0.05},
                {{-0.3, 0.09, 0}, 0.09, 0.13},
                {{0.2, 0.1, 0}, 0.1, 0.14},
                {{0.46 * body, 0.2, 0}, 0.1, 0.11},
                {{0.58 * body, 0.36, 0}, 0.11, 0.11}},
               skin));
    std::vector<Station> spiral;
    const int steps = static_cast<int>(turns * 10);
    for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps, angle = -1.2 + kTurn * turns * t,
                     r = shell * (0.72 * (1.0 - t) + 0.02);
        spiral.push_back({{-0.05 - r * std::cos(angle), 0.16 + shell + r * std::sin(angle), 0.0},
                          shell * (0.34 * (1.0 - t) + 0.07),
                          shell * (0.4 * (1.0 - t) + 0.2)});
    }
    a.add(painted(tube(spiral, shell_colour, {.sides = 16, .steps = 3}), [&](Vec3 p, Rgb c) {
        return std::sin(18.0 * std::atan2(p.y - 0.16 - shell, p.x + 0.05)) > 0.75 ? darker(c, 0.2) : c;
    }));
    for (const double side : {1.0, -1.0})
        a.add(tube({{{0.6 * body, 0.42, side * 0.05}, 0.025}, {{0.66 * body, 0.44 + stalk, side * 0.12}, 0.018}}, skin))
            .add(ball({0.66 * body, 0.46 + stalk, side * 0.125}, 0.04, kInk, 8));
    return facing_front(a.mesh());
}

TriangleMesh snake(double waves, double height, double r, double lift, Rgb skin, Rgb band) {
    std::vector<Station> line;
    const int n = 28;
    for (int k = 0; k <= n; ++k) {
        const double t = static_cast<double>(k) / n;
        line.push_back(
            {{-1.0 + 1.8 * t, r + height * (1.0 + std::sin(kTurn * waves * t)) * 0.5 + lift * std::pow(t, 6.0), 0},
             r * std::min(1.0, 0.12 + 2.4 * t)});
    }
    const Vec3 neck = line.back().at;
    line.push_back({neck + Vec3{0.12, lift * 0.2 + 0.03, 0}, r * 1.3, r * 1.45});
    line.push_back({neck + Vec3{0.27, lift * 0.18, 0}, r * 0.8, r * 0.9});
    Assembly a;
    a.add(painted(tube(line, skin, {.sides = 16, .steps = 4}),
                  [&](Vec3 p, Rgb c) { return std::sin(p.x * 26.0) > 0.5 && p.x < neck.x - 0.05 ? band : c; }));
    const Vec3 head = neck + Vec3{0.17, lift * 0.2 + 0.03, 0};
    a.pair(ball(head + Vec3{0.0, r * 0.7, r * 0.85}, r * 0.3, kInk, 8));
    const Vec3 tip = neck + Vec3{0.27 + r * 0.6, lift * 0.18, 0};
    a.add(tube({{tip, 0.012}, {tip + Vec3{0.1, 0, 0}, 0.012}}, kRed, {.sides = 8}))
        .pair(tube({{tip + Vec3{0.1, 0, 0}, 0.011}, {tip + Vec3{0.17, 0.02, 0.03}, 0.008}}, kRed, {.sides = 8}));
    return facing_front(a.mesh());
}

TriangleMesh crocodile(double snout, double tail, double girth, Rgb skin) {
    Quadruped q;
    q.length = 0.8;
    q.shoulder = q.hip = 0.26;
    q.chest = q.belly = q.rump = girth;
    q.thigh = 0.075;
    q.ankle = 0.05;
    q.foot = 0.055;
    q.stride = 0.12;
    q.spread = 0.22;
    q.neck_angle = 6;
    q.neck_length = 0.2;
    q.neck_base = girth * 0.85;
    q.neck_top = 0.12;
    q.skull = 0.13;
    q.muzzle = 0.07;
    q.head_length = snout;
    q.head_angle = 4;
    q.ear = Ear::None;
    q.tint(skin);
    q.underside = mixed(skin, kCream, 0.6);
    q.muzzle_colour = q.foot_colour = skin;
    Animal a = quadruped(q, 0.07);
    a.body.chain({{{-0.4, 0.26, 0}, girth * 0.9},
                  {{-0.75, 0.2, 0}, girth * 0.55},
                  {{-1.0 - tail * 0.4, 0.14, 0}, 0.07},
                  {{-1.0 - tail, 0.1, 0}, 0.03}},
                 skin);
    for (int k = 0; k < 12; ++k) {
        const double x = 0.4 - 0.13 * k, y = 0.26 + (x > -0.45 ? girth * 0.92 : girth * (0.9 - 0.6 * (-0.45 - x)));
        a.details.add(
            cone({x, y - 0.03, 0}, {x - 0.03, y + 0.09 - 0.003 * k, 0}, 0.055, 0.008, darker(skin, 0.2), Cap::Round));
    }
    a.details.pair(ball(a.head + Vec3{0.02, 0.12, 0.06}, 0.05, skin, 8))
        .pair(ball(a.head + Vec3{0.05, 0.13, 0.085}, 0.028, kMustard, 8));
    for (int k = 0; k < 6; ++k)
        a.details.pair(cone(a.muzzle_tip + Vec3{-0.05 * k - 0.02, -0.05, 0.05},
                            a.muzzle_tip + Vec3{-0.05 * k - 0.02, -0.12, 0.055}, 0.018, 0.004, kWhite));
    return facing_front(a.mesh(80));
}

}  // namespace

void add_shore_animals(Models& models) {
    add_model(models, "octopus", "Octopus", octopus(0.3, 0.75, 0.1, kCoral));
    add_model(models, "octopus", "Purple octopus", octopus(0.36, 0.6, 0.24, kLilac));
    add_model(models, "octopus", "Long-armed octopus", octopus(0.24, 0.95, 0.3, kTeal));
    add_model(models, "crab", "Red crab", crab(0.42, 0.2, 0.14, kRed));
    add_model(models, "crab", "Fiddler crab", crab(0.34, 0.28, 0.26, kOrange));
    add_model(models, "crab", "Blue crab", crab(0.52, 0.17, 0.02, kBlue));
    add_model(models, "sea turtle", "Green turtle", turtle(0.3, 0.5, 0.0, kGreen, kLeaf));
    add_model(models, "sea turtle", "Leatherback", turtle(0.22, 0.68, 0.06, kSlate, kGrey));
    add_model(models, "sea turtle", "Young turtle", turtle(0.4, 0.36, 0.02, kOlive, kStraw));
    add_model(models, "snail", "Garden snail", snail(2.2, 0.3, 1.0, 0.14, kHoney, kSand));
    add_model(models, "snail", "Roman snail", snail(2.6, 0.36, 1.05, 0.2, kCream, kTan));
    add_model(models, "snail", "Little pink snail", snail(1.8, 0.24, 0.9, 0.1, kRose, kCream));
    add_model(models, "snake", "Grass snake", snake(1.6, 0.3, 0.06, 0.2, kLeaf, kForest));
    add_model(models, "snake", "Coral snake", snake(2.4, 0.22, 0.05, 0.05, kRed, kInk));
    add_model(models, "snake", "Rearing snake", snake(1.2, 0.18, 0.07, 0.55, kMustard, kWalnut));
    add_model(models, "crocodile", "Crocodile", crocodile(0.46, 0.55, 0.16, kGreen));
    add_model(models, "crocodile", "Alligator", crocodile(0.34, 0.35, 0.19, kOlive));
    add_model(models, "crocodile", "Gharial", crocodile(0.62, 0.7, 0.14, kTeal));
}

}  // namespace core::starter
