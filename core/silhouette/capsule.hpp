#pragma once
// The pixels that a round pen of constant width covers between two points, in whole numbers: the same pixels wherever
// on the grid the stroke lies, in whatever order it is drawn, and whoever asks.

#include <algorithm>
#include <cstdint>

namespace core {

/// A place on the raster in sixteenths of a pixel; pixel centres are multiples of kSubpixels.
struct FixedPoint {
    std::int64_t x = 0, y = 0;
    friend bool operator==(const FixedPoint&, const FixedPoint&) = default;
};
inline constexpr std::int64_t kSubpixels = 16;

/// The greatest whole number not above n / d; d > 0.
[[nodiscard]] constexpr std::int64_t floor_div(std::int64_t n, std::int64_t d) {
    return n >= 0 ? n / d : -((-n + d - 1) / d);
}

/// The centre of pixel (x, y) lies no farther from the segment a b than `half`, in sixteenths of a pixel. Exact while
/// coordinates stay below 2^17 sixteenths.
[[nodiscard]] constexpr bool in_capsule(FixedPoint a, FixedPoint b, std::int64_t half, int x, int y) {
    const std::int64_t px = x * kSubpixels - a.x, py = y * kSubpixels - a.y;
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const std::int64_t along = px * dx + py * dy, length2 = dx * dx + dy * dy;
    if (along <= 0) return px * px + py * py <= half * half;
    if (along >= length2) {
        const std::int64_t qx = px - dx, qy = py - dy;
        return qx * qx + qy * qy <= half * half;
    }
    const std::int64_t across = px * dy - py * dx;
    return across * across <= half * half * length2;
}

/// Calls visit(y, x0, x1) for every row of the capsule that has pixels, from the top; x0 <= x1. Linear in the pixels.
template <typename Visit>
void each_capsule_run(FixedPoint a, FixedPoint b, std::int64_t half, Visit visit) {
    if (a.y > b.y) std::swap(a, b);
    const auto top = static_cast<int>(floor_div(a.y - half, kSubpixels));
    const auto bottom = static_cast<int>(floor_div(b.y + half, kSubpixels)) + 1;
    for (int y = top; y <= bottom; ++y) {
        // The row's covered pixels are one run about the place where the row is nearest to the segment.
        const std::int64_t row = y * kSubpixels;
        std::int64_t nearest = row <= a.y ? a.x : b.x;
        if (row > a.y && row < b.y) nearest = a.x + floor_div((b.x - a.x) * (row - a.y), b.y - a.y);
        auto x0 = static_cast<int>(floor_div(nearest, kSubpixels));
        if (!in_capsule(a, b, half, x0, y) && !in_capsule(a, b, half, ++x0, y)) continue;
        int x1 = x0;
        while (in_capsule(a, b, half, x0 - 1, y)) --x0;
        while (in_capsule(a, b, half, x1 + 1, y)) ++x1;
        visit(y, x0, x1);
    }
}

}  // namespace core
