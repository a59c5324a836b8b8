// Shoes, hats, spectacles, bulbs, toys and other things about the house.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/blob.hpp"
#include "core/starter/kit/quadruped.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

constexpr double kTurn = 6.283185307179586;

void add_clothes(Models& models) {
    const auto shoe = [](double ankle, double toe, double length, double sole, Rgb upper, Rgb rubber, bool laces) {
        const double instep = std::min(ankle - 0.02, 0.32);
        Blob b(0.08);
        b.limb({-0.33 * length, 0.14, 0}, {0.33 * length, 0.09, 0}, 0.13, toe, upper)
            .limb({-0.34 * length, 0.16, 0}, {-0.3 * length, ankle, 0}, 0.13, 0.13, upper)
            .limb({-0.28 * length, instep, 0}, {0.12 * length, 0.12, 0}, 0.1, 0.09, upper);
        Assembly a;
        a.add(scaled(b.mesh(52), {1.0, 1.0, 0.85}));
        const std::vector<Point> plan = closed_spline({{-0.47 * length, 0},
                                                       {-0.36 * length, 0.14},
                                                       {0.0, 0.12},
                                                       {0.3 * length, 0.15},
                                                       {0.47 * length, 0.07},
                                                       {0.48 * length, -0.05},
                                                       {0.3 * length, -0.15},
                                                       {0.0, -0.12},
                                                       {-0.36 * length, -0.14}},
                                                      5);
        a.add(moved(turned_x(slab(plan, sole, 0.02, rubber), -90), {0, sole / 2 - 0.02, 0}));
        a.add(moved(scaled(ring({0, 0, 0}, {0, 1, 0}, 0.13, 0.028, lighter(upper)), {1.0, 1.0, 0.85}),
                    {-0.3 * length, ankle + 0.06, 0}))
            .add(moved(ball({0, 0, 0}, {0.125, 0.03, 0.1}, kInk, 10), {-0.3 * length, ankle + 0.115, 0}));
        for (int k = 0; k < 3 && laces; ++k) {
            const double t = 0.45 + 0.2 * k;  // along the instep, from the ankle to the toe
            const double x = -0.28 * length + 0.4 * length * t, y = instep + (0.12 - instep) * t + 0.115;
            a.add(rod({x, y, -0.075}, {x + 0.03, y, 0.075}, 0.02, kWhite));
        }
        return facing_front(a.mesh());
    };
    add_model(models, "shoe", "Sneaker", shoe(0.34, 0.11, 1.0, 0.08, kCoral, kWhite, true));
    add_model(models, "shoe", "Boot", shoe(0.78, 0.13, 1.0, 0.1, kWalnut, kInk, true));
    add_model(models, "shoe", "Running shoe", shoe(0.3, 0.09, 1.2, 0.12, kSky, kMustard, true));
    add_model(models, "shoe", "Rubber boot", shoe(0.95, 0.12, 0.9, 0.07, kMustard, kHoney, false));
    add_model(models, "shoe", "Slipper", shoe(0.24, 0.12, 0.95, 0.05, kPlum, kTan, false));
    const auto hat = [](double brim, double crown, double top, double height, double curl, Rgb felt, Rgb band) {
        TriangleMesh m = lathe({{0, 0.02},
                                {crown * 0.97, 0.02},
                                {brim, -0.0},
                                {brim, 0.035},
                                {crown * 1.02, 0.05},
                                {(crown + top) / 2 + 0.01, height * 0.6},
                                {top, height * 0.96},
                                {top * 0.92, height},
                                {0, height * 0.97}},
                               felt, 48);
        join(m, lathe({{0, 0.05}, {crown * 1.03, 0.05}, {crown * 1.01, 0.05 + height * 0.2}, {0, 0.05 + height * 0.2}},
                      band, 48));
        return bent(m, [&](Vec3 p) {
            const double r = std::max(0.0, std::hypot(p.x, p.z) - crown) / std::max(brim - crown, 1e-9);
            return Vec3{p.x, p.y + curl * r * r * (p.x * p.x - 0.3 * p.z * p.z) / (brim * brim), p.z};
        });
    };
    add_model(models, "hat", "Top hat", hat(0.55, 0.34, 0.36, 0.62, 0.1, kInk, kWine));
    add_model(models, "hat", "Straw hat", hat(0.75, 0.34, 0.3, 0.3, -0.05, kStraw, kCoral));
    add_model(models, "hat", "Cowboy hat", hat(0.72, 0.32, 0.24, 0.4, 0.3, kTan, kCocoa));
    add_model(models, "hat", "Bowler", hat(0.5, 0.36, 0.2, 0.42, 0.12, kSlate, kInk));
    Assembly wizard;
    wizard.add(lathe({{0, 0}, {0.7, 0}, {0.7, 0.03}, {0.35, 0.06}, {0.04, 1.1}, {0, 1.12}}, kPlum, 40))
        .add(lathe({{0, 0.07}, {0.36, 0.07}, {0.33, 0.16}, {0, 0.16}}, kMustard, 40));
    add_model(models, "hat", "Wizard's hat", bent(wizard.mesh(), [](Vec3 p) {
                  return Vec3{p.x + 0.22 * std::pow(std::max(0.0, p.y - 0.35), 2.0), p.y, p.z};
              }));
    const auto glasses = [](double rx, double ry, double gap, bool square, Rgb frame, Rgb lens) {
        Assembly a;
        std::vector<Vec3> rim;
        for (int k = 0; k < 16; ++k) {
            const double turn = kTurn * k / 16, power = square ? 0.55 : 1.0, c = std::cos(turn), s = std::sin(turn);
            rim.push_back({(rx + gap) + rx * std::copysign(std::pow(std::abs(c), power), c),
                           ry * std::copysign(std::pow(std::abs(s), power), s), 0});
        }
        std::vector<Point> pane;
        for (const Vec3 p : rim) pane.push_back({p.x, p.y});
        a.pair_x(loop(rim, 0.035, frame, 4))
            .pair_x(slab(closed_spline(pane, 3), 0.02, 0.005, lens))
            .add(tube({{{-gap - 0.02, 0.02, 0}, 0.03}, {{0, 0.07, 0.02}, 0.03}, {{gap + 0.02, 0.02, 0}, 0.03}}, frame));
        const double edge = gap + 2 * rx;
        a.pair_x(tube({{{edge, 0.05, 0}, 0.03},
                       {{edge + 0.06, 0.05, -0.1}, 0.025},
                       {{edge + 0.05, 0.04, -0.6}, 0.022},
                       {{edge + 0.03, -0.12, -0.8}, 0.026}},
                      frame));
        return a.mesh();
    };
    add_model(models, "eyeglasses", "Round glasses", glasses(0.26, 0.26, 0.09, false, kWalnut, kGlass));
    add_model(models, "eyeglasses", "Square glasses", glasses(0.3, 0.2, 0.08, true, kInk, kGlass));
    add_model(models, "eyeglasses", "Sunglasses", glasses(0.32, 0.24, 0.06, true, kRed, kSlate));
    add_model(models, "eyeglasses", "Oval glasses", glasses(0.3, 0.17, 0.12, false, kBrass, kGlass));
    const auto crown = [](int tips, double r, double height, double low, Rgb gem) {
        Assembly a;
        const TriangleMesh cup = lathe({{0, 0},
                                        {r, 0},
                                        {r * 1.05, 0.25},
                                        {r * 1.1, 0.5},
                                        {r * 1.16, 0.75},
                                        {r * 1.22, 1.0},
                                        {r * 1.18, 1.0},
                                        {r * 1.06, 0.5},
                                        {r * 0.95, 0.05},
                                        {0, 0.05}},
                                       kMustard, 16 * tips);
        a.add(bent(cup, [&](Vec3 p) {  // the rim rises to a tip in the middle of every section
            const double wave = std::abs(std::fmod((std::atan2(p.x, p.z) / kTurn + 1.0) * tips, 1.0) - 0.5) * 2.0;
            return Vec3{p.x, p.y * (low + (height - low) * (1.0 - wave)), p.z};
        }));
        a.add(ring({0, 0.03, 0}, {0, 1, 0}, r + 0.01, 0.045, kBrass, 48));
        const double dome = height * 0.55;
        a.add(lathe_smooth({{r * 0.98, 0.0}, {r * 0.95, dome * 0.6}, {r * 0.6, dome * 0.95}, {0, dome}}, kWine, 36));
        for (int k = 0; k < tips; ++k) {
            const double turn = kTurn * (k + 0.5) / tips;
            a.add(ball({r * 1.2 * std::sin(turn), height + 0.03, r * 1.2 * std::cos(turn)}, 0.05, gem, 10))
                .add(ball({r * 1.09 * std::sin(turn), low * 0.62, r * 1.09 * std::cos(turn)}, 0.04, gem, 8));
        }
        return a.mesh();
    };
    add_model(models, "crown", "King's crown", crown(8, 0.42, 0.5, 0.22, kRed));
    add_model(models, "crown", "Princess crown", crown(10, 0.36, 0.34, 0.12, kPink));
    add_model(models, "crown", "Tall crown", crown(6, 0.38, 0.66, 0.26, kTeal));
}

