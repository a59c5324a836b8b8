// Ducks and flamingos.

#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/blob.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

/// A folded wing on the side of a body: a flat leaf pointing back and down.
TriangleMesh folded_wing(Vec3 root, double length, double height, Rgb colour, double droop = -12) {
    return moved(turned_z(ball({-length * 0.42, 0, 0}, {length * 0.55, height, 0.05}, colour, 12), -droop), root);
}

struct Waterfowl {
    double body = 0.42, neck = 0.2, lean = 0.1, head = 0.15, bill = 0.2, tail = 0.14;
    bool curved = false;  ///< a goose's S
    Rgb feathers = kWhite, head_colour = kGreen, bill_colour = kMustard, wing = kStone;
    bool standing = false;
};

TriangleMesh waterfowl(const Waterfowl& w) {
    Blob b(0.07);
    const double lift = w.standing ? 0.22 : 0.0, r = w.body;
    const Vec3 middle{0, lift + r * 0.5, 0}, root{r * 0.72, lift + r * 0.62, 0};
    b.egg(middle, {r * 1.1, r * 0.56, r * 0.62}, w.feathers, 6)
        .limb(middle + Vec3{-r * 0.8, r * 0.15, 0}, middle + Vec3{-r * 1.05 - w.tail, r * 0.42 + w.tail * 0.5, 0},
              r * 0.25, 0.03, w.feathers);
    const Vec3 head = root + Vec3{w.lean, w.neck + r * 0.2, 0};
    if (w.curved)
        b.chain({{root + Vec3{-0.05, -0.05, 0}, 0.13},
                 {root + Vec3{0.1, w.neck * 0.2, 0}, 0.085},
                 {root + Vec3{0.0, w.neck * 0.55, 0}, 0.07},
                 {root + Vec3{-0.05, w.neck * 0.85, 0}, 0.065},
                 {root + Vec3{0.02, w.neck + r * 0.2, 0}, 0.07},
                 {head, 0.08}},
                w.feathers);
    else
        b.limb(root + Vec3{-0.04, -0.04, 0}, head, 0.15, 0.1, w.feathers);
    b.egg(head, {w.head * 1.05, w.head, w.head * 0.9}, w.head_colour);
    Assembly a;
    a.add(b.mesh(52))
        .add(tube({{head + Vec3{w.head * 0.8, -0.02, 0}, 0.06, 0.06},
                   {head + Vec3{w.head + w.bill * 0.55, -0.05, 0}, 0.035, 0.065},
                   {head + Vec3{w.head + w.bill, -0.045, 0}, 0.02, 0.06}},
                  w.bill_colour));
    a.pair(ball(head + Vec3{w.head * 0.45, w.head * 0.3, w.head * 0.72}, 0.026, kInk, 8));
    a.pair(folded_wing(middle + Vec3{r * 0.55, r * 0.22, r * 0.56}, r * 1.55, r * 0.32, w.wing, 10));
    if (w.standing)
        for (const double side : {1.0, -1.0}) {
            a.add(rod({0.04, lift + 0.1, side * 0.13}, {0.04 + side * 0.06, 0.03, side * 0.13}, 0.028, w.bill_colour));
            a.add(ball({0.1 + side * 0.06, 0.022, side * 0.13}, {0.13, 0.022, 0.09}, w.bill_colour, 8));
        }
    return narrow(a.mesh(), 0.6);  // narrow: its side is what people draw
}

