// Birds: songbirds, ducks, swans, flamingos, owls, penguins, parrots.

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

TriangleMesh beak(Vec3 root, Vec3 tip, double r, Rgb colour) {
    return tube({{root, r, r * 0.8}, {root + (tip - root) * 0.5, r * 0.62, r * 0.5}, {tip, r * 0.1}}, colour,
                {.sides = 12});
}

/// Two legs with three toes each.
void add_thin_legs(Assembly& a, Vec3 hip, double ground, double r, double stride, Rgb colour) {
    for (const double side : {1.0, -1.0}) {
        const Vec3 foot{hip.x + side * stride, ground + r, side * hip.z};
        a.add(rod({hip.x, hip.y, side * hip.z}, foot, r, colour));
        for (const double turn : {-0.5, 0.0, 0.5})
            a.add(rod(foot, foot + Vec3{0.11, -r * 0.2, 0.11 * turn}, r * 0.8, colour));
        a.add(rod(foot, foot + Vec3{-0.06, 0, 0}, r * 0.7, colour));
    }
}

struct Songbird {
    double body = 0.3, tilt = 22, head = 0.17, beak = 0.13, tail = 0.36, tail_angle = -14, leg = 0.2;
    double crest = 0.0;
    bool flying = false;
    Rgb back = kBlue, belly = kCream, beak_colour = kMustard, wing = kNavy;
};

TriangleMesh flying_wing(double span, double chord, Rgb colour) {
    const std::vector<Point> outline = closed_spline({{chord * 0.5, 0.0},
                                                      {chord * 0.62, span * 0.4},
                                                      {chord * 0.2, span * 0.85},
                                                      {-chord * 0.25, span},
                                                      {-chord * 0.35, span * 0.72},
                                                      {-chord * 0.6, span * 0.5},
                                                      {-chord * 0.55, 0.0}},
                                                     5);
    return turned_x(slab(outline, 0.045, 0.015, colour), 90);
}

TriangleMesh songbird(const Songbird& s) {
    Blob b(0.07);
    const double r = s.body, angle = s.tilt * 3.14159265 / 180.0;
    const Vec3 ahead{std::cos(angle), std::sin(angle), 0};
    const Vec3 middle{0, s.flying ? 0.0 : s.leg + r * 0.85, 0},
        head = middle + ahead * (r * 1.05) + Vec3{0.02, 0.05, 0};
    b.egg(middle, {r * 1.25, r * 0.82, r * 0.78}, s.back, s.tilt)
        .egg(middle + Vec3{0.05, -r * 0.22, 0}, {r * 1.0, r * 0.68, r * 0.68}, s.belly, s.tilt)
        .egg(head, {s.head, s.head, s.head * 0.95}, s.back);
    Assembly a;
    a.add(b.mesh(48))
        .add(beak(head + Vec3{s.head * 0.8, -0.01, 0}, head + Vec3{s.head * 0.85 + s.beak, -0.03, 0}, 0.055,
                  s.beak_colour));
    a.pair(ball(head + Vec3{s.head * 0.45, s.head * 0.28, s.head * 0.72}, 0.03, kInk, 8));
    const Vec3 rump = middle - ahead * (r * 1.0);
    const double turn = s.tail_angle * 3.14159265 / 180.0;
    a.add(tube({{rump + Vec3{0.08, 0, 0}, 0.06, 0.09},
                {rump + Vec3{-s.tail * 0.5 * std::cos(turn), s.tail * 0.5 * std::sin(turn), 0}, 0.045, 0.11},
                {rump + Vec3{-s.tail * std::cos(turn), s.tail * std::sin(turn), 0}, 0.025, 0.14}},
               s.wing));
    if (s.crest > 0)
        a.add(tube({{head + Vec3{0.02, s.head * 0.7, 0}, 0.06, 0.04},
                    {head + Vec3{-s.crest * 0.5, s.head + s.crest * 0.6, 0}, 0.045, 0.03},
                    {head + Vec3{-s.crest, s.head + s.crest, 0}, 0.01}},
                   s.wing));
    if (s.flying) {
        a.pair(moved(turned_x(flying_wing(0.8, 0.42, s.wing), -38), middle + Vec3{0, 0.08, 0.12}));
    } else {
        a.pair(folded_wing(middle + Vec3{r * 0.55, r * 0.22, r * 0.74}, r * 1.9, r * 0.42, s.wing, -s.tilt * 0.9));
        add_thin_legs(a, {0.02, s.leg + 0.06, 0.09}, 0, 0.018, 0.05, s.beak_colour);
    }
    return facing_front(a.mesh());
}

