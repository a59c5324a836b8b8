// Chairs, tables, lamps, beds and couches.

#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

/// Four straight legs under a board; the profile frame's x is the depth (back at -x), z the width.
void add_legs(Assembly& a, double depth, double width, double height, double top_r, double foot_r, double splay,
              Rgb colour) {
    for (const double x : {-1.0, 1.0})
        a.pair(cone({x * (depth / 2 + splay), 0, width / 2 + splay}, {x * depth / 2, height, width / 2}, foot_r, top_r,
                    colour));
}

/// A chair's back: two posts leaning back and what is between them.
void add_slat_back(Assembly& a, double x, double seat, double height, double width, double lean, int slats, Rgb wood) {
    a.pair(tube({{{x, seat - 0.02, width / 2}, 0.035},
                 {{x - lean * 0.35, seat + height * 0.5, width / 2}, 0.033},
                 {{x - lean, seat + height, width / 2}, 0.028}},
                wood));
    for (int k = 0; k < slats; ++k) {
        const double t = 0.35 + 0.6 * (slats == 1 ? 1.0 : k / (slats - 1.0));
        a.add(moved(turned_z(box({0, 0, 0}, {0.03, height * 0.14, width}, 0.012, wood), 8),
                    {x - lean * t, seat + height * t, 0}));
    }
}

struct Chair {
    double back = 0.6, seat = 0.48, depth = 0.46, width = 0.27, lean = 0.1;
    double thick = 0.05, leg = 0.026;
    int slats = 3;
    Rgb wood = kWood, cushion = kCoral;
};

/// Narrower than life: its side, the one that people draw, is what one sees of it.
TriangleMesh side_chair(const Chair& c) {
    Assembly a;
    const double x = c.depth / 2;
    add_legs(a, c.depth * 0.86, c.width * 0.8, c.seat, c.leg, c.leg * 0.8, 0.02, c.wood);
    a.add(box({0, c.seat, 0}, {c.depth + 0.06, c.thick, c.width}, c.thick * 0.4, c.wood))
        .add(box({0.01, c.seat + c.thick * 0.7, 0}, {c.depth * 0.9, c.thick * 0.8, c.width * 0.86}, c.thick * 0.35,
                 c.cushion));
    add_slat_back(a, -x, c.seat, c.back, c.width * 0.8, c.lean, c.slats, c.wood);
    return facing_front(a.mesh());
}

/// Front, back and seat are boards as wide as the chair: from the side an "h" of four lines, as a chair is drawn.
TriangleMesh board_chair(const Chair& c) {
    Assembly a;
    const double x = c.depth / 2, t = c.thick;
    a.add(box({0, c.seat, 0}, {c.depth + t, t, c.width}, t * 0.4, c.cushion));
    a.add(moved(turned_z(box({0, -c.seat / 2, 0}, {t * 0.8, c.seat, c.width}, t * 0.3, c.wood), 3), {x, c.seat, 0}));
    a.add(moved(turned_z(box({0, -c.seat / 2, 0}, {t * 0.8, c.seat, c.width}, t * 0.3, c.wood), -3), {-x, c.seat, 0}));
    const double lean = std::atan2(c.lean, c.back) * 180.0 / 3.14159265;
    a.add(moved(turned_z(box({0, c.back / 2, 0}, {t * 0.8, c.back, c.width}, t * 0.3, c.wood), lean),
                {-x, c.seat - t * 0.3, 0}));
    a.add(moved(
        turned_z(box({t * 0.5, c.back * 0.66, 0}, {t * 0.7, c.back * 0.5, c.width * 0.8}, t * 0.3, c.cushion), lean),
        {-x, c.seat - t * 0.3, 0}));
    return facing_front(a.mesh());
}

