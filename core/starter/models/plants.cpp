// Trees, flowers, mushrooms and fruit.

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

struct LeafyTree {
    double trunk = 0.7, r = 0.08, foot = 1.8;  ///< height and radius of the trunk; how much wider it is at the ground
    double width = 0.62, height = 0.4;         ///< half sizes of the crown
    int clumps = 7;
    double clump = 0.3;  ///< radius
    Rgb leaf = kGreen, bark = kWalnut;
    bool fruit = false;
    double spread = 0.0;  ///< above 0: two slim stems, their feet so far from the middle
};

/// The trunk, up to the middle of the crown; two stems that part towards the ground where the tree has a spread.
void add_trunk(Assembly& a, const LeafyTree& t, Vec3 middle) {
    if (t.spread > 0)
        a.pair_x(tube({{{t.spread, 0, 0}, t.r * t.foot},
                       {{t.spread * 0.62, t.trunk * 0.3, 0}, t.r},
                       {{t.spread * 0.5, t.trunk, 0}, t.r},
                       {middle + Vec3{t.spread * 0.4, 0, 0}, t.r * 0.8}},
                      t.bark, {.cap = Cap::Flat}));
    else
        a.add(tube({{{0, 0, 0}, t.r * t.foot},
                    {{0, t.trunk * 0.12, 0}, t.r * (0.5 + 0.5 * t.foot)},
                    {{0, t.trunk * 0.5, 0}, t.r},
                    {middle, t.r * 0.8}},
                   t.bark, {.cap = Cap::Flat}));
}

