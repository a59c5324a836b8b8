#include "core/views/silhouette_render.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace core {
namespace {

// Single precision is good for a thousandth of a pixel in any image one would draw, and takes half the memory.

/// floor(v) for v in [0, size), -1 below, size from there on and for NaN. (std::floor is a call on plain x86-64.)
inline int floor_px(float v, int size) {
    if (v < 0.0F) return -1;
    return v < static_cast<float>(size) ? static_cast<int>(v) : size;
}

/// The same with ceil(v): 0 for anything up to 0, size for anything from there on and for NaN.
inline int ceil_px(float v, int size) {
    if (v <= 0.0F) return 0;
    if (!(v < static_cast<float>(size))) return size;
    const int below = static_cast<int>(v);
    return below + static_cast<int>(static_cast<float>(below) < v);
}

/// A triangle corner in pixels: `along` the axis that is walked, `across` the other.
struct Corner {
    float along = 0.0F;
    float across = 0.0F;
};

/// The line through two corners of different `along`.
class Line {
  public:
    Line(const Corner& from, const Corner& to)
        : from_(from), slope_((to.across - from.across) / (to.along - from.along)) {}
    [[nodiscard]] float at(float along) const { return from_.across + slope_ * (along - from_.along); }

  private:
    Corner from_;
    float slope_;
};

inline void swap_if_after(Corner& p, Corner& q) {
    const Corner first = q.along < p.along ? q : p, second = q.along < p.along ? p : q;
    p = first;
    q = second;
}

/// Calls span(i, low, high) for each pixel row (or column) i in [0, size) whose centre line i + 0.5 meets the triangle,
/// with the interval in which it does. An edge shared by two triangles gives both the same numbers.
template <typename Span>
inline void walk(Corner a, Corner b, Corner c, int size, const Span& span) {
    int i = ceil_px(std::min({a.along, b.along, c.along}) - 0.5F, size);
    const int last = std::min(floor_px(std::max({a.along, b.along, c.along}) - 0.5F, size), size - 1);
    if (i > last) return;
    swap_if_after(a, b);
    swap_if_after(b, c);
    swap_if_after(a, b);
    if (a.along == c.along) {
        return span(i, std::min({a.across, b.across, c.across}), std::max({a.across, b.across, c.across}));
    }
    const Line long_side(a, c);
    const auto centre = [&i] { return static_cast<float>(i) + 0.5F; };
    const auto draw = [&](float across) {
        const float other = long_side.at(centre());
        span(i, std::min(across, other), std::max(across, other));
    };
    if (centre() < b.along) {
        const Line side(a, b);
        for (; i <= last && centre() < b.along; ++i) draw(side.at(centre()));
    }
    if (i <= last && centre() == b.along) draw(b.across), ++i;  // a level side at this very line is met whole
    if (i <= last) {
        const Line side(b, c);
        for (; i <= last; ++i) draw(side.at(centre()));
    }
}

/// The image while it is drawn, one bit a pixel: small enough for the fastest cache, and a span takes a few operations.
class Canvas {
  public:
    explicit Canvas(int size_px)
        : size_(size_px),
          words_per_row_((size_px + 63) / 64),
          words_(static_cast<std::size_t>(words_per_row_) * static_cast<std::size_t>(size_px), 0) {}

    void fill(Corner a, Corner b, Corner c) {
        // Level arms of the crosses: whole rows of pixels. The corners come as y, x.
        walk(a, b, c, size_, [this](int y, float low, float high) {
            const auto [from, to] = pixels(low, high);
            if (from < size_ && to >= 0) set_span(y, std::max(from, 0), std::min(to, size_ - 1));
        });
        // Upright arms: between the two ends of a column the centres are covered, and so the rows have drawn them.
        const auto turned = [](Corner p) { return Corner{p.across, p.along}; };
        walk(turned(a), turned(b), turned(c), size_, [this](int x, float low, float high) {
            const auto [from, to] = pixels(low, high);
            set(x, from);
            set(x, to);
        });
    }

