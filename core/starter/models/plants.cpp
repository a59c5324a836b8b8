// Trees, flowers, mushrooms, cactuses and fruit.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/blob.hpp"
#include "core/starter/kit/quadruped.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kGolden = 2.399963;

TriangleMesh trunk(double height, double r, Rgb bark) {
    return tube({{{0, 0, 0}, r * 1.7},
                 {{0, height * 0.15, 0}, r * 1.1},
                 {{0, height * 0.6, 0}, r * 0.95},
                 {{0, height, 0}, r * 0.75}},
                bark, {.cap = Cap::Flat});
}

TriangleMesh leafy_tree(double trunk_height, double r, double crown_width, double crown_height, int clumps, Rgb leaf,
                        Rgb bark, Rgb fruit = {0, 0, 0}) {
    Assembly a;
    a.add(trunk(trunk_height + crown_height * 0.4, r, bark))
        .pair_x(tube({{{0, trunk_height * 0.75, 0}, r * 0.6},
                      {{crown_width * 0.4, trunk_height + crown_height * 0.3, 0.05}, r * 0.35}},
                     bark));
    Blob crown(0.1);
    const Vec3 middle{0, trunk_height + crown_height * 0.55, 0};
    crown.egg(middle, {crown_width * 0.7, crown_height * 0.45, crown_width * 0.65}, leaf);
    for (int k = 0; k < clumps; ++k) {
        const double up = 1.0 - 2.0 * (k + 0.5) / clumps, wide = std::sqrt(1.0 - up * up), turn = kGolden * k;
        crown.egg(middle + Vec3{crown_width * 0.68 * wide * std::cos(turn), crown_height * 0.42 * up,
                                crown_width * 0.62 * wide * std::sin(turn)},
                  Vec3{1, 1, 1} * (crown_width * 0.36), k % 3 == 0 ? lighter(leaf, 0.15) : leaf);
    }
    a.add(crown.mesh(44));
    if (!(fruit == Rgb{0, 0, 0}))
        for (int k = 0; k < 16; ++k) {
            const double up = 0.8 - 1.6 * (k + 0.5) / 16, wide = std::sqrt(1.0 - up * up), turn = kGolden * k + 0.7;
            a.add(ball(middle + Vec3{crown_width * 1.0 * wide * std::cos(turn), crown_height * 0.62 * up,
                                     crown_width * 0.94 * wide * std::sin(turn)},
                       crown_width * 0.085, fruit, 8));
        }
    return a.mesh();
}

TriangleMesh fir(int tiers, double height, double width, Rgb needle, bool snow) {
    Assembly a;
    a.add(trunk(height * 0.3, 0.08, kWalnut));
    for (int k = 0; k < tiers; ++k) {
        const double t = static_cast<double>(k) / tiers, low = height * (0.16 + 0.84 * t * 0.86),
                     r = width * (1.0 - 0.74 * t), h = height * 0.9 / tiers * 1.45;
        a.add(moved(painted(lathe({{0, 0.04},
                                   {r * 0.7, 0.03},
                                   {r, 0},
                                   {r * 0.92, 0.07},
                                   {r * 0.4, h * 0.55},
                                   {k + 1 == tiers ? 0.0 : r * 0.2, h}},
                                  k % 2 == 0 ? needle : lighter(needle, 0.12), 28),
                            [&](Vec3 p, Rgb c) { return snow && std::hypot(p.x, p.z) > r * 0.9 ? kWhite : c; }),
                    {0, low, 0}));
    }
    return a.mesh();
}

TriangleMesh poplar(Rgb leaf) {
    Assembly a;
    a.add(trunk(0.6, 0.07, kWood))
        .add(moved(lathe_smooth({{0, 0}, {0.2, 0.08}, {0.3, 0.45}, {0.24, 1.0}, {0.1, 1.45}, {0, 1.6}}, leaf, 28),
                   {0, 0.3, 0}));
    return a.mesh();
}