void add_waterfowl(Models& models) {
    add_model(models, "duck", "Mallard", waterfowl({.feathers = kStone, .wing = kWalnut}));
    add_model(models, "duck", "Yellow duckling",
              waterfowl({.body = 0.32,
                         .neck = 0.16,
                         .lean = 0.04,
                         .head = 0.19,
                         .bill = 0.12,
                         .tail = 0.06,
                         .feathers = kStraw,
                         .head_colour = kStraw,
                         .bill_colour = kOrange,
                         .wing = kMustard,
                         .standing = true}));
    add_model(models, "duck", "Farm duck",
              waterfowl({.body = 0.44,
                         .neck = 0.3,
                         .lean = 0.08,
                         .head = 0.14,
                         .feathers = kWhite,
                         .head_colour = kWhite,
                         .bill_colour = kOrange,
                         .wing = kCream,
                         .standing = true}));
    add_model(models, "duck", "Rubber duck",
              waterfowl({.body = 0.36,
                         .neck = 0.24,
                         .lean = -0.04,
                         .head = 0.23,
                         .bill = 0.13,
                         .tail = 0.12,
                         .feathers = kMustard,
                         .head_colour = kMustard,
                         .bill_colour = kCoral,
                         .wing = kHoney}));
    add_model(models, "duck", "Goose",
              waterfowl({.body = 0.46,
                         .neck = 0.52,
                         .lean = 0.12,
                         .head = 0.12,
                         .bill = 0.15,
                         .curved = true,
                         .feathers = kGrey,
                         .head_colour = kInk,
                         .bill_colour = kInk,
                         .wing = kSlate,
                         .standing = true}));
}

void add_more_ducks(Models& models) {
    add_model(models, "duck", "Pond duck",
              waterfowl({.body = 0.46,
                         .neck = 0.34,
                         .lean = -0.02,
                         .head = 0.14,
                         .bill = 0.2,
                         .tail = 0.24,
                         .feathers = kWhite,
                         .head_colour = kWhite,
                         .bill_colour = kMustard,
                         .wing = kIvory}));
}

/// A flamingo as it is drawn in a few lines: an egg, a neck with hardly a bend, two straight legs side by side.
TriangleMesh plain_flamingo(Vec3 body, double leg, double neck, double lean, Rgb pink) {
    Blob b(0.04);
    const Vec3 middle{0, leg + body.y * 0.9, 0}, root = middle + Vec3{body.x * 0.75, body.y * 0.45, 0};
    const Vec3 head = root + Vec3{lean, neck, 0};
    b.egg(middle, {body.x, body.y, body.z}, pink, 14)
        .chain({{root + Vec3{-0.06, -0.08, 0}, 0.08},
                {root + Vec3{lean * 0.2 + 0.05, neck * 0.4, 0}, 0.055},
                {root + Vec3{lean * 0.7, neck * 0.8, 0}, 0.05},
                {head, 0.055}},
               pink)
        .egg(head + Vec3{0.03, 0.01, 0}, {0.105, 0.085, 0.08}, pink);
    Assembly a;
    a.add(b.mesh(58))
        .add(tube(
            {{head + Vec3{0.1, 0, 0}, 0.05}, {head + Vec3{0.2, -0.03, 0}, 0.04}, {head + Vec3{0.26, -0.13, 0}, 0.014}},
            kInk))
        .pair(ball(head + Vec3{0.05, 0.03, 0.068}, 0.02, kInk, 8))
        .pair(folded_wing(middle + Vec3{body.x * 0.45, body.y * 0.2, body.z * 0.9}, body.x * 1.5, body.y * 0.5,
                          darker(pink, 0.1), -14));
    for (const double side : {1.0, -1.0})
        a.add(rod({side * 0.08, leg + 0.04, side * 0.05}, {side * 0.08, 0.02, side * 0.05}, 0.022, kRose))
            .add(ball({side * 0.08 + 0.04, 0.02, side * 0.05}, {0.08, 0.02, 0.05}, kRose, 8));
    return facing_front(a.mesh());
}

