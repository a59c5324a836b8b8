// Butterflies, bees, spiders and ants.

#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

struct Butterfly {
    double upper = 0.7, lower = 0.5, height = 1.0, tails = 0.0, fold = 14;
    Rgb wing = kOrange, edge = kInk, spot = kCream;
};

TriangleMesh butterfly(const Butterfly& b) {
    Assembly a;
    a.add(tube({{{0, -0.34, 0}, 0.03}, {{0, -0.1, 0}, 0.055}, {{0, 0.12, 0}, 0.065}, {{0, 0.26, 0}, 0.045}}, kCocoa))
        .add(ball({0, 0.33, 0}, 0.075, kCocoa));
    a.pair_x(tube({{{0.02, 0.38, 0}, 0.012}, {{0.1, 0.54, 0}, 0.01}, {{0.2, 0.62, 0}, 0.01}}, kCocoa, {.sides = 8}))
        .pair_x(ball({0.2, 0.62, 0}, 0.028, kCocoa, 8));
    const double u = b.upper, l = b.lower, h = b.height;
    const std::vector<Point> upper = closed_spline({{0.02, 0.02},
                                                    {0.03, 0.2},
                                                    {u * 0.5, 0.46 * h},
                                                    {u * 0.95, 0.6 * h},
                                                    {u * 1.05, 0.42 * h},
                                                    {u * 0.85, 0.08},
                                                    {u * 0.45, -0.04}},
                                                   6);
    std::vector<Point> ring{
        {0.02, 0.06}, {l * 0.5, 0.02}, {l * 1.0, -0.1}, {l * 1.02, -0.34 * h}, {l * 0.7, -0.52 * h}};
    if (b.tails > 0) {
        ring.push_back({l * 0.66, -0.52 * h - b.tails});
        ring.push_back({l * 0.56, -0.5 * h - b.tails * 0.9});
    }
    ring.push_back({l * 0.4, -0.46 * h});
    ring.push_back({0.08, -0.16});
    const auto wing = [&](const std::vector<Point>& outline, Point middle, Rgb colour, double z) {
        Assembly w;
        std::vector<Point> inner = outline;
        for (Point& p : inner) p = middle + (p - middle) * 0.8;
        w.add(slab(outline, 0.03, 0.01, b.edge)).add(slab(inner, 0.04, 0.01, colour));
        w.add(slab(circle_outline(middle + Point{0.2 * u, 0.04}, 0.075, 0.075), 0.05, 0.01, b.spot));
        return moved(turned_y(w.mesh(), -b.fold), {0.03, 0, z});
    };
    a.pair_x(wing(upper, {u * 0.55, 0.28 * h}, b.wing, 0.012))
        .pair_x(wing(closed_spline(ring, 6), {l * 0.5, -0.22 * h}, lighter(b.wing, 0.15), -0.012));
    return a.mesh();
}

void add_butterflies(Models& models) {
    add_model(models, "butterfly", "Monarch", butterfly({}));
    add_model(models, "butterfly", "Swallowtail",
              butterfly({.upper = 0.75, .lower = 0.48, .tails = 0.24, .wing = kStraw, .edge = kInk, .spot = kCoral}));
    add_model(models, "butterfly", "Blue morpho",
              butterfly({.upper = 0.8, .lower = 0.62, .height = 0.85, .wing = kBlue, .edge = kNavy, .spot = kSky}));
    add_model(models, "butterfly", "Cabbage white",
              butterfly({.upper = 0.6, .lower = 0.52, .height = 1.1, .wing = kWhite, .edge = kStone, .spot = kSlate}));
    add_model(models, "butterfly", "Rose moth",
              butterfly({.upper = 0.9, .lower = 0.4, .height = 0.75, .wing = kRose, .edge = kWine, .spot = kMustard}));
}

TriangleMesh bee(double body, double girth, double wing, Rgb stripe) {
    Assembly a;
    a.add(painted(ball({-0.1 * body, 0, 0}, {0.42 * body, girth, girth}, kMustard, 24),
                  [&](Vec3 p, Rgb c) { return std::sin(p.x / body * 17.0 + 0.6) > 0.1 ? stripe : c; }));
    a.add(ball({0.36 * body, 0.03, 0}, {0.17, 0.17, 0.17}, stripe, 14))
        .add(cone({-0.48 * body, 0, 0}, {-0.66 * body, -0.02, 0}, 0.05, 0.005, kInk, Cap::Round));
    a.pair(ball({0.45 * body, 0.07, 0.11}, {0.05, 0.06, 0.05}, kWhite, 8))
        .pair(ball({0.48 * body, 0.07, 0.14}, 0.026, kInk, 8));
    a.pair(
        tube({{{0.42 * body, 0.15, 0.05}, 0.014}, {{0.5 * body, 0.3, 0.09}, 0.012}, {{0.62 * body, 0.33, 0.1}, 0.018}},
             kInk, {.sides = 8}));
    for (const double back : {0.0, 1.0})
        a.pair(moved(turned_x(turned_z(ball({0, wing * (0.55 - 0.1 * back), 0},
                                            {0.16 - 0.03 * back, wing * (0.58 - 0.12 * back), 0.02}, kGlass, 12),
                                       18 + 26 * back),
                              28),
                     {0.02 - 0.1 * back, girth * 0.75, 0.06}));
    for (int k = 0; k < 3; ++k)
        a.pair(tube({{{0.12 - 0.14 * k, -girth * 0.8, 0.08}, 0.02}, {{0.16 - 0.16 * k, -girth - 0.1, 0.14}, 0.016}},
                    kInk, {.sides = 8}));
    return facing_front(a.mesh());
}