TriangleMesh rocking_chair() {
    Assembly a;
    a.add(moved(side_chair({.seat = 0.46, .lean = 0.16, .slats = 4, .cushion = kTeal}), {0, 0.1, 0}));
    Assembly rockers;
    rockers.pair(tube({{{-0.55, 0.2, 0.14}, 0.028},
                       {{-0.25, 0.1, 0.14}, 0.03},
                       {{0.05, 0.075, 0.14}, 0.03},
                       {{0.3, 0.1, 0.14}, 0.03},
                       {{0.52, 0.18, 0.14}, 0.028}},
                      kWalnut));
    a.add(facing_front(rockers.mesh()));
    return a.mesh();
}

TriangleMesh office_chair() {
    Assembly a;
    for (int k = 0; k < 5; ++k) {
        a.add(turned_y(tube({{{0.02, 0.13, 0}, 0.035}, {{0.36, 0.08, 0}, 0.024}}, kSlate), 72.0 * k));
        a.add(turned_y(ball({0.36, 0.045, 0}, 0.045, kInk, 8), 72.0 * k));
    }
    a.add(rod({0, 0.1, 0}, {0, 0.5, 0}, 0.04, kSteel)).add(box({0.02, 0.53, 0}, {0.52, 0.11, 0.52}, 0.05, kBlue));
    a.add(tube({{{-0.16, 0.5, 0}, 0.03}, {{-0.32, 0.56, 0}, 0.03}, {{-0.33, 0.8, 0}, 0.025}}, kSlate));
    a.add(moved(turned_z(box({0, 0.3, 0}, {0.09, 0.56, 0.46}, 0.043, kBlue), 8), {-0.27, 0.62, 0}));
    a.pair(tube({{{0.0, 0.5, 0.27}, 0.02}, {{0.0, 0.74, 0.3}, 0.02}}, kSlate))
        .pair(box({0.03, 0.76, 0.3}, {0.28, 0.04, 0.08}, 0.018, kInk));
    return facing_front(a.mesh());
}

/// Wider than deep, for those who draw a chair from the front: the back's board, the seat's edge, two legs.
TriangleMesh front_chair(double width, double seat, double back, double board, Rgb wood, Rgb cushion) {
    Assembly a;
    const double x = width / 2, deep = 0.13, post = 0.05;
    a.add(box({0, seat, 0}, {width + 0.1, 0.09, 2 * deep + 0.08}, 0.03, wood))
        .add(box({0, seat + 0.05, 0.02}, {width, 0.06, 2 * deep}, 0.025, cushion));
    for (const double side : {1.0, -1.0})
        a.pair(rod({side * x, 0, deep}, {side * x, seat, deep}, post, wood, Cap::Flat))
            .add(rod({side * x * 0.95, seat, -deep}, {side * x, seat + back, -deep}, post, wood));
    a.add(box({0, seat + back - board / 2, -deep}, {width, board, 0.06}, 0.025, cushion));
    return a.mesh();
}

/// From the side a thick L on thin legs.
TriangleMesh padded_chair(double depth, double seat, double back, double pad, Rgb cloth, Rgb wood) {
    Assembly a;
    const double x = depth / 2;
    a.add(box({0, seat, 0}, {depth + pad, pad, 0.4}, pad * 0.42, cloth))
        .add(moved(turned_z(box({0, back / 2, 0}, {pad, back, 0.4}, pad * 0.42, lighter(cloth, 0.12)), 5),
                   {-x, seat - pad * 0.3, 0}));
    for (const double side : {1.0, -1.0})
        a.pair(rod({side * (x + 0.03), 0, 0.15}, {side * (x - 0.03), seat, 0.15}, 0.028, wood, Cap::Flat));
    return facing_front(a.mesh());
}

