// Tools and small things of the house: hammers, keys, scissors, umbrellas, pencils and the like. They face +z.

#include <array>
#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

constexpr double kTurn = 6.283185307179586;

TriangleMesh grip(double from, double to, double r, Rgb colour, double waist = 0.8) {
    const double l = to - from;
    return tube({{{0, from, 0}, r * 0.9},
                 {{0, from + l * 0.12, 0}, r},
                 {{0, from + l * 0.45, 0}, r * waist},
                 {{0, to, 0}, r * 0.75}},
                colour, {.sides = 16});
}

void add_hammers(Models& models) {
    const auto claw = [](double length, double head, Rgb handle, Rgb steel, bool mallet) {
        Assembly a;
        a.add(grip(0, length, 0.06, handle));
        const double y = length;
        if (mallet) {
            a.add(tube({{{-head, y, 0}, 0.15}, {{head, y, 0}, 0.15}}, steel, {.sides = 24, .cap = Cap::Flat}))
                .pair_x(rod({head - 0.06, y, 0}, {head - 0.02, y, 0}, 0.16, kBrass, Cap::Flat));
            return a.mesh();
        }
        a.add(tube({{{0.1, y, 0}, 0.085},
                    {{0.1 + head * 0.5, y, 0}, 0.07},
                    {{0.1 + head * 0.6, y, 0}, 0.11},
                    {{0.1 + head, y, 0}, 0.115}},
                   steel, {.sides = 18, .cap = Cap::Flat}))
            .add(box({0.03, y, 0}, {0.22, 0.2, 0.17}, 0.04, steel));
        for (const double z : {0.05, -0.05})
            a.add(tube({{{-0.02, y + 0.02, z}, 0.075, 0.045},
                        {{-0.25, y + 0.02, z}, 0.055, 0.04},
                        {{-0.45, y - 0.1, z * 1.3}, 0.022, 0.03},
                        {{-0.52, y - 0.2, z * 1.4}, 0.01}},
                       steel));
        return a.mesh();
    };
    add_model(models, "hammer", "Claw hammer", claw(1.1, 0.3, kHoney, kSteel, false));
    add_model(models, "hammer", "Mallet", claw(0.95, 0.3, kWood, kSand, true));
    add_model(models, "hammer", "Carpenter's hammer", claw(1.35, 0.42, kBlue, kSlate, false));
    add_model(models, "hammer", "Croquet mallet", claw(1.5, 0.26, kCream, kRed, true));
    add_model(models, "hammer", "Small hammer", claw(0.85, 0.24, kCoral, kSteel, false));
}

void add_keys(Models& models) {
    const auto key = [](int bow, double length, int teeth, double size, Rgb metal) {
        Assembly a;
        const double r = 0.045;
        if (bow == 0) {
            a.add(ring({-size, 0, 0}, {0, 0, 1}, size, 0.065, metal));
        } else if (bow == 1) {
            for (int k = 0; k < 3; ++k) {
                const double turn = kTurn * k / 3 + kTurn / 2;
                a.add(ring({-size * 1.05 + size * 0.62 * std::cos(turn), size * 0.62 * std::sin(turn), 0}, {0, 0, 1},
                           size * 0.48, 0.055, metal));
            }
        } else {
            a.add(loop({{0, 0, 0},
                        {-size * 0.5, size * 0.9, 0},
                        {-size * 1.5, size * 0.9, 0},
                        {-size * 2.0, 0, 0},
                        {-size * 1.5, -size * 0.9, 0},
                        {-size * 0.5, -size * 0.9, 0}},
                       0.06, metal));
        }
        a.add(rod({-0.02, 0, 0}, {length, 0, 0}, r, metal))
            .add(rod({0.06, 0, 0}, {0.1, 0, 0}, r * 1.6, metal))
            .add(rod({0.15, 0, 0}, {0.18, 0, 0}, r * 1.4, metal));
        for (int k = 0; k < teeth; ++k) {
            const double depth = 0.24 - 0.05 * ((k * 2) % 3);
            a.add(box_between({length - 0.12 - 0.15 * k, -depth, -0.03}, {length - 0.02 - 0.15 * k, 0.01, 0.03}, 0.015,
                              metal));
        }
        return a.mesh();
    };
    add_model(models, "key", "Old key", key(0, 0.9, 2, 0.24, kBrass));
    add_model(models, "key", "Trefoil key", key(1, 1.0, 3, 0.3, kSteel));
    add_model(models, "key", "Castle key", key(2, 1.15, 3, 0.22, kSlate));
    add_model(models, "key", "Short key", key(0, 0.62, 3, 0.27, kMustard));
    add_model(models, "key", "Long key", key(1, 1.3, 2, 0.24, kHoney));
}