TriangleMesh spider(double body, double reach, double height, Rgb colour, Rgb mark) {
    Assembly a;
    a.add(painted(ball({0, height, -body * 0.9}, {body, body * 0.9, body * 1.15}, colour, 18), [&](Vec3 p, Rgb c) {
        return std::abs(p.x) < body * 0.22 * std::abs(std::sin(p.z * 9.0)) && p.y > height ? mark : c;
    }));
    a.add(ball({0, height, body * 0.45}, {body * 0.6, body * 0.5, body * 0.55}, darker(colour, 0.15), 14));
    for (const double side : {1.0, -1.0}) {
        for (int k = 0; k < 4; ++k) {
            const double z = 0.75 - 0.5 * k, knee = reach * (0.55 + 0.04 * k);
            a.add(tube({{{side * body * 0.4, height, body * (0.6 - 0.15 * k)}, 0.035},
                        {{side * knee, height + 0.34, z * 0.45}, 0.03},
                        {{side * reach * 0.92, height * 0.45, z * 0.8}, 0.022},
                        {{side * reach, 0, z * 0.9}, 0.012}},
                       colour, {.sides = 10}));
        }
        a.add(ball({side * 0.06, height + body * 0.3, body * 0.9}, 0.045, kWhite, 8))
            .add(ball({side * 0.06, height + body * 0.3, body * 0.9 + 0.03}, 0.024, kInk, 8));
    }
    return a.mesh();
}

TriangleMesh ant(double abdomen, double leg, double head, Rgb colour) {
    Assembly a;
    a.add(ball({-0.34 - abdomen * 0.8, 0.32, 0}, {abdomen * 1.25, abdomen * 0.85, abdomen * 0.85}, colour, 16))
        .add(ball({0, 0.3, 0}, {0.2, 0.12, 0.12}, colour, 12))
        .add(ball({0.26 + head, 0.36, 0}, {head * 1.1, head, head}, colour, 14));
    a.add(rod({-0.15, 0.3, 0}, {-0.4, 0.3, 0}, 0.05, darker(colour)))
        .add(rod({0.12, 0.31, 0}, {0.3, 0.35, 0}, 0.05, darker(colour)));
    for (int k = 0; k < 3; ++k) {
        const double x = 0.12 - 0.12 * k, foot = x + (1 - k) * 0.3 + 0.04;
        a.pair(tube({{{x, 0.26, 0.08}, 0.03},
                     {{(x + foot) / 2, 0.36, 0.08 + leg * 0.55}, 0.024},
                     {{foot, 0.0, 0.08 + leg}, 0.014}},
                    darker(colour, 0.15), {.sides = 10}));
    }
    const Vec3 brow{0.3 + head * 1.5, 0.36 + head * 0.7, 0.05};
    a.pair(tube({{brow, 0.016}, {brow + Vec3{0.12, 0.14, 0.06}, 0.014}, {brow + Vec3{0.28, 0.08, 0.08}, 0.014}},
                darker(colour), {.sides = 8}))
        .pair(ball({0.3 + head * 1.4, 0.4, head * 0.75}, 0.03, kWhite, 8));
    return facing_front(a.mesh());
}

}  // namespace

void add_insects(Models& models) {
    add_butterflies(models);
    add_model(models, "bee", "Honey bee", bee(1.0, 0.22, 0.46, kInk));
    add_model(models, "bee", "Bumblebee", bee(0.9, 0.32, 0.4, kCocoa));
    add_model(models, "bee", "Wasp", bee(1.25, 0.17, 0.55, kInk));
    add_model(models, "spider", "Garden spider", spider(0.22, 0.75, 0.32, kChestnut, kCream));
    add_model(models, "spider", "Round spider", spider(0.32, 0.65, 0.36, kSlate, kCoral));
    add_model(models, "spider", "Long-legged spider", spider(0.15, 0.95, 0.42, kTan, kInk));
    add_model(models, "ant", "Black ant", ant(0.22, 0.32, 0.15, kSlate));
    add_model(models, "ant", "Red ant", ant(0.18, 0.42, 0.17, kBrick));
    add_model(models, "ant", "Honey ant", ant(0.32, 0.3, 0.13, kHoney));
}

}  // namespace core::starter
