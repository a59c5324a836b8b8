#include "core/contour/polar_cover.hpp"

#include <algorithm>
#include <numbers>

namespace core {

namespace {

constexpr double kReach = 2.5;  // units out to the last ring's edge
constexpr std::size_t kRaysPerSector = 4;
constexpr std::size_t kRays = kRaysPerSector * kPolarSectors;
constexpr double kBlur = 1.5;  // sigma in sectors
constexpr int kBlurReach = 6;  // sectors

using RayCover = std::array<std::array<double, kRays>, kPolarRings>;

/// Adds what lies on each ray nearer than the edge from p to q: where the shape lies inside, as when it is met
/// anti-clockwise, it counts, else it is taken away again. Over all edges this leaves the covered length of the ray in
/// each ring, in ring widths. Points in ring widths about the centroid.
void add_edge(RayCover& cover, Point p, Point q) {
    constexpr double kStep = 2.0 * std::numbers::pi / static_cast<double>(kRays);
    const double turn = std::atan2(cross(p, q), dot(p, q));
    if (turn == 0.0) return;
    const bool anti_clockwise = turn > 0.0;
    const double from = std::atan2(p.y, p.x) / kStep - 0.5, to = from + turn / kStep;  // rays lie at n + 1/2
    const double low = std::min(from, to), high = std::max(from, to);
    for (auto n = static_cast<long>(std::ceil(low)); static_cast<double>(n) < high; ++n) {
        const double angle = (static_cast<double>(n) + 0.5) * kStep;
        const Point ray{std::cos(angle), std::sin(angle)};
        const double across = cross(ray, q - p);
        if (across == 0.0) continue;
        const double radius = std::clamp(cross(p, q - p) / across, 0.0, static_cast<double>(kPolarRings));
        const auto index = static_cast<std::size_t>(n + 2 * static_cast<long>(kRays)) % kRays;
        for (std::size_t k = 0; k < kPolarRings && static_cast<double>(k) < radius; ++k) {
            const double within = std::min(radius - static_cast<double>(k), 1.0);
            cover[k][index] += anti_clockwise ? within : -within;
        }
    }
}

RayCover ray_cover(const Polygon& ring, const RingMoments& m) {
    const double same_area = std::sqrt(m.area / std::numbers::pi), same_spread = std::sqrt(2.0 * (m.xx + m.yy));
    const double ring_width = std::sqrt(same_area * same_spread) * kReach / static_cast<double>(kPolarRings);
    const double angle = m.long_axis_rad();
    const Point x{std::cos(angle) / ring_width, std::sin(angle) / ring_width}, y{-x.y, x.x};
    RayCover cover{};
    Point p = ring.back() - m.centroid;
    p = {dot(p, x), dot(p, y)};
    for (const Point& corner : ring) {
        const Point relative = corner - m.centroid, q{dot(relative, x), dot(relative, y)};
        add_edge(cover, p, q);
        p = q;
    }
    return cover;
}

std::array<double, kPolarSectors> sectors_of(const std::array<double, kRays>& rays) {
    std::array<double, kPolarSectors> sectors{};
    for (std::size_t a = 0; a < kPolarSectors; ++a) {
        for (std::size_t i = 0; i < kRaysPerSector; ++i) sectors[a] += rays[a * kRaysPerSector + i];
        sectors[a] /= static_cast<double>(kRaysPerSector);
    }
    return sectors;
}

std::array<double, kPolarSectors> blurred(const std::array<double, kPolarSectors>& sectors) {
    std::array<double, kPolarSectors> out{};
    double weights = 0.0;
    for (int d = -kBlurReach; d <= kBlurReach; ++d) {
        const double weight = std::exp(-0.5 * d * d / (kBlur * kBlur));
        weights += weight;
        for (std::size_t a = 0; a < kPolarSectors; ++a) {
            out[a] += weight * sectors[(a + kPolarSectors + static_cast<std::size_t>(d)) % kPolarSectors];
        }
    }
    for (double& cell : out) cell /= weights;
    return out;
}

}  // namespace

std::array<std::array<std::uint8_t, kPolarSectors>, kPolarRings> polar_cover(const Polygon& ring,
                                                                             const RingMoments& moments) {
    const RayCover rays = ray_cover(ring, moments);
    std::array<std::array<std::uint8_t, kPolarSectors>, kPolarRings> cover{};
    for (std::size_t k = 0; k < kPolarRings; ++k) {
        const double worth =
            255.0 * (2.0 * static_cast<double>(k) + 1.0) / (2.0 * static_cast<double>(kPolarRings) - 1.0);
        const std::array<double, kPolarSectors> cells = blurred(sectors_of(rays[k]));
        for (std::size_t a = 0; a < kPolarSectors; ++a) {
            cover[k][a] = static_cast<std::uint8_t>(std::lround(worth * std::clamp(cells[a], 0.0, 1.0)));
        }
    }
    return cover;
}

}  // namespace core