TriangleMesh bulb(double r, double neck, double screw, Rgb glass) {
    Assembly a;
    a.add(moved(lathe_smooth({{0.13, 0},
                              {0.15, neck * 0.4},
                              {r * 0.82, neck + r * 0.25},
                              {r, neck + r * 0.95},
                              {r * 0.66, neck + r * 1.72},
                              {0, neck + r * 1.95}},
                             glass, 36, 8),
                {0, screw, 0}));
    std::vector<Point> thread{{0, -0.05}, {0.06, -0.04}, {0.1, 0.0}};
    for (int k = 0; k < 4; ++k) {
        thread.push_back({0.155, screw * (k + 0.35) / 4});
        thread.push_back({0.125, screw * (k + 0.85) / 4});
    }
    thread.push_back({0.15, screw + 0.03});
    a.add(lathe(thread, kSteel, 28)).add(ball({0, -0.05, 0}, {0.06, 0.04, 0.06}, kInk, 8));
    return a.mesh();
}

TriangleMesh hourglass(double r, double height, double waist, Rgb wood, Rgb sand) {
    Assembly a;
    const double h = height / 2;
    a.add(painted(lathe_smooth({{r * 0.85, -h},
                                {r * 0.9, -h * 0.7},
                                {r * 0.55, -h * 0.3},
                                {waist, 0},
                                {r * 0.55, h * 0.3},
                                {r * 0.9, h * 0.7},
                                {r * 0.85, h}},
                               kGlass, 32, 6),
                  [&](Vec3 p, Rgb c) { return (p.y < -h * 0.35) || (p.y > h * 0.1 && p.y < h * 0.55) ? sand : c; }));
    for (const double y : {-h - 0.05, h + 0.05})
        a.add(moved(lathe({{0, -0.05}, {r * 1.15, -0.05}, {r * 1.22, 0}, {r * 1.15, 0.05}, {0, 0.05}}, wood, 36),
                    {0, y, 0}));
    for (int k = 0; k < 3; ++k) a.add(turned_y(rod({r * 1.05, -h, 0}, {r * 1.05, h, 0}, 0.035, wood), 120.0 * k + 30));
    return a.mesh();
}

