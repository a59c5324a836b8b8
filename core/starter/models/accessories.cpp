// What is worn with clothes: shoes, hats, spectacles, crowns, handbags and headphones.

#include <algorithm>
#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/blob.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

constexpr double kTurn = 6.283185307179586;

struct Shoe {
    double ankle = 0.34, toe = 0.13, length = 1.0, sole = 0.08;
    Rgb upper = kCoral, rubber = kWhite;
    bool laces = true;
    double heel = 0.0;    ///< height of a heel under the ankle
    double shaft = 0.17;  ///< half width of the opening
};

TriangleMesh shoe(const Shoe& s) {
    const double instep = std::min(s.ankle - 0.02, 0.32), l = s.length;
    Blob b(0.08);
    b.limb({-0.33 * l, 0.14, 0}, {0.33 * l, 0.09, 0}, 0.13, s.toe, s.upper)
        .limb({-0.32 * l, 0.16, 0}, {-0.27 * l, s.ankle, 0}, 0.15, s.shaft, s.upper)
        .limb({-0.28 * l, instep, 0}, {0.12 * l, 0.12, 0}, 0.1, 0.09, s.upper);
    Assembly a;
    a.add(scaled(b.mesh(42), {1.0, 1.0, 0.85}));
    const std::vector<Point> plan = closed_spline({{-0.465 * l, 0},
                                                   {-0.36 * l, 0.14},
                                                   {0.0, 0.12},
                                                   {0.3 * l, 0.15},
                                                   {0.47 * l, 0.07},
                                                   {0.48 * l, -0.05},
                                                   {0.3 * l, -0.15},
                                                   {0.0, -0.12},
                                                   {-0.36 * l, -0.14}},
                                                  5);
    a.add(moved(turned_x(slab(plan, s.sole, 0.02, s.rubber), -90), {0, s.sole / 2 - 0.02, 0}));
    if (s.heel > 0) a.add(box_between({-0.46 * l, -s.heel, -0.12}, {-0.2 * l, 0.02, 0.12}, 0.03, s.rubber));
    a.add(moved(scaled(ring({0, 0, 0}, {0, 1, 0}, s.shaft - 0.01, 0.022, lighter(s.upper)), {1.0, 1.0, 0.85}),
                {-0.27 * l, s.ankle + s.shaft - 0.07, 0}))
        .add(moved(ball({0, 0, 0}, {s.shaft * 0.94, 0.03, s.shaft * 0.78}, kInk, 10),
                   {-0.27 * l, s.ankle + s.shaft - 0.02, 0}));
    for (int k = 0; k < 3 && s.laces; ++k) {
        const double t = 0.45 + 0.2 * k;  // along the instep, from the ankle to the toe
        const double x = -0.28 * l + 0.4 * l * t, y = instep + (0.12 - instep) * t + 0.095;
        a.add(rod({x, y, -0.08}, {x + 0.03, y, 0.08}, 0.02, kWhite));
    }
    return facing_front(a.mesh());
}

void add_shoes(Models& models) {
    add_model(models, "shoe", "Sneaker", shoe({}));
    add_model(models, "shoe", "Boot",
              shoe({.ankle = 0.66, .toe = 0.16, .sole = 0.1, .upper = kWalnut, .rubber = kInk, .heel = 0.08}));
    add_model(models, "shoe", "Running shoe",
              shoe({.ankle = 0.3, .toe = 0.09, .length = 1.2, .sole = 0.12, .upper = kSky, .rubber = kMustard}));
    add_model(models, "shoe", "High-top shoe", shoe({.ankle = 0.48, .toe = 0.14, .length = 1.0, .upper = kNavy}));
    add_model(models, "shoe", "Slipper",
              shoe({.ankle = 0.24,
                    .toe = 0.12,
                    .length = 0.95,
                    .sole = 0.05,
                    .upper = kPlum,
                    .rubber = kTan,
                    .laces = false}));
    add_model(models, "shoe", "Buckled shoe",
              shoe({.ankle = 0.36,
                    .toe = 0.1,
                    .length = 1.1,
                    .sole = 0.06,
                    .upper = kChestnut,
                    .rubber = kCocoa,
                    .laces = false,
                    .heel = 0.12}));
}