void add_trees(Models& models) {
    add_model(models, "tree", "Oak", leafy_tree(0.6, 0.1, 0.62, 0.85, 14, kGreen, kWalnut));
    add_model(models, "tree", "Fir tree", fir(4, 1.6, 0.55, kForest, false));
    add_model(models, "tree", "Apple tree", leafy_tree(0.5, 0.08, 0.5, 0.75, 12, kLeaf, kWood, kRed));
    add_model(models, "tree", "Poplar", poplar(kLeaf));
    add_model(models, "tree", "Snowy fir", fir(3, 1.2, 0.6, kGreen, true));
    add_model(models, "tree", "Cherry in bloom", leafy_tree(0.7, 0.07, 0.7, 0.6, 16, kPink, kCocoa));
    const auto palm = [](double height, double lean, int fronds, double reach, Rgb leaf, bool nuts) {
        Assembly a;
        const auto at = [&](double t) { return Vec3{lean * t * t, height * t, 0}; };
        std::vector<Station> line;
        for (int k = 0; k <= 24; ++k)
            line.push_back({at(k / 24.0), (0.1 - 0.045 * k / 24.0) * (k % 2 == 0 ? 1.0 : 0.88)});
        a.add(tube(line, kTan, {.steps = 2}));
        const Vec3 top = at(1.0);
        for (int k = 0; k < fronds; ++k) {
            const double turn = 360.0 * k / fronds + 10, rise = k % 2 == 0 ? 0.24 : 0.12;
            a.add(moved(turned_y(tube({{{0, 0, 0}, 0.025, 0.05},
                                       {{reach * 0.3, rise, 0}, 0.02, 0.12},
                                       {{reach * 0.7, rise * 0.6, 0}, 0.018, 0.11},
                                       {{reach, -0.16, 0}, 0.012, 0.02}},
                                      k % 2 == 0 ? leaf : darker(leaf, 0.12), {.sides = 10}),
                                 turn),
                        top));
        }
        if (nuts)
            for (int k = 0; k < 3; ++k)
                a.add(
                    ball(top + Vec3{0.09 * std::cos(kTurn * k / 3 + 0.5), -0.08, 0.09 * std::sin(kTurn * k / 3 + 0.5)},
                         0.075, kCocoa, 10));
        return a.mesh();
    };
    add_model(models, "palm tree", "Coconut palm", palm(1.4, 0.35, 9, 0.75, kLeaf, true));
    add_model(models, "palm tree", "Straight palm", palm(1.7, 0.05, 11, 0.6, kGreen, false));
    add_model(models, "palm tree", "Leaning palm", palm(1.1, 0.75, 8, 0.8, kTeal, true));
    const auto cactus = [](double height, double r, const std::vector<std::array<double, 3>>& arms, Rgb skin, Rgb pot) {
        Blob b(0.04);
        b.limb({0, 0.1, 0}, {0, height, 0}, r, r * 0.9, skin);
        for (const auto& [y, reach, up] : arms)
            b.limb({0, y, 0}, {reach, y, 0}, r * 0.55, r * 0.58, skin)
                .limb({reach, y, 0}, {reach, y + up, 0}, r * 0.6, r * 0.52, skin);
        Assembly a;
        a.add(b.mesh(56))
            .add(ball({0, height + r * 0.95, 0}, {0.06, 0.045, 0.06}, kRose, 8))
            .add(lathe({{0, -0.25},
                        {0.2, -0.25},
                        {0.26, 0.05},
                        {0.3, 0.05},
                        {0.3, 0.13},
                        {0.24, 0.13},
                        {0.23, 0.09},
                        {0, 0.09}},
                       pot, 28));
        return a.mesh();
    };
    add_model(models, "cactus", "Cactus", cactus(0.95, 0.13, {{0.45, -0.32, 0.3}, {0.6, 0.3, 0.24}}, kGreen, kBrick));
    add_model(models, "cactus", "Tall cactus",
              cactus(1.3, 0.11, {{0.5, 0.3, 0.5}, {0.75, -0.28, 0.3}, {0.95, 0.24, 0.16}}, kTeal, kMustard));
    add_model(models, "cactus", "Round cactus", cactus(0.42, 0.24, {{0.3, -0.38, 0.12}}, kLeaf, kCoral));
    const auto flower = [](int petals, double size, double petal_width, double stem, Rgb petal, Rgb eye, double lean) {
        Assembly a;
        const Vec3 top{lean, stem, 0};
        a.add(tube({{{0, 0, 0}, 0.028}, {{lean * 0.2, stem * 0.5, 0}, 0.026}, {top, 0.024}}, kLeaf));
        for (int k = 0; k < petals; ++k) {
            const double turn = 360.0 * k / petals;
            a.add(moved(
                turned_z(ball({0, size * 0.62, 0.01 * (k % 2)}, {petal_width, size * 0.42, 0.045}, petal, 10), turn),
                top));
        }
        a.add(ball(top + Vec3{0, 0, 0.02}, {size * 0.32, size * 0.32, 0.09}, eye, 12));
        a.add(ear_shape({lean * 0.15, stem * 0.3, 0}, {0.3, 0.2, 0.03}, 0.07, 0.018, Ear::Round, kGreen))
            .add(ear_shape({lean * 0.1, stem * 0.2, 0}, {-0.3, 0.22, -0.03}, 0.07, 0.018, Ear::Round, kGreen));
        return a.mesh();
    };
    add_model(models, "flower", "Daisy", flower(10, 0.36, 0.075, 1.0, kWhite, kMustard, 0.06));
    add_model(models, "flower", "Poppy", flower(5, 0.36, 0.2, 0.95, kRed, kInk, -0.08));
    add_model(models, "flower", "Sunflower", flower(16, 0.46, 0.075, 1.3, kMustard, kCocoa, 0.0));
    add_model(models, "flower", "Forget-me-not", flower(5, 0.28, 0.13, 0.65, kSky, kStraw, 0.1));
    Assembly tulip;
    tulip.add(tube({{{0, 0, 0}, 0.028}, {{0.03, 0.5, 0}, 0.026}, {{0.0, 0.95, 0}, 0.026}}, kLeaf))
        .add(moved(
            lathe_smooth({{0, 0}, {0.15, 0.05}, {0.2, 0.2}, {0.14, 0.36}, {0.1, 0.36}, {0.14, 0.2}, {0, 0.08}}, kRose),
            {0, 0.92, 0}));
    for (int k = 0; k < 3; ++k)
        tulip.add(moved(
            turned_y(
                tube({{{0.1, 0.1, 0}, 0.05, 0.09}, {{0.17, 0.3, 0}, 0.03, 0.08}, {{0.14, 0.48, 0}, 0.008}}, kCoral),
                120.0 * k),
            {0, 0.92, 0}));
    tulip.add(ear_shape({0, 0.02, 0}, {0.22, 0.7, 0.05}, 0.07, 0.02, Ear::Pointed, kGreen))
        .add(ear_shape({0, 0.02, 0}, {-0.26, 0.55, -0.05}, 0.07, 0.02, Ear::Pointed, kGreen));
    add_model(models, "flower", "Tulip", tulip.mesh());
    const auto mushroom = [](double stem, double stem_r, double cap, double cap_height, Rgb colour, bool dots) {
        Assembly a;
        a.add(lathe_smooth({{0, 0},
                            {stem_r * 1.35, 0.02},
                            {stem_r * 1.2, stem * 0.3},
                            {stem_r * 0.85, stem * 0.75},
                            {stem_r * 0.9, stem}},
                           kCream, 28));
        a.add(moved(lathe(spline({{0, 0},
                                  {cap * 0.6, -0.01},
                                  {cap * 0.97, -0.04},
                                  {cap, 0.02},
                                  {cap * 0.82, cap_height * 0.6},
                                  {cap * 0.4, cap_height * 0.95},
                                  {0, cap_height}},
                                 5),
                          colour, 36),
                    {0, stem, 0}));
        for (int k = 0; k < 14 && dots; ++k) {
            const double t = 0.12 + 0.75 * k / 14.0, turn = kGolden * k, r = cap * std::sin(t * 1.5),
                         y = cap_height * std::cos(t * 1.45);
            a.add(ball({r * std::cos(turn) * 0.97, stem + y, r * std::sin(turn) * 0.97}, {0.055, 0.035, 0.055}, kWhite,
                       8));
        }
        return a.mesh();
    };
    add_model(models, "mushroom", "Fly agaric", mushroom(0.6, 0.12, 0.42, 0.34, kRed, true));
    add_model(models, "mushroom", "Porcini", mushroom(0.5, 0.22, 0.38, 0.26, kChestnut, false));
    add_model(models, "mushroom", "Parasol mushroom", mushroom(0.95, 0.08, 0.5, 0.2, kTan, true));
    add_model(models, "mushroom", "Bell mushroom", mushroom(0.75, 0.08, 0.26, 0.42, kLilac, false));
}