void add_songbirds(Models& models) {
    add_model(models, "bird", "Bluebird", songbird({}));
    add_model(models, "bird", "Robin",
              songbird({.body = 0.33,
                        .tilt = 35,
                        .head = 0.19,
                        .beak = 0.09,
                        .tail = 0.26,
                        .tail_angle = -30,
                        .leg = 0.24,
                        .back = kTan,
                        .belly = kCoral,
                        .beak_colour = kCocoa,
                        .wing = kWalnut}));
    add_model(models, "bird", "Crested cardinal",
              songbird({.body = 0.28,
                        .tilt = 40,
                        .head = 0.16,
                        .tail = 0.48,
                        .tail_angle = -48,
                        .crest = 0.17,
                        .back = kRed,
                        .belly = kCoral,
                        .wing = kWine}));
    add_model(models, "bird", "Swallow in flight",
              songbird({.body = 0.24,
                        .tilt = 4,
                        .head = 0.14,
                        .beak = 0.08,
                        .tail = 0.5,
                        .tail_angle = 6,
                        .flying = true,
                        .back = kNavy,
                        .belly = kWhite,
                        .beak_colour = kInk,
                        .wing = kNavy}));
    add_model(models, "bird", "Long-tailed tit",
              songbird({.body = 0.24,
                        .tilt = 12,
                        .head = 0.18,
                        .beak = 0.06,
                        .tail = 0.7,
                        .tail_angle = 24,
                        .leg = 0.16,
                        .back = kPink,
                        .belly = kWhite,
                        .beak_colour = kInk,
                        .wing = kSlate}));
}

struct Waterfowl {
    double body = 0.42, neck = 0.2, lean = 0.1, head = 0.15, bill = 0.2, tail = 0.14;
    bool curved = false;  ///< a swan's S
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
    return facing_front(a.mesh());
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
                         .feathers = kGrey,
                         .head_colour = kInk,
                         .bill_colour = kInk,
                         .wing = kSlate,
                         .standing = true}));
    add_model(models, "swan", "Swan",
              waterfowl({.body = 0.48,
                         .neck = 0.62,
                         .lean = 0.14,
                         .head = 0.1,
                         .bill = 0.15,
                         .tail = 0.12,
                         .curved = true,
                         .feathers = kWhite,
                         .head_colour = kWhite,
                         .bill_colour = kOrange,
                         .wing = kCream}));
    add_model(models, "swan", "Black swan",
              waterfowl({.body = 0.44,
                         .neck = 0.75,
                         .lean = 0.2,
                         .head = 0.1,
                         .bill = 0.14,
                         .tail = 0.08,
                         .curved = true,
                         .feathers = kSlate,
                         .head_colour = kSlate,
                         .bill_colour = kRed,
                         .wing = kInk}));
    add_model(models, "swan", "Cygnet",
              waterfowl({.body = 0.38,
                         .neck = 0.4,
                         .lean = 0.12,
                         .head = 0.11,
                         .bill = 0.12,
                         .tail = 0.05,
                         .curved = true,
                         .feathers = kStone,
                         .head_colour = kStone,
                         .bill_colour = kGrey,
                         .wing = kGrey}));
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
}

TriangleMesh owl(double width, double height, double tuft, Rgb coat, Rgb face, Rgb belly) {
    Blob b(0.08);
    b.egg({0, height * 0.42, 0}, {width, height * 0.42, width * 0.85}, coat)
        .egg({0, height * 0.8, 0.02}, {width * 0.95, height * 0.28, width * 0.8}, coat)
        .egg({0, height * 0.4, width * 0.3}, {width * 0.72, height * 0.33, width * 0.62}, belly);
    Assembly a;
    a.add(b.mesh(48));
    for (const double side : {1.0, -1.0}) {
        const Vec3 eye{side * width * 0.42, height * 0.84, width * 0.66};
        a.add(ball(eye, {width * 0.4, width * 0.4, 0.08}, face))
            .add(ball(eye + Vec3{0, 0, 0.06}, {width * 0.2, width * 0.2, 0.05}, kMustard, 10))
            .add(ball(eye + Vec3{0, 0, 0.09}, {width * 0.11, width * 0.11, 0.04}, kInk, 8));
        a.add(tube({{{side * width * 0.55, height * 0.98, 0.05}, 0.09, 0.05},
                    {{side * width * 0.78, height * 1.02 + tuft, 0.02}, 0.015}},
                   coat));
        a.add(moved(turned_z(ball({0, 0, 0}, {width * 0.24, height * 0.33, width * 0.5}, darker(coat), 12), side * 8),
                    {side * width * 0.92, height * 0.44, -0.02}));
        for (const double toe : {-0.06, 0.0, 0.06})
            a.add(ball({side * width * 0.4 + toe, 0.03, width * 0.62}, {0.03, 0.035, 0.07}, kHoney, 8));
    }
    a.add(tube({{{0, height * 0.8, width * 0.78}, 0.05},
                {{0, height * 0.72, width * 0.92}, 0.035},
                {{0, height * 0.65, width * 0.88}, 0.01}},
               kHoney));
    a.add(moved(slab({{-0.1, 0.1}, {0.1, 0.1}, {0.13, -0.16}, {-0.13, -0.16}}, 0.06, 0.02, darker(coat)),
                {0, 0.06, -width * 0.5}));
    return a.mesh();
}