TriangleMesh ice_cream(int scoops, const std::array<Rgb, 3>& flavours, double cone_height, double r, bool cherry) {
    Assembly a;
    a.add(lathe({{0, -cone_height}, {0.02, -cone_height}, {r * 0.92, -0.02}, {r * 1.0, 0.03}, {0, 0.04}}, kHoney, 48));
    for (int k = 0; k < 7; ++k)
        a.add(ring({0, -cone_height * (0.08 + 0.12 * k), 0}, {0, 1, 0}, r * 0.92 * (0.92 - 0.12 * k) + 0.004, 0.012,
                   kTan, 32));
    double y = r * 0.45;
    for (int k = 0; k < scoops; ++k) {
        const double size = r * (1.08 - 0.1 * k);
        a.add(ball({0, y, 0}, {size, size * 0.95, size}, flavours[static_cast<std::size_t>(k)], 18));
        for (int j = 0; j < 9; ++j)
            a.add(ball({size * 0.92 * std::cos(kTurn * j / 9), y - size * 0.38, size * 0.92 * std::sin(kTurn * j / 9)},
                       {size * 0.3, size * 0.18, size * 0.3}, flavours[static_cast<std::size_t>(k)], 8));
        y += size * 1.18;
    }
    if (cherry)
        a.add(ball({0, y - r * 0.12, 0}, r * 0.26, kRed, 12))
            .add(tube({{{0, y, 0}, 0.014}, {{0.04, y + 0.12, 0}, 0.012}, {{0.12, y + 0.18, 0}, 0.012}}, kForest));
    return a.mesh();
}

