#include "core/garment/desk/limb_threads.hpp"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr double kFar_cm = 400.0;

/// +1 when the segment passes the triangle from behind, -1 from before, 0 beside it (Moeller and Trumbore 1997).
int crossing(Vec3 from, Vec3 to, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 way = to - from, ab = b - a, ac = c - a, across = cross(way, ac);
    const double det = dot(ab, across);
    if (std::abs(det) < 1e-12) return 0;
    const Vec3 start = from - a, turned = cross(start, ab);
    const double u = dot(start, across) / det, v = dot(way, turned) / det, t = dot(ac, turned) / det;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || t < 0.0 || t > 1.0) return 0;
    return dot(way, cross(ab, ac)) > 0.0 ? 1 : -1;
}

}  // namespace

std::vector<SpaceLine> limb_threads(const PartSurface& parts) {
    if (parts.empty()) return {};
    SpaceLine upper, trunk;  // from above down
    for (const BodyPart part : {BodyPart::Head, BodyPart::Neck})
        for (const Vec3& p : parts.centre_line(part)) upper.push_back(p);
    const SpaceLine torso = parts.centre_line(BodyPart::Torso), hips = parts.centre_line(BodyPart::Hips);
    if (torso.empty()) return {};
    trunk.insert(trunk.end(), torso.begin(), torso.end());
    trunk.insert(trunk.end(), hips.begin(), hips.end());
    std::vector<SpaceLine> threads;
    for (const BodyPart part : {BodyPart::ArmLeft, BodyPart::ArmRight, BodyPart::LegLeft, BodyPart::LegRight}) {
        const SpaceLine limb = parts.centre_line(part);
        if (limb.size() < 2) continue;
        const bool arm = part == BodyPart::ArmLeft || part == BodyPart::ArmRight;
        SpaceLine thread = upper;
        // an arm leaves the trunk at its own height, a leg at its lower end
        for (const Vec3& p : trunk)
            if (!arm || p.y > limb.front().y) thread.push_back(p);
        thread.insert(thread.end(), limb.begin(), limb.end());
        thread.insert(thread.begin(), thread.front() + Vec3{0, kFar_cm, 0});
        thread.push_back(limb.back() + normalised(limb.back() - limb[limb.size() / 2]) * kFar_cm);
        threads.push_back(std::move(thread));
    }
    return threads;
}

int passes_cone(const SpaceLine& thread, const SpaceLine& line) {
    const Vec3 apex{137.3, 311.7, 523.1};  // away from all bodies, and from their planes
    int sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        for (std::size_t k = 0; k + 1 < thread.size(); ++k)
            sum += crossing(thread[k], thread[k + 1], apex, line[i], line[i + 1]);
    return sum;
}

}  // namespace core
