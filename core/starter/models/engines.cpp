// Trains, tractors and motorbikes.

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

TriangleMesh wheel(Vec3 at, double r, double width, Rgb tyre, Rgb hub) {
    Assembly a;
    const double w = width / 2;
    a.add(moved(turned_x(lathe({{0, -w}, {r * 0.86, -w}, {r, -w * 0.6}, {r, w * 0.6}, {r * 0.86, w}, {0, w}}, tyre, 32),
                         90),
                at))
        .add(rod(at - Vec3{0, 0, w + 0.012}, at + Vec3{0, 0, w + 0.012}, r * 0.55, hub, Cap::Flat))
        .add(rod(at - Vec3{0, 0, w + 0.03}, at + Vec3{0, 0, w + 0.03}, r * 0.14, kBrass, Cap::Flat));
    return a.mesh();
}

TriangleMesh locomotive(double boiler, double r, double chimney, int drivers, Rgb paint, Rgb cab, bool tender) {
    Assembly a;
    const double axle = 0.24, base = 0.3;
    a.add(box_between({-0.72, base - 0.02, -0.3}, {boiler + 0.12, base + 0.08, 0.3}, 0.03, kSlate))
        .add(rod({-0.3, base + 0.12 + r, 0}, {boiler, base + 0.12 + r, 0}, r, paint, Cap::Flat))
        .add(rod({boiler, base + 0.12 + r, 0}, {boiler + 0.06, base + 0.12 + r, 0}, r * 0.9, kSlate));
    for (const double x : {-0.05, boiler * 0.45, boiler * 0.85})
        a.add(rod({x, base + 0.12 + r, 0}, {x + 0.04, base + 0.12 + r, 0}, r * 1.03, kBrass, Cap::Flat));
    const double top = base + 0.12 + 2 * r;
    a.add(moved(lathe({{0, -0.06},
                       {0.07, -0.06},
                       {0.06, chimney * 0.55},
                       {0.13, chimney},
                       {0.1, chimney},
                       {0, chimney - 0.03}},
                      kInk, 24),
                {boiler * 0.84, top, 0}))
        .add(moved(lathe_smooth({{0.11, -0.06}, {0.11, 0.08}, {0.07, 0.15}, {0, 0.17}}, kBrass, 20),
                   {boiler * 0.4, top, 0}));
    a.add(box_between({-0.74, base + 0.06, -0.32}, {-0.26, base + 0.62, 0.32}, 0.03, cab));
    for (const double x : {-0.7, -0.3}) a.pair(box({x, base + 0.75, 0.29}, {0.07, 0.3, 0.05}, 0.015, cab));
    a.add(box({-0.5, base + 0.92, 0}, {0.66, 0.07, 0.76}, 0.03, kSlate));
    for (int k = 0; k < drivers; ++k) a.pair(wheel({-0.5 + 0.46 * k, axle, 0.27}, 0.24, 0.07, kInk, paint));
    a.pair(wheel({boiler - 0.04, 0.15, 0.26}, 0.15, 0.07, kInk, paint))
        .pair(box({-0.5 + 0.23 * (drivers - 1), axle, 0.33}, {0.46 * (drivers - 1) + 0.1, 0.05, 0.03}, 0.012, kSteel));
    a.add(slab({{boiler + 0.08, base + 0.05}, {boiler + 0.08, 0.05}, {boiler + 0.36, 0.05}}, 0.5, 0.02, kRed))
        .add(ball({boiler + 0.08, top - 0.05, 0}, 0.07, kStraw, 10));
    if (tender) {
        a.add(box_between({-1.6, base, -0.3}, {-0.82, base + 0.42, 0.3}, 0.03, paint))
            .add(ball({-1.2, base + 0.42, 0}, {0.34, 0.12, 0.24}, kInk, 12))
            .add(rod({-0.9, base, 0}, {-0.7, base, 0}, 0.03, kSlate));
        for (const double x : {-1.42, -1.0}) a.pair(wheel({x, 0.17, 0.27}, 0.17, 0.07, kInk, paint));
    }
    return facing_front(a.mesh());
}

