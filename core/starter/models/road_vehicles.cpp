// Cars, buses and bicycles. They are built narrow, like toys, so that the side is what one sees of them.

#include <cmath>
#include <numbers>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

TriangleMesh wheel(Vec3 at, double r, double width, Rgb hub = kSteel) {
    Assembly a;
    const double w = width / 2;
    a.add(moved(
        turned_x(lathe({{0, -w}, {r * 0.86, -w}, {r, -w * 0.6}, {r, w * 0.6}, {r * 0.86, w}, {0, w}}, kInk, 32), 90),
        at));
    a.add(rod(at - Vec3{0, 0, w + 0.012}, at + Vec3{0, 0, w + 0.012}, r * 0.52, hub, Cap::Flat));
    return a.mesh();
}

/// A body cut from its side view and narrowed towards the roof: z shrinks above `waist`.
TriangleMesh car_body(const std::vector<Point>& side, double width, double waist, double roof_share, Rgb colour,
                      int steps = 5) {
    double top = waist + 1e-6;
    for (const Point p : side) top = std::max(top, p.y);
    return bent(slab(closed_spline(side, steps), width, 0.045, colour), [=](Vec3 p) {
        const double t = std::max(0.0, (p.y - waist) / (top - waist));
        return Vec3{p.x, p.y, p.z * (1.0 - (1.0 - roof_share) * t)};
    });
}

struct Car {
    std::vector<Point> body;   ///< hull below the windows
    std::vector<Point> cabin;  ///< windows and roof
    double width = 0.8, wheel = 0.2, front = 0.62, rear = -0.62, roof = 0.72;
    Rgb paint = kRed;
};

TriangleMesh car(const Car& c) {
    Assembly a;
    a.add(car_body(c.body, c.width, 0.5, 0.94, c.paint));
    if (!c.cabin.empty()) {
        double waist = 1e9, top = 0.0, left = 1e9, right = -1e9;
        for (const Point p : c.cabin) {
            waist = std::min(waist, p.y);
            top = std::max(top, p.y);
            left = std::min(left, p.x);
            right = std::max(right, p.x);
        }
        const double post = left + (right - left) * 0.48;
        a.add(painted(car_body(c.cabin, c.width * 0.94, waist, c.roof, kGlass, 7),
                      [&](Vec3 p, Rgb glass) { return p.y > waist + (top - waist) * 0.86 ? c.paint : glass; }));
        for (const double z : {1.0, -1.0})
            a.add(tube({{{post, waist, z * c.width * 0.455}, 0.028, 0.03},
                        {{post, top - 0.02, z * c.width * 0.47 * c.roof}, 0.028, 0.03}},
                       c.paint, {.sides = 8}));
    }
    double nose = 0.0, tail = 0.0, nose_y = 0.3;
    for (const Point p : c.body) {
        if (p.x > nose) nose_y = p.y;
        nose = std::max(nose, p.x);
        tail = std::min(tail, p.x);
    }
    a.pair(ball({nose - 0.02, nose_y + 0.06, c.width * 0.33}, {0.05, 0.065, 0.08}, kCream, 10))
        .pair(ball({tail + 0.02, nose_y + 0.08, c.width * 0.34}, {0.04, 0.05, 0.07}, kRed, 8));
    a.add(box({nose - 0.02, 0.22, 0}, {0.08, 0.09, c.width * 0.9}, 0.035, kSteel))
        .add(box({tail + 0.02, 0.22, 0}, {0.08, 0.09, c.width * 0.9}, 0.035, kSteel));
    for (const double x : {c.front, c.rear})
        a.pair(wheel({x, c.wheel * 0.85, c.width / 2 - 0.03}, c.wheel * 1.15, 0.18));
    return narrow(a.mesh(), 0.35);
}