void add_scissors(Models& models) {
    const auto scissors = [](double open, double blade, double bow, double stretch, Rgb handle) {
        Assembly half;
        half.add(slab({{-0.05, -0.16},
                       {0.06, -0.1},
                       {0.075, 0.1},
                       {0.035, blade * 0.7},
                       {-0.02, blade},
                       {-0.035, blade},
                       {-0.05, 0.1}},
                      0.04, 0.012, kSteel));
        half.add(
            tube({{{0.0, -0.1, 0}, 0.045, 0.03}, {{-0.04, -0.3, 0}, 0.042, 0.034}, {{-0.08, -0.42, 0}, 0.045, 0.04}},
                 handle));
        half.add(moved(scaled(ring({0, 0, 0}, {0, 0, 1}, bow, 0.048, handle), {1.0, stretch, 1.0}),
                       {-0.08 - bow * 0.35, -0.42 - bow * stretch * 0.9, 0}));
        Assembly a;
        a.add(moved(turned_z(half.mesh(), -open), {0, 0, 0.022}))
            .add(moved(mirrored_x(turned_z(half.mesh(), -open)), {0, 0, -0.022}));
        a.add(rod({0, 0, -0.06}, {0, 0, 0.06}, 0.035, kBrass, Cap::Flat));
        return a.mesh();
    };
    add_model(models, "scissors", "Scissors", scissors(22, 0.85, 0.16, 1.2, kCoral));
    add_model(models, "scissors", "Nail scissors", scissors(16, 0.45, 0.17, 1.0, kSteel));
    add_model(models, "scissors", "Kitchen scissors", scissors(30, 0.75, 0.2, 1.35, kTeal));
    add_model(models, "scissors", "Tailor's shears", scissors(12, 1.15, 0.19, 1.6, kInk));
    add_model(models, "scissors", "Children's scissors", scissors(36, 0.55, 0.18, 1.05, kMustard));
}

void add_umbrellas(Models& models) {
    const auto umbrella = [](double radius, double height, double shaft, bool hook, Rgb one, Rgb two, double point) {
        Assembly a;
        constexpr int kRibs = 8;
        const auto profile = [&](double t) {
            return Point{radius * std::sin(t * 1.45) / std::sin(1.45), height * std::cos(t * 1.57)};
        };
        std::vector<Point> line;
        for (int k = 10; k >= 0; --k) line.push_back(profile(k / 10.0) + Point{0.0, -0.025});
        line.front().x -= 0.01;
        line.back().x = 0.0;
        std::vector<Point> closed(line.rbegin(), line.rend());  // the inside from the axis out, then the outside back
        for (int k = 10; k >= 0; --k) closed.push_back(k == 0 ? Point{0.0, height} : profile(k / 10.0));
        TriangleMesh cloth = bent(lathe(closed, one, 64), [&](Vec3 p) {
            const double r = std::hypot(p.x, p.z) / radius, turn = std::atan2(p.z, p.x);
            return Vec3{p.x, p.y + 0.085 * r * r * (std::abs(std::sin(turn * kRibs / 2)) - 0.2), p.z};
        });
        a.add(painted(cloth, [&](Vec3 p, Rgb) {
            const int panel = static_cast<int>(std::floor((std::atan2(p.z, p.x) / kTurn + 1.0 + 1e-6) * kRibs));
            return panel % 2 == 0 ? one : two;
        }));
        a.add(rod({0, -shaft, 0}, {0, height, 0}, 0.022, kWalnut))
            .add(cone({0, height - 0.01, 0}, {0, height + point, 0}, 0.03, 0.012, kWalnut, Cap::Round));
        if (hook)
            a.add(tube({{{0, -shaft + 0.04, 0}, 0.034},
                        {{0.01, -shaft - 0.1, 0}, 0.036},
                        {{0.1, -shaft - 0.19, 0}, 0.036},
                        {{0.2, -shaft - 0.1, 0}, 0.036},
                        {{0.21, -shaft, 0}, 0.034}},
                       kHoney));
        else
            a.add(tube({{{0, -shaft + 0.14, 0}, 0.03}, {{0, -shaft - 0.06, 0}, 0.045}}, kHoney))
                .add(ball({0, -shaft - 0.08, 0}, 0.06, kHoney));
        return a.mesh();
    };
    add_model(models, "umbrella", "Red umbrella", umbrella(0.7, 0.52, 0.75, true, kRed, kCoral, 0.1));
    add_model(models, "umbrella", "Parasol", umbrella(0.85, 0.3, 0.9, false, kCream, kRose, 0.06));
    add_model(models, "umbrella", "Beach umbrella", umbrella(0.95, 0.4, 1.2, false, kSky, kWhite, 0.12));
    add_model(models, "umbrella", "Bell umbrella", umbrella(0.58, 0.6, 0.62, true, kTeal, kMint, 0.14));
    add_model(models, "umbrella", "Golf umbrella", umbrella(0.85, 0.5, 0.8, true, kNavy, kMustard, 0.16));
}