struct Hat {
    double brim = 0.55, crown = 0.34, top = 0.36, height = 0.62;
    double curl = 0.1;  ///< how far the brim rises at the sides
    Rgb felt = kInk, band = kWine;
};

TriangleMesh hat(const Hat& h) {
    TriangleMesh m = lathe({{0, 0.02},
                            {h.crown * 0.97, 0.02},
                            {h.brim, -0.0},
                            {h.brim, 0.035},
                            {h.crown * 1.02, 0.05},
                            {(h.crown + h.top) / 2 + 0.01, h.height * 0.6},
                            {h.top, h.height * 0.96},
                            {h.top * 0.92, h.height},
                            {0, h.height * 0.97}},
                           h.felt, 48);
    join(m,
         lathe({{0, 0.05}, {h.crown * 1.03, 0.05}, {h.crown * 1.01, 0.05 + h.height * 0.2}, {0, 0.05 + h.height * 0.2}},
               h.band, 48));
    m = bent(m, [&](Vec3 p) {
        const double r = std::max(0.0, std::hypot(p.x, p.z) - h.crown) / std::max(h.brim - h.crown, 1e-9);
        return Vec3{p.x, p.y + h.curl * r * r * (p.x * p.x - 0.3 * p.z * p.z) / (h.brim * h.brim), p.z};
    });
    return scaled(m, {1.0, 1.0, 0.6});
}

void add_hats(Models& models) {
    add_model(models, "hat", "Top hat", hat({}));
    add_model(models, "hat", "Straw hat",
              hat({.brim = 0.75, .top = 0.3, .height = 0.3, .curl = -0.05, .felt = kStraw, .band = kCoral}));
    add_model(
        models, "hat", "Cowboy hat",
        hat({.brim = 0.72, .crown = 0.32, .top = 0.24, .height = 0.4, .curl = 0.3, .felt = kTan, .band = kCocoa}));
    add_model(
        models, "hat", "Trilby",
        hat({.brim = 0.5, .crown = 0.36, .top = 0.2, .height = 0.42, .curl = 0.12, .felt = kSlate, .band = kInk}));
    Assembly bowler;
    bowler
        .add(lathe_smooth({{0, 0}, {0.5, -0.01}, {0.56, 0.03}, {0.4, 0.05}, {0.38, 0.2}, {0.28, 0.38}, {0, 0.46}},
                          kWalnut, 40))
        .add(lathe({{0, 0.06}, {0.405, 0.06}, {0.4, 0.14}, {0, 0.14}}, kCream, 40));
    add_model(models, "hat", "Bowler", scaled(bowler.mesh(), {1.0, 1.0, 0.75}));
    Assembly wizard;
    wizard.add(lathe({{0, 0}, {0.7, 0}, {0.7, 0.03}, {0.35, 0.06}, {0.04, 1.1}, {0, 1.12}}, kPlum, 40))
        .add(lathe({{0, 0.07}, {0.36, 0.07}, {0.33, 0.16}, {0, 0.16}}, kMustard, 40));
    add_model(models, "hat", "Wizard's hat", bent(scaled(wizard.mesh(), {1.0, 1.0, 0.75}), [](Vec3 p) {
                  return Vec3{p.x + 0.22 * std::pow(std::max(0.0, p.y - 0.35), 2.0), p.y, p.z};
              }));
}

struct Glasses {
    double rx = 0.26, ry = 0.26, gap = 0.09;
    bool square = false;
    double temple = 0.0;  ///< how far the temples spread beyond the rims; folded behind them when 0
    Rgb frame = kWalnut, lens = kGlass;
};

