// Fish.

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

}  // namespace

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
    add_model(models, "fish", "Little fish",
              fish({.length = 0.5,
                    .height = 0.27,
                    .width = 0.1,
                    .tail = 0.34,
                    .tail_spread = 0.26,
                    .dorsal = 0.03,
                    .forked = false,
                    .body = kSky,
                    .belly = kWhite,
                    .fins = kBlue}));
    add_model(models, "fish", "Round fish",
              fish({.length = 0.44,
                    .height = 0.34,
                    .width = 0.11,
                    .tail = 0.32,
                    .tail_spread = 0.32,
                    .dorsal = 0.05,
                    .body = kCoral,
                    .belly = kCream,
                    .fins = kBrick}));
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

}  // namespace core::starter
