// Turtles, snails and snakes.

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
    return narrow(a.mesh(), 0.7);
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

}  // namespace

void add_shore_animals(Models& models) {
    add_model(models, "sea turtle", "Green turtle", turtle(0.3, 0.5, 0.0, kGreen, kLeaf));
    add_model(models, "sea turtle", "Leatherback", turtle(0.22, 0.68, 0.06, kSlate, kGrey));
    add_model(models, "sea turtle", "Young turtle", turtle(0.4, 0.36, 0.02, kOlive, kStraw));
    add_model(models, "sea turtle", "Old turtle", turtle(0.34, 0.58, 0.1, kWalnut, kSand));
    add_model(models, "sea turtle", "Paddling turtle", turtle(0.26, 0.44, 0.04, kTeal, kMint));
    add_model(models, "snail", "Garden snail", snail(2.2, 0.4, 0.9, 0.14, kHoney, kSand));
    add_model(models, "snail", "Roman snail", snail(2.6, 0.46, 0.95, 0.16, kCream, kTan));
    add_model(models, "snail", "Little pink snail", snail(1.8, 0.32, 0.85, 0.1, kRose, kCream));
    add_model(models, "snail", "Great snail", snail(2.4, 0.54, 0.9, 0.12, kBrick, kStraw));
    add_model(models, "snail", "Sea snail", snail(2.0, 0.44, 0.75, 0.2, kTeal, kSky));
    add_model(models, "snake", "Grass snake", snake(1.6, 0.3, 0.06, 0.2, kLeaf, kForest));
    add_model(models, "snake", "Coral snake", snake(2.4, 0.22, 0.05, 0.05, kRed, kInk));
    add_model(models, "snake", "Rearing snake", snake(1.2, 0.18, 0.07, 0.55, kMustard, kWalnut));
    add_model(models, "snake", "Thick snake", snake(1.1, 0.34, 0.1, 0.1, kOlive, kCocoa));
    add_model(models, "snake", "Winding snake", snake(1.9, 0.42, 0.05, 0.3, kTeal, kStraw));
}

}  // namespace core::starter