void add_chairs(Models& models) {
    add_model(models, "chair", "Kitchen chair", side_chair({}));
    add_model(models, "chair", "Ladder-back chair",
              side_chair({.back = 0.85, .seat = 0.46, .lean = 0.12, .slats = 5, .wood = kWalnut, .cushion = kStraw}));
    add_model(models, "chair", "Rocking chair", rocking_chair());
    add_model(models, "chair", "Office chair", office_chair());
    add_model(models, "chair", "Board chair",
              board_chair({.back = 0.66,
                           .seat = 0.5,
                           .depth = 0.5,
                           .width = 0.36,
                           .lean = 0.05,
                           .thick = 0.045,
                           .wood = kHoney,
                           .cushion = kForest}));
    add_model(models, "chair", "High-backed chair",
              board_chair({.back = 0.85,
                           .seat = 0.46,
                           .depth = 0.46,
                           .width = 0.32,
                           .lean = 0.1,
                           .thick = 0.05,
                           .wood = kSlate,
                           .cushion = kMustard}));
    add_model(models, "chair", "Low chair",
              board_chair({.back = 0.5,
                           .seat = 0.4,
                           .depth = 0.6,
                           .width = 0.36,
                           .lean = 0.02,
                           .thick = 0.055,
                           .wood = kCream,
                           .cushion = kMint}));
    add_model(models, "chair", "Bar chair",
              board_chair({.back = 0.4,
                           .seat = 0.78,
                           .depth = 0.44,
                           .width = 0.3,
                           .lean = 0.04,
                           .thick = 0.045,
                           .wood = kBrick,
                           .cushion = kStraw}));
    add_model(models, "chair", "Padded chair", padded_chair(0.5, 0.42, 0.56, 0.16, kBlue, kInk));
    add_model(models, "chair", "Reading chair", padded_chair(0.62, 0.34, 0.6, 0.2, kWine, kBrass));
    add_model(models, "chair", "School chair", front_chair(0.46, 0.46, 0.5, 0.3, kSlate, kOrange));
    add_model(models, "chair", "Dining chair", front_chair(0.4, 0.44, 0.66, 0.52, kWalnut, kTeal));
    add_model(models, "chair", "Broad chair", front_chair(0.56, 0.36, 0.44, 0.36, kHoney, kRose));
}

TriangleMesh four_leg_table(double length, double width, double height, double leg, double splay, Rgb top, Rgb legs) {
    Assembly a;
    add_legs(a, length * 0.86, width * 0.8, height, leg, leg * 0.7, splay, legs);
    a.add(box({0, height + 0.02, 0}, {length, 0.06, width}, 0.02, top));
    a.pair(box({0, height - 0.06, width * 0.4}, {length * 0.84, 0.09, 0.03}, 0.01, legs));
    return a.mesh();
}

TriangleMesh pedestal_table(double radius, double height, Rgb top, Rgb foot) {
    Assembly a;
    a.add(moved(lathe({{0, 0}, {radius, 0}, {radius + 0.015, 0.025}, {radius, 0.05}, {0, 0.05}}, top, 40),
                {0, height, 0}));
    a.add(lathe_smooth(
        {{0.05, 0.06}, {0.09, 0.14}, {0.05, 0.3}, {0.07, height * 0.55}, {0.045, height * 0.8}, {0.1, height}}, foot,
        20));
    for (int k = 0; k < 4; ++k)
        a.add(turned_y(
            tube({{{0.03, 0.16, 0}, 0.045}, {{radius * 0.35, 0.1, 0}, 0.038}, {{radius * 0.62, 0.03, 0}, 0.035}}, foot),
            90.0 * k));
    return a.mesh();
}

TriangleMesh trestle_table() {
    Assembly a;
    a.add(box({0, 0.72, 0}, {1.7, 0.06, 0.7}, 0.02, kHoney));
    for (const double x : {-0.6, 0.6}) {
        a.pair(rod({x - 0.16, 0.03, 0.26}, {x, 0.7, 0.22}, 0.03, kWalnut))
            .pair(rod({x + 0.16, 0.03, 0.26}, {x, 0.7, 0.22}, 0.03, kWalnut));
        a.pair(rod({x - 0.1, 0.3, 0.25}, {x + 0.1, 0.3, 0.25}, 0.022, kWalnut));
    }
    a.add(rod({-0.6, 0.66, 0}, {0.6, 0.66, 0}, 0.03, kWalnut));
    return a.mesh();
}

