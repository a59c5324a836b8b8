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

}  // namespace

void add_tractors(Models& models) {
    add_model(models, "tractor", "Red tractor", tractor(0.44, 0.24, 0.9, false, kRed, kCream));
    add_model(models, "tractor", "Green tractor", tractor(0.5, 0.3, 0.85, true, kGreen, kMustard));
    add_model(models, "tractor", "Old tractor", tractor(0.36, 0.18, 1.05, false, kBlue, kCoral));
    add_model(models, "tractor", "Orange tractor", tractor(0.4, 0.36, 0.75, true, kOrange, kWhite));
    add_model(models, "tractor", "Field tractor", tractor(0.46, 0.22, 0.8, true, kTeal, kStraw));
}

}  // namespace core::starter