TriangleMesh glasses(const Glasses& g) {
    Assembly a;
    std::vector<Vec3> rim;
    for (int k = 0; k < 16; ++k) {
        const double turn = kTurn * k / 16, power = g.square ? 0.55 : 1.0, c = std::cos(turn), s = std::sin(turn);
        rim.push_back({(g.rx + g.gap) + g.rx * std::copysign(std::pow(std::abs(c), power), c),
                       g.ry * std::copysign(std::pow(std::abs(s), power), s), 0});
    }
    std::vector<Point> pane;
    pane.reserve(rim.size());
    for (const Vec3 p : rim) pane.push_back({p.x, p.y});
    a.pair_x(loop(rim, 0.035, g.frame, 4))
        .pair_x(slab(closed_spline(pane, 3), 0.02, 0.005, g.lens))
        .add(tube({{{-g.gap - 0.02, 0.02, 0}, 0.03}, {{0, 0.07, 0.02}, 0.03}, {{g.gap + 0.02, 0.02, 0}, 0.03}},
                  g.frame));
    const double edge = g.gap + 2 * g.rx, t = g.temple;
    if (t > 0)
        a.pair_x(tube({{{edge, 0.05, 0}, 0.03},
                       {{edge + t * 0.5, 0.12, -0.05}, 0.026},
                       {{edge + t, 0.1, -0.14}, 0.024},
                       {{edge + t * 1.15, -0.06, -0.18}, 0.026}},
                      g.frame));
    else  // one temple folded over the other
        a.add(rod({edge, 0.06, -0.05}, {-edge * 0.75, 0.04, -0.09}, 0.025, g.frame))
            .add(rod({-edge, 0.06, -0.1}, {edge * 0.75, 0.02, -0.13}, 0.025, g.frame));
    return a.mesh();
}

void add_glasses_to_wear(Models& models) {
    add_model(models, "eyeglasses", "Round glasses", glasses({}));
    add_model(models, "eyeglasses", "Square glasses",
              glasses({.rx = 0.3, .ry = 0.2, .gap = 0.1, .square = true, .temple = 0.2, .frame = kInk}));
    add_model(models, "eyeglasses", "Sunglasses",
              glasses({.rx = 0.32, .ry = 0.24, .gap = 0.08, .square = true, .frame = kRed, .lens = kSlate}));
    add_model(models, "eyeglasses", "Oval glasses",
              glasses({.rx = 0.27, .ry = 0.17, .gap = 0.14, .temple = 0.32, .frame = kBrass}));
    add_model(models, "eyeglasses", "Reading glasses",
              glasses({.rx = 0.2, .ry = 0.17, .gap = 0.16, .temple = 0.26, .frame = kTeal}));
    add_model(models, "eyeglasses", "Big round glasses",
              glasses({.rx = 0.34, .ry = 0.33, .gap = 0.12, .temple = 0.24, .frame = kPlum, .lens = kLilac}));
}

struct Crown {
    int tips = 6;  ///< even, so that those behind stand behind those before
    double r = 0.42, height = 0.5, low = 0.22, flare = 0.2, depth = 0.42, gem_r = 0.035;
    Rgb gem = kRed;
};

