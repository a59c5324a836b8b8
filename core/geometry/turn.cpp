#include "core/geometry/turn.hpp"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

/// From one axis towards the next.
void turn_in_plane(double& a, double& b, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double first = a * c - b * s;
    b = a * s + b * c;
    a = first;
}

/// O. Rodrigues' formula.
Vec3 about(Vec3 p, Vec3 axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return p * c + cross(axis, p) * s + axis * (dot(axis, p) * (1 - c));
}

}  // namespace

Vec3 turned(Vec3 p, Vec3 turn) {
    turn_in_plane(p.y, p.z, turn.x);
    turn_in_plane(p.z, p.x, turn.y);
    turn_in_plane(p.x, p.y, turn.z);
    return p;
}

Vec3 turn_of_axes(Vec3 x, Vec3 y, Vec3 z) {
    // the columns of Rz Ry Rx; its last row is (-sin b, cos b sin a, cos b cos a)
    const double second = std::asin(std::clamp(-x.z, -1.0, 1.0));
    constexpr double kUpright = 1e-9;
    if (std::abs(x.x) < kUpright && std::abs(x.y) < kUpright) return {std::atan2(-z.y, y.y), second, 0};
    return {std::atan2(y.z, z.z), second, std::atan2(x.y, x.x)};
}

Vec3 turned_further(Vec3 turn, Vec3 axis, double angle) {
    return turn_of_axes(about(turned({1, 0, 0}, turn), axis, angle), about(turned({0, 1, 0}, turn), axis, angle),
                        about(turned({0, 0, 1}, turn), axis, angle));
}

}  // namespace core
