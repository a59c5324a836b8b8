#include "core/mesh/triangulate_face.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>

namespace core {
namespace {

constexpr std::size_t kMostCornersToClip = 1000;

Vec3 newell_normal(std::span<const Vec3> corners) {
    Vec3 normal;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        // Differences to the first corner keep faces far from the origin exact enough.
        normal = normal + cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
    }
    return normal;
}

/// The corners along the axis in which the normal is largest, turned so that the face runs anti-clockwise.
std::vector<Point> flattened(std::span<const Vec3> corners, Vec3 normal) {
    const double ax = std::abs(normal.x), ay = std::abs(normal.y), az = std::abs(normal.z);
    std::vector<Point> flat;
    flat.reserve(corners.size());
    for (const Vec3& p : corners) {
        const Vec3 d = p - corners[0];
        if (ax >= ay && ax >= az)
            flat.push_back(normal.x > 0.0 ? Point{d.y, d.z} : Point{d.z, d.y});
        else if (ay >= az)
            flat.push_back(normal.y > 0.0 ? Point{d.z, d.x} : Point{d.x, d.z});
        else
            flat.push_back(normal.z > 0.0 ? Point{d.x, d.y} : Point{d.y, d.x});
    }
    return flat;
}

/// Whether the corner at `at` of the remaining ring can be cut off: convex, and no other corner in its triangle.
bool is_ear(const std::vector<Point>& flat, const std::vector<std::uint32_t>& ring, std::size_t at) {
    const std::size_t n = ring.size();
    const Point a = flat[ring[(at + n - 1) % n]], b = flat[ring[at]], c = flat[ring[(at + 1) % n]];
    if (cross(b - a, c - b) <= 0.0) return false;
    for (std::size_t k = 2; k + 1 < n; ++k) {
        const Point p = flat[ring[(at + k) % n]];
        if (p == a || p == b || p == c) continue;  // bridges to holes visit a corner twice
        if (cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0) return false;
    }
    return true;
}

void fan(const std::vector<std::uint32_t>& ring, std::vector<std::array<std::uint32_t, 3>>& out) {
    for (std::size_t i = 2; i < ring.size(); ++i) out.push_back({ring[0], ring[i - 1], ring[i]});
}

}  // namespace

void triangulate_face(std::span<const Vec3> corners, std::vector<std::array<std::uint32_t, 3>>& out) {
    if (corners.size() < 3) return;
    std::vector<std::uint32_t> ring(corners.size());
    std::iota(ring.begin(), ring.end(), 0U);
    if (corners.size() == 3 || corners.size() > kMostCornersToClip) return fan(ring, out);
    const std::vector<Point> flat = flattened(corners, newell_normal(corners));
    std::size_t at = 0, without_ear = 0;
    while (ring.size() > 3 && without_ear < ring.size()) {
        const std::size_t n = ring.size();
        if (!is_ear(flat, ring, at % n)) {
            ++at;
            ++without_ear;
            continue;
        }
        at %= n;
        out.push_back({ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
        without_ear = 0;
    }
    fan(ring, out);
}

}  // namespace core
