// Airplanes and helicopters.

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

/// A wing in the plane y = 0 from z = 0 to its tip, given by where its chord starts and ends (x) at root and tip.
struct Wing {
    double root_front, root_back, tip_front, tip_back, span;
    double thickness = 0.05;
};

TriangleMesh flat_wing(const Wing& w, Rgb colour) {
    const double chord = w.tip_front - w.tip_back;
    const std::vector<Point> outline{{w.root_back, 0.0},
                                     {w.tip_back, w.span * 0.97},
                                     {w.tip_back + chord * 0.15, w.span},
                                     {w.tip_front - chord * 0.3, w.span},
                                     {w.tip_front, w.span * 0.94},
                                     {w.root_front, 0.0}};
    return turned_x(slab(outline, w.thickness, w.thickness * 0.35, colour), 90);
}

TriangleMesh propeller(Vec3 hub, double radius, int blades, Rgb colour) {
    Assembly a;
    for (int k = 0; k < blades; ++k)
        a.add(turned_x(
            tube({{{0, 0, 0}, 0.02, 0.025}, {{0, radius * 0.6, 0}, 0.022, 0.06}, {{0, radius, 0}, 0.015, 0.03}},
                 colour),
            360.0 * k / blades + 20));
    a.add(tube({{{-0.04, 0, 0}, 0.06}, {{0.05, 0, 0}, 0.045}, {{0.1, 0, 0}, 0.02}}, kInk));
    return moved(a.mesh(), hub);
}

TriangleMesh wheel(Vec3 at, double r) {
    Assembly a;
    a.add(rod(at - Vec3{0, 0, 0.03}, at + Vec3{0, 0, 0.03}, r, kInk, Cap::Flat));
    a.add(rod(at - Vec3{0, 0, 0.035}, at + Vec3{0, 0, 0.035}, r * 0.5, kSteel, Cap::Flat));
    return a.mesh();
}

struct Jet {
    double length = 2.2, radius = 0.17;
    Wing wing{0.35, -0.2, -0.25, -0.48, 1.15, 0.06};
    Wing tail{-0.8, -1.02, -1.05, -1.2, 0.42, 0.04};
    double fin = 0.5;
    int engines_a_side = 1;
    Rgb body = kWhite, accent = kBlue;
};

TriangleMesh jet(const Jet& j) {
    Assembly a;
    const double h = j.length / 2, r = j.radius;
    a.add(painted(tube({{{-h, r * 0.55, 0}, r * 0.18},
                        {{-h * 0.72, r * 0.3, 0}, r * 0.62},
                        {{-h * 0.35, 0, 0}, r},
                        {{h * 0.6, 0, 0}, r},
                        {{h * 0.85, -r * 0.08, 0}, r * 0.78},
                        {{h, -r * 0.25, 0}, r * 0.3}},
                       j.body, {.sides = 24, .steps = 10}),
                  [&](Vec3 p, Rgb c) {
                      if (p.x > h * 0.8 && p.x < h * 0.92 && p.y > r * 0.2) return kNavy;
                      return p.y < -r * 0.35 ? mixed(c, j.accent, 0.9) : c;
                  }));
    a.pair(moved(turned_x(flat_wing(j.wing, kSteel), -5), {0, -r * 0.4, 0}));
    a.pair(moved(flat_wing(j.tail, kSteel), {0, r * 0.4, 0}));
    a.add(slab({{-h * 0.62, r * 0.5}, {-h * 0.88, r + j.fin}, {-h * 1.03, r + j.fin}, {-h * 0.95, r * 0.4}}, 0.06, 0.02,
               j.accent));
    for (int k = 0; k < j.engines_a_side; ++k) {
        const double z = j.wing.span * (0.34 + 0.28 * k),
                     x = j.wing.root_front + (j.wing.tip_front - j.wing.root_front) * z / j.wing.span;
        a.pair(tube(
            {{{x - 0.28, -r * 0.95, z}, 0.05}, {{x - 0.05, -r * 0.95, z}, 0.085}, {{x + 0.12, -r * 0.95, z}, 0.08}},
            j.accent, {.cap = Cap::Flat}));
        a.pair(rod({x + 0.121, -r * 0.95, z}, {x + 0.13, -r * 0.95, z}, 0.065, kInk, Cap::Flat));
        a.pair(box({x - 0.12, -r * 0.55, z}, {0.2, 0.1, 0.04}, 0.015, kSteel));
    }
    for (int k = -5; k <= 5; ++k) a.pair(ball({k * h * 0.1, r * 0.22, r * 0.95}, {0.025, 0.032, 0.015}, kNavy, 6));
    return facing_front(a.mesh());
}