TriangleMesh penguin(double width, double height, double spread, Rgb coat, Rgb bib, bool crest) {
    Blob body(0.08);
    body.egg({0, height * 0.42, 0}, {width, height * 0.42, width * 0.9}, coat)
        .egg({0, height * 0.86, 0.02}, {width * 0.68, height * 0.19, width * 0.68}, coat)
        .egg({0, height * 0.4, width * 0.28}, {width * 0.8, height * 0.36, width * 0.72}, bib);
    Assembly a;
    a.add(body.mesh(48));
    for (const double side : {1.0, -1.0}) {
        a.add(moved(turned_z(ball({0, -height * 0.24, 0}, {0.07, height * 0.28, 0.13}, coat, 12), side * spread),
                    {side * width * 0.88, height * 0.62, 0}));
        a.add(ball({side * width * 0.45, 0.035, width * 0.45}, {0.14, 0.045, 0.2}, kOrange, 10))
            .add(ball({side * width * 0.3, height * 0.9, width * 0.6}, {0.075, 0.085, 0.03}, bib, 8))
            .add(ball({side * width * 0.3, height * 0.9, width * 0.68}, 0.034, kInk, 8));
        if (crest)
            a.add(tube({{{side * width * 0.4, height * 0.98, 0.12}, 0.03},
                        {{side * width * 0.85, height * 1.08, -0.02}, 0.01}},
                       kMustard));
    }
    a.add(beak({0, height * 0.84, width * 0.62}, {0, height * 0.81, width * 0.62 + 0.2}, 0.06, kOrange));
    return a.mesh();
}

TriangleMesh parrot(double tail, double crest, Rgb coat, Rgb wing, Rgb tail_colour) {
    Blob b(0.06);
    b.limb({-0.08, 0.36, 0}, {0.06, 0.68, 0}, 0.17, 0.15, coat).egg({0.1, 0.86, 0}, {0.16, 0.155, 0.14}, coat);
    Assembly a;
    a.add(b.mesh(50))
        .pair(ball({0.17, 0.9, 0.11}, {0.06, 0.06, 0.04}, kWhite, 8))
        .pair(ball({0.19, 0.9, 0.145}, 0.022, kInk, 8));
    a.add(tube({{{0.22, 0.9, 0}, 0.075, 0.06}, {{0.33, 0.86, 0}, 0.05}, {{0.34, 0.74, 0}, 0.012}}, kIvory));
    a.pair(moved(turned_z(ball({0, -0.2, 0}, {0.11, 0.3, 0.05}, wing, 12), -24), {-0.02, 0.7, 0.15}));
    a.add(tube({{{-0.12, 0.3, 0}, 0.09, 0.08},
                {{-0.2, 0.3 - tail * 0.5, 0}, 0.06, 0.08},
                {{-0.26, 0.3 - tail, 0}, 0.02, 0.03}},
               tail_colour));
    for (int k = 0; k < 3 && crest > 0; ++k)
        a.add(tube(
            {{{0.1 - 0.05 * k, 0.98, 0}, 0.035, 0.03}, {{0.04 - 0.1 * k, 1.0 + crest * (1.0 - 0.25 * k), 0}, 0.01}},
            wing));
    a.add(rod({-0.06, 0.16, -0.5}, {-0.06, 0.16, 0.5}, 0.05, kWood));
    for (const double z : {-0.09, 0.09}) a.add(ball({-0.02, 0.2, z}, {0.08, 0.035, 0.035}, kStone, 8));
    return facing_front(a.mesh());
}

void add_upright_birds(Models& models) {
    add_model(models, "owl", "Brown owl", owl(0.34, 0.8, 0.1, kTan, kCream, kIvory));
    add_model(models, "owl", "Snowy owl", owl(0.38, 0.78, 0.0, kWhite, kCream, kWhite));
    add_model(models, "owl", "Eagle owl", owl(0.36, 0.98, 0.18, kWalnut, kHoney, kSand));
    add_model(models, "penguin", "Emperor penguin", penguin(0.3, 1.0, 14, kInk, kCream, false));
    add_model(models, "penguin", "Little blue penguin", penguin(0.33, 0.78, 28, kBlue, kWhite, false));
    add_model(models, "penguin", "Rockhopper penguin", penguin(0.28, 0.85, 40, kSlate, kWhite, true));
    add_model(models, "parrot", "Scarlet macaw", parrot(0.75, 0.0, kRed, kBlue, kRed));
    add_model(models, "parrot", "Cockatoo", parrot(0.35, 0.24, kWhite, kStraw, kCream));
    add_model(models, "parrot", "Green parrot", parrot(0.5, 0.0, kLeaf, kForest, kTeal));
}

}  // namespace

void add_birds(Models& models) {
    add_songbirds(models);
    add_waterfowl(models);
    add_flamingos(models);
    add_upright_birds(models);
}

}  // namespace core::starter