TriangleMesh crown(const Crown& c) {
    Assembly a;
    const auto wide = [&](double t) { return c.r * (1.0 + c.flare * t); };
    const TriangleMesh cup = lathe({{0, 0},
                                    {wide(0), 0},
                                    {wide(0.25), 0.25},
                                    {wide(0.5), 0.5},
                                    {wide(0.75), 0.75},
                                    {wide(1.0), 1.0},
                                    {wide(1.0) - 0.02, 1.0},
                                    {wide(0.5) - 0.03, 0.5},
                                    {c.r * 0.95, 0.05},
                                    {0, 0.05}},
                                   kMustard, 16 * c.tips);
    a.add(bent(cup, [&](Vec3 p) {  // the rim rises to a tip in the middle of every section
        const double wave = std::abs(std::fmod((std::atan2(p.x, p.z) / kTurn + 1.0) * c.tips, 1.0) - 0.5) * 2.0;
        return Vec3{p.x, p.y * (c.low + (c.height - c.low) * (1.0 - wave)), p.z};
    }));
    a.add(ring({0, 0.03, 0}, {0, 1, 0}, c.r + 0.01, 0.045, kBrass, 48));
    for (int k = 0; k < c.tips; ++k) {
        const double turn = kTurn * (k + 0.5) / c.tips;
        a.add(ball({wide(1.0) * std::sin(turn), c.height + 0.02, wide(1.0) * std::cos(turn)}, c.gem_r, c.gem, 8))
            .add(ball({wide(0.25) * std::sin(turn), c.low * 0.6, wide(0.25) * std::cos(turn)}, 0.04, c.gem, 8));
    }
    return scaled(a.mesh(), {1.0, 1.0, c.depth});
}

void add_crowns(Models& models) {
    add_model(models, "crown", "King's crown", crown({}));
    add_model(models, "crown", "Princess crown",
              crown({.tips = 8, .r = 0.4, .height = 0.4, .low = 0.14, .gem = kPink}));
    add_model(models, "crown", "Tall crown", crown({.r = 0.36, .height = 0.66, .low = 0.26, .gem = kTeal}));
    add_model(models, "crown", "Straight crown",
              crown({.tips = 8, .r = 0.46, .height = 0.42, .low = 0.2, .flare = 0.05, .gem_r = 0.028, .gem = kSky}));
    add_model(models, "crown", "Prince's crown",
              crown({.r = 0.4, .height = 0.56, .low = 0.2, .flare = 0.32, .gem_r = 0.06, .gem = kPlum}));
}

struct Handbag {
    double low = 0.5, high = 0.4, height = 0.5;  ///< half widths below and above
    double handle = 0.36, grip = 0.24;           ///< rise of the handle, half its width
    double round = 0.06;
    bool flap = true;
    Rgb leather = kChestnut, trim = kBrass;
};

TriangleMesh handbag(const Handbag& h) {
    Assembly a;
    std::vector<Point> side{{-h.low, 0}, {h.low, 0}, {h.high, h.height}, {-h.high, h.height}};
    if (h.round > 0.1)
        side = closed_spline({{-h.low * 0.7, 0},
                              {h.low * 0.7, 0},
                              {h.low, h.height * 0.4},
                              {h.high, h.height},
                              {0, h.height * 1.04},
                              {-h.high, h.height},
                              {-h.low, h.height * 0.4}},
                             5);
    a.add(slab(side, 0.24, 0.06, h.leather));
    const auto strap = [&](double z) {
        return tube({{{-h.grip, h.height - 0.05, z}, 0.03},
                     {{-h.grip * 0.95, h.height + h.handle * 0.6, z}, 0.03},
                     {{-h.grip * 0.45, h.height + h.handle, z}, 0.03},
                     {{h.grip * 0.45, h.height + h.handle, z}, 0.03},
                     {{h.grip * 0.95, h.height + h.handle * 0.6, z}, 0.03},
                     {{h.grip, h.height - 0.05, z}, 0.03}},
                    darker(h.leather), {.sides = 10});
    };
    a.add(strap(0.06)).add(strap(-0.06));
    if (h.flap)
        a.add(moved(slab({{-h.high * 0.96, h.height * 0.96},
                          {-h.high * 0.8, h.height * 0.52},
                          {h.high * 0.8, h.height * 0.52},
                          {h.high * 0.96, h.height * 0.96}},
                         0.04, 0.012, darker(h.leather, 0.15)),
                    {0, 0, 0.125}));
    else
        a.add(box({0, h.height * 0.93, 0.11}, {h.high * 1.9, 0.05, 0.05}, 0.02, h.trim));
    a.add(box({0, h.height * 0.54, 0.15}, {0.12, 0.09, 0.05}, 0.02, h.trim));
    return a.mesh();
}