TriangleMesh desk() {
    Assembly a;
    a.add(box({0, 0.74, 0}, {1.3, 0.06, 0.66}, 0.02, kCream));
    a.add(box({0.43, 0.4, 0}, {0.36, 0.64, 0.56}, 0.02, kTeal));
    for (int k = 0; k < 3; ++k) {
        a.add(box({0.43, 0.2 + 0.2 * k, 0.285}, {0.3, 0.16, 0.03}, 0.012, lighter(kTeal)));
        a.add(ball({0.43, 0.2 + 0.2 * k, 0.31}, 0.022, kBrass, 8));
    }
    for (const double x : {0.3, 0.56}) a.pair(cone({x, 0, 0.22}, {x, 0.1, 0.22}, 0.02, 0.03, kWalnut));
    a.pair(cone({-0.58, 0, 0.25}, {-0.55, 0.72, 0.25}, 0.022, 0.035, kWalnut));
    return a.mesh();
}

void add_tables(Models& models) {
    add_model(models, "table", "Dining table", four_leg_table(1.5, 0.8, 0.74, 0.05, 0.0, kHoney, kWood));
    add_model(models, "table", "Round table", pedestal_table(0.6, 0.72, kWood, kWalnut));
    add_model(models, "table", "Coffee table", four_leg_table(1.2, 0.6, 0.38, 0.035, 0.08, kWalnut, kBrass));
    add_model(models, "table", "Trestle table", trestle_table());
    add_model(models, "table", "Desk", desk());
    add_model(models, "table", "Side table", four_leg_table(0.55, 0.5, 0.62, 0.03, 0.03, kCoral, kCream));
}

TriangleMesh shade(double low, double high, double height, Rgb colour) {
    return lathe({{low - 0.02, 0}, {low, 0}, {high, height}, {high - 0.02, height}, {low - 0.03, 0.02}}, colour, 32);
}

TriangleMesh straight_lamp(double height, double low, double high, double shade_height, Rgb cloth, Rgb metal) {
    Assembly a;
    a.add(lathe({{0, 0}, {0.24, 0}, {0.24, 0.03}, {0.05, 0.07}, {0, 0.07}}, metal));
    a.add(rod({0, 0.04, 0}, {0, height, 0}, 0.025, metal));
    a.add(moved(shade(low, high, shade_height, cloth), {0, height - shade_height * 0.4, 0}))
        .add(ball({0, height, 0}, 0.07, kStraw));
    return a.mesh();
}

TriangleMesh arc_lamp() {
    Assembly a;
    a.add(box({-0.5, 0.05, 0}, {0.4, 0.1, 0.36}, 0.03, kStone));
    a.add(tube({{{-0.5, 0.08, 0}, 0.022},
                {{-0.52, 0.9, 0}, 0.022},
                {{-0.3, 1.5, 0}, 0.022},
                {{0.15, 1.62, 0}, 0.022},
                {{0.42, 1.4, 0}, 0.022}},
               kBrass));
    a.add(moved(lathe_smooth({{0.27, 0}, {0.24, 0.12}, {0.12, 0.22}, {0.03, 0.26}}, kCoral), {0.44, 1.16, 0}))
        .add(ball({0.44, 1.19, 0}, 0.09, kStraw));
    return a.mesh();
}

TriangleMesh tripod_lamp() {
    Assembly a;
    for (int k = 0; k < 3; ++k)
        a.add(turned_y(cone({0.36, 0, 0}, {0.03, 1.15, 0}, 0.018, 0.026, kHoney, Cap::Round), 120.0 * k + 30));
    a.add(moved(shade(0.3, 0.3, 0.36, kCream), {0, 1.12, 0})).add(ball({0, 1.25, 0}, 0.08, kStraw));
    return a.mesh();
}

