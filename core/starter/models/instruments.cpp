// Guitars, violins, drums, trumpets and pianos.

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

TriangleMesh fiddle(double size, double neck, bool spike, Rgb wood, double fat) {
    Assembly a;
    std::vector<Point> half{{0.0, -0.02}, {0.2, 0.0},   {0.33, 0.14}, {0.32, 0.32}, {0.24, 0.38}, {0.19, 0.5},
                            {0.22, 0.62}, {0.28, 0.66}, {0.26, 0.84}, {0.12, 0.94}, {0.04, 0.95}};
    for (Point& p : half) p.x *= fat;
    a.add(slab(mirrored_outline(half), 0.14 * fat, 0.035, wood));
    const double z = 0.07 * fat;
    for (const double side : {1.0, -1.0})
        a.add(tube({{{side * 0.13, 0.34, z}, 0.014}, {{side * 0.15, 0.45, z}, 0.012}, {{side * 0.12, 0.56, z}, 0.014}},
                   kInk, {.sides = 8}));
    a.add(
        moved(slab({{-0.035, 0.04}, {-0.06, 0.28}, {0.06, 0.28}, {0.035, 0.04}}, 0.05, 0.012, kInk), {0, 0, z + 0.01}));
    a.add(box({0, 0.42, z + 0.03}, {0.17, 0.025, 0.09}, 0.01, kHoney));
    a.add(box_between({-0.035, 0.55, z}, {0.035, 0.92 + neck, z + 0.05}, 0.012, kInk));
    a.add(tube({{{0, 0.9 + neck, z + 0.02}, 0.035}, {{0, 1.05 + neck, z + 0.02}, 0.038}, {{0, 1.16 + neck, z}, 0.05}},
               darker(wood)));
    for (const double y : {0.98, 1.06})
        a.add(tube({{{-0.13, y + neck, z + 0.02}, 0.03, 0.015},
                    {{-0.08, y + neck, z + 0.02}, 0.014},
                    {{0.08, y + neck, z + 0.02}, 0.014},
                    {{0.13, y + neck, z + 0.02}, 0.03, 0.015}},
                   kInk, {.sides = 8, .steps = 2}));
    for (int k = 0; k < 4; ++k)
        a.add(tube({{{0.02 * (k - 1.5), 0.2, z + 0.06}, 0.004}, {{0.016 * (k - 1.5), 0.92 + neck, z + 0.06}, 0.004}},
                   kSteel, {.sides = 5, .cap = Cap::Flat}));
    if (spike) a.add(rod({0, 0.02, 0}, {0, -0.26, 0}, 0.018, kSteel));
    return scaled(a.mesh(), {size, size, size});
}

void add_violins(Models& models) {
    add_model(models, "violin", "Violin", fiddle(1.0, 0.5, false, kChestnut, 1.0));
    add_model(models, "violin", "Honey violin", fiddle(1.0, 0.38, false, kHoney, 0.9));
    add_model(models, "violin", "Viola", fiddle(1.0, 0.6, false, kBrick, 1.1));
    add_model(models, "cello", "Cello", fiddle(1.6, 0.42, true, kWood, 1.12));
    add_model(models, "cello", "Dark cello", fiddle(1.6, 0.55, true, kCocoa, 1.0));
    add_model(models, "cello", "Double bass", fiddle(1.8, 0.7, true, kHoney, 1.25));
}

TriangleMesh drum(Vec3 at, double r, double h, Rgb colour) {
    Assembly a;
    a.add(lathe({{0, 0}, {r, 0}, {r, h}, {0, h}}, colour, 36))
        .add(lathe({{0, h * 0.86}, {r + 0.02, h * 0.86}, {r + 0.02, h + 0.01}, {0, h + 0.01}}, kCream, 36))
        .add(lathe({{0, -0.01}, {r + 0.02, -0.01}, {r + 0.02, h * 0.12}, {0, h * 0.12}}, kSteel, 36));
    return moved(a.mesh(), at);
}

TriangleMesh drum_kit(double bass, int toms, int cymbals, Rgb colour) {
    Assembly a;
    a.add(moved(turned_x(drum({0, -0.25, 0}, bass, 0.5, colour), 90), {0, bass, 0}));
    for (int k = 0; k < toms; ++k)
        a.add(moved(turned_x(drum({0, 0, 0}, 0.24, 0.22, colour), 12),
                    {(k - (toms - 1) / 2.0) * 0.54, 2 * bass + 0.06, 0}));
    for (const double side : {-1.0, 1.0}) {
        a.add(drum({side * (bass + 0.34), 0.3, 0.1}, 0.28, 0.3, colour));
        for (int k = 0; k < 3; ++k)
            a.add(moved(turned_y(rod({0.2, 0, 0}, {0.12, 0.35, 0}, 0.018, kSteel), 120.0 * k),
                        {side * (bass + 0.34), 0, 0.1}));
    }
    for (int k = 0; k < cymbals; ++k) {
        const double side = k == 0 ? 1.0 : -1.0;
        a.add(rod({side * (bass + 0.62), 0, -0.2}, {side * (bass + 0.5), 1.35, -0.2}, 0.02, kSteel));
        a.add(moved(turned_z(lathe({{0, 0}, {0.36, 0}, {0.1, 0.04}, {0.06, 0.08}, {0, 0.09}}, kBrass, 32), side * 12),
                    {side * (bass + 0.5), 1.33, -0.2}));
    }
    return a.mesh();
}

void add_drums(Models& models) {
    add_model(models, "drums", "Drum kit", drum_kit(0.42, 2, 2, kRed));
    add_model(models, "drums", "Jazz drum kit", drum_kit(0.34, 1, 2, kTeal));
    add_model(models, "drums", "Big drum kit", drum_kit(0.5, 3, 2, kNavy));
}