void add_handbags(Models& models) {
    add_model(models, "purse", "Handbag", handbag({}));
    add_model(models, "purse", "Tote bag",
              handbag({.low = 0.42,
                       .high = 0.46,
                       .height = 0.66,
                       .handle = 0.44,
                       .flap = false,
                       .leather = kStraw,
                       .trim = kTeal}));
    add_model(models, "purse", "Evening bag",
              handbag({.low = 0.5, .high = 0.34, .height = 0.36, .handle = 0.22, .grip = 0.14, .leather = kWine}));
    add_model(models, "purse", "Round handbag",
              handbag({.low = 0.5,
                       .high = 0.3,
                       .height = 0.56,
                       .handle = 0.3,
                       .grip = 0.2,
                       .round = 0.2,
                       .flap = false,
                       .leather = kRose,
                       .trim = kBrass}));
    add_model(models, "purse", "Doctor's bag",
              handbag({.low = 0.55, .high = 0.48, .height = 0.46, .handle = 0.26, .grip = 0.18, .leather = kNavy}));
}

struct Headphones {
    double r = 0.46, rise = 0.6, band = 0.03, cup = 0.17, cup_high = 0.2, tilt = 0.0;
    Rgb shell = kSlate, pad = kInk, metal = kSteel;
};

TriangleMesh headphones(const Headphones& h) {
    Assembly a;
    std::vector<Station> arc;
    for (int k = 0; k <= 12; ++k) {
        const double angle = kTurn * 0.5 * k / 12;
        arc.push_back({{h.r * std::cos(angle), h.rise * std::sin(angle), 0}, h.band, h.band * 1.6});
    }
    a.add(tube(arc, h.metal, {.sides = 10, .steps = 3}));
    a.add(tube({{{-h.r * 0.6, h.rise * 0.82, 0}, h.band * 1.5, h.band * 2.2},
                {{0, h.rise * 1.01, 0}, h.band * 1.6, h.band * 2.4},
                {{h.r * 0.6, h.rise * 0.82, 0}, h.band * 1.5, h.band * 2.2}},
               h.shell));
    const auto cup = [&](double x, double wide, double tall, Rgb colour) {
        return moved(turned_z(ball({0, 0, 0}, {wide, tall, h.cup_high * 0.8}, colour, 14), h.tilt), {x, -0.08, 0});
    };
    a.pair_x(cup(h.r + 0.02, h.cup * 0.75, h.cup_high, h.shell))
        .pair_x(cup(h.r - h.cup * 0.55, h.cup * 0.45, h.cup_high * 0.95, h.pad));
    return a.mesh();
}

void add_headphones(Models& models) {
    add_model(models, "headphones", "Headphones", headphones({}));
    add_model(models, "headphones", "Big headphones",
              headphones({.r = 0.48, .rise = 0.56, .band = 0.04, .cup = 0.22, .cup_high = 0.26, .shell = kCoral}));
    add_model(
        models, "headphones", "Light headphones",
        headphones({.r = 0.5, .rise = 0.7, .band = 0.022, .cup = 0.13, .cup_high = 0.14, .shell = kSky, .pad = kNavy}));
    add_model(models, "headphones", "Wide headphones",
              headphones({.r = 0.58, .rise = 0.5, .cup = 0.18, .cup_high = 0.2, .tilt = -12, .shell = kMustard}));
    add_model(
        models, "headphones", "Studio headphones",
        headphones({.r = 0.42, .rise = 0.66, .band = 0.035, .cup = 0.18, .cup_high = 0.24, .tilt = 8, .shell = kLeaf}));
}

}  // namespace

void add_accessories(Models& models) {
    add_shoes(models);
    add_hats(models);
    add_glasses_to_wear(models);
    add_crowns(models);
    add_handbags(models);
    add_headphones(models);
}

}  // namespace core::starter
