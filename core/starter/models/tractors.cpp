// Tractors.

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
    return narrow(a.mesh(), 0.6);
}

/// A toy tractor: the cab stands over the large wheel, the wheels are close under the body. `slope` is how far the
/// windscreen leans.
TriangleMesh toy_tractor(double rear, double front, double hood, double cab, double slope, Rgb paint, Rgb hub) {
    Assembly a;
    const double floor = rear * 0.8, deck = floor + 0.36;
    a.add(box_between({-0.42, floor, -0.17}, {hood, deck, 0.17}, 0.06, paint))
        .add(slab({{-0.42, deck - 0.04}, {0.04, deck - 0.04}, {0.04 - slope, deck + cab}, {-0.42, deck + cab}}, 0.3,
                  0.02, kGlass))
        .add(box({-0.19 - slope / 2, deck + cab, 0}, {0.5 - slope, 0.07, 0.4}, 0.03, paint));
    a.add(rod({hood * 0.68, deck - 0.05, 0}, {hood * 0.68, deck + 0.3, 0}, 0.045, kInk, Cap::Flat))
        .pair(ball({hood - 0.01, floor + 0.22, 0.1}, 0.05, kCream, 8));
    a.pair(wheel({-0.22, rear, 0.24}, rear, 0.16, kInk, hub))
        .pair(wheel({hood - front, front, 0.22}, front, 0.14, kInk, hub));
    return narrow(a.mesh(), 0.6);
}

}  // namespace

void add_tractors(Models& models) {
    add_model(models, "tractor", "Red tractor", tractor(0.44, 0.24, 0.9, false, kRed, kCream));
    add_model(models, "tractor", "Green tractor", tractor(0.5, 0.3, 0.85, true, kGreen, kMustard));
    add_model(models, "tractor", "Old tractor", tractor(0.36, 0.18, 1.05, false, kBlue, kCoral));
    add_model(models, "tractor", "Orange tractor", tractor(0.4, 0.36, 0.75, true, kOrange, kWhite));
    add_model(models, "tractor", "Field tractor", tractor(0.46, 0.22, 0.8, true, kTeal, kStraw));
    add_model(models, "tractor", "Toy tractor", toy_tractor(0.36, 0.22, 0.72, 0.36, 0.06, kRed, kMustard));
    add_model(models, "tractor", "Vineyard tractor", toy_tractor(0.4, 0.26, 0.54, 0.5, 0.16, kLeaf, kCream));
    add_model(models, "tractor", "Two-wheel-drive tractor", toy_tractor(0.42, 0.15, 0.9, 0.26, 0.1, kMustard, kSlate));
}

}  // namespace core::starter
