// Houses, castles, lighthouses, windmills, churches and tents. They face +z.

#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

/// A gabled roof: its ridge runs along x, or along z when the gable faces the viewer.
TriangleMesh gable_roof(double width, double depth, double height, double y, Rgb tiles, bool gable_to_front) {
    const double half = (gable_to_front ? width : depth) / 2, run = gable_to_front ? depth : width;
    TriangleMesh roof = slab({{-half, 0}, {0, height}, {half, 0}}, run, 0.02, tiles);
    if (!gable_to_front) roof = turned_y(roof, 90);
    return moved(roof, {0, y, 0});
}

TriangleMesh window(Vec3 at, double width, double height) {
    Assembly a;
    a.add(box(at, {width, height, 0.04}, 0.012, kWhite))
        .add(box(at + Vec3{0, 0, 0.012}, {width * 0.82, height * 0.84, 0.04}, 0.01, kGlass))
        .add(box(at + Vec3{0, 0, 0.02}, {0.018, height * 0.9, 0.04}, 0.006, kWhite))
        .add(box(at + Vec3{0, 0, 0.02}, {width * 0.9, 0.018, 0.04}, 0.006, kWhite));
    return a.mesh();
}

TriangleMesh door(Vec3 foot, double width, double height, Rgb colour) {
    Assembly a;
    a.add(box(foot + Vec3{0, height / 2, 0}, {width, height, 0.05}, 0.015, colour))
        .add(ball(foot + Vec3{width * 0.32, height * 0.48, 0.03}, 0.025, kBrass, 8));
    return a.mesh();
}

struct House {
    double width = 1.2, depth = 0.9, wall = 0.7, roof = 0.5, eaves = 0.12;
    int floors = 1;
    bool gable_to_front = true, chimney = true, porch = false;
    Rgb walls = kCream, tiles = kBrick, door_colour = kTeal;
};

TriangleMesh house(const House& h) {
    Assembly a;
    const double front = h.depth / 2, top = h.wall * h.floors;
    a.add(box_between({-h.width / 2, 0, -front}, {h.width / 2, top, front}, 0.015, h.walls));
    if (h.gable_to_front)
        a.add(moved(slab({{-h.width / 2, -0.01}, {0, h.roof * 0.86}, {h.width / 2, -0.01}}, h.depth, 0.01, h.walls),
                    {0, top, 0}));
    a.add(gable_roof(h.width + 2 * h.eaves, h.depth + (h.gable_to_front ? -0.02 : 2 * h.eaves), h.roof, top, h.tiles,
                     h.gable_to_front));
    if (h.gable_to_front) {  // the roof's face shows the wall inside a frame of tiles
        const double w = h.width / 2 + h.eaves;
        a.add(moved(slab({{-w * 0.78, 0.03}, {0, h.roof * 0.8}, {w * 0.78, 0.03}}, 0.04, 0.01, h.walls),
                    {0, top, front}));
        a.add(moved(turned_z(ring({0, 0, 0}, {0, 0, 1}, 0.085, 0.018, kWhite, 24), 0),
                    {0, top + h.roof * 0.34, front + 0.03}))
            .add(rod({0, top + h.roof * 0.34, front}, {0, top + h.roof * 0.34, front + 0.03}, 0.08, kGlass, Cap::Flat));
    }
    if (h.chimney)
        a.add(box_between({h.width * 0.22, top + h.roof * 0.25, -0.09},
                          {h.width * 0.22 + 0.16, top + h.roof * 1.15, 0.07}, 0.012, darker(h.tiles)))
            .add(box_between({h.width * 0.22 - 0.02, top + h.roof * 1.12, -0.11},
                             {h.width * 0.22 + 0.18, top + h.roof * 1.2, 0.09}, 0.012, h.tiles));
    a.add(door({0, 0, front + 0.01}, 0.24, h.wall * 0.68, h.door_colour));
    for (int f = 0; f < h.floors; ++f) {
        a.pair_x(window({h.width * 0.32, h.wall * (f + 0.56), front}, 0.24, 0.26));
        if (f > 0) a.add(window({0, h.wall * (f + 0.56), front}, 0.24, 0.26));
        a.pair_x(turned_y(window({0, h.wall * (f + 0.56), h.width / 2}, 0.24, 0.26), 90));
    }
    if (h.porch) {
        a.add(box_between({-0.34, h.wall * 0.78, front}, {0.34, h.wall * 0.86, front + 0.32}, 0.015, h.tiles))
            .add(box_between({-0.34, 0, front}, {0.34, 0.06, front + 0.32}, 0.015, kStone));
        a.pair_x(rod({0.29, 0.03, front + 0.27}, {0.29, h.wall * 0.8, front + 0.27}, 0.028, kWhite, Cap::Flat));
    }
    return a.mesh();
}