struct PropellerPlane {
    double length = 1.5, radius = 0.19, span = 1.0, chord = 0.42, wing_height = 0.16;
    bool floats = false;
    Rgb body = kRed, wing = kCream;
};

void add_gear(Assembly& a, const PropellerPlane& p, double nose) {
    const double r = p.radius;
    if (p.floats) {
        a.pair(tube({{{-0.55, -r - 0.22, 0.3}, 0.04},
                     {{-0.1, -r - 0.24, 0.3}, 0.085},
                     {{0.4, -r - 0.24, 0.3}, 0.085},
                     {{0.7, -r - 0.16, 0.3}, 0.03}},
                    p.wing));
        a.pair(rod({0.15, -r * 0.5, 0.1}, {0.3, -r - 0.2, 0.3}, 0.022, kSlate))
            .pair(rod({-0.15, -r * 0.5, 0.1}, {-0.15, -r - 0.2, 0.3}, 0.022, kSlate));
        return;
    }
    a.pair(rod({nose * 0.42, -r * 0.6, 0.08}, {nose * 0.5, -r - 0.18, 0.24}, 0.022, kSlate));
    a.pair(wheel({nose * 0.5, -r - 0.2, 0.27}, 0.1));
    a.add(wheel({-p.length * 0.47, -r * 0.35, 0}, 0.05));
}

TriangleMesh propeller_plane(const PropellerPlane& p) {
    Assembly a;
    const double h = p.length / 2, r = p.radius;
    a.add(tube({{{-h, r * 0.25, 0}, r * 0.2},
                {{-h * 0.4, r * 0.05, 0}, r * 0.68},
                {{h * 0.2, 0, 0}, r},
                {{h * 0.75, 0, 0}, r * 0.9},
                {{h * 0.92, 0, 0}, r * 0.6}},
               p.body, {.sides = 22, .steps = 8}));
    a.add(propeller({h * 1.02, 0, 0}, r * 1.7, 3, kWood));
    a.add(ball({h * 0.12, r * 0.75, 0}, {r * 1.25, r * 0.75, r * 0.62}, kGlass));
    const Wing wing{h * 0.42, h * 0.42 - p.chord, h * 0.36, h * 0.4 - p.chord * 0.85, p.span, 0.07};
    a.pair(moved(flat_wing(wing, p.wing), {0, p.wing_height, 0}));
    a.pair(moved(flat_wing({-h * 0.72, -h * 1.02, -h * 0.82, -h * 1.04, 0.38, 0.045}, p.wing), {0, r * 0.3, 0}));
    a.add(slab(closed_spline({{-h * 0.6, r * 0.3},
                              {-h * 0.78, r + 0.14},
                              {-h * 0.95, r + 0.28},
                              {-h * 1.08, r + 0.2},
                              {-h * 1.06, r * 0.2}},
                             4),
               0.05, 0.015, p.body));
    add_gear(a, p, h);
    return facing_front(a.mesh());
}

struct ToyPlane {
    double length = 1.4, radius = 0.26, span = 0.8, chord = 0.44, sweep = 0.18;
    Rgb body = kSky, wing = kCoral;
};

/// A stout body, two broad wings, a small tail: an airplane as it is drawn.
TriangleMesh toy_plane(const ToyPlane& p) {
    Assembly a;
    const double h = p.length / 2, r = p.radius;
    a.add(tube({{{-h, 0.05, 0}, r * 0.25},
                {{-h * 0.5, 0.02, 0}, r * 0.75},
                {{h * 0.2, 0, 0}, r},
                {{h * 0.75, 0, 0}, r * 0.85},
                {{h * 0.97, 0, 0}, r * 0.4}},
               p.body, {.sides = 22, .steps = 8}));
    const double front = h * 0.1 + p.chord / 2;
    a.pair(
        flat_wing({front, front - p.chord, front - p.sweep, front - p.sweep - p.chord * 0.75, p.span, 0.08}, p.wing));
    a.pair(flat_wing({-h * 0.7, -h, -h * 0.85, -h * 1.05, 0.36, 0.06}, p.wing));
    a.add(slab(closed_spline({{-h * 0.65, r * 0.3}, {-h * 0.95, r + 0.2}, {-h * 1.08, r + 0.18}, {-h, r * 0.1}}, 4),
               0.06, 0.02, p.wing));
    for (int k = -2; k <= 2; ++k) a.pair(ball({h * 0.16 * k, r * 0.35, r * 0.86}, {0.05, 0.05, 0.03}, kNavy, 8));
    a.add(ball({h * 0.72, r * 0.45, 0}, {0.16, 0.11, r * 0.7}, kGlass, 12));
    return facing_front(a.mesh());
}

