// Hourglasses, ice cream and teddy bears.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/blob.hpp"
#include "core/starter/kit/quadruped.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

constexpr double kTurn = 6.283185307179586;

struct Hourglass {
    double r = 0.34, height = 1.0, waist = 0.04, round = 0.6;  ///< round: 0 cones, 1 full bulbs
    Rgb wood = kWalnut, sand = kStraw;
};

/// Without posts, and flat: the two bulbs are what everyone draws.
TriangleMesh hourglass(const Hourglass& g) {
    Assembly a;
    const double h = g.height / 2, bulge = 0.5 + 0.35 * g.round;
    a.add(painted(lathe(spline({{g.r, -h},
                                {g.r * (0.7 + 0.28 * g.round), -h * 0.68},
                                {g.r * bulge * 0.72, -h * 0.32},
                                {g.waist, 0},
                                {g.r * bulge * 0.72, h * 0.32},
                                {g.r * (0.7 + 0.28 * g.round), h * 0.68},
                                {g.r, h}},
                               6),
                        kGlass, 32),
                  [&](Vec3 p, Rgb c) { return (p.y < -h * 0.35) || (p.y > h * 0.1 && p.y < h * 0.55) ? g.sand : c; }));
    for (const double y : {-h - 0.035, h + 0.035})
        a.add(moved(
            lathe({{0, -0.045}, {g.r * 1.06, -0.045}, {g.r * 1.1, 0}, {g.r * 1.06, 0.045}, {0, 0.045}}, g.wood, 36),
            {0, y, 0}));
    return scaled(a.mesh(), {1.0, 1.0, 0.7});
}

TriangleMesh ice_cream(int scoops, const std::array<Rgb, 3>& flavours, double cone_height, double r, bool cherry) {
    Assembly a;
    a.add(lathe({{0, -cone_height}, {0.02, -cone_height}, {r * 0.92, -0.02}, {r * 1.0, 0.03}, {0, 0.04}}, kHoney, 48));
    for (int k = 0; k < 7; ++k)
        a.add(ring({0, -cone_height * (0.08 + 0.12 * k), 0}, {0, 1, 0}, r * 0.92 * (0.92 - 0.12 * k) + 0.004, 0.012,
                   kTan, 32));
    double y = r * 0.45;
    for (int k = 0; k < scoops; ++k) {
        const double size = r * (1.08 - 0.1 * k);
        a.add(ball({0, y, 0}, {size, size * 0.95, size}, flavours[static_cast<std::size_t>(k)], 18));
        for (int j = 0; j < 9; ++j)
            a.add(ball({size * 0.92 * std::cos(kTurn * j / 9), y - size * 0.38, size * 0.92 * std::sin(kTurn * j / 9)},
                       {size * 0.3, size * 0.18, size * 0.3}, flavours[static_cast<std::size_t>(k)], 8));
        y += size * 1.18;
    }
    if (cherry)
        a.add(ball({0, y - r * 0.12, 0}, r * 0.26, kRed, 12))
            .add(tube({{{0, y, 0}, 0.014}, {{0.04, y + 0.12, 0}, 0.012}, {{0.12, y + 0.18, 0}, 0.012}}, kForest));
    return scaled(a.mesh(), {1.0, 1.0, 0.75});
}