    [[nodiscard]] BinaryImage image() const {
        BinaryImage bytes(size_, size_);
        for (int y = 0; y < size_; ++y) {
            for (int x = 0; x < size_; x += 64) {
                std::uint8_t* pixel = &bytes.at(x, y);
                // Empty and full words are the most.
                const std::uint64_t bits = words_[word(x, y)];
                const int count = std::min(64, size_ - x);
                if (bits == ~0ULL)
                    std::fill_n(pixel, count, std::uint8_t{1});
                else if (bits != 0)
                    unpack(bits, count, pixel);
            }
        }
        return bytes;
    }

  private:
    static void unpack(std::uint64_t bits, int count, std::uint8_t* pixel) {
        for (int k = 0; k < count; ++k) pixel[k] = static_cast<std::uint8_t>((bits >> k) & 1U);
    }
    /// First and last pixel of an interval, anything outside the image as -1 or size. An interval that ends on the
    /// border between two pixels does not take the next one, so that mirrored input gives mirrored output.
    [[nodiscard]] std::pair<int, int> pixels(float low, float high) const {
        const int from = floor_px(low, size_), to = ceil_px(high, size_ + 1) - 1;
        return {from, std::max(from, to)};
    }
    [[nodiscard]] std::size_t word(int x, int y) const {
        return static_cast<std::size_t>(y * words_per_row_ + (x >> 6));
    }
    void set(int x, int y) {
        if (y >= 0 && y < size_) words_[word(x, y)] |= 1ULL << (x & 63);
    }
    void set_span(int y, int from, int to) {
        const std::size_t first = word(from, y), last = word(to, y);
        const std::uint64_t from_mask = ~0ULL << (from & 63), to_mask = ~0ULL >> (63 - (to & 63));
        if (first == last) {
            words_[first] |= from_mask & to_mask;
            return;
        }
        words_[first] |= from_mask;
        for (std::size_t w = first + 1; w < last; ++w) words_[w] = ~0ULL;
        words_[last] |= to_mask;
    }

    int size_;
    int words_per_row_;
    std::vector<std::uint64_t> words_;
};

/// The vertices in pixels, as y (along) and x (across).
std::vector<Corner> projected(const TriangleMesh& mesh, const Camera& camera, int size_px) {
    const double scale = pixels_per_unit(size_px), middle = size_px * 0.5;
    const Vec3 right = camera.right() * scale, down = camera.up * -scale;
    std::vector<Corner> corners;
    corners.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) {
        corners.push_back({static_cast<float>(middle + dot(down, v)), static_cast<float>(middle + dot(right, v))});
    }
    return corners;
}

/// False when a coordinate is infinite or NaN: 0 times such a number is NaN.
bool is_finite(const Corner& a, const Corner& b, const Corner& c) {
    const float zero =
        0.0F * a.along + 0.0F * a.across + 0.0F * b.along + 0.0F * b.across + 0.0F * c.along + 0.0F * c.across;
    return zero == 0.0F;
}

}  // namespace

BinaryImage render_silhouette(const TriangleMesh& normalised, const Camera& camera, int size_px) {
    assert(size_px > 2 * kViewMarginPx);
    const std::vector<Corner> corners = projected(normalised, camera, size_px);
    Canvas canvas(size_px);
    for (const auto& [i, j, k] : normalised.triangles) {
        if (i >= corners.size() || j >= corners.size() || k >= corners.size()) continue;
        const Corner &a = corners[i], &b = corners[j], &c = corners[k];
        if (is_finite(a, b, c)) canvas.fill(a, b, c);
    }
    return canvas.image();
}

BinaryImage mirrored(const BinaryImage& image) {
    BinaryImage swapped = image;
    for (int y = 0; y < image.height; ++y) {
        const auto row = swapped.pixels.begin() + static_cast<std::ptrdiff_t>(swapped.index(0, y));
        std::reverse(row, row + image.width);
    }
    return swapped;
}

}  // namespace core