TriangleMesh flamingo(double leg, double neck, bool one_leg, bool feeding, Rgb pink) {
    Blob b(0.06);
    const Vec3 middle{0, leg + 0.16, 0}, root{0.24, leg + 0.22, 0};
    b.egg(middle, {0.32, 0.19, 0.17}, pink, 10)
        .limb(middle + Vec3{-0.2, 0, 0}, middle + Vec3{-0.44, -0.08, 0}, 0.1, 0.03, darker(pink, 0.12));
    const Vec3 head = feeding ? root + Vec3{0.34, -neck * 0.95, 0} : root + Vec3{0.16, neck, 0};
    if (feeding)
        b.chain({{root, 0.075},
                 {root + Vec3{0.16, 0.14, 0}, 0.05},
                 {root + Vec3{0.3, -0.05, 0}, 0.045},
                 {root + Vec3{0.3, -neck * 0.6, 0}, 0.045},
                 {head, 0.06}},
                pink);
    else
        b.chain({{root, 0.075},
                 {root + Vec3{0.14, neck * 0.28, 0}, 0.05},
                 {root + Vec3{0.03, neck * 0.62, 0}, 0.045},
                 {root + Vec3{0.04, neck * 0.92, 0}, 0.045},
                 {head, 0.06}},
                pink);
    b.egg(head, {0.085, 0.075, 0.07}, pink);
    Assembly a;
    a.add(b.mesh(76));
    const double down = feeding ? -0.1 : -0.16;
    a.add(tube({{head + Vec3{0.05, 0, 0}, 0.045},
                {head + Vec3{0.15, -0.02, 0}, 0.04},
                {head + Vec3{0.19, down, 0}, 0.012}},
               kCream))
        .add(ball(head + Vec3{0.18, down * 0.7, 0}, {0.032, 0.055, 0.03}, kInk, 8));
    a.pair(ball(head + Vec3{0.03, 0.025, 0.058}, 0.018, kInk, 8))
        .pair(folded_wing(middle + Vec3{0.16, 0.06, 0.15}, 0.5, 0.12, darker(pink, 0.1), -14));
    const Rgb shank = kRose;
    a.add(rod({0, leg + 0.05, 0.06}, {0.02, 0.02, 0.05}, 0.022, shank))
        .add(ball({0.05, 0.02, 0.05}, {0.09, 0.02, 0.06}, shank, 8))
        .add(ball({0.01, leg * 0.52, 0.055}, 0.032, shank, 8));
    if (one_leg)
        a.add(rod({0, leg + 0.05, -0.06}, {0.26, leg * 0.62, -0.06}, 0.022, shank))
            .add(rod({0.26, leg * 0.62, -0.06}, {0.0, leg * 0.55, -0.06}, 0.02, shank));
    else
        a.add(rod({0, leg + 0.05, -0.06}, {-0.16, 0.02, -0.05}, 0.022, shank))
            .add(ball({-0.12, 0.02, -0.05}, {0.09, 0.02, 0.06}, shank, 8));
    return facing_front(a.mesh());
}

void add_flamingos(Models& models) {
    add_model(models, "flamingo", "Flamingo", flamingo(0.7, 0.62, false, false, kPink));
    add_model(models, "flamingo", "Flamingo on one leg", flamingo(0.75, 0.56, true, false, kCoral));
    add_model(models, "flamingo", "Feeding flamingo", flamingo(0.66, 0.7, false, true, kRose));
    add_model(models, "flamingo", "Tall flamingo", flamingo(0.95, 0.7, false, false, mixed(kPink, kCoral, 0.4)));
    add_model(models, "flamingo", "Young flamingo", flamingo(0.55, 0.45, false, false, lighter(kPink)));
    add_model(models, "flamingo", "Round flamingo", plain_flamingo({0.24, 0.22, 0.16}, 0.5, 0.5, 0.12, kRose));
    add_model(models, "flamingo", "Leaning flamingo",
              plain_flamingo({0.36, 0.2, 0.16}, 0.5, 0.52, 0.3, mixed(kPink, kRose, 0.5)));
}

}  // namespace

void add_ducks_and_flamingos(Models& models) {
    add_waterfowl(models);
    add_more_ducks(models);
    add_flamingos(models);
}

}  // namespace core::starter
