#include "core/silhouette/distance_raster.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "core/match/lanes.hpp"

namespace core {
namespace {

constexpr std::int16_t kFar = std::numeric_limits<std::int16_t>::max();
constexpr int kMostReach = 127;
constexpr std::int16_t kBeyond = (kMostReach + 1) * (kMostReach + 1) - 1;  // plus the square of a reach it fits a cell
constexpr int kLane = 16;

/// Sixteen distances at once, see lanes.hpp.
using Cells = std::int16_t __attribute__((vector_size(2 * kLane)));

/// to[i] = min(to[i], from[i] + add) for `count` cells, rounded up to whole lanes.
CROQUIS_LANES_CLONES
void lower(std::int16_t* to, const std::int16_t* from, std::int16_t add, int count) {
    for (int i = 0; i < count; i += kLane) {
        Cells a, b;
        std::memcpy(&a, to + i, sizeof a);
        std::memcpy(&b, from + i, sizeof b);
        b += add;
        a = a < b ? a : b;
        std::memcpy(to + i, &a, sizeof a);
    }
}

/// here[x] = min(here[x], before[x] + 1), at most `cap`.
CROQUIS_LANES_CLONES
void one_farther(std::uint8_t* here, const std::uint8_t* before, std::uint8_t cap, std::size_t count) {
    using Bytes = std::uint8_t __attribute__((vector_size(16)));
    for (std::size_t i = 0; i < count; i += 16) {
        Bytes h, b;
        std::memcpy(&h, here + i, sizeof h);
        std::memcpy(&b, before + i, sizeof b);
        const Bytes next = b < cap ? b + 1 : b;
        h = h < next ? h : next;
        std::memcpy(here + i, &h, sizeof h);
    }
}

/// Bit i says whether cells[i] is above the limit, for 64 cells.
std::uint64_t above(const std::int16_t* cells, std::int16_t limit) {
    std::uint64_t word = 0;
#if defined(__SSE2__)
    const __m128i limits = _mm_set1_epi16(limit);
    const auto greater = [&](int at) {
        return _mm_cmpgt_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(cells + at)), limits);
    };
    for (int i = 0; i < 64; i += 16) {
        const auto bits = static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(greater(i), greater(i + 8))));
        word |= static_cast<std::uint64_t>(bits) << i;
    }
#else
    for (int i = 0; i < 64; ++i) word |= static_cast<std::uint64_t>(cells[i] > limit ? 1 : 0) << i;
#endif
    return word;
}

}  // namespace

DistanceRaster::DistanceRaster(int width, int height, int reach)
    : width_((width + 63) / 64 * 64), height_(height), reach_(reach), pad_(reach + 2 * kLane) {
    assert(reach <= kMostReach);
    stride_ = width_ + 2 * pad_;
    distance2_.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height_ + 2 * pad_), kFar);
    squares_.resize(static_cast<std::size_t>(2 * pad_) + 1);
    for (int d = -pad_; d <= pad_; ++d) {
        squares_[static_cast<std::size_t>(d + pad_)] = static_cast<Cell>(std::min(d * d, int{kBeyond}));
    }
    for (int d = 0; d <= reach_; ++d) chord_.push_back(static_cast<int>(std::sqrt(reach_ * reach_ - d * d)));
    line_.resize(static_cast<std::size_t>(stride_), kBeyond);
}

void DistanceRaster::clear() {
    std::fill(distance2_.begin(), distance2_.end(), kFar);
    fresh_.clear();
}

void DistanceRaster::ink(int y, int x0, int x1) {
    for (int x = x0; x <= x1; ++x) {
        Cell& cell = distance2_[index(x, y)];
        if (cell == 0) continue;
        cell = 0;
        fresh_.push_back({x, y});
    }
}