void add_houses(Models& models) {
    add_model(models, "house", "Cottage", house({}));
    add_model(models, "house", "Town house",
              house({.width = 0.95,
                     .depth = 0.9,
                     .wall = 0.56,
                     .roof = 0.55,
                     .floors = 2,
                     .walls = kCoral,
                     .tiles = kSlate,
                     .door_colour = kNavy}));
    add_model(models, "house", "Farmhouse",
              house({.width = 1.7,
                     .depth = 0.85,
                     .wall = 0.68,
                     .roof = 0.46,
                     .gable_to_front = false,
                     .porch = true,
                     .walls = kWhite,
                     .tiles = kTeal,
                     .door_colour = kRed}));
    add_model(models, "house", "Chalet",
              house({.width = 1.3,
                     .depth = 1.0,
                     .wall = 0.55,
                     .roof = 0.82,
                     .eaves = 0.28,
                     .walls = kHoney,
                     .tiles = kWalnut,
                     .door_colour = kForest}));
    add_model(models, "house", "Tower house",
              house({.width = 0.72,
                     .depth = 0.72,
                     .wall = 0.5,
                     .roof = 0.62,
                     .floors = 3,
                     .chimney = false,
                     .walls = kSky,
                     .tiles = kNavy,
                     .door_colour = kMustard}));
}

TriangleMesh battlements(double r, double y, int count, Rgb stone, double height) {
    Assembly a;
    for (int k = 0; k < count; ++k)
        a.add(
            moved(turned_y(box({r * 0.92, 0, 0}, {r * 0.18, height, r * 3.2 / count}, 0.012, stone), 360.0 * k / count),
                  {0, y, 0}));
    return a.mesh();
}

TriangleMesh castle_tower(double r, double height, Rgb stone, Rgb roof, bool pointed) {
    Assembly a;
    a.add(lathe({{0, 0},
                 {r * 1.06, 0},
                 {r, 0.1},
                 {r, height * 0.88},
                 {r * 1.18, height * 0.92},
                 {r * 1.18, height},
                 {0, height}},
                stone, 28));
    if (pointed)
        a.add(moved(lathe({{0, 0}, {r * 1.35, 0}, {r * 0.6, r * 1.5}, {0, r * 3.2}}, roof, 28), {0, height, 0}));
    else
        a.add(battlements(r * 1.16, height + 0.05, 8, stone, 0.14));
    a.add(box({0, height * 0.66, r * 0.96}, {r * 0.34, 0.2, 0.08}, 0.02, kSlate));
    return a.mesh();
}

TriangleMesh castle(double width, double wall, double tower, double keep, Rgb stone, Rgb roof, bool pointed) {
    Assembly a;
    const double h = width / 2;
    a.add(box_between({-h, 0, -0.12}, {h, wall, 0.12}, 0.015, stone));
    const int teeth = static_cast<int>(width / 0.2);
    for (int k = 0; k < teeth; ++k)
        a.add(box({-h + (k + 0.5) * width / teeth, wall + 0.05, 0}, {width / teeth * 0.55, 0.12, 0.2}, 0.012, stone));
    a.pair_x(moved(castle_tower(0.22, tower, stone, roof, pointed), {h, 0, 0}));
    if (keep > 0) a.add(moved(castle_tower(0.3, keep, lighter(stone, 0.15), roof, pointed), {0, 0, -0.38}));
    std::vector<Point> arch{{-0.17, 0.0}, {-0.17, 0.26}};
    for (int k = 1; k < 8; ++k)
        arch.push_back({-0.17 * std::cos(3.14159265 * k / 8), 0.26 + 0.17 * std::sin(3.14159265 * k / 8)});
    arch.push_back({0.17, 0.26});
    arch.push_back({0.17, 0.0});
    a.add(moved(slab(arch, 0.06, 0.012, kWalnut), {0, 0.0, 0.12}));
    const double top = keep > 0 ? keep + (pointed ? 0.94 : 0.1) : 0.0;
    if (keep > 0)
        a.add(rod({0, top - 0.1, -0.38}, {0, top + 0.3, -0.38}, 0.014, kCocoa))
            .add(moved(slab({{0, 0}, {0, 0.16}, {0.26, 0.08}}, 0.03, 0.008, kCoral), {0, top + 0.13, -0.38}));
    return a.mesh();
}

