// Guitars and saxophones. They face +z.

#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

/// The right half of a body's outline (x >= 0, from the bottom up), mirrored to a whole ring and smoothed.
std::vector<Point> mirrored_outline(const std::vector<Point>& right, int steps = 6) {
    std::vector<Point> ring = right;
    for (std::size_t i = right.size(); i-- > 0;)
        if (right[i].x > 1e-9) ring.push_back({-right[i].x, right[i].y});
    return closed_spline(ring, steps);
}

struct Neck {
    double from = 0.4, length = 1.0, width = 0.1, depth = 0.02;
    int pegs_a_side = 3;
    Rgb wood = kWalnut, head = kChestnut, pegs = kCream;
};

void add_neck(Assembly& a, const Neck& n, int strings, double bridge_y) {
    const double top = n.from + n.length;
    a.add(box_between({-n.width / 2, n.from, n.depth}, {n.width / 2, top, n.depth + 0.08}, 0.02, n.wood));
    for (int k = 1; k < 10; ++k)
        a.add(box({0, top - n.length * (1.0 - std::pow(0.9, k)) * 1.1, n.depth + 0.082}, {n.width * 0.95, 0.012, 0.008},
                  0.003, kBrass));
    a.add(moved(slab({{-n.width * 0.5, 0},
                      {-n.width * 0.9, 0.08},
                      {-n.width * 0.78, 0.34},
                      {0, 0.38},
                      {n.width * 0.78, 0.34},
                      {n.width * 0.9, 0.08},
                      {n.width * 0.5, 0}},
                     0.07, 0.015, n.head),
                {0, top - 0.01, n.depth + 0.03}));
    for (int k = 0; k < n.pegs_a_side; ++k)
        a.pair_x(tube({{{n.width * 0.8, top + 0.09 + 0.1 * k, n.depth + 0.03}, 0.018},
                       {{n.width * 1.2, top + 0.09 + 0.1 * k, n.depth + 0.03}, 0.035, 0.018}},
                      n.pegs, {.sides = 10}));
    for (int k = 0; k < strings; ++k) {
        const double x = (strings > 1 ? k / (strings - 1.0) - 0.5 : 0.0) * n.width * 0.75;
        a.add(tube({{{x, bridge_y, n.depth + 0.1}, 0.005}, {{x, top + 0.06, n.depth + 0.1}, 0.005}}, kSteel,
                   {.sides = 5, .cap = Cap::Flat}));
    }
}

TriangleMesh acoustic(const std::vector<Point>& half, double depth, double neck, double hole_y, Rgb top, Rgb sides,
                      int strings = 6, int pegs = 3) {
    Assembly a;
    const std::vector<Point> outline = mirrored_outline(half);
    double high = 0.0, wide = 0.0;
    for (const Point p : outline) {
        high = std::max(high, p.y);
        wide = std::max(wide, p.x);
    }
    a.add(painted(slab(outline, depth, 0.025, sides), [&](Vec3 p, Rgb c) { return p.z > depth * 0.499 ? top : c; }));
    const double front = depth / 2;
    a.add(rod({0, hole_y, front - 0.02}, {0, hole_y, front + 0.008}, wide * 0.32, kBrass, Cap::Flat))
        .add(rod({0, hole_y, front - 0.02}, {0, hole_y, front + 0.012}, wide * 0.27, kInk, Cap::Flat));
    const double bridge = hole_y - wide * 1.0;
    a.add(box({0, bridge, front + 0.015}, {wide * 0.7, 0.05, 0.04}, 0.012, kCocoa));
    add_neck(a, {.from = high - 0.12, .length = neck, .width = 0.1, .depth = front - 0.03, .pegs_a_side = pegs},
             strings, bridge);
    return a.mesh();
}

TriangleMesh electric(const std::vector<Point>& outline, double neck, Rgb body, Rgb guard, int strings,
                      double neck_from) {
    Assembly a;
    a.add(slab(closed_spline(outline, 6), 0.14, 0.035, body));
    a.add(moved(slab(closed_spline({{-0.12, 0.1}, {0.16, 0.0}, {0.22, 0.3}, {0.12, 0.58}, {-0.12, 0.58}}, 6), 0.02,
                     0.006, guard),
                {0, 0, 0.075}));
    for (const double y : {0.24, 0.42}) a.add(box({0, y, 0.09}, {0.16, 0.06, 0.03}, 0.012, kInk));
    a.add(box({0, 0.1, 0.09}, {0.2, 0.07, 0.03}, 0.012, kSteel));
    for (const double y : {-0.02, 0.1}) a.add(rod({0.27, y, 0.05}, {0.27, y, 0.1}, 0.03, kCream, Cap::Flat));
    add_neck(a,
             {.from = neck_from,
              .length = neck,
              .width = 0.09,
              .depth = 0.03,
              .pegs_a_side = (strings + 1) / 2,
              .wood = kHoney,
              .head = body,
              .pegs = kSteel},
             strings, 0.1);
    return a.mesh();
}