const std::vector<RasterPixel>& DistanceRaster::settle() {
    edge_.clear();
    for (const RasterPixel p : fresh_) {
        const bool inner = squared(p.x - 1, p.y) == 0 && squared(p.x + 1, p.y) == 0 && squared(p.x, p.y - 1) == 0 &&
                           squared(p.x, p.y + 1) == 0;
        if (!inner) edge_.push_back(p);
    }
    fresh_.clear();
    for (const RasterPixel p : edge_) lower_about(p);
    return edge_;
}

void DistanceRaster::lower_about(RasterPixel p) {
    for (int dy = -reach_; dy <= reach_; ++dy) {
        const int chord = chord_[static_cast<std::size_t>(std::abs(dy))];
        lower(&distance2_[index(p.x - chord, p.y + dy)], &squares_[static_cast<std::size_t>(pad_ - chord)],
              static_cast<Cell>(dy * dy), 2 * chord + 1);
    }
}

void DistanceRaster::settle_all() {
    if (fresh_.empty()) return;
    int top = height_, bottom = 0;
    for (const RasterPixel p : fresh_) {
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    fresh_.clear();
    top = std::max(top - reach_, 0);
    bottom = std::min(bottom + reach_, height_ - 1);
    column_pass(top, bottom);
    row_pass(top, bottom);
}

/// Vertical distances to ink.
void DistanceRaster::column_pass(int top, int bottom) {
    const auto cap = static_cast<std::uint8_t>(reach_ + 1);
    const auto w = static_cast<std::size_t>(width_);
    above_.resize(w * static_cast<std::size_t>(height_));
    for (int y = top; y <= bottom; ++y) {
        const Cell* cells = &distance2_[index(0, y)];
        std::uint8_t* here = &above_[static_cast<std::size_t>(y) * w];
        const std::uint8_t* before = y > top ? here - w : nullptr;
        for (std::size_t x = 0; x < w; ++x) here[x] = cells[x] == 0 ? std::uint8_t{0} : cap;
        if (before != nullptr) one_farther(here, before, cap, w);
    }
    for (int y = bottom - 1; y >= top; --y) {
        std::uint8_t* here = &above_[static_cast<std::size_t>(y) * w];
        one_farther(here, here + w, cap, w);
    }
}

/// The least of vertical² + horizontal² within reach along each row.
void DistanceRaster::row_pass(int top, int bottom) {
    const auto w = static_cast<std::size_t>(width_);
    for (int y = top; y <= bottom; ++y) {
        const std::uint8_t* vertical = &above_[static_cast<std::size_t>(y) * w];
        std::size_t first = w, last = 0;
        for (std::size_t x = 0; x < w; ++x) {
            const int v = vertical[x];
            line_[x + static_cast<std::size_t>(pad_)] = v <= reach_ ? static_cast<Cell>(v * v) : kBeyond;
            if (v > reach_) continue;
            first = std::min(first, x);
            last = x;
        }
        if (first == w) continue;
        const int from = std::max(static_cast<int>(first) - reach_, 0);
        const int to = std::min(static_cast<int>(last) + reach_, width_ - 1);
        Cell* cells = &distance2_[index(from, y)];
        for (int d = -reach_; d <= reach_; ++d) {
            lower(cells, &line_[static_cast<std::size_t>(pad_ + from + d)], static_cast<Cell>(d * d), to - from + 1);
        }
    }
}

void DistanceRaster::farther_than(int limit, BitImage& out) const {
    for (int y = 0; y < height_; ++y) {
        const Cell* cells = &distance2_[index(0, y)];
        std::uint64_t* row = out.row(y);
        for (int w = 0; w < out.words(); ++w)
            row[w] = above(cells + static_cast<std::ptrdiff_t>(64) * w, static_cast<Cell>(limit));
    }
}

bool DistanceRaster::any_at_least(int y, int x0, int x1, int limit) const {
    const Cell* cells = &distance2_[index(0, y)];
    return std::any_of(cells + x0, cells + x1 + 1, [limit](Cell c) { return c >= limit; });
}

}  // namespace core
