// Houses and tents. They face +z and are not deep, so that one sees the front that people draw.

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
    double width = 1.2, depth = 0.9, wall = 0.7, roof = 0.5, eaves = 0.06;
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
    return scaled(a.mesh(), {1.0, 1.0, 0.45});
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
              house({.width = 1.45,
                     .wall = 0.68,
                     .roof = 0.62,
                     .eaves = 0.08,
                     .chimney = false,
                     .porch = true,
                     .walls = kWhite,
                     .tiles = kTeal,
                     .door_colour = kRed}));
    add_model(models, "house", "Little house",
              house({.width = 0.9,
                     .wall = 0.72,
                     .roof = 0.6,
                     .eaves = 0.02,
                     .chimney = false,
                     .walls = kStraw,
                     .tiles = kCoral,
                     .door_colour = kBlue}));
    add_model(models, "house", "Chalet",
              house({.width = 1.3,
                     .depth = 1.0,
                     .wall = 0.55,
                     .roof = 0.82,
                     .eaves = 0.2,
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
    add_model(models, "house", "Hut",
              house({.width = 0.86,
                     .wall = 0.78,
                     .roof = 0.42,
                     .eaves = 0.14,
                     .chimney = false,
                     .walls = kSand,
                     .tiles = kOlive,
                     .door_colour = kWalnut}));
    add_model(models, "house", "Log cabin",
              house({.width = 1.15,
                     .wall = 0.66,
                     .roof = 0.4,
                     .eaves = 0.1,
                     .walls = kWood,
                     .tiles = kForest,
                     .door_colour = kCream}));
}

void add_tents(Models& models) {
    const auto tent = [](double width, double height, double depth, Rgb cloth, Rgb flap) {
        Assembly a;
        a.add(slab({{-width / 2, 0}, {0, height}, {width / 2, 0}}, depth, 0.015, cloth))
            .add(moved(
                slab({{-width * 0.16, 0.0}, {0, height * 0.72}, {width * 0.16, 0.0}}, 0.03, 0.008, darker(cloth, 0.5)),
                {0, 0, depth / 2}))
            .add(moved(slab({{width * 0.14, 0.0}, {0.0, height * 0.72}, {width * 0.3, 0.12}}, 0.03, 0.008, flap),
                       {0, 0, depth / 2 + 0.025}));
        for (const double z : {depth / 2, -depth / 2})
            a.add(rod({0, height - 0.08, z}, {0, height + 0.05, z}, 0.02, kWalnut));
        return scaled(a.mesh(), {1.0, 1.0, 0.4});
    };
    add_model(models, "tent", "Ridge tent", tent(1.2, 0.8, 1.3, kOrange, kCream));
    add_model(models, "tent", "Low tent", tent(1.4, 0.62, 1.1, kLeaf, kMustard));
    add_model(models, "tent", "Tall tent", tent(1.05, 1.05, 1.0, kBlue, kSky));
    add_model(models, "tent", "Wide tent", tent(1.6, 0.95, 1.0, kTan, kCream));
    add_model(models, "tent", "Pointed tent", tent(0.85, 1.15, 0.9, kWine, kRose));
    Assembly tipi;
    tipi.add(painted(lathe({{0, 0}, {0.6, 0}, {0.47, 0.3}, {0.4, 0.46}, {0.06, 1.25}, {0, 1.25}}, kSand, 24),
                     [](Vec3 p, Rgb c) { return p.y > 0.29 && p.y < 0.47 ? kBrick : c; }))
        .add(moved(turned_x(slab({{-0.17, 0.0}, {0, 0.55}, {0.17, 0.0}}, 0.03, 0.008, kWalnut), -23), {0, 0, 0.6}));
    for (int k = 0; k < 5; ++k) tipi.add(turned_y(rod({-0.06, 1.15, 0}, {0.11, 1.5, 0}, 0.02, kWood), 72.0 * k));
    add_model(models, "tent", "Tipi", scaled(tipi.mesh(), {1.0, 1.0, 0.5}));
}

}  // namespace

void add_buildings(Models& models) {
    add_houses(models);
    add_tents(models);
}

}  // namespace core::starter