void add_guitars(Models& models) {
    const std::vector<Point> classic{{0.0, -0.02}, {0.24, 0.02}, {0.4, 0.2},   {0.38, 0.42},
                                     {0.26, 0.58}, {0.3, 0.78},  {0.24, 0.95}, {0.08, 1.0}};
    add_model(models, "guitar", "Acoustic guitar", acoustic(classic, 0.2, 0.85, 0.63, kHoney, kWalnut));
    std::vector<Point> jumbo = classic;
    for (Point& p : jumbo) p.x *= p.y < 0.5 ? 1.22 : 1.08;
    add_model(models, "guitar", "Jumbo guitar", acoustic(jumbo, 0.24, 0.72, 0.64, kMustard, kBrick));
    std::vector<Point> small = classic;
    for (Point& p : small) p = p * 0.72;
    add_model(models, "guitar", "Ukulele", acoustic(small, 0.15, 0.5, 0.45, kSky, kBlue, 4, 2));
    add_model(models, "guitar", "Electric guitar",
              electric({{0.02, -0.12},
                        {0.3, -0.12},
                        {0.4, 0.08},
                        {0.28, 0.3},
                        {0.3, 0.52},
                        {0.34, 0.7},
                        {0.2, 0.62},
                        {0.08, 0.52},
                        {-0.08, 0.54},
                        {-0.18, 0.74},
                        {-0.34, 0.86},
                        {-0.3, 0.6},
                        {-0.25, 0.36},
                        {-0.38, 0.12},
                        {-0.3, -0.1}},
                       0.95, kRed, kCream, 6, 0.5));
    add_model(models, "guitar", "Flying V guitar",
              electric({{0.0, 0.12},
                        {0.18, -0.12},
                        {0.36, -0.38},
                        {0.48, -0.36},
                        {0.44, -0.18},
                        {0.28, 0.2},
                        {0.12, 0.56},
                        {0.0, 0.62},
                        {-0.12, 0.56},
                        {-0.28, 0.2},
                        {-0.44, -0.18},
                        {-0.48, -0.36},
                        {-0.36, -0.38},
                        {-0.18, -0.12}},
                       0.9, kInk, kMustard, 6, 0.52));
    add_model(models, "guitar", "Bass guitar",
              electric({{0.0, -0.16},
                        {0.26, -0.2},
                        {0.34, 0.02},
                        {0.24, 0.28},
                        {0.26, 0.5},
                        {0.36, 0.68},
                        {0.2, 0.66},
                        {0.07, 0.54},
                        {-0.07, 0.56},
                        {-0.14, 0.8},
                        {-0.26, 0.98},
                        {-0.28, 0.7},
                        {-0.22, 0.36},
                        {-0.32, 0.06},
                        {-0.24, -0.16}},
                       1.25, kTeal, kWhite, 4, 0.5));
}

struct Saxophone {
    double length = 1.0, bend = 0.2, bell = 0.22, neck = 0.3, bore = 0.035;  ///< of the straight body; radii
    bool keys = true;
    Rgb metal = kMustard;
};

/// From the mouthpiece over the neck down the body, round the bow and up to the bell.
TriangleMesh saxophone(const Saxophone& s) {
    const double l = s.length, r = s.bend, w = s.bore;
    Assembly a;
    a.add(tube({{{-s.neck, l + 0.02, 0}, w * 0.8},
                {{-s.neck * 0.55, l + 0.1, 0}, w * 0.85},
                {{-s.neck * 0.12, l + 0.06, 0}, w},
                {{0, l * 0.85, 0}, w * 1.15},
                {{0.02, l * 0.4, 0}, w * 1.8},
                {{0.05, r * 0.6, 0}, w * 2.4},
                {{0.05 + r * 0.4, -r * 0.25, 0}, w * 2.7},
                {{0.05 + r * 1.25, -r * 0.2, 0}, w * 3.0},
                {{0.05 + r * 1.75, r * 0.8, 0}, w * 3.2},
                {{0.05 + r * 1.85, l * 0.36, 0}, s.bell * 0.62},
                {{0.05 + r * 2.0, l * 0.52, 0}, s.bell}},
               s.metal, {.sides = 20, .steps = 6, .cap = Cap::Flat}));
    a.add(moved(turned_z(ball({0, 0, 0}, {s.bell * 0.9, 0.012, s.bell * 0.9}, darker(s.metal, 0.5), 12), -10),
                {0.05 + r * 2.0, l * 0.525, 0}));
    a.add(tube({{{-s.neck + 0.03, l + 0.04, 0}, w * 0.95}, {{-s.neck - 0.16, l - 0.03, 0}, w * 0.55}}, kInk));
    for (int k = 0; k < 6 && s.keys; ++k)
        a.add(rod({0.01, l * (0.78 - 0.11 * k), w * 1.1}, {0.01, l * (0.78 - 0.11 * k), w * 2.4}, w * (1.0 + 0.1 * k),
                  kCream, Cap::Flat));
    return a.mesh();
}

void add_saxophones(Models& models) {
    add_model(models, "saxophone", "Alto saxophone", saxophone({.length = 0.9, .bell = 0.24, .bore = 0.045}));
    add_model(models, "saxophone", "Tenor saxophone",
              saxophone({.length = 1.15, .bend = 0.24, .bell = 0.27, .neck = 0.4, .bore = 0.045, .metal = kHoney}));
    add_model(models, "saxophone", "Silver saxophone",
              saxophone({.length = 0.85, .bend = 0.28, .bell = 0.28, .neck = 0.22, .bore = 0.05, .metal = kSteel}));
    add_model(models, "saxophone", "Baritone saxophone",
              saxophone({.length = 1.0, .bend = 0.34, .bell = 0.34, .neck = 0.3, .bore = 0.06, .metal = kBrass}));
    add_model(
        models, "saxophone", "Toy saxophone",
        saxophone(
            {.length = 0.7, .bend = 0.22, .bell = 0.28, .neck = 0.16, .bore = 0.058, .keys = false, .metal = kCoral}));
}

}  // namespace

void add_instruments(Models& models) {
    add_guitars(models);
    add_saxophones(models);
}

}  // namespace core::starter
