// Fish, sharks, dolphins and whales.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/starter/kit/quadruped.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

TriangleMesh fin(const std::vector<Point>& outline, Rgb colour, double thickness = 0.05) {
    return slab(closed_spline(outline, 5), thickness, thickness * 0.3, colour);
}

struct Fish {
    double length = 0.6, height = 0.3, width = 0.14, tail = 0.3, tail_spread = 0.28, dorsal = 0.16;
    bool forked = true;
    Rgb body = kOrange, belly = kCream, fins = kCoral, stripe = kOrange;
    int stripes = 0;
};

TriangleMesh fish(const Fish& f) {
    Assembly a;
    const double l = f.length, h = f.height;
    a.add(painted(tube({{{-l, 0, 0}, h * 0.16, f.width * 0.25},
                        {{-l * 0.55, 0, 0}, h * 0.5, f.width * 0.65},
                        {{0, 0, 0}, h, f.width},
                        {{l * 0.5, 0, 0}, h * 0.84, f.width * 0.95},
                        {{l * 0.86, -h * 0.06, 0}, h * 0.4, f.width * 0.6},
                        {{l, -h * 0.1, 0}, h * 0.14, f.width * 0.3}},
                       f.body, {.sides = 28, .steps = 8}),
                  [&](Vec3 p, Rgb c) {
                      if (f.stripes > 0 && std::sin(p.x / l * f.stripes * 3.14159 + 0.9) > 0.45) return f.stripe;
                      return p.y < -h * 0.35 ? f.belly : c;
                  }));
    const double t = f.tail, s = f.tail_spread, root = -l * 0.92;
    a.add(moved(fin({{0.03, h * 0.12},
                     {-t * 0.45, s * 0.55},
                     {-t * 1.05, s},
                     {-t * (f.forked ? 0.55 : 1.15), 0},
                     {-t * 1.05, -s},
                     {-t * 0.45, -s * 0.55},
                     {0.03, -h * 0.12}},
                    f.fins),
                {root, 0, 0}));
    a.add(fin({{l * 0.35, h * 0.72},
               {l * 0.1, h * 0.9 + f.dorsal},
               {-l * 0.35, h * 0.65 + f.dorsal * 0.9},
               {-l * 0.5, h * 0.42},
               {-l * 0.1, h * 0.7}},
              f.fins));
    a.add(fin({{-l * 0.05, -h * 0.85}, {-l * 0.3, -h * 0.72 - f.dorsal * 0.8}, {-l * 0.42, -h * 0.5}}, f.fins));
    a.pair(moved(
        turned_y(fin({{0.02, 0.05}, {-0.16, 0.08}, {-0.22, -0.06}, {-0.08, -0.1}, {0.02, -0.03}}, f.fins, 0.03), 30),
        {l * 0.3, -h * 0.25, f.width * 0.92}));
    a.pair(ball({l * 0.66, h * 0.2, f.width * 0.72}, {0.055, 0.055, 0.035}, kWhite, 10))
        .pair(ball({l * 0.675, h * 0.2, f.width * 0.72 + 0.025}, 0.03, kInk, 8));
    return facing_front(a.mesh());
}

void add_fish(Models& models) {
    add_model(models, "fish", "Goldfish", fish({}));
    add_model(models, "fish", "Clownfish",
              fish({.length = 0.55,
                    .height = 0.26,
                    .tail = 0.24,
                    .tail_spread = 0.2,
                    .forked = false,
                    .body = kOrange,
                    .belly = kOrange,
                    .fins = kOrange,
                    .stripe = kWhite,
                    .stripes = 3}));
    add_model(models, "fish", "Angelfish",
              fish({.length = 0.45,
                    .height = 0.42,
                    .width = 0.1,
                    .tail = 0.28,
                    .tail_spread = 0.22,
                    .dorsal = 0.34,
                    .body = kStraw,
                    .belly = kStraw,
                    .fins = kMustard,
                    .stripe = kNavy,
                    .stripes = 3}));
    add_model(models, "fish", "Trout",
              fish({.length = 0.85,
                    .height = 0.2,
                    .width = 0.13,
                    .tail = 0.24,
                    .tail_spread = 0.24,
                    .dorsal = 0.1,
                    .body = kOlive,
                    .belly = kCream,
                    .fins = kHoney}));
    add_model(models, "fish", "Tang",
              fish({.length = 0.5,
                    .height = 0.34,
                    .width = 0.1,
                    .tail = 0.22,
                    .tail_spread = 0.3,
                    .dorsal = 0.1,
                    .body = kBlue,
                    .belly = kNavy,
                    .fins = kMustard}));
    add_model(models, "fish", "Puffer",
              fish({.length = 0.45,
                    .height = 0.36,
                    .width = 0.32,
                    .tail = 0.16,
                    .tail_spread = 0.13,
                    .dorsal = 0.04,
                    .forked = false,
                    .body = kMint,
                    .belly = kWhite,
                    .fins = kTeal}));
}

