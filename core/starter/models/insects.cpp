// Butterflies and spiders.

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
    const std::vector<Point> upper = closed_spline({{0.02, 0.0},
                                                    {0.03, 0.18},
                                                    {u * 0.36, 0.5 * h},
                                                    {u * 0.78, 0.6 * h},
                                                    {u, 0.4 * h},
                                                    {u * 0.86, 0.12 * h},
                                                    {u * 0.42, -0.03}},
                                                   6);
    std::vector<Point> ring{{0.02, 0.04}, {l * 0.45, 0.0}, {l * 0.92, -0.1}, {l, -0.34 * h}, {l * 0.72, -0.54 * h}};
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
    add_model(models, "butterfly", "Monarch", butterfly({.upper = 0.66, .lower = 0.56, .height = 1.1}));
    add_model(models, "butterfly", "Swallowtail",
              butterfly({.upper = 0.75, .lower = 0.48, .tails = 0.2, .wing = kStraw, .edge = kInk, .spot = kCoral}));
    add_model(models, "butterfly", "Blue morpho",
              butterfly({.upper = 0.72, .lower = 0.66, .height = 0.95, .wing = kBlue, .edge = kNavy, .spot = kSky}));
    add_model(models, "butterfly", "Cabbage white",
              butterfly({.upper = 0.5, .lower = 0.48, .height = 1.3, .wing = kWhite, .edge = kStone, .spot = kSlate}));
    add_model(models, "butterfly", "Rose moth",
              butterfly({.upper = 0.9, .lower = 0.4, .height = 0.75, .wing = kRose, .edge = kWine, .spot = kMustard}));
    add_model(models, "butterfly", "Peacock butterfly",
              butterfly({.upper = 0.8, .lower = 0.74, .height = 1.2, .wing = kCoral, .edge = kBrick, .spot = kNavy}));
}

struct Spider {
    double body = 0.22, reach = 0.75, height = 0.2;
    double knee = 0.2;  ///< how far the knees stand above the body
    double fan = 1.0;   ///< how far the legs of a side spread forward and back
    Rgb colour = kChestnut, mark = kCream;
};

TriangleMesh spider(const Spider& s) {
    Assembly a;
    a.add(painted(
        ball({0, s.height, -s.body * 0.9}, {s.body, s.body * 0.75, s.body * 1.15}, s.colour, 16), [&](Vec3 p, Rgb c) {
            return std::abs(p.x) < s.body * 0.22 * std::abs(std::sin(p.z * 9.0)) && p.y > s.height ? s.mark : c;
        }));
    a.add(ball({0, s.height, s.body * 0.45}, {s.body * 0.6, s.body * 0.45, s.body * 0.55}, darker(s.colour, 0.15), 12));
    for (const double side : {1.0, -1.0}) {
        for (int k = 0; k < 4; ++k) {
            const double turn = s.fan * (0.95 - 0.62 * k), out = std::cos(turn), ahead = std::sin(turn);
            const auto at = [&](double r, double y) { return Vec3{side * r * out, y, r * ahead}; };
            a.add(tube({{at(s.body * 0.4, s.height), 0.034},
                        {at(s.reach * 0.55, s.height + s.knee), 0.03},
                        {at(s.reach * 0.9, s.height * 0.4), 0.022},
                        {at(s.reach, 0), 0.014}},
                       s.colour, {.sides = 8, .steps = 5}));
        }
        a.add(ball({side * 0.06, s.height + s.body * 0.3, s.body * 0.85}, 0.045, kWhite, 8))
            .add(ball({side * 0.06, s.height + s.body * 0.3, s.body * 0.85 + 0.03}, 0.024, kInk, 8));
    }
    return a.mesh();
}

void add_spiders(Models& models) {
    add_model(models, "spider", "Garden spider", spider({}));
    add_model(models, "spider", "Round spider",
              spider({.body = 0.34, .reach = 0.78, .colour = kSlate, .mark = kCoral}));
    add_model(models, "spider", "Long-legged spider",
              spider({.body = 0.15, .reach = 1.0, .height = 0.28, .knee = 0.3, .colour = kTan, .mark = kInk}));
    add_model(
        models, "spider", "Flat spider",
        spider({.body = 0.26, .reach = 0.9, .height = 0.14, .knee = 0.06, .fan = 1.15, .colour = kInk, .mark = kRed}));
    add_model(
        models, "spider", "Jumping spider",
        spider(
            {.body = 0.3, .reach = 0.62, .height = 0.18, .knee = 0.14, .fan = 0.85, .colour = kCocoa, .mark = kStraw}));
}

}  // namespace

void add_insects(Models& models) {
    add_butterflies(models);
    add_spiders(models);
}

}  // namespace core::starter