TriangleMesh reading_lamp() {
    Assembly a;
    a.add(lathe({{0, 0}, {0.22, 0}, {0.2, 0.04}, {0, 0.05}}, kTeal));
    a.add(rod({0, 0.03, 0}, {-0.16, 0.62, 0}, 0.022, kSteel))
        .add(rod({-0.16, 0.62, 0}, {0.2, 1.1, 0}, 0.022, kSteel))
        .add(ball({-0.16, 0.62, 0}, 0.045, kTeal, 8));
    a.add(moved(turned_z(lathe_smooth({{0.2, -0.2}, {0.15, -0.06}, {0.07, 0.04}, {0.05, 0.12}}, kTeal), 38),
                {0.24, 1.08, 0}));
    a.add(ball({0.3, 0.98, 0}, 0.075, kStraw, 8));
    return a.mesh();
}

void add_lamps(Models& models) {
    add_model(models, "floor lamp", "Floor lamp", straight_lamp(1.35, 0.34, 0.16, 0.36, kStraw, kBrass));
    add_model(models, "floor lamp", "Arc lamp", arc_lamp());
    add_model(models, "floor lamp", "Tripod lamp", tripod_lamp());
    add_model(models, "floor lamp", "Table lamp", straight_lamp(0.62, 0.3, 0.12, 0.34, kPink, kTeal));
    add_model(models, "floor lamp", "Reading lamp", reading_lamp());
}

struct Bed {
    double length = 1.9, width = 1.0, head = 0.85, foot = 0.5, height = 0.4;
    Rgb wood = kWood, blanket = kBlue;
    bool posts = false;
};

TriangleMesh bed(const Bed& b) {
    Assembly a;
    const double h = b.length / 2;
    a.add(box({0, b.height - 0.06, 0}, {b.length, 0.1, b.width}, 0.03, b.wood))
        .add(box({0, b.height + 0.08, 0}, {b.length - 0.06, 0.16, b.width - 0.04}, 0.06, kWhite));
    a.add(box({h * 0.28, b.height + 0.1, 0}, {b.length * 0.68, 0.18, b.width + 0.03}, 0.07, b.blanket));
    a.add(box({-h * 0.74, b.height + 0.22, 0}, {0.32, 0.15, b.width * 0.72}, 0.07, kCream));
    a.add(box({-h, b.head / 2 + 0.12, 0}, {0.07, b.head - 0.24, b.width}, 0.03, b.wood))
        .add(box({h, b.foot / 2 + 0.1, 0}, {0.07, b.foot - 0.2, b.width}, 0.03, b.wood));
    const double top = b.posts ? 1.7 : 0.0;
    for (const double x : {-h, h}) {
        const double height = b.posts ? top : (x < 0 ? b.head : b.foot);
        a.pair(rod({x, 0, b.width / 2}, {x, height, b.width / 2}, 0.045, b.wood))
            .pair(ball({x, height + 0.04, b.width / 2}, 0.06, b.wood, 8));
    }
    if (b.posts) a.add(box({0, top, 0}, {b.length + 0.1, 0.12, b.width + 0.1}, 0.03, b.blanket));
    return narrow(a.mesh(), 0.45);  // narrow: people draw its side
}

void add_beds(Models& models) {
    add_model(models, "bed", "Bed", bed({}));
    add_model(models, "bed", "Four-poster bed",
              bed({.head = 1.0, .foot = 0.6, .wood = kWalnut, .blanket = kWine, .posts = true}));
    add_model(models, "bed", "Child's bed",
              bed({.length = 1.4,
                   .width = 0.8,
                   .head = 0.7,
                   .foot = 0.62,
                   .height = 0.34,
                   .wood = kCream,
                   .blanket = kMint}));
    add_model(models, "bed", "Low bed",
              bed({.length = 2.1,
                   .width = 1.5,
                   .head = 0.72,
                   .foot = 0.3,
                   .height = 0.24,
                   .wood = kHoney,
                   .blanket = kStone}));
    add_model(models, "bed", "High-backed bed",
              bed({.length = 1.9, .width = 1.3, .head = 1.25, .foot = 0.55, .wood = kSlate, .blanket = kMustard}));
}