void add_other_buildings(Models& models) {
    add_model(models, "castle", "Castle", castle(1.5, 0.6, 0.95, 1.2, kStone, kNavy, true));
    add_model(models, "castle", "Fortress", castle(1.7, 0.7, 0.9, 1.05, kSand, kBrick, false));
    add_model(models, "castle", "Fairy-tale castle", castle(1.1, 0.5, 1.05, 1.6, kPink, kPlum, true));
    const auto lighthouse = [](double height, double low, double high, int bands, Rgb colour, Rgb rock) {
        Assembly a;
        a.add(lathe({{0, -0.12}, {low * 1.7, -0.12}, {low * 1.5, 0.0}, {low * 1.15, 0.06}, {0, 0.06}}, rock, 24));
        std::vector<Point> side{{0, 0}};
        for (int k = 0; k <= 30; ++k) side.push_back({low + (high - low) * std::sqrt(k / 30.0), height * k / 30.0});
        a.add(painted(lathe(side, kWhite, 32), [&](Vec3 p, Rgb c) {
            return static_cast<int>(std::floor(p.y / height * bands * 2 - 1e-6)) % 2 == 0 ? colour : c;
        }));
        a.add(moved(lathe({{0, 0}, {high * 1.5, 0}, {high * 1.5, 0.06}, {0, 0.06}}, kSlate, 28), {0, height, 0}))
            .add(ring({0, height + 0.15, 0}, {0, 1, 0}, high * 1.42, 0.014, kSlate, 32));
        for (int k = 0; k < 10; ++k)
            a.add(moved(turned_y(rod({high * 1.42, 0.03, 0}, {high * 1.42, 0.15, 0}, 0.01, kSlate), 36.0 * k),
                        {0, height, 0}));
        a.add(moved(lathe({{0, 0}, {high * 0.85, 0}, {high * 0.85, 0.28}, {0, 0.28}}, kStraw, 24),
                    {0, height + 0.05, 0}))
            .add(moved(lathe_smooth({{high * 1.1, 0}, {high * 0.85, 0.12}, {0.03, 0.24}, {0.02, 0.36}}, colour, 24),
                       {0, height + 0.32, 0}));
        a.add(door({0, 0.05, low * 0.98}, 0.16, 0.3, kWalnut));
        return a.mesh();
    };
    add_model(models, "lighthouse", "Striped lighthouse", lighthouse(1.3, 0.3, 0.18, 3, kRed, kSlate));
    add_model(models, "lighthouse", "Blue lighthouse", lighthouse(1.0, 0.34, 0.22, 2, kBlue, kStone));
    add_model(models, "lighthouse", "Tall lighthouse", lighthouse(1.7, 0.27, 0.15, 4, kTeal, kWalnut));
    const auto windmill = [](double height, double low, double high, double sail, double turn, Rgb wall, Rgb cap) {
        Assembly a;
        a.add(lathe({{0, 0}, {low, 0}, {high, height}, {0, height}}, wall, 24))
            .add(moved(lathe_smooth({{high * 1.15, 0}, {high * 0.95, 0.14}, {high * 0.5, 0.26}, {0, 0.3}}, cap, 24),
                       {0, height - 0.01, 0}));
        const Vec3 hub{0, height + 0.06, high + 0.16};
        a.add(rod({0, height + 0.06, 0}, hub, 0.045, kCocoa));
        for (int k = 0; k < 4; ++k) {
            Assembly s;
            s.add(rod({0, 0, 0}, {0, sail, 0}, 0.022, kCocoa))
                .add(box({0.1, sail * 0.58, 0}, {0.17, sail * 0.74, 0.02}, 0.008, kCream));
            for (int j = 0; j < 5; ++j)
                s.add(box({0.1, sail * (0.24 + 0.17 * j), 0.012}, {0.19, 0.014, 0.02}, 0.005, kWood));
            a.add(moved(turned_z(s.mesh(), 90.0 * k + turn), hub));
        }
        a.add(door({0, 0.0, low * 0.97}, 0.22, 0.36, kTeal))
            .add(window({0, height * 0.6, low + (high - low) * 0.6 + 0.0}, 0.16, 0.18));
        return a.mesh();
    };
    add_model(models, "windmill", "Dutch windmill", windmill(1.0, 0.4, 0.26, 0.8, 20, kBrick, kSlate));
    add_model(models, "windmill", "White windmill", windmill(0.75, 0.38, 0.34, 0.7, 45, kWhite, kBlue));
    add_model(models, "windmill", "Tall windmill", windmill(1.4, 0.36, 0.2, 0.9, 0, kHoney, kCocoa));
    const auto church = [](double nave, double tower, double spire, Rgb wall, Rgb tiles) {
        Assembly a;
        a.add(box_between({-0.15, 0, -0.3}, {nave, 0.5, 0.3}, 0.015, wall))
            .add(moved(gable_roof(nave + 0.22, 0.76, 0.42, 0.5, tiles, false), {nave / 2 - 0.06, 0, 0}));
        a.add(box_between({-0.5, 0, -0.2}, {-0.1, tower, 0.2}, 0.015, wall));
        TriangleMesh point = lathe({{0, 0}, {0.34, 0}, {0, spire}}, tiles, 4);
        a.add(moved(turned_y(point, 45), {-0.3, tower, 0}));
        const double top = tower + spire;
        a.add(box({-0.3, top + 0.1, 0}, {0.03, 0.26, 0.03}, 0.01, kBrass))
            .add(box({-0.3, top + 0.14, 0}, {0.14, 0.03, 0.03}, 0.01, kBrass));
        a.add(door({-0.3, 0, 0.2}, 0.18, 0.34, kWalnut))
            .add(rod({-0.3, tower * 0.75, 0.19}, {-0.3, tower * 0.75, 0.215}, 0.09, kCream, Cap::Flat));
        for (int k = 0; k < 3; ++k) a.add(window({0.12 + k * (nave - 0.2) / 2.4, 0.28, 0.3}, 0.13, 0.26));
        return a.mesh();
    };
    add_model(models, "church", "Village church", church(0.95, 0.9, 0.6, kCream, kBrick));
    add_model(models, "church", "Chapel", church(0.6, 0.65, 0.35, kWhite, kNavy));
    add_model(models, "church", "Tall-spired church", church(1.1, 1.0, 1.0, kStone, kTeal));
    const auto tent = [](double width, double height, double depth, Rgb cloth, Rgb flap) {
        Assembly a;
        a.add(slab({{-width / 2, 0}, {0, height}, {width / 2, 0}}, depth, 0.015, cloth))
            .add(moved(
                slab({{-width * 0.16, 0.0}, {0, height * 0.72}, {width * 0.16, 0.0}}, 0.03, 0.008, darker(cloth, 0.5)),
                {0, 0, depth / 2}))
            .add(moved(slab({{width * 0.14, 0.0}, {0.0, height * 0.72}, {width * 0.3, 0.12}}, 0.03, 0.008, flap),
                       {0, 0, depth / 2 + 0.025}));
        for (const double z : {depth / 2, -depth / 2})
            a.add(rod({0, height - 0.05, z}, {0, height + 0.12, z}, 0.02, kWalnut))
                .pair_x(rod({width / 2 - 0.02, 0.03, z}, {width / 2 + 0.12, 0.0, z}, 0.014, kWalnut));
        return a.mesh();
    };
    add_model(models, "tent", "Ridge tent", tent(1.2, 0.8, 1.3, kOrange, kCream));
    add_model(models, "tent", "Low tent", tent(1.4, 0.62, 1.1, kLeaf, kMustard));
    Assembly tipi;
    tipi.add(painted(lathe({{0, 0}, {0.6, 0}, {0.47, 0.3}, {0.4, 0.46}, {0.06, 1.25}, {0, 1.25}}, kSand, 24),
                     [](Vec3 p, Rgb c) { return p.y > 0.29 && p.y < 0.47 ? kBrick : c; }))
        .add(moved(turned_x(slab({{-0.17, 0.0}, {0, 0.55}, {0.17, 0.0}}, 0.03, 0.008, kWalnut), -23), {0, 0, 0.6}));
    for (int k = 0; k < 5; ++k) tipi.add(turned_y(rod({-0.06, 1.15, 0}, {0.11, 1.5, 0}, 0.02, kWood), 72.0 * k));
    add_model(models, "tent", "Tipi", tipi.mesh());
}

}  // namespace

void add_buildings(Models& models) {
    add_houses(models);
    add_other_buildings(models);
}

}  // namespace core::starter