TriangleMesh fighter(Rgb body, Rgb accent) {
    Assembly a;
    a.add(tube({{{-0.95, 0, 0}, 0.12},
                {{-0.5, 0, 0}, 0.15},
                {{0.2, 0, 0}, 0.14},
                {{0.75, -0.02, 0}, 0.1},
                {{1.25, -0.05, 0}, 0.015}},
               body, {.sides = 20}));
    a.add(rod({-1.08, 0, 0}, {-0.9, 0, 0}, 0.1, kInk, Cap::Flat));
    a.add(ball({0.45, 0.11, 0}, {0.28, 0.1, 0.08}, kGlass));
    a.pair(flat_wing({0.35, -0.8, -0.55, -0.85, 0.85, 0.05}, body));
    a.pair(moved(flat_wing({-0.7, -1.0, -1.0, -1.15, 0.45, 0.04}, accent), {0, 0.02, 0}));
    a.add(slab({{-0.35, 0.1}, {-0.85, 0.55}, {-1.05, 0.55}, {-0.95, 0.08}}, 0.05, 0.015, accent));
    a.pair(tube({{{-0.1, -0.07, 0.45}, 0.03}, {{0.2, -0.07, 0.45}, 0.035}, {{0.32, -0.07, 0.45}, 0.005}}, accent));
    return facing_front(a.mesh());
}

void add_airplanes(Models& models) {
    add_model(models, "airplane", "Airliner", jet({}));
    Jet jumbo;
    jumbo.length = 2.5;
    jumbo.radius = 0.23;
    jumbo.engines_a_side = 2;
    jumbo.wing = {0.45, -0.25, -0.45, -0.68, 1.35, 0.07};
    jumbo.tail = {-0.9, -1.15, -1.2, -1.35, 0.52, 0.05};
    jumbo.fin = 0.62;
    jumbo.accent = kCoral;
    add_model(models, "airplane", "Jumbo jet", jet(jumbo));
    add_model(models, "airplane", "Little propeller plane", propeller_plane({}));
    add_model(models, "airplane", "Toy airplane", toy_plane({}));
    add_model(
        models, "airplane", "Wooden airplane",
        toy_plane(
            {.length = 1.5, .radius = 0.22, .span = 0.95, .chord = 0.36, .sweep = 0.0, .body = kHoney, .wing = kTeal}));
    add_model(models, "airplane", "Fighter jet", fighter(kSlate, kBrick));
    PropellerPlane seaplane;
    seaplane.floats = true;
    seaplane.wing_height = 0.26;
    seaplane.span = 1.15;
    seaplane.length = 1.7;
    seaplane.body = kMustard;
    seaplane.wing = kWhite;
    add_model(models, "airplane", "Seaplane", propeller_plane(seaplane));
}

struct Helicopter {
    double cabin = 0.42, height = 0.38, boom = 1.1, rotor = 1.15;
    int blades = 2;
    bool skids = true, twin = false;
    Rgb body = kRed, accent = kWhite;
};

void add_rotor(Assembly& a, Vec3 at, double radius, int blades) {
    a.add(rod(at - Vec3{0, 0.16, 0}, at + Vec3{0, 0.03, 0}, 0.035, kSlate)).add(ball(at, {0.09, 0.04, 0.09}, kInk, 8));
    for (int k = 0; k < blades; ++k)
        a.add(moved(turned_y(box({radius / 2, 0, 0}, {radius, 0.03, 0.1}, 0.013, kInk), 360.0 * k / blades), at));
}