TriangleMesh express(Rgb paint, Rgb stripe) {
    Assembly a;
    a.add(slab({{-1.3, 0.22}, {-1.3, 0.92}, {0.6, 0.92}, {0.82, 0.86}, {1.06, 0.62}, {1.3, 0.34}, {1.3, 0.22}}, 0.66,
               0.07, paint))
        .pair(box({-0.25, 0.42, 0.33}, {2.0, 0.1, 0.03}, 0.012, stripe));
    for (int k = 0; k < 6; ++k) a.pair(box({-1.08 + 0.3 * k, 0.68, 0.33}, {0.22, 0.2, 0.03}, 0.012, kGlass));
    a.add(moved(turned_z(box({0, 0, 0}, {0.3, 0.04, 0.5}, 0.018, kGlass), -46), {0.96, 0.74, 0}));
    for (const double x : {-1.0, -0.65, 0.55, 0.9}) a.pair(wheel({x, 0.14, 0.25}, 0.14, 0.07, kInk, kSteel));
    a.add(rod({-0.3, 0.92, 0}, {-0.1, 1.1, 0}, 0.02, kSlate))
        .add(rod({-0.1, 1.1, -0.2}, {-0.1, 1.1, 0.2}, 0.02, kSlate))
        .add(rod({-0.1, 1.1, 0}, {-0.3, 1.0, 0}, 0.015, kSlate));
    return facing_front(a.mesh());
}

TriangleMesh tractor(double rear, double front, double length, bool cab, Rgb paint, Rgb hub) {
    Assembly a;
    a.add(box_between({-0.2, rear * 0.75, -0.2}, {length, rear * 0.75 + 0.42, 0.2}, 0.07, paint))
        .add(box({length, rear * 0.75 + 0.2, 0}, {0.05, 0.3, 0.3}, 0.02, kSlate))
        .pair(ball({length + 0.02, rear * 0.75 + 0.3, 0.13}, 0.05, kCream, 8));
    a.pair(wheel({-0.35, rear, 0.36}, rear, 0.24, kInk, hub))
        .pair(wheel({length - 0.18, front, 0.32}, front, 0.16, kInk, hub));
    a.add(box({-0.35, rear * 1.05, 0}, {0.5, 0.36, 0.44}, 0.05, paint))
        .add(rod({length * 0.62, rear * 0.75 + 0.4, 0.1}, {length * 0.62, rear * 0.75 + 0.85, 0.1}, 0.035, kInk,
                 Cap::Flat))
        .add(rod({length * 0.62, rear * 0.75 + 0.45, 0.1}, {length * 0.62, rear * 0.75 + 0.68, 0.1}, 0.055, kSlate));
    const double deck = rear * 1.05 + 0.16;
    if (cab) {
        a.add(box({-0.32, deck + 0.36, 0}, {0.56, 0.62, 0.52}, 0.05, kGlass))
            .add(box({-0.32, deck + 0.7, 0}, {0.72, 0.08, 0.64}, 0.035, paint));
        for (const double x : {-0.58, -0.06}) a.pair(box({x, deck + 0.36, 0.25}, {0.05, 0.66, 0.05}, 0.015, paint));
    } else {
        a.add(box({-0.4, deck + 0.1, 0}, {0.3, 0.08, 0.34}, 0.035, kWalnut))
            .add(box({-0.54, deck + 0.24, 0}, {0.07, 0.28, 0.34}, 0.03, kWalnut))
            .add(rod({-0.02, deck, 0}, {-0.14, deck + 0.3, 0}, 0.02, kSlate))
            .add(moved(turned_z(ring({0, 0, 0}, {0, 1, 0}, 0.12, 0.018, kInk, 24), 24), {-0.14, deck + 0.3, 0}));
    }
    return facing_front(a.mesh());
}