/// Flat, its crown a ring of clumps like the cloud that people draw.
TriangleMesh leafy_tree(const LeafyTree& t) {
    Assembly a;
    const Vec3 middle{0, t.trunk + t.height * 0.9, 0};
    add_trunk(a, t, middle);
    Blob crown(0.06);
    crown.egg(middle, {t.width * 0.85, t.height * 0.85, t.clump}, t.leaf);
    for (int k = 0; k < t.clumps; ++k) {
        const double turn = kTurn * (k + 0.25) / t.clumps;
        crown.egg(
            middle + Vec3{t.width * 0.8 * std::cos(turn), t.height * 0.75 * std::sin(turn), 0.08 * (k % 2 * 2 - 1)},
            Vec3{1, 1, 1} * t.clump, k % 3 == 0 ? lighter(t.leaf, 0.15) : t.leaf);
    }
    a.add(crown.mesh(48));
    for (int k = 0; k < 14 && t.fruit; ++k) {
        const double turn = kGolden * k, out = std::sqrt((k + 0.5) / 14.0);
        for (const double side : {1.0, -1.0})
            a.add(ball(middle + Vec3{t.width * 0.85 * out * std::cos(turn), t.height * 0.8 * out * std::sin(turn),
                                     side * (t.clump + 0.06 * (1.0 - out))},
                       0.055, kRed, 6));
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

void add_trees(Models& models) {
    add_model(models, "tree", "Oak", leafy_tree({}));
    add_model(
        models, "tree", "Apple tree",
        leafy_tree(
            {.trunk = 0.6, .width = 0.5, .height = 0.42, .clumps = 6, .leaf = kLeaf, .bark = kWood, .fruit = true}));
    add_model(models, "tree", "Cherry in bloom",
              leafy_tree({.trunk = 0.8,
                          .r = 0.04,
                          .foot = 2.2,
                          .width = 0.72,
                          .height = 0.3,
                          .clumps = 7,
                          .clump = 0.27,
                          .leaf = kPink,
                          .bark = kCocoa}));
    add_model(models, "tree", "Young tree",
              leafy_tree({.trunk = 0.85,
                          .r = 0.03,
                          .foot = 1.6,
                          .width = 0.5,
                          .height = 0.36,
                          .clumps = 5,
                          .clump = 0.3,
                          .leaf = kLeaf,
                          .bark = kTan}));
    add_model(models, "tree", "Broad tree",
              leafy_tree({.trunk = 0.75,
                          .r = 0.12,
                          .foot = 2.4,
                          .width = 0.8,
                          .height = 0.34,
                          .clumps = 8,
                          .clump = 0.3,
                          .leaf = kForest}));
    add_model(models, "tree", "Birch with two stems",
              leafy_tree({.trunk = 0.85,
                          .r = 0.035,
                          .foot = 1.3,
                          .width = 0.44,
                          .height = 0.3,
                          .clumps = 6,
                          .clump = 0.2,
                          .leaf = kLeaf,
                          .bark = kIvory,
                          .spread = 0.24}));
    add_model(models, "tree", "Olive tree",
              leafy_tree({.trunk = 0.6,
                          .r = 0.045,
                          .foot = 1.5,
                          .width = 0.6,
                          .height = 0.26,
                          .clumps = 7,
                          .clump = 0.22,
                          .leaf = kOlive,
                          .bark = kWood,
                          .spread = 0.3}));
    add_model(models, "tree", "Twin maple",
              leafy_tree({.trunk = 0.62,
                          .r = 0.035,
                          .foot = 1.4,
                          .width = 0.36,
                          .height = 0.36,
                          .clumps = 5,
                          .clump = 0.22,
                          .leaf = kOrange,
                          .bark = kWalnut,
                          .spread = 0.13}));
    add_model(models, "tree", "Plane tree",
              leafy_tree({.trunk = 0.55,
                          .r = 0.13,
                          .foot = 1.15,
                          .width = 0.66,
                          .height = 0.22,
                          .clumps = 7,
                          .clump = 0.21,
                          .leaf = kGreen,
                          .bark = kTan}));
    add_model(models, "tree", "Chestnut tree",
              leafy_tree({.trunk = 0.6,
                          .r = 0.09,
                          .foot = 1.2,
                          .width = 0.4,
                          .height = 0.4,
                          .clumps = 11,
                          .clump = 0.16,
                          .leaf = kForest,
                          .bark = kChestnut}));
    add_model(models, "tree", "Fir tree", scaled(fir(4, 1.6, 0.55, kForest, false), {1.0, 1.0, 0.6}));
    add_model(models, "tree", "Snowy fir", scaled(fir(3, 1.2, 0.6, kGreen, true), {1.0, 1.0, 0.6}));
}

void add_flowers_and_mushrooms(Models& models) {
    const auto flower = [](int petals, double size, double petal_width, double stem, Rgb petal, Rgb eye, bool leaves) {
        Assembly a;
        const Vec3 top{0.04, stem, 0};
        a.add(tube({{{0, 0, 0}, 0.022}, {{0.01, stem * 0.5, 0}, 0.02}, {top, 0.02}}, kLeaf));
        for (int k = 0; k < petals; ++k) {
            const double turn = 360.0 * k / petals;
            a.add(moved(
                turned_z(ball({0, size * 0.62, 0.01 * (k % 2)}, {petal_width, size * 0.42, 0.045}, petal, 10), turn),
                top));
        }
        a.add(ball(top + Vec3{0, 0, 0.02}, {size * 0.34, size * 0.34, 0.09}, eye, 12));
        if (leaves)
            a.add(ear_shape({0.01, stem * 0.3, 0}, {0.24, 0.16, 0.03}, 0.06, 0.018, Ear::Round, kGreen))
                .add(ear_shape({0.01, stem * 0.2, 0}, {-0.24, 0.18, -0.03}, 0.06, 0.018, Ear::Round, kGreen));
        return a.mesh();
    };
    add_model(models, "flower", "Daisy", flower(8, 0.44, 0.13, 1.0, kWhite, kMustard, true));
    add_model(models, "flower", "Poppy", flower(5, 0.46, 0.25, 0.95, kRed, kInk, false));
    add_model(models, "flower", "Sunflower", flower(12, 0.5, 0.1, 1.25, kMustard, kCocoa, true));
    add_model(models, "flower", "Forget-me-not", flower(5, 0.42, 0.2, 0.8, kSky, kStraw, false));
    add_model(models, "flower", "Cosmos", flower(6, 0.5, 0.18, 0.85, kLilac, kStraw, false));
    add_model(models, "flower", "Four-petalled flower", flower(4, 0.45, 0.22, 1.1, kRose, kMustard, false));
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
        return scaled(a.mesh(), {1.0, 1.0, 0.7});
    };
    add_model(models, "mushroom", "Fly agaric", mushroom(0.6, 0.12, 0.42, 0.34, kRed, true));
    add_model(models, "mushroom", "Porcini", mushroom(0.5, 0.22, 0.38, 0.26, kChestnut, false));
    add_model(models, "mushroom", "Parasol mushroom", mushroom(0.95, 0.08, 0.5, 0.2, kTan, true));
    add_model(models, "mushroom", "Bell mushroom", mushroom(0.75, 0.08, 0.26, 0.42, kLilac, false));
    add_model(models, "mushroom", "Button mushroom", mushroom(0.4, 0.16, 0.36, 0.36, kSand, false));
    add_model(models, "mushroom", "Stout toadstool", mushroom(0.55, 0.17, 0.5, 0.4, kCoral, true));
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
    return scaled(a.mesh(), {1.0, 1.0, 0.7});
}

void add_fruit(Models& models) {
    add_model(models, "apple", "Red apple",
              fruit_body({{0, 0.03}, {0.14, 0.0}, {0.38, 0.2}, {0.46, 0.52}, {0.38, 0.78}, {0.2, 0.83}, {0, 0.64}},
                         kRed, kStraw, 0.34, true));
    add_model(models, "apple", "Green apple",
              fruit_body({{0, 0.03}, {0.16, 0.0}, {0.44, 0.18}, {0.5, 0.45}, {0.4, 0.66}, {0.2, 0.71}, {0, 0.54}},
                         kLeaf, kStraw, 0.36, false));
    add_model(models, "apple", "Tall apple",
              fruit_body({{0, 0.03}, {0.12, 0.0}, {0.3, 0.2}, {0.42, 0.6}, {0.36, 0.88}, {0.15, 0.92}, {0, 0.82}},
                         kWine, kCoral, 0.28, true));
    add_model(models, "apple", "Wide apple",
              fruit_body({{0, 0.06}, {0.2, 0.0}, {0.48, 0.2}, {0.56, 0.5}, {0.42, 0.74}, {0.2, 0.78}, {0, 0.6}}, kCoral,
                         kStraw, 0.34, false));
    add_model(models, "apple", "Heart-shaped apple",
              fruit_body({{0, 0.03}, {0.1, 0.0}, {0.28, 0.2}, {0.47, 0.58}, {0.42, 0.82}, {0.22, 0.88}, {0, 0.72}},
                         kRed, kCoral, 0.32, true));
    add_model(models, "apple", "Yellow apple",
              fruit_body({{0, 0.03}, {0.16, 0.0}, {0.4, 0.16}, {0.47, 0.44}, {0.38, 0.74}, {0.18, 0.84}, {0, 0.76}},
                         kMustard, kCoral, 0.22, false));
    add_model(models, "apple", "Crab apple",
              fruit_body({{0, 0.03}, {0.14, 0.0}, {0.36, 0.22}, {0.42, 0.46}, {0.32, 0.68}, {0.14, 0.7}, {0, 0.62}},
                         kMustard, kRed, 0.44, true));
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
    add_model(models, "banana", "Slender banana", banana(1.6, 0.1, 1.4, kStraw));
    add_model(models, "banana", "Fat banana", banana(2.0, 0.2, 1.3, kHoney));
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
    add_model(models, "carrot", "Spring carrot", carrot(0.9, 0.13, 2, 0.3, kOrange));
    add_model(models, "carrot", "Bushy carrot", carrot(0.85, 0.2, 7, 0.6, kHoney));
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
        return scaled(a.mesh(), {1.0, 1.0, 0.7});
    };
    add_model(models, "pineapple", "Pineapple", pineapple(0.8, 0.34, 14, 0.45));
    add_model(models, "pineapple", "Slim pineapple", pineapple(1.0, 0.28, 12, 0.6));
    add_model(models, "pineapple", "Baby pineapple", pineapple(0.5, 0.27, 10, 0.4));
    add_model(models, "pineapple", "Tall-crowned pineapple", pineapple(0.7, 0.3, 12, 0.75));
    add_model(models, "pineapple", "Wide pineapple", pineapple(0.66, 0.38, 16, 0.36));
}

}  // namespace

void add_plants(Models& models) {
    add_trees(models);
    add_flowers_and_mushrooms(models);
    add_fruit(models);
}

}  // namespace core::starter
