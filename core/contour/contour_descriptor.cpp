#include "core/contour/contour_descriptor.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/contour/canonical_ring.hpp"
#include "core/contour/polar_cover.hpp"

namespace core {

namespace {

constexpr std::size_t kFine = 4;  // points of the canonical ring for each point that has a frame
constexpr std::size_t kRing = kFine * kFramePoints;
constexpr std::size_t kTangent = 3;  // the tangent joins the ring's points this far on either side
constexpr double kNearness = 2.5;    // stretches grow with this power of their distance along the outline

/// Where stretch m begins, in points of the ring from the frame's own; the same seen from the other end.
std::size_t stretch_from(std::size_t m) {
    if (2 * m > kFrameStretches) return kRing - stretch_from(kFrameStretches - m);
    const double share = 2.0 * static_cast<double>(m) / static_cast<double>(kFrameStretches);
    return static_cast<std::size_t>(std::lround(0.5 * static_cast<double>(kRing) * std::pow(share, kNearness)));
}

using Channel = std::array<double, kFramePoints>;

/// Sums of the midpoints of the ring's edges, twice round, so that the mean of any stretch is one difference.
std::vector<Point> edge_sums(const Polygon& ring) {
    std::vector<Point> sums(2 * kRing + 1);
    for (std::size_t k = 0; k < 2 * kRing; ++k) {
        sums[k + 1] = sums[k] + midpoint(ring[k % kRing], ring[(k + 1) % kRing]);
    }
    return sums;
}

/// Means over one stretch in the frames of all points: heights above the tangent and distances ahead.
void fill_stretch(const Polygon& ring, const std::vector<Point>& sums, std::size_t stretch, Channel& heights,
                  Channel& ahead) {
    const std::size_t from = stretch_from(stretch), to = stretch_from(stretch + 1);
    for (std::size_t i = 0; i < kFramePoints; ++i) {
        const std::size_t own = i * kFine + kFine / 2;  // in the middle, so that the mirror image has the same points
        Point tangent = ring[(own + kTangent) % kRing] - ring[(own + kRing - kTangent) % kRing];
        const double norm = length(tangent);
        if (norm > 0.0) tangent = tangent * (1.0 / norm);
        const Point mean = (sums[own + to] - sums[own + from]) * (1.0 / static_cast<double>(to - from));
        heights[i] = cross(tangent, mean - ring[own]);
        ahead[i] = dot(tangent, mean - ring[own]);
    }
}

/// Divided by its greatest; a channel of nothing but 0 stays so.
void normalise(Channel& channel) {
    double greatest = 0.0;
    for (const double value : channel) greatest = std::max(greatest, std::abs(value));
    if (greatest <= 0.0) return;
    for (double& value : channel) value /= greatest;
}

double deviation(const Channel& channel) {
    double mean = 0.0, variance = 0.0;
    for (const double value : channel) mean += value / static_cast<double>(kFramePoints);
    for (const double value : channel) variance += (value - mean) * (value - mean) / static_cast<double>(kFramePoints);
    return std::sqrt(variance);
}

std::array<std::int8_t, kFramePoints> rounded(const Channel& channel, int greatest) {
    std::array<std::int8_t, kFramePoints> out{};
    for (std::size_t i = 0; i < kFramePoints; ++i)
        out[i] = static_cast<std::int8_t>(std::lround(channel[i] * greatest));
    return out;
}

void fill_frames(const Polygon& ring, ContourDescriptor& descriptor) {
    const std::vector<Point> sums = edge_sums(ring);
    double complexity = 0.0;
    for (std::size_t m = 0; m < kFrameStretches; ++m) {
        Channel heights{}, ahead{};
        fill_stretch(ring, sums, m, heights, ahead);
        normalise(heights);
        normalise(ahead);
        complexity += deviation(heights) / static_cast<double>(kFrameStretches);
        descriptor.frames[m] = rounded(heights, kGreatestHeight);
        descriptor.frames[kFrameStretches + m] = rounded(ahead, kGreatestAhead);
    }
    descriptor.complexity = static_cast<float>(std::clamp(complexity, 0.0, 1.0));
}

/// From its lowest, then leftmost point, which becomes the origin: the same numbers whatever point the ring is listed
/// from and wherever on the pixel grid it lies.
Polygon from_lowest(const Polygon& contour) {
    const auto lowest = std::min_element(contour.begin(), contour.end(),
                                         [](Point a, Point b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
    Polygon ring(lowest, contour.end());
    ring.insert(ring.end(), contour.begin(), lowest);
    const Point origin = ring.front();
    for (Point& p : ring) p = p - origin;
    return ring;
}

Polygon mirror_image(const Polygon& contour) {
    Polygon image(contour.rbegin(), contour.rend());
    for (Point& p : image) p.x = -p.x;
    return image;
}

/// Nothing when the ring encloses no area.
std::optional<ContourDescriptor> describe_as_seen(const Polygon& contour) {
    const Polygon ring = from_lowest(contour);
    const RingMoments moments = ring_moments(ring);
    if (!(moments.area > 0.0) || !(moments.xx + moments.yy > 0.0)) return std::nullopt;
    if (!std::isfinite(moments.area) || !std::isfinite(moments.xx + moments.yy)) return std::nullopt;
    ContourDescriptor descriptor;
    fill_frames(canonical_ring(ring, moments, {.count = static_cast<int>(kRing)}), descriptor);
    descriptor.cover = polar_cover(ring, moments);
    return descriptor;
}

}  // namespace

ContourDescriptor mirrored(const ContourDescriptor& descriptor) {
    ContourDescriptor out = descriptor;
    for (std::size_t m = 0; m < kFrameStretches; ++m) {
        const std::size_t other = kFrameStretches - 1 - m;
        for (std::size_t i = 0; i < kFramePoints; ++i) {
            const std::size_t j = kFramePoints - 1 - i;
            out.frames[m][i] = descriptor.frames[other][j];
            out.frames[kFrameStretches + m][i] =
                static_cast<std::int8_t>(-descriptor.frames[kFrameStretches + other][j]);
        }
    }
    for (auto& ring : out.cover) std::reverse(ring.begin(), ring.end());
    return out;
}

Result<ContourDescriptor> describe_contour(const Polygon& contour) {
    constexpr const char* kNothing = "the outline encloses no area; draw one closed object";
    if (contour.size() < 3) return unexpected(ErrorCode::BadOutline, kNothing);
    const auto finite = [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    if (!std::all_of(contour.begin(), contour.end(), finite)) {
        return unexpected(ErrorCode::BadOutline, "a point of the outline is not finite; trace it again");
    }
    // Both the outline and its mirror image are described, and which of the two is kept depends on the descriptors
    // alone: so the mirror image gets the mirrored descriptor to the last bit, whatever was rounded.
    const std::optional<ContourDescriptor> seen = describe_as_seen(contour),
                                           other = describe_as_seen(mirror_image(contour));
    if (!seen || !other) return unexpected(ErrorCode::BadOutline, kNothing);
    const auto content = [](const ContourDescriptor& d) { return std::tie(d.complexity, d.frames, d.cover); };
    return content(*seen) < content(*other) ? *seen : mirrored(*other);
}

}  // namespace core