void add_cars(Models& models) {
    const std::vector<Point> saloon{{-1.0, 0.22}, {-0.98, 0.48}, {-0.6, 0.56}, {0.0, 0.56}, {0.5, 0.54},
                                    {0.9, 0.44},  {0.98, 0.22},  {0.5, 0.16},  {-0.5, 0.16}};
    add_model(models, "car", "Family car",
              car({.body = saloon,
                   .cabin = {{-0.72, 0.5}, {-0.5, 0.84}, {-0.1, 0.9}, {0.2, 0.84}, {0.48, 0.5}},
                   .paint = kBlue}));
    add_model(models, "car", "Beetle",
              car({.body = {{-0.88, 0.2},
                            {-0.9, 0.36},
                            {-0.66, 0.58},
                            {0.0, 0.6},
                            {0.5, 0.58},
                            {0.82, 0.42},
                            {0.86, 0.2},
                            {0.4, 0.15},
                            {-0.4, 0.15}},
                   .cabin = {{-0.66, 0.5}, {-0.42, 0.88}, {-0.02, 1.0}, {0.3, 0.86}, {0.44, 0.5}},
                   .wheel = 0.19,
                   .front = 0.54,
                   .rear = -0.54,
                   .paint = kMint}));
    add_model(models, "car", "Sports car",
              car({.body = {{-1.05, 0.2},
                            {-1.05, 0.42},
                            {-0.6, 0.5},
                            {0.0, 0.44},
                            {0.6, 0.4},
                            {1.05, 0.3},
                            {1.12, 0.18},
                            {0.5, 0.13},
                            {-0.5, 0.13}},
                   .cabin = {{-0.68, 0.42}, {-0.38, 0.66}, {-0.05, 0.69}, {0.4, 0.4}},
                   .wheel = 0.19,
                   .front = 0.68,
                   .rear = -0.66,
                   .paint = kRed}));
    add_model(models, "car", "Off-roader",
              car({.body = {{-0.92, 0.3},
                            {-0.92, 0.68},
                            {-0.4, 0.7},
                            {0.3, 0.7},
                            {0.82, 0.66},
                            {0.88, 0.3},
                            {0.5, 0.26},
                            {-0.5, 0.26}},
                   .cabin = {{-0.86, 0.64}, {-0.82, 1.06}, {-0.3, 1.1}, {0.18, 1.06}, {0.36, 0.64}},
                   .wheel = 0.25,
                   .front = 0.56,
                   .rear = -0.58,
                   .roof = 0.88,
                   .paint = kForest}));
    add_model(models, "car", "Small hatchback",
              car({.body = {{-0.74, 0.22},
                            {-0.76, 0.5},
                            {-0.4, 0.56},
                            {0.2, 0.56},
                            {0.66, 0.44},
                            {0.72, 0.22},
                            {0.3, 0.16},
                            {-0.3, 0.16}},
                   .cabin = {{-0.72, 0.5}, {-0.62, 0.9}, {-0.2, 0.96}, {0.14, 0.88}, {0.44, 0.5}},
                   .wheel = 0.17,
                   .front = 0.46,
                   .rear = -0.48,
                   .paint = kMustard}));
    add_model(models, "car", "Open roadster",
              car({.body = {{-1.0, 0.2},
                            {-1.02, 0.46},
                            {-0.55, 0.56},
                            {-0.3, 0.46},
                            {0.05, 0.46},
                            {0.2, 0.55},
                            {0.75, 0.5},
                            {1.0, 0.36},
                            {1.04, 0.2},
                            {0.4, 0.14},
                            {-0.4, 0.14}},
                   .cabin = {},
                   .front = 0.64,
                   .rear = -0.62,
                   .paint = kWine}));
}