struct Swimmer {
    double length = 1.0, height = 0.24, width = 0.2, nose = 0.1, dorsal = 0.26, flipper = 0.34;
    double bend = 0.0;  ///< how much nose and tail hang below the middle
    bool upright_tail = true;
    double tail = 0.34;
    Rgb back = kSlate, belly = kWhite;
};

TriangleMesh swimmer(const Swimmer& s) {
    Assembly a;
    const double l = s.length, h = s.height;
    const auto y = [&](double x) { return -s.bend * x * x / (l * l); };
    std::vector<Station> line;
    const std::vector<std::array<double, 2>> plan{{-1.0, 0.14}, {-0.6, 0.42}, {-0.1, 0.95}, {0.3, 1.0},
                                                  {0.7, 0.72},  {0.92, 0.42}, {1.0, s.nose}};
    for (const auto& [x, r] : plan) line.push_back({{x * l, y(x * l), 0}, r * h, r * s.width});
    a.add(painted(tube(line, s.back, {.sides = 26, .steps = 8}),
                  [&](Vec3 p, Rgb c) { return p.y - y(p.x) < -h * 0.3 ? s.belly : c; }));
    a.add(moved(
        fin({{0.16, -0.04}, {0.02, s.dorsal * 0.7}, {-0.14, s.dorsal}, {-0.1, s.dorsal * 0.4}, {-0.16, -0.06}}, s.back),
        {-0.05 * l, h * 0.9 + y(0.05), 0}));
    const double f = s.flipper;
    const TriangleMesh side_fin =
        turned_x(fin({{0.1, 0}, {-0.02, f * 0.6}, {-0.2, f}, {-0.16, f * 0.4}, {-0.1, 0}}, s.back), 90);
    a.pair(moved(turned_x(side_fin, 32), {l * 0.36, -h * 0.5 + y(l * 0.4), s.width * 0.75}));
    const double t = s.tail;
    const Vec3 end{-l * 0.97, y(l), 0};
    if (s.upright_tail)
        a.add(moved(fin({{0.1, 0.03},
                         {-0.12, t * 0.55},
                         {-0.3, t * 1.05},
                         {-0.16, 0.08},
                         {-0.2, -t * 0.7},
                         {-0.08, -t * 0.3},
                         {0.1, -0.03}},
                        s.back),
                    end));
    else
        a.add(moved(turned_z(turned_x(fin({{0.1, 0.04},
                                           {-0.08, t * 0.6},
                                           {-0.26, t},
                                           {-0.18, 0.0},
                                           {-0.26, -t},
                                           {-0.08, -t * 0.6},
                                           {0.1, -0.04}},
                                          s.back, 0.06),
                                      90),
                             -28),
                    end));
    a.pair(ball({l * 0.76, h * 0.14 + y(l * 0.76), s.width * 0.58}, 0.032, kInk, 8));
    return facing_front(a.mesh());
}