void add_axes_and_swords(Models& models) {
    const auto axe = [](double length, double blade, bool two, Rgb handle, Rgb steel) {
        Assembly a;
        a.add(tube({{{0.04, 0, 0}, 0.055, 0.04},
                    {{0.0, length * 0.15, 0}, 0.045, 0.035},
                    {{-0.02, length * 0.6, 0}, 0.042, 0.034},
                    {{0.0, length, 0}, 0.05, 0.036}},
                   handle));
        const auto head = slab(closed_spline({{-0.06, length - 0.16},
                                              {0.06, length - 0.2},
                                              {blade * 0.75, length - 0.1 - blade * 0.5},
                                              {blade, length - 0.1 - blade * 0.42},
                                              {blade * 1.1, length - 0.1},
                                              {blade, length - 0.1 + blade * 0.42},
                                              {blade * 0.75, length - 0.1 + blade * 0.45},
                                              {0.06, length},
                                              {-0.06, length - 0.03}},
                                             5),
                               0.09, 0.03, steel);
        a.add(head);
        if (two) a.add(mirrored_x(head));
        return a.mesh();
    };
    add_model(models, "axe", "Axe", axe(1.2, 0.36, false, kHoney, kSteel));
    add_model(models, "axe", "Double axe", axe(1.3, 0.4, true, kWalnut, kSlate));
    add_model(models, "axe", "Hatchet", axe(0.75, 0.32, false, kBrick, kSteel));
    add_model(models, "axe", "Felling axe", axe(1.05, 0.46, false, kTan, kSlate));
    add_model(models, "axe", "Fire axe", axe(1.4, 0.42, false, kMustard, kRed));
    const auto sword = [](double blade, double width, double guard, double droop, Rgb steel, Rgb hilt) {
        Assembly a;
        a.add(slab({{-width, 0}, {-width * 0.85, blade * 0.85}, {0, blade}, {width * 0.85, blade * 0.85}, {width, 0}},
                   0.05, 0.02, steel))
            .add(box_between({-0.012, 0.02, -0.032}, {0.012, blade * 0.7, 0.032}, 0.01, darker(steel)));
        a.add(tube({{{-guard, droop, 0}, 0.04}, {{0, 0, 0}, 0.05}, {{guard, droop, 0}, 0.04}}, kBrass))
            .add(tube({{{0, 0, 0}, 0.045}, {{0, -0.16, 0}, 0.05}, {{0, -0.3, 0}, 0.042}}, hilt))
            .add(ball({0, -0.36, 0}, 0.075, kBrass));
        return a.mesh();
    };
    add_model(models, "sword", "Knight's sword", sword(1.2, 0.08, 0.28, 0.0, kSteel, kWalnut));
    add_model(models, "sword", "Broadsword", sword(1.05, 0.13, 0.34, 0.08, kStone, kNavy));
    add_model(models, "sword", "Short sword", sword(0.75, 0.1, 0.2, -0.05, kSteel, kWine));
    add_model(models, "sword", "Long sword", sword(1.5, 0.07, 0.24, 0.04, kSteel, kCocoa));
    add_model(models, "sword", "Toy sword", sword(0.85, 0.11, 0.3, 0.0, kHoney, kBlue));
}