TriangleMesh grand_piano(Rgb colour, double length) {
    Assembly a;
    std::vector<Point> plan = closed_spline({{-0.75, -0.45},
                                             {0.75, -0.45},
                                             {0.78, 0.2},
                                             {0.55, 0.6},
                                             {0.2, 0.75},
                                             {0.0, 1.15},
                                             {-0.4, 1.4},
                                             {-0.74, 1.2},
                                             {-0.78, 0.4}},
                                            5);
    for (Point& p : plan) p.y *= length;
    a.add(moved(turned_x(slab(plan, 0.3, 0.03, colour), -90), {0, 0.75, 0}));
    a.add(moved(turned_z(moved(turned_x(slab(plan, 0.04, 0.012, colour), -90), {0.78, 0, 0}), 38), {-0.78, 0.93, 0}));
    a.add(box({0, 0.75, 0.58}, {1.4, 0.12, 0.3}, 0.02, colour))
        .add(box({0, 0.83, 0.58}, {1.3, 0.05, 0.24}, 0.01, kWhite));
    for (int k = 0; k < 14; ++k)
        if (k % 7 != 2 && k % 7 != 6) a.add(box({-0.58 + 0.09 * k, 0.865, 0.52}, {0.045, 0.04, 0.13}, 0.008, kInk));
    for (const Vec3 foot : {Vec3{-0.65, 0, 0.4}, Vec3{0.65, 0, 0.4}, Vec3{-0.4, 0, -1.1 * length}})
        a.add(cone(foot, foot + Vec3{0, 0.65, 0}, 0.04, 0.07, colour));
    return a.mesh();
}

TriangleMesh upright_piano(Rgb colour, double height) {
    Assembly a;
    a.add(box({0, height / 2, -0.15}, {1.4, height, 0.4}, 0.03, colour))
        .add(box({0, height + 0.02, -0.15}, {1.5, 0.06, 0.46}, 0.02, colour))
        .add(box({0, 0.62, 0.18}, {1.4, 0.14, 0.34}, 0.03, colour))
        .add(box({0, 0.7, 0.2}, {1.28, 0.05, 0.24}, 0.01, kWhite));
    for (int k = 0; k < 14; ++k)
        if (k % 7 != 2 && k % 7 != 6) a.add(box({-0.58 + 0.09 * k, 0.73, 0.14}, {0.045, 0.04, 0.13}, 0.008, kInk));
    a.pair_x(cone({0.62, 0, 0.28}, {0.62, 0.58, 0.28}, 0.035, 0.055, colour))
        .add(box({0, 0.95, 0.06}, {0.6, 0.3, 0.03}, 0.012, kCream));
    return a.mesh();
}

void add_pianos(Models& models) {
    add_model(models, "piano", "Grand piano", grand_piano(kInk, 1.0));
    add_model(models, "piano", "Upright piano", upright_piano(kWalnut, 1.25));
    add_model(models, "piano", "White grand piano", grand_piano(kCream, 0.7));
    add_model(models, "piano", "Spinet", upright_piano(kHoney, 0.98));
}

TriangleMesh trumpet(double length, double bell, double loop_height, Rgb metal) {
    Assembly a;
    const double h = length / 2;
    a.add(tube({{{h, 0, 0}, bell},
                {{h - 0.06, 0, 0}, bell * 0.72},
                {{h - 0.25, 0, 0}, bell * 0.3},
                {{h - 0.6, 0, 0}, 0.05},
                {{-h * 0.4, 0, 0}, 0.04},
                {{-h * 0.62, -loop_height * 0.5, 0}, 0.04},
                {{-h * 0.4, -loop_height, 0}, 0.04},
                {{h * 0.25, -loop_height, 0}, 0.04},
                {{h * 0.42, -loop_height * 0.5, 0}, 0.04},
                {{h * 0.2, -loop_height * 0.12, 0}, 0.038}},
               metal, {.sides = 18, .cap = Cap::Flat}));
    a.add(tube({{{h * 0.1, -0.03, 0}, 0.035},
                {{-h * 0.8, -0.03, 0}, 0.032},
                {{-h, -0.03, 0}, 0.04},
                {{-h - 0.06, -0.03, 0}, 0.06}},
               metal, {.cap = Cap::Flat}));
    for (int k = -1; k <= 1; ++k)
        a.add(rod({0.12 * k, -loop_height * 1.15, 0.0}, {0.12 * k, 0.1, 0.0}, 0.05, metal, Cap::Flat))
            .add(rod({0.12 * k, 0.1, 0}, {0.12 * k, 0.18, 0}, 0.02, kSteel))
            .add(rod({0.12 * k, 0.17, 0}, {0.12 * k, 0.2, 0}, 0.042, kCream, Cap::Flat));
    a.add(rod({h + 0.001, 0, 0}, {h + 0.003, 0, 0}, bell * 0.8, darker(metal, 0.4), Cap::Flat));
    return a.mesh();
}

void add_trumpets(Models& models) {
    add_model(models, "trumpet", "Trumpet", trumpet(1.6, 0.26, 0.28, kMustard));
    add_model(models, "trumpet", "Silver trumpet", trumpet(1.8, 0.22, 0.2, kSteel));
    add_model(models, "trumpet", "Cornet", trumpet(1.2, 0.25, 0.36, kBrass));
    add_model(models, "trumpet", "Flugelhorn", trumpet(1.4, 0.36, 0.34, kHoney));
}

}  // namespace

void add_instruments(Models& models) {
    add_guitars(models);
    add_violins(models);
    add_drums(models);
    add_pianos(models);
    add_trumpets(models);
}

}  // namespace core::starter