TriangleMesh couch(int seats, double back, double arm, Rgb cloth, Rgb legs, double leg_height = 0.14) {
    Assembly a;
    const double width = seats * 0.56, low = leg_height;
    a.add(box({0, low + 0.13, 0}, {width + 0.3, 0.24, 0.8}, 0.07, cloth));
    for (int k = 0; k < seats; ++k) {
        const double x = (k - (seats - 1) / 2.0) * 0.56;
        a.add(box({x, low + 0.31, 0.06}, {0.55, 0.17, 0.66}, 0.07, lighter(cloth, 0.2)));
        a.add(moved(turned_x(box({0, back / 2, 0}, {0.55, back, 0.2}, 0.085, lighter(cloth, 0.12)), -8),
                    {x, low + 0.3, -0.24}));
    }
    a.add(box({0, low + back * 0.55, -0.36}, {width + 0.26, back, 0.12}, 0.055, cloth));
    a.pair_x(box({width / 2 + 0.1, low + arm / 2, 0.02}, {0.2, arm, 0.82}, 0.09, cloth));
    for (const double x : {-1.0, 1.0})
        a.pair(cone({x * (width / 2 + 0.06), 0, 0.3}, {x * (width / 2 + 0.03), low + 0.04, 0.28}, 0.025, 0.04, legs));
    return scaled(a.mesh(), {1.0, 1.0, 0.5});  // shallow: people draw it from the front
}

/// Plump and rounded: arms like bolsters at the foot of a back that is narrower than both.
TriangleMesh plump_couch(double width, double back, double arm, Rgb cloth) {
    Assembly a;
    const double x = width / 2;
    a.add(box({0, 0.08 + back / 2, -0.12}, {width, back, 0.26}, 0.12, cloth))
        .add(box({0, 0.24, 0.06}, {width, 0.36, 0.5}, 0.08, lighter(cloth, 0.12)))
        .add(box({0, 0.44, 0.1}, {width - 0.06, 0.14, 0.46}, 0.06, lighter(cloth, 0.25)));
    a.pair_x(box({x + arm * 0.3, 0.05 + arm, 0.05}, {arm * 1.7, arm * 2, 0.56}, arm * 0.8, cloth));
    for (const double side : {1.0, -1.0})
        a.pair(rod({side * x * 0.9, 0, 0.2}, {side * x * 0.9, 0.1, 0.2}, 0.04, kWalnut));
    return scaled(a.mesh(), {1.0, 1.0, 0.7});
}

void add_couches(Models& models) {
    add_model(models, "couch", "Couch", couch(2, 0.66, 0.54, kTeal, kWalnut, 0.12));
    add_model(models, "couch", "Love seat", couch(2, 0.56, 0.5, kRose, kWood, 0.1));
    add_model(models, "couch", "Long sofa", couch(3, 0.6, 0.46, kStone, kInk, 0.1));
    add_model(models, "couch", "High-backed settee", couch(2, 0.8, 0.6, kMustard, kWalnut, 0.14));
    add_model(models, "couch", "Lounge sofa", couch(3, 0.66, 0.62, kNavy, kBrass, 0.16));
    add_model(models, "couch", "Plump couch", plump_couch(1.1, 0.86, 0.24, kCoral));
    add_model(models, "couch", "Armchair", plump_couch(0.72, 0.84, 0.24, kLeaf));
    add_model(models, "couch", "Low lounge couch", plump_couch(1.5, 0.7, 0.19, kPlum));
}

}  // namespace

void add_furniture(Models& models) {
    add_chairs(models);
    add_tables(models);
    add_lamps(models);
    add_beds(models);
    add_couches(models);
}

}  // namespace core::starter