TriangleMesh fruit_body(const std::vector<Point>& profile, Rgb colour, Rgb blush, double stalk, bool leaf) {
    double top = 0.0;
    for (const Point p : profile) top = std::max(top, p.y);
    const double dent = profile.back().y;
    Assembly a;
    a.add(painted(lathe_smooth(profile, colour, 36, 6), [&](Vec3 p, Rgb c) {
        return p.x + p.z > 0.3 ? mixed(c, blush, std::min(1.0, (p.x + p.z - 0.3) * 2.0)) : c;
    }));
    a.add(tube({{{0, dent - 0.04, 0}, 0.022}, {{0.02, dent + stalk * 0.6, 0}, 0.02}, {{0.06, dent + stalk, 0}, 0.028}},
               kCocoa));
    if (leaf) a.add(ear_shape({0.03, dent + stalk * 0.5, 0}, {0.3, 0.14, 0.03}, 0.075, 0.018, Ear::Round, kLeaf));
    return a.mesh();
}

void add_fruit(Models& models) {
    add_model(models, "apple", "Red apple",
              fruit_body({{0, 0.03}, {0.14, 0.0}, {0.38, 0.2}, {0.46, 0.52}, {0.36, 0.78}, {0.16, 0.82}, {0, 0.72}},
                         kRed, kStraw, 0.24, true));
    add_model(models, "apple", "Green apple",
              fruit_body({{0, 0.03}, {0.16, 0.0}, {0.44, 0.18}, {0.5, 0.45}, {0.38, 0.66}, {0.16, 0.7}, {0, 0.6}},
                         kLeaf, kStraw, 0.2, false));
    add_model(models, "apple", "Tall apple",
              fruit_body({{0, 0.03}, {0.12, 0.0}, {0.3, 0.2}, {0.42, 0.6}, {0.36, 0.88}, {0.15, 0.92}, {0, 0.82}},
                         kWine, kCoral, 0.28, true));
    add_model(
        models, "pear", "Pear",
        fruit_body(
            {{0, 0.02}, {0.15, 0.0}, {0.4, 0.2}, {0.42, 0.42}, {0.26, 0.72}, {0.17, 0.95}, {0.1, 1.04}, {0, 1.02}},
            kStraw, kLeaf, 0.22, true));
    add_model(
        models, "pear", "Red pear",
        fruit_body(
            {{0, 0.02}, {0.14, 0.0}, {0.34, 0.18}, {0.38, 0.4}, {0.2, 0.75}, {0.15, 1.1}, {0.08, 1.18}, {0, 1.16}},
            kBrick, kMustard, 0.18, false));
    add_model(
        models, "pear", "Round pear",
        fruit_body({{0, 0.02}, {0.2, 0.0}, {0.46, 0.2}, {0.47, 0.46}, {0.3, 0.72}, {0.18, 0.84}, {0.1, 0.9}, {0, 0.88}},
                   kOlive, kStraw, 0.26, true));
    const auto banana = [](double curve, double r, double length, Rgb colour) {
        std::vector<Station> line;
        const std::vector<double> widths{0.2, 0.32, 0.72, 1.0, 1.05, 0.95, 0.6, 0.25};
        for (std::size_t k = 0; k < widths.size(); ++k) {
            const double angle = (static_cast<double>(k) / (static_cast<double>(widths.size()) - 1.0) - 0.5) * curve,
                         big = length / curve;
            line.push_back({{big * std::sin(angle), big * (1.0 - std::cos(angle)), 0}, r * widths[k]});
        }
        const double end = line.front().at.x, tip = line.back().at.x;
        return painted(tube(line, colour, {.sides = 10, .steps = 8}),
                       [=](Vec3 p, Rgb c) { return p.x < end + 0.05 || p.x > tip - 0.02 ? kCocoa : c; });
    };
    add_model(models, "banana", "Banana", banana(1.8, 0.15, 1.3, kMustard));
    add_model(models, "banana", "Curved banana", banana(2.6, 0.14, 1.5, kStraw));
    add_model(models, "banana", "Green banana", banana(1.2, 0.16, 1.2, kLeaf));
    const auto carrot = [](double length, double r, int leaves, double spread, Rgb colour) {
        Assembly a;
        a.add(tube({{{0, 0, 0}, 0.015},
                    {{0.01, length * 0.3, 0}, r * 0.45},
                    {{0, length * 0.7, 0}, r * 0.85},
                    {{0, length * 0.95, 0}, r}},
                   colour, {.sides = 18}));
        for (int k = 0; k < leaves; ++k) {
            const double t = leaves > 1 ? k / (leaves - 1.0) - 0.5 : 0.0;
            a.add(tube({{{t * 0.06, length, 0}, 0.02},
                        {{t * spread * 0.6, length + 0.22, 0.04 * (k % 2)}, 0.05, 0.03},
                        {{t * spread, length + 0.42, 0.05 * (k % 2)}, 0.045, 0.03},
                        {{t * spread * 1.25, length + 0.52, 0.05 * (k % 2)}, 0.01}},
                       k % 2 == 0 ? kLeaf : kGreen));
        }
        return turned_z(a.mesh(), 25);
    };
    add_model(models, "carrot", "Carrot", carrot(1.0, 0.17, 5, 0.5, kOrange));
    add_model(models, "carrot", "Stubby carrot", carrot(0.62, 0.22, 3, 0.4, kCoral));
    add_model(models, "carrot", "Purple carrot", carrot(1.25, 0.14, 4, 0.7, kPlum));
    const auto pineapple = [](double height, double r, int leaves, double crown) {
        Assembly a;
        a.add(painted(lathe_smooth({{0, 0},
                                    {r * 0.7, 0.04},
                                    {r, height * 0.35},
                                    {r * 0.95, height * 0.7},
                                    {r * 0.55, height * 0.97},
                                    {0, height}},
                                   kMustard, 48, 10),
                      [&](Vec3 p, Rgb c) {
                          const double turn = std::atan2(p.z, p.x) * 6.0, up = p.y * 24.0;
                          return std::sin(turn + up) > 0.82 || std::sin(turn - up) > 0.82 ? kHoney : c;
                      }));
        for (int k = 0; k < leaves; ++k) {
            const double ring_no = k / (leaves * 0.34), reach = 0.36 - 0.11 * ring_no;
            a.add(moved(turned_y(tube({{{0.03, -0.03, 0}, 0.03, 0.07},
                                       {{reach * 0.45, crown * 0.5, 0}, 0.025, 0.06},
                                       {{reach, crown * (0.75 + 0.14 * ring_no), 0}, 0.006}},
                                      k % 2 == 0 ? kGreen : kLeaf),
                                 137.5 * k),
                        {0, height, 0}));
        }
        return a.mesh();
    };
    add_model(models, "pineapple", "Pineapple", pineapple(0.8, 0.34, 14, 0.45));
    add_model(models, "pineapple", "Slim pineapple", pineapple(1.0, 0.28, 12, 0.6));
    add_model(models, "pineapple", "Baby pineapple", pineapple(0.5, 0.27, 10, 0.4));
}

}  // namespace

void add_plants(Models& models) {
    add_trees(models);
    add_fruit(models);
}

}  // namespace core::starter