TriangleMesh snowman(int balls, double r, bool hat, double arms, Rgb scarf) {
    Assembly a;
    double y = r, size = r;
    Vec3 head, chest;
    for (int k = 0; k < balls; ++k) {
        a.add(ball({0, y, 0}, size, kWhite, 18));
        chest = head;
        head = {0, y, 0};
        if (k + 1 < balls) {
            y += size * 0.86 + size * 0.72 * 0.86;
            size *= 0.72;
        }
    }
    for (const double x : {-0.34, 0.34})
        a.add(ball(head + Vec3{x * size, size * 0.22, size * 0.9}, size * 0.1, kInk, 8));
    a.add(cone(head + Vec3{0, 0, size * 0.9}, head + Vec3{0.06, -0.03, size * 1.75}, size * 0.16, 0.01, kOrange,
               Cap::Round));
    for (int k = 0; k < 3; ++k)
        a.add(ball(chest + Vec3{0, r * (0.42 - 0.26 * k), r * 0.7 + 0.012 * k}, r * 0.06, kInk, 8));
    a.add(ring(head - Vec3{0, size * 0.86, 0}, {0, 1, 0}, size * 0.72, size * 0.2, scarf, 32))
        .add(box(head + Vec3{size * 0.5, -size * 1.4, size * 0.85}, {size * 0.34, size * 0.9, 0.06}, 0.025, scarf));
    for (const double side : {1.0, -1.0}) {
        const Vec3 shoulder = chest + Vec3{side * r * 0.6, r * 0.15, 0},
                   hand = shoulder + Vec3{side * arms, arms * 0.55, 0};
        a.add(rod(shoulder, hand, 0.025, kWalnut))
            .add(rod(hand - Vec3{side * 0.08, 0.04, 0}, hand + Vec3{side * 0.02, 0.12, 0}, 0.018, kWalnut))
            .add(rod(hand - Vec3{side * 0.08, 0.04, 0}, hand + Vec3{side * 0.12, -0.04, 0}, 0.018, kWalnut));
    }
    if (hat)
        a.add(moved(lathe({{0, 0},
                           {size * 1.1, 0},
                           {size * 1.1, 0.05},
                           {size * 0.68, 0.06},
                           {size * 0.68, size * 1.1},
                           {0, size * 1.1}},
                          kInk, 28),
                    head + Vec3{0, size * 0.72, 0}));
    return a.mesh();
}

TriangleMesh teddy(double belly, double head, double ear, Rgb fur, Rgb light, Rgb bow) {
    const Vec3 top{0, 0.5 + belly * 0.9 + head * 0.7, 0};
    Blob body(0.06);
    body.egg({0, 0.42, 0}, {belly, belly * 1.15, belly * 0.85}, fur)
        .egg({0, 0.4, belly * 0.35}, {belly * 0.66, belly * 0.78, belly * 0.58}, light)
        .egg(top, {head * 1.08, head, head * 0.95}, fur)
        .egg(top + Vec3{0, -head * 0.22, head * 0.72}, {head * 0.44, head * 0.36, head * 0.36}, light);
    for (const double side : {1.0, -1.0}) {
        body.egg(top + Vec3{side * head * 0.85, head * 0.78, 0}, {ear, ear, ear * 0.6}, fur)
            .limb({side * belly * 0.8, 0.6, 0.02}, {side * (belly + 0.2), 0.36, 0.1}, 0.11, 0.105, fur);
        body.limb({side * belly * 0.6, 0.16, 0.05}, {side * (belly * 0.75 + 0.12), 0.1, 0.34}, 0.14, 0.12, fur)
            .egg({side * (belly * 0.75 + 0.13), 0.12, 0.42}, {0.1, 0.12, 0.06}, light);
    }
    Assembly a;
    a.add(body.mesh(50))
        .pair_x(ball(top + Vec3{head * 0.38, head * 0.18, head * 0.86}, 0.035, kInk, 8))
        .add(ball(top + Vec3{0, -head * 0.1, head * 1.06}, {0.055, 0.04, 0.035}, kInk, 8));
    const Vec3 neck{0, 0.5 + belly * 0.82, belly * 0.8};
    a.pair_x(ball(neck + Vec3{0.1, 0, 0}, {0.1, 0.07, 0.05}, bow, 10))
        .add(ball(neck + Vec3{0, 0, 0.03}, 0.045, darker(bow), 8));
    return a.mesh();
}

