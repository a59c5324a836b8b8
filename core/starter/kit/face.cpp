#include "core/starter/kit/face.hpp"

#include <cmath>
#include <numbers>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/blob.hpp"

namespace core::starter {
namespace {

/// Unit vector `degrees` away from straight up, to the right.
Vec3 aside(double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return {std::sin(angle), std::cos(angle), 0.0};
}

/// The right ear; `outer` in the coat's colour on the head, `inner` a smaller patch before it.
void add_ear(Blob& head, Assembly& details, const Face& f, double side) {
    const Vec3 spot = aside(side * f.ear_place);
    const Vec3 root{spot.x * f.width * 0.9, spot.y * f.height * 0.9, 0.0};
    const Vec3 along = aside(side * f.ear_lean), tip = root + along * f.ear_length;
    const double w = f.ear_width;
    const auto patch = [&](Vec3 centre, double length, double width, double z) {
        details.add(moved(turned_z(ball({0, 0, 0}, {width, length, 0.03}, f.inner_ear, 10), -side * f.ear_lean),
                          centre + Vec3{0, 0, z}));
    };
    switch (f.ear) {
        case FaceEar::Pointed:
            head.limb(root - along * (0.3 * w), tip, w, 0.02, f.coat);
            patch(root + along * (0.32 * f.ear_length), f.ear_length * 0.42, w * 0.42, w * 0.62);
            break;
        case FaceEar::Round:
            head.egg(root + along * (0.45 * f.ear_length), {w, w, w * 0.6}, f.coat);
            patch(root + along * (0.5 * f.ear_length), w * 0.55, w * 0.55, w * 0.58);
            break;
        case FaceEar::Long:
            head.limb(root, root + along * (0.55 * f.ear_length), w * 0.75, w, f.coat)
                .limb(root + along * (0.55 * f.ear_length), tip, w, w * 0.5, f.coat);
            patch(root + along * (0.6 * f.ear_length), f.ear_length * 0.32, w * 0.5, w * 0.85);
            break;
        case FaceEar::Hanging:
            head.limb(root, root + along * (0.35 * f.ear_length), w * 0.7, w, f.inner_ear)
                .limb(root + along * (0.35 * f.ear_length), tip, w, w * 0.8, f.inner_ear);
            break;
        case FaceEar::Draped: {
            const Vec3 bend = root + along * (0.3 * f.ear_length),
                       end = bend + Vec3{side * 0.12, -0.7, 0} * f.ear_length;
            head.limb(root, bend, w * 0.7, w * 0.85, f.inner_ear).limb(bend, end, w * 0.85, w, f.inner_ear);
            break;
        }
    }
}

void add_features(Assembly& a, const Face& f) {
    const double front = f.depth * 0.9, snout = front + f.muzzle * 0.55, low = -f.height * 0.28;
    a.pair_x(ball({f.width * 0.38, f.height * 0.16, front}, {0.06, 0.075, 0.035}, kWhite, 10))
        .pair_x(ball({f.width * 0.38, f.height * 0.15, front + 0.03}, {0.036, 0.05, 0.02}, kInk, 8));
    a.add(ball({0, low + f.muzzle * 0.42, snout}, {0.07, 0.05, 0.04}, f.nose, 10));
    a.pair_x(tube({{{0, low + f.muzzle * 0.2, snout}, 0.013},
                   {{0.02, low - f.muzzle * 0.25, snout + 0.005}, 0.013},
                   {{0.1, low - f.muzzle * 0.3, snout - 0.03}, 0.013}},
                  kInk, {.sides = 6, .steps = 3}));
    for (int k = -1; k <= 1 && f.whiskers > 0; ++k)
        a.pair_x(rod({f.width * 0.4, low + 0.05 * k, front}, {f.width + f.whiskers, low + 0.03 + 0.13 * k, front * 0.4},
                     0.013, kSlate));
}

}  // namespace

TriangleMesh animal_face(const Face& f) {
    Blob head(0.06);
    head.egg({0, 0, 0}, {f.width, f.height, f.depth}, f.coat);
    if (f.chin > 0) head.egg({0, -f.chin, 0}, {f.width * 0.68, f.height * 0.75, f.depth * 0.95}, f.coat);
    if (f.body > 0) {
        head.egg({0, -f.height - f.body * 0.42, -0.02}, {f.width * 0.72, f.body * 0.55, f.depth * 0.9}, f.coat)
            .egg({0, -f.height - f.body * 0.45, f.depth * 0.35}, {f.width * 0.45, f.body * 0.4, f.depth * 0.6}, f.light)
            .egg({-f.width * 0.4, -f.height - f.body * 0.92, 0.08}, {0.15, 0.09, 0.14}, f.light)
            .egg({f.width * 0.4, -f.height - f.body * 0.92, 0.08}, {0.15, 0.09, 0.14}, f.light);
    }
    if (f.muzzle > 0)
        head.egg({0, -f.height * 0.3, f.depth * 0.75}, {f.muzzle * 1.3, f.muzzle, f.muzzle * 0.8}, f.light);
    head.blending(0.03);
    Assembly a;
    for (const double side : {1.0, -1.0}) add_ear(head, a, f, side);
    a.add(head.mesh(56));
    add_features(a, f);
    return scaled(a.mesh(), {1.0, 1.0, 0.65});  // flat: the face is what one sees of it
}

}  // namespace core::starter