TriangleMesh motorbike(double wheel_r, double base, double bars, double seat, bool scooter, Rgb paint) {
    Assembly a;
    const Vec3 rear{-base / 2, wheel_r, 0}, front{base / 2, wheel_r, 0},
        head{base / 2 - 0.24, wheel_r * 2 + bars * 0.5, 0};
    for (const Vec3 at : {rear, front})
        a.add(ring(at, {0, 0, 1}, wheel_r * 0.82, wheel_r * 0.2, kInk, 36))
            .add(rod(at - Vec3{0, 0, 0.04}, at + Vec3{0, 0, 0.04}, wheel_r * 0.66, kSteel, Cap::Flat))
            .add(rod(at - Vec3{0, 0, 0.07}, at + Vec3{0, 0, 0.07}, wheel_r * 0.2, kSlate, Cap::Flat));
    a.pair(rod(front + Vec3{0, 0, 0.08}, head + Vec3{0, 0, 0.06}, 0.028, kSteel))
        .add(rod(head, head + Vec3{-0.05, bars * 0.5, 0}, 0.035, kSlate))
        .pair(tube({{head + Vec3{-0.05, bars * 0.5, 0}, 0.024},
                    {head + Vec3{-0.06, bars * 0.62, 0.14}, 0.024},
                    {head + Vec3{-0.16, bars * 0.6, 0.28}, 0.03}},
                   kInk))
        .add(ball(head + Vec3{0.1, 0.06, 0}, {0.1, 0.11, 0.11}, kCream, 12));
    a.add(tube({{front + Vec3{-wheel_r * 0.8, wheel_r * 0.75, 0}, 0.025, 0.08},
                {front + Vec3{0, wheel_r * 1.1, 0}, 0.03, 0.09},
                {front + Vec3{wheel_r * 0.75, wheel_r * 0.75, 0}, 0.022, 0.07}},
               paint));
    if (scooter) {
        a.add(tube({{head + Vec3{-0.02, 0.02, 0}, 0.06, 0.16},
                    {{base * 0.2, wheel_r * 1.2, 0}, 0.05, 0.2},
                    {{base * 0.05, wheel_r * 0.75, 0}, 0.05, 0.18},
                    {{-base * 0.16, wheel_r * 0.75, 0}, 0.05, 0.17}},
                   paint))
            .add(ball({-base * 0.4, wheel_r * 1.6, 0}, {base * 0.3, wheel_r * 0.8, 0.19}, paint, 16));
    } else {
        a.add(tube({{{-base * 0.05, wheel_r * 2.1, 0}, 0.08, 0.09},
                    {{base * 0.1, wheel_r * 2.25, 0}, 0.13, 0.12},
                    {{base * 0.24, wheel_r * 2.3, 0}, 0.09, 0.1}},
                   paint))
            .add(box({-0.02, wheel_r * 1.15, 0}, {base * 0.28, wheel_r * 1.0, 0.22}, 0.05, kSlate))
            .add(rod(rear, {0.0, wheel_r * 1.1, 0}, 0.04, kSlate))
            .add(rod(head, {0.05, wheel_r * 1.6, 0}, 0.035, kSlate))
            .add(rod({0.05, wheel_r * 1.9, 0}, rear + Vec3{-0.02, wheel_r * 1.1, 0}, 0.05, kSlate));
        for (const double t : {0.0, 0.08, 0.16})
            a.add(box({-0.02, wheel_r * (1.2 + t * 3), 0}, {base * 0.3, 0.03, 0.26}, 0.012, kSteel));
        a.add(tube({{{0.1, wheel_r * 0.75, 0.14}, 0.03},
                    {{-0.2, wheel_r * 0.6, 0.16}, 0.035},
                    {{-base * 0.55, wheel_r * 0.85, 0.17}, 0.055}},
                   kSteel))
            .add(tube({{rear + Vec3{-wheel_r * 0.8, wheel_r * 0.8, 0}, 0.022, 0.08},
                       {rear + Vec3{0, wheel_r * 1.12, 0}, 0.028, 0.09},
                       {rear + Vec3{wheel_r * 0.6, wheel_r * 0.95, 0}, 0.022, 0.08}},
                      paint));
    }
    a.add(tube({{{-base * 0.5, seat + 0.04, 0}, 0.05, 0.1},
                {{-base * 0.28, seat, 0}, 0.06, 0.13},
                {{-base * 0.06, seat + 0.02, 0}, 0.045, 0.09}},
               kCocoa));
    return facing_front(a.mesh());
}

}  // namespace

void add_engines(Models& models) {
    add_model(models, "train", "Steam locomotive", locomotive(0.8, 0.22, 0.34, 2, kTeal, kRed, false));
    add_model(models, "train", "Engine and tender", locomotive(1.1, 0.24, 0.26, 3, kForest, kForest, true));
    add_model(models, "train", "Little tank engine", locomotive(0.5, 0.26, 0.4, 2, kBlue, kMustard, false));
    add_model(models, "train", "Express train", express(kWhite, kCoral));
    add_model(models, "tractor", "Red tractor", tractor(0.44, 0.24, 0.9, false, kRed, kCream));
    add_model(models, "tractor", "Green tractor", tractor(0.5, 0.3, 0.85, true, kGreen, kMustard));
    add_model(models, "tractor", "Old tractor", tractor(0.36, 0.18, 1.05, false, kBlue, kCoral));
    add_model(models, "tractor", "Orange tractor", tractor(0.4, 0.36, 0.75, true, kOrange, kWhite));
    add_model(models, "motorbike", "Motorbike", motorbike(0.28, 1.2, 0.3, 0.62, false, kRed));
    add_model(models, "motorbike", "Chopper", motorbike(0.27, 1.55, 0.62, 0.52, false, kNavy));
    add_model(models, "motorbike", "Scooter", motorbike(0.2, 1.0, 0.5, 0.68, true, kMint));
    add_model(models, "motorbike", "Sport motorbike", motorbike(0.3, 1.1, 0.2, 0.72, false, kMustard));
}

}  // namespace core::starter