TriangleMesh bus(double length, double height, int windows, Rgb paint, bool snout, bool double_deck) {
    Assembly a;
    const double h = length / 2, deck = 0.26;
    const double back = snout ? h - 0.42 : h;
    a.add(box_between({-h, deck, -0.38}, {back, deck + height, 0.38}, 0.09, paint));
    if (snout) a.add(box_between({back - 0.1, deck, -0.34}, {h, deck + height * 0.46, 0.34}, 0.08, paint));
    a.add(box_between({back - 0.05, deck + height * 0.52, -0.31}, {back + 0.012, deck + height * 0.88, 0.31}, 0.03,
                      kGlass));
    const int decks = double_deck ? 2 : 1;
    const double pitch = (back + h - 0.3) / windows;
    for (int d = 0; d < decks; ++d)
        for (int k = 0; k < windows; ++k) {
            const double x = -h + 0.2 + pitch * (k + 0.42), y = deck + height * (double_deck ? 0.4 + 0.38 * d : 0.66);
            a.pair(box({x, y, 0.375}, {pitch * 0.78, height * (double_deck ? 0.2 : 0.3), 0.03}, 0.012, kGlass));
        }
    a.pair(box({0, deck + height * 0.2, 0.38}, {length * 0.9, 0.05, 0.02}, 0.008, darker(paint, 0.45)));
    a.pair(ball({h, deck + 0.16, 0.26}, {0.03, 0.06, 0.06}, kCream, 8));
    for (const double x : {h * 0.62, -h * 0.6}) a.pair(wheel({x, 0.17, 0.34}, 0.23, 0.18));
    return narrow(a.mesh(), 0.4);
}

void add_buses(Models& models) {
    add_model(models, "bus", "City bus", bus(2.3, 0.8, 6, kCoral, false, false));
    add_model(models, "bus", "Double-decker", bus(1.9, 1.25, 5, kRed, false, true));
    add_model(models, "bus", "Minibus", bus(1.5, 0.75, 3, kTeal, true, false));
    add_model(models, "bus", "Long coach", bus(2.7, 0.85, 7, kNavy, false, false));
    add_model(models, "bus", "School bus", bus(2.2, 0.85, 5, kMustard, true, false));
}

struct Bicycle {
    double wheel = 0.34, front_wheel = 0.34, base = 1.0, seat = 0.86, bar = 0.95;
    bool drop_bar = false, basket = false;
    double tyre = 0.025;
    Rgb frame = kTeal, saddle = kWalnut;
};

TriangleMesh spoked_wheel(Vec3 at, double r, double tyre, Rgb rim) {
    Assembly a;
    a.add(ring(at, {0, 0, 1}, r, tyre, kInk, 40)).add(ring(at, {0, 0, 1}, r - tyre * 1.2, tyre * 0.5, rim, 32));
    for (int k = 0; k < 10; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 10;
        a.add(tube({{at, 0.006}, {at + Vec3{std::cos(angle) * r, std::sin(angle) * r, 0}, 0.006}}, kSteel,
                   {.sides = 5, .cap = Cap::Flat}));
    }
    a.add(rod(at - Vec3{0, 0, 0.05}, at + Vec3{0, 0, 0.05}, 0.03, kSteel));
    return a.mesh();
}