void add_workshop(Models& models) {
    const auto shovel = [](double shaft, double width, double blade, bool pointed, Rgb steel, bool grip = true) {
        Assembly a;
        a.add(rod({0, 0, 0}, {0, shaft, 0}, 0.035, kHoney));
        if (grip)
            a.add(loop({{-0.03, shaft, 0},
                        {-0.13, shaft + 0.12, 0},
                        {-0.1, shaft + 0.22, 0},
                        {0.1, shaft + 0.22, 0},
                        {0.13, shaft + 0.12, 0},
                        {0.03, shaft, 0}},
                       0.03, kWalnut));
        const std::vector<Point> spade =
            pointed ? std::vector<Point>{{-width * 0.9, 0.02},          {-width, -blade * 0.5},
                                         {-width * 0.6, -blade * 0.85}, {0, -blade * 1.08},
                                         {width * 0.6, -blade * 0.85},  {width, -blade * 0.5},
                                         {width * 0.9, 0.02},           {0, 0.08}}
                    : std::vector<Point>{
                          {-width, 0.02},         {-width, -blade * 0.5}, {-width * 0.98, -blade}, {0, -blade * 1.02},
                          {width * 0.98, -blade}, {width, -blade * 0.5},  {width, 0.02},           {0, 0.06}};
        a.add(bent(slab(closed_spline(spade, 4), 0.04, 0.012, steel), [&](Vec3 p) {
             return Vec3{p.x, p.y, p.z + 0.5 * p.x * p.x};
         })).add(cone({0, -blade * 0.35, 0.02}, {0, 0.2, 0.01}, 0.02, 0.05, steel, Cap::Round));
        return a.mesh();
    };
    add_model(models, "shovel", "Garden shovel", shovel(0.95, 0.2, 0.42, true, kSlate));
    add_model(models, "shovel", "Spade", shovel(0.8, 0.17, 0.42, false, kSteel));
    add_model(models, "shovel", "Snow shovel", shovel(1.1, 0.34, 0.4, false, kBlue));
    add_model(models, "shovel", "Sand shovel", shovel(0.5, 0.2, 0.38, true, kCoral));
    add_model(models, "shovel", "Long shovel", shovel(1.3, 0.22, 0.36, true, kOlive));
    add_model(models, "shovel", "Plain shovel", shovel(0.9, 0.19, 0.36, true, kSteel, false));
    add_model(models, "shovel", "Coal shovel", shovel(1.0, 0.24, 0.34, false, kInk, false));
    const auto ladder = [](double height, double low, double high, int rungs, bool steps, Rgb colour) {
        Assembly side;
        side.pair_x(rod({low, 0, 0}, {high, height, 0}, 0.03, colour));
        for (int k = 0; k < rungs; ++k) {
            const double t = (k + 0.6) / rungs, x = low + (high - low) * t;
            side.add(steps ? box({0, height * t, 0}, {2 * x, 0.035, 0.12}, 0.012, lighter(colour))
                           : rod({-x, height * t, 0}, {x, height * t, 0}, 0.024, lighter(colour)));
        }
        if (!steps) return side.mesh();
        Assembly a;
        a.add(moved(turned_x(side.mesh(), -14), {0, 0, 0.02}));
        Assembly back;
        back.pair_x(rod({low, 0, 0}, {high, height, 0}, 0.022, kSlate))
            .add(rod({-low, height * 0.25, 0}, {low, height * 0.25, 0}, 0.018, kSlate));
        const double tilt = 14 * kTurn / 360.0;
        a.add(moved(turned_x(back.mesh(), 14), {0, 0, 0.02 - 2 * std::sin(tilt) * height}));
        a.add(
            box({0, height * std::cos(tilt), 0.02 - std::sin(tilt) * height}, {high * 2.4, 0.05, 0.24}, 0.02, kCoral));
        return facing_front(a.mesh());
    };
    add_model(models, "ladder", "Ladder", ladder(1.6, 0.25, 0.2, 7, false, kHoney));
    add_model(models, "ladder", "Stepladder", ladder(1.1, 0.3, 0.2, 4, true, kMustard));
    add_model(models, "ladder", "Orchard ladder", ladder(1.8, 0.34, 0.07, 8, false, kTan));
    add_model(models, "ladder", "Short ladder", ladder(1.0, 0.3, 0.27, 4, false, kCoral));
    add_model(models, "ladder", "Wide ladder", ladder(1.3, 0.4, 0.38, 5, false, kSlate));
    const auto pencil = [](double length, double r, Rgb colour, Rgb lead, bool rubber) {
        Assembly a;
        a.add(tube({{{0, 0, 0}, r}, {{0, length, 0}, r}}, colour, {.sides = 6, .cap = Cap::Flat}))
            .add(cone({0, length, 0}, {0, length + r * 2.4, 0}, r * 0.98, r * 0.33, kSand))
            .add(cone({0, length + r * 2.4, 0}, {0, length + r * 3.4, 0}, r * 0.34, r * 0.05, lead, Cap::Round));
        if (rubber)
            a.add(rod({0, -0.14, 0}, {0, 0.005, 0}, r * 1.02, kSteel, Cap::Flat))
                .add(tube({{{0, -0.2, 0}, r * 0.9}, {{0, -0.13, 0}, r * 0.95}}, kPink));
        return turned_z(a.mesh(), -35);
    };
    add_model(models, "pencil", "Yellow pencil", pencil(1.2, 0.075, kMustard, kInk, true));
    add_model(models, "pencil", "Red crayon pencil", pencil(0.85, 0.1, kRed, kRed, false));
    add_model(models, "pencil", "Blue pencil", pencil(1.45, 0.065, kBlue, kNavy, true));
    add_model(models, "pencil", "Carpenter's pencil", pencil(0.7, 0.13, kLeaf, kInk, false));
    add_model(models, "pencil", "Short pencil", pencil(0.55, 0.085, kCoral, kInk, true));
}

}  // namespace

void add_tools(Models& models) {
    add_hammers(models);
    add_keys(models);
    add_scissors(models);
    add_umbrellas(models);
    add_axes_and_swords(models);
    add_workshop(models);
}

}  // namespace core::starter