TriangleMesh alarm_clock(double r, double bells, Rgb body, Rgb face, bool legs) {
    Assembly a;
    a.add(turned_x(lathe({{0, -0.14}, {r * 0.96, -0.14}, {r, -0.1}, {r, 0.12}, {r * 0.92, 0.15}, {0, 0.15}}, body, 44),
                   90))
        .add(rod({0, 0, 0.14}, {0, 0, 0.165}, r * 0.84, face, Cap::Flat));
    for (int k = 0; k < 12; ++k)
        a.add(moved(turned_z(box({0, r * 0.72, 0}, {0.022, k % 3 == 0 ? 0.1 : 0.05, 0.02}, 0.006, kInk), 30.0 * k),
                    {0, 0, 0.168}));
    a.add(moved(turned_z(box({0, r * 0.2, 0}, {0.04, r * 0.46, 0.02}, 0.008, kInk), 55), {0, 0, 0.18}))
        .add(moved(turned_z(box({0, r * 0.3, 0}, {0.03, r * 0.64, 0.02}, 0.008, kInk), -60), {0, 0, 0.185}))
        .add(ball({0, 0, 0.19}, 0.035, kRed, 8));
    if (bells > 0)
        for (const double side : {-1.0, 1.0})
            a
                .add(turned_z(
                    moved(lathe_smooth(
                              {{bells, 0}, {bells * 0.86, bells * 0.5}, {bells * 0.4, bells * 0.85}, {0, bells * 0.95}},
                              kBrass, 24),
                          {0, r + 0.05, 0}),
                    side * 35))
                .add(turned_z(rod({0, r - 0.02, 0}, {0, r + 0.08, 0}, 0.025, kSteel), side * 35));
    if (bells > 0)
        a.add(tube({{{-0.1, r + 0.03, 0}, 0.02},
                    {{-0.1, r + bells + 0.16, 0}, 0.02},
                    {{0.1, r + bells + 0.16, 0}, 0.02},
                    {{0.1, r + 0.03, 0}, 0.02}},
                   kSteel));
    if (legs)
        a.pair_x(tube({{{r * 0.55, -r * 0.75, 0}, 0.045}, {{r * 0.78, -r * 1.18, 0}, 0.03}}, kSteel))
            .pair_x(ball({r * 0.79, -r * 1.2, 0}, 0.045, kSteel, 8));
    return a.mesh();
}

void add_things(Models& models) {
    add_model(models, "light bulb", "Light bulb", bulb(0.36, 0.22, 0.22, kStraw));
    add_model(models, "light bulb", "Globe bulb", bulb(0.48, 0.1, 0.2, kCream));
    add_model(models, "light bulb", "Candle bulb", bulb(0.24, 0.34, 0.24, kMustard));
    add_model(models, "hourglass", "Hourglass", hourglass(0.34, 1.0, 0.05, kWalnut, kStraw));
    add_model(models, "hourglass", "Slim hourglass", hourglass(0.26, 1.2, 0.04, kBrass, kCoral));
    add_model(models, "hourglass", "Egg timer", hourglass(0.36, 0.75, 0.06, kTeal, kPink));
    add_model(models, "ice cream", "Strawberry cone", ice_cream(1, {kPink, kPink, kPink}, 0.95, 0.34, true));
    add_model(models, "ice cream", "Double scoop", ice_cream(2, {kMint, kCocoa, kPink}, 1.0, 0.32, false));
    add_model(models, "ice cream", "Triple scoop", ice_cream(3, {kCream, kPink, kMint}, 1.05, 0.3, true));
    add_model(models, "snowman", "Snowman", snowman(3, 0.42, true, 0.42, kCoral));
    add_model(models, "snowman", "Little snowman", snowman(2, 0.44, false, 0.3, kTeal));
    add_model(models, "snowman", "Tall snowman", snowman(4, 0.38, true, 0.34, kMustard));
    add_model(models, "teddy-bear", "Teddy bear", teddy(0.3, 0.27, 0.12, kHoney, kCream, kRed));
    add_model(models, "teddy-bear", "Chubby teddy", teddy(0.38, 0.28, 0.1, kWalnut, kSand, kTeal));
    add_model(models, "teddy-bear", "Big-eared teddy", teddy(0.26, 0.3, 0.17, kStone, kPink, kPlum));
    add_model(models, "alarm clock", "Alarm clock", alarm_clock(0.45, 0.19, kRed, kCream, true));
    add_model(models, "alarm clock", "Little alarm clock", alarm_clock(0.34, 0.22, kTeal, kWhite, true));
    add_model(models, "alarm clock", "Plain alarm clock", alarm_clock(0.48, 0.12, kMustard, kWhite, true));
}

}  // namespace

void add_household(Models& models) {
    add_clothes(models);
    add_things(models);
}

}  // namespace core::starter