TriangleMesh bicycle(const Bicycle& b) {
    Assembly a;
    const Vec3 rear{-b.base / 2, b.wheel, 0}, front{b.base / 2, b.front_wheel, 0};
    const Vec3 crank{-0.08, b.wheel * 0.85, 0}, saddle{-0.22, b.seat, 0}, head{b.base * 0.5 - 0.17, b.bar - 0.14, 0};
    const Vec3 seat_tube = crank + (saddle - crank) * 0.82;
    const double r = 0.024;
    a.add(spoked_wheel(rear, b.wheel, b.tyre, kSteel)).add(spoked_wheel(front, b.front_wheel, b.tyre, kSteel));
    a.add(rod(crank, seat_tube, r, b.frame))
        .add(rod(crank, head - Vec3{-0.02, 0.08, 0}, r * 1.15, b.frame))
        .add(rod(seat_tube, head, r, b.frame));
    a.pair(rod(rear + Vec3{0, 0, 0.05}, crank + Vec3{0, 0, 0.03}, 0.014, b.frame))
        .pair(rod(rear + Vec3{0, 0, 0.05}, seat_tube + Vec3{0, 0, 0.02}, 0.014, b.frame))
        .pair(rod(front + Vec3{0, 0, 0.05}, head + Vec3{0.02, -0.1, 0.04}, 0.016, b.frame));
    a.add(rod(head - Vec3{-0.03, 0.12, 0}, head + Vec3{-0.04, 0.14, 0}, 0.026, b.frame))
        .add(rod(seat_tube, saddle, 0.018, kSteel));
    a.add(tube({{saddle + Vec3{-0.12, 0.03, 0}, 0.03, 0.075},
                {saddle + Vec3{-0.02, 0.025, 0}, 0.028, 0.06},
                {saddle + Vec3{0.14, 0.02, 0}, 0.02, 0.022}},
               b.saddle));
    const Vec3 stem = head + Vec3{-0.04, 0.14, 0};
    if (b.drop_bar)
        a.pair(tube({{stem, 0.018},
                     {stem + Vec3{0.03, 0.0, 0.18}, 0.018},
                     {stem + Vec3{0.14, -0.02, 0.2}, 0.018},
                     {stem + Vec3{0.14, -0.13, 0.2}, 0.018},
                     {stem + Vec3{0.02, -0.15, 0.2}, 0.02}},
                    kInk));
    else
        a.pair(tube({{stem, 0.018},
                     {stem + Vec3{0.04, 0.05, 0.14}, 0.018},
                     {stem + Vec3{-0.06, 0.06, 0.24}, 0.018},
                     {stem + Vec3{-0.18, 0.04, 0.26}, 0.024}},
                    kInk));
    a.add(ring(crank, {0, 0, 1}, 0.085, 0.014, kSlate, 24))
        .add(rod(crank + Vec3{0, 0, 0.05}, crank + Vec3{0.13, -0.1, 0.05}, 0.014, kSteel))
        .add(rod(crank - Vec3{0, 0, 0.05}, crank + Vec3{-0.13, 0.1, -0.05}, 0.014, kSteel));
    a.add(box(crank + Vec3{0.13, -0.1, 0.1}, {0.1, 0.025, 0.08}, 0.01, kInk))
        .add(box(crank + Vec3{-0.13, 0.1, -0.1}, {0.1, 0.025, 0.08}, 0.01, kInk));
    if (b.basket)
        a.add(moved(lathe({{0, 0}, {0.12, 0}, {0.17, 0.2}, {0.15, 0.2}, {0.1, 0.02}, {0, 0.02}}, kHoney, 20),
                    stem + Vec3{0.2, -0.14, 0}));
    return narrow(a.mesh(), 0.7);
}

void add_bicycles(Models& models) {
    add_model(models, "bicycle", "City bicycle", bicycle({.wheel = 0.3, .front_wheel = 0.3, .base = 1.1}));
    add_model(models, "bicycle", "Racing bicycle",
              bicycle({.wheel = 0.31,
                       .front_wheel = 0.31,
                       .base = 1.1,
                       .seat = 0.96,
                       .bar = 0.92,
                       .drop_bar = true,
                       .tyre = 0.016,
                       .frame = kRed,
                       .saddle = kInk}));
    add_model(models, "bicycle", "Shopper with basket",
              bicycle({.wheel = 0.26,
                       .front_wheel = 0.26,
                       .base = 1.1,
                       .seat = 0.82,
                       .bar = 1.02,
                       .basket = true,
                       .frame = kMint,
                       .saddle = kHoney}));
    add_model(models, "bicycle", "Mountain bike",
              bicycle({.wheel = 0.31,
                       .front_wheel = 0.31,
                       .base = 1.2,
                       .seat = 0.82,
                       .bar = 0.9,
                       .tyre = 0.05,
                       .frame = kOrange,
                       .saddle = kInk}));
    add_model(models, "bicycle", "Folding bicycle",
              bicycle({.wheel = 0.21,
                       .front_wheel = 0.21,
                       .base = 1.0,
                       .seat = 0.86,
                       .bar = 0.98,
                       .tyre = 0.03,
                       .frame = kPlum,
                       .saddle = kSlate}));
}

}  // namespace

void add_road_vehicles(Models& models) {
    add_cars(models);
    add_buses(models);
    add_bicycles(models);
}

}  // namespace core::starter