TriangleMesh helicopter(const Helicopter& h) {
    Assembly a;
    a.add(painted(ball({0, 0, 0}, {h.cabin * 1.25, h.height, h.height * 0.85}, h.body, 20),
                  [&](Vec3 p, Rgb c) { return p.x > h.cabin * 0.35 && p.y > -h.height * 0.25 ? kGlass : c; }));
    a.pair(ball({0.0, h.height * 0.25, h.height * 0.74}, {h.cabin * 0.32, h.height * 0.34, 0.06}, kGlass, 8));
    const double end = -h.cabin * 0.8 - h.boom;
    if (h.twin) {
        a.add(tube({{{-h.cabin * 0.5, 0.02, 0}, h.height * 0.9, h.height * 0.8},
                    {{end * 0.7, 0.05, 0}, h.height * 0.88, h.height * 0.75},
                    {{end, 0.2, 0}, h.height * 0.6, h.height * 0.5}},
                   h.body, {.sides = 20}));
        a.add(box({end, h.height + 0.2, 0}, {0.35, 0.5, 0.22}, 0.08, h.accent));
        add_rotor(a, {end, h.height + 0.6, 0}, h.rotor, h.blades);
    } else {
        a.add(tube({{{-h.cabin * 0.5, h.height * 0.2, 0}, h.height * 0.6},
                    {{-h.cabin * 1.25, h.height * 0.3, 0}, 0.13},
                    {{end, h.height * 0.42, 0}, 0.055}},
                   h.body));
        a.add(slab({{end + 0.2, h.height * 0.42},
                    {end - 0.02, h.height * 0.42 + 0.42},
                    {end - 0.2, h.height * 0.42 + 0.42},
                    {end - 0.06, h.height * 0.36},
                    {end - 0.1, h.height * 0.1},
                    {end, h.height * 0.1}},
                   0.05, 0.015, h.accent));
        for (const double turn : {30.0, 120.0})
            a.add(moved(turned_z(box({0, 0, 0}, {0.42, 0.05, 0.02}, 0.009, kInk), turn), {end, h.height * 0.45, 0.08}));
    }
    add_rotor(a, {0, h.height + 0.17, 0}, h.rotor, h.blades);
    if (h.skids) {
        a.pair(tube({{{-h.cabin * 1.0, -h.height - 0.2, 0.3}, 0.028},
                     {{0, -h.height - 0.2, 0.3}, 0.028},
                     {{h.cabin * 0.9, -h.height - 0.2, 0.3}, 0.028},
                     {{h.cabin * 1.25, -h.height - 0.1, 0.3}, 0.028}},
                    kSlate));
        for (const double x : {-h.cabin * 0.55, h.cabin * 0.5})
            a.pair(rod({x, -h.height * 0.6, 0.15}, {x, -h.height - 0.2, 0.3}, 0.024, kSlate));
    } else {
        a.pair(wheel({-h.cabin * 0.6, -h.height - 0.02, 0.24}, 0.11))
            .add(wheel({h.cabin * 0.85, -h.height * 0.85, 0}, 0.09));
    }
    return facing_front(a.mesh());
}

void add_helicopters(Models& models) {
    add_model(models, "helicopter", "Rescue helicopter", helicopter({}));
    add_model(models, "helicopter", "Bubble helicopter",
              helicopter({.cabin = 0.34,
                          .height = 0.4,
                          .boom = 0.9,
                          .rotor = 0.95,
                          .blades = 2,
                          .body = kMustard,
                          .accent = kTeal}));
    add_model(
        models, "helicopter", "Police helicopter",
        helicopter(
            {.cabin = 0.5, .height = 0.34, .boom = 1.2, .rotor = 1.2, .blades = 4, .body = kNavy, .accent = kWhite}));
    add_model(models, "helicopter", "Transport helicopter",
              helicopter({.cabin = 0.5,
                          .height = 0.36,
                          .boom = 1.3,
                          .rotor = 0.95,
                          .blades = 3,
                          .skids = false,
                          .twin = true,
                          .body = kOlive,
                          .accent = kForest}));
    add_model(models, "helicopter", "Toy helicopter",
              helicopter({.cabin = 0.42,
                          .height = 0.48,
                          .boom = 0.6,
                          .rotor = 0.8,
                          .blades = 3,
                          .skids = false,
                          .body = kSky,
                          .accent = kCoral}));
}

}  // namespace

void add_aircraft(Models& models) {
    add_airplanes(models);
    add_helicopters(models);
}

}  // namespace core::starter