TriangleMesh teddy(double belly, double head, double ear, Rgb fur, Rgb light, Rgb bow) {
    const Vec3 top{0, 0.5 + belly * 0.9 + head * 0.7, 0};
    Blob body(0.06);
    body.egg({0, 0.42, 0}, {belly, belly * 1.15, belly * 0.85}, fur)
        .egg({0, 0.4, belly * 0.35}, {belly * 0.66, belly * 0.78, belly * 0.58}, light)
        .egg(top, {head * 1.08, head, head * 0.95}, fur)
        .egg(top + Vec3{0, -head * 0.22, head * 0.72}, {head * 0.44, head * 0.36, head * 0.36}, light);
    for (const double side : {1.0, -1.0}) {
        body.egg(top + Vec3{side * head * 0.85, head * 0.78, 0}, {ear, ear, ear * 0.6}, fur)
            .limb({side * belly * 0.8, 0.6, 0.02}, {side * (belly + 0.2), 0.36, 0.1}, 0.11, 0.105, fur);
        body.limb({side * belly * 0.6, 0.16, 0.05}, {side * (belly * 0.75 + 0.12), 0.1, 0.34}, 0.14, 0.12, fur)
            .egg({side * (belly * 0.75 + 0.13), 0.12, 0.42}, {0.1, 0.12, 0.06}, light);
    }
    Assembly a;
    a.add(body.mesh(50))
        .pair_x(ball(top + Vec3{head * 0.38, head * 0.18, head * 0.86}, 0.035, kInk, 8))
        .add(ball(top + Vec3{0, -head * 0.1, head * 1.06}, {0.055, 0.04, 0.035}, kInk, 8));
    const Vec3 neck{0, 0.5 + belly * 0.82, belly * 0.8};
    a.pair_x(ball(neck + Vec3{0.1, 0, 0}, {0.1, 0.07, 0.05}, bow, 10))
        .add(ball(neck + Vec3{0, 0, 0.03}, 0.045, darker(bow), 8));
    return a.mesh();
}

void add_things(Models& models) {
    add_model(models, "hourglass", "Hourglass", hourglass({}));
    add_model(models, "hourglass", "Slim hourglass",
              hourglass({.r = 0.26, .height = 1.2, .waist = 0.035, .wood = kBrass, .sand = kCoral}));
    add_model(models, "hourglass", "Egg timer",
              hourglass({.r = 0.36, .height = 0.8, .waist = 0.06, .round = 1.0, .wood = kTeal, .sand = kPink}));
    add_model(models, "hourglass", "Pointed hourglass",
              hourglass({.r = 0.4, .height = 1.0, .waist = 0.03, .round = 0.0, .wood = kBrick, .sand = kMustard}));
    add_model(models, "hourglass", "Tall hourglass",
              hourglass({.r = 0.3, .height = 1.0, .waist = 0.12, .round = 0.4, .wood = kInk, .sand = kSky}));
    add_model(models, "ice cream", "Strawberry cone", ice_cream(1, {kPink, kPink, kPink}, 0.95, 0.34, true));
    add_model(models, "ice cream", "Double scoop", ice_cream(2, {kMint, kCocoa, kPink}, 1.0, 0.32, false));
    add_model(models, "ice cream", "Triple scoop", ice_cream(3, {kCream, kPink, kMint}, 1.05, 0.3, true));
    add_model(models, "ice cream", "Single scoop", ice_cream(1, {kCream, kPink, kMint}, 0.8, 0.38, false));
    add_model(models, "ice cream", "Chocolate cone", ice_cream(1, {kCocoa, kPink, kMint}, 1.1, 0.36, false));
    add_model(models, "ice cream", "Vanilla cone", ice_cream(1, {kIvory, kPink, kMint}, 1.2, 0.3, false));
    add_model(models, "ice cream", "Lemon cone", ice_cream(1, {kStraw, kPink, kMint}, 0.72, 0.44, true));
    add_model(models, "teddy-bear", "Teddy bear", teddy(0.3, 0.27, 0.12, kHoney, kCream, kRed));
    add_model(models, "teddy-bear", "Chubby teddy", teddy(0.38, 0.28, 0.1, kWalnut, kSand, kTeal));
    add_model(models, "teddy-bear", "Big-eared teddy", teddy(0.26, 0.3, 0.17, kStone, kPink, kPlum));
    add_model(models, "teddy-bear", "Little teddy", teddy(0.24, 0.25, 0.11, kCream, kWhite, kBlue));
    add_model(models, "teddy-bear", "Big-headed teddy", teddy(0.28, 0.36, 0.13, kChestnut, kTan, kMustard));
}

}  // namespace

void add_household(Models& models) {
    add_things(models);
}

}  // namespace core::starter