void add_swimmers(Models& models) {
    add_model(models, "shark", "Shark", swimmer({}));
    add_model(models, "shark", "Blue shark",
              swimmer({.length = 1.2,
                       .height = 0.19,
                       .width = 0.15,
                       .dorsal = 0.22,
                       .flipper = 0.5,
                       .tail = 0.46,
                       .back = kBlue}));
    add_model(models, "shark", "Great white shark",
              swimmer({.length = 0.95,
                       .height = 0.32,
                       .width = 0.26,
                       .dorsal = 0.36,
                       .flipper = 0.42,
                       .tail = 0.42,
                       .back = kGrey}));
    add_model(models, "dolphin", "Dolphin",
              swimmer({.length = 0.85,
                       .height = 0.21,
                       .width = 0.17,
                       .nose = 0.12,
                       .dorsal = 0.22,
                       .flipper = 0.28,
                       .bend = 0.22,
                       .upright_tail = false,
                       .tail = 0.26,
                       .back = kSky}));
    add_model(models, "dolphin", "Leaping dolphin",
              swimmer({.length = 0.85,
                       .height = 0.2,
                       .width = 0.17,
                       .nose = 0.12,
                       .dorsal = 0.2,
                       .flipper = 0.3,
                       .bend = 0.5,
                       .upright_tail = false,
                       .tail = 0.3,
                       .back = kSteel}));
    add_model(models, "dolphin", "Porpoise",
              swimmer({.length = 0.7,
                       .height = 0.25,
                       .width = 0.22,
                       .nose = 0.2,
                       .dorsal = 0.14,
                       .flipper = 0.22,
                       .bend = 0.12,
                       .upright_tail = false,
                       .tail = 0.22,
                       .back = kSlate}));
    const auto whale = [](double height, double bend, double spout, Rgb back, double l, double dorsal) {
        Assembly a;
        const double h = height;
        a.add(painted(tube({{{-l, 0.42 + bend, 0}, 0.05, 0.07},
                            {{-l * 0.75, 0.12 + bend * 0.4, 0}, 0.12},
                            {{-l * 0.35, 0.02, 0}, h * 0.62, h * 0.6},
                            {{l * 0.1, 0, 0}, h, h * 0.92},
                            {{l * 0.6, -0.02, 0}, h * 0.96, h * 0.85},
                            {{l * 0.85, -0.06, 0}, h * 0.6, h * 0.6}},
                           back, {.sides = 28, .steps = 9}),
                      [&](Vec3 p, Rgb c) { return p.y < -h * 0.35 && p.x > -l * 0.5 ? kCream : c; }));
        a.add(moved(turned_z(turned_x(fin({{0.12, 0.05},
                                           {0.0, 0.28},
                                           {-0.2, 0.42},
                                           {-0.16, 0.0},
                                           {-0.2, -0.42},
                                           {0.0, -0.28},
                                           {0.12, -0.05}},
                                          back, 0.08),
                                      90),
                             -48),
                    {-l, 0.46 + bend, 0}));
        a.pair(moved(
            turned_x(turned_x(fin({{0.1, 0}, {0.0, 0.28}, {-0.18, 0.4}, {-0.14, 0.0}}, darker(back), 0.06), 90), 35),
            {l * 0.3, -h * 0.6, h * 0.7}));
        if (dorsal > 0)
            a.add(moved(fin({{0.16, -0.06}, {0.0, dorsal}, {-0.08, dorsal}, {-0.12, -0.06}}, darker(back)),
                        {-l * 0.05, h * 0.95, 0}));
        a.pair(ball({l * 0.72, -h * 0.02, h * 0.74}, 0.04, kInk, 8));
        if (spout > 0) {
            const Vec3 hole{l * 0.5, h * 0.93, 0};
            for (const double side : {1.0, -1.0})
                a.add(tube({{hole, 0.035},
                            {hole + Vec3{side * 0.05, spout * 0.6, 0}, 0.04},
                            {hole + Vec3{side * 0.17, spout, 0}, 0.05},
                            {hole + Vec3{side * 0.28, spout * 0.78, 0}, 0.03}},
                           kSky));
        }
        return facing_front(a.mesh());
    };
    add_model(models, "whale", "Blue whale", whale(0.38, 0.1, 0.34, kBlue, 1.0, 0.0));
    add_model(models, "whale", "Baby whale", whale(0.42, 0.2, 0.26, kTeal, 0.72, 0.0));
    add_model(models, "whale", "Orca", whale(0.3, -0.05, 0.0, kInk, 0.9, 0.4));
    add_model(models, "whale", "Grey whale", whale(0.3, 0.3, 0.4, kSlate, 1.1, 0.0));
}

}  // namespace

void add_fish_and_whales(Models& models) {
    add_fish(models);
    add_swimmers(models);
}

}  // namespace core::starter
