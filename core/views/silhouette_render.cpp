#include "core/views/silhouette_render.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <utility>

namespace core {
namespace {

/// Where the line from a to b, a lower than b along the walked axis, is at `at` of that axis.
double crossing(double a_at, double a, double b_at, double b, double at) {
    return b_at > a_at ? a + (b - a) * ((at - a_at) / (b_at - a_at)) : b;
}

/// A triangle corner in pixels: `along` the axis that is walked, `across` the other.
struct Corner {
    double along = 0.0;
    double across = 0.0;
};

/// Calls span(i, low, high) for each pixel row (or column) i in [0, size) whose centre line i + 0.5 meets the triangle,
/// with the interval in which it does. A corner shared by two triangles, or an edge, gives both the same numbers.
template <typename Span>
void walk(std::array<Corner, 3> corners, int size, const Span& span) {
    const auto less = [](const Corner& a, const Corner& b) {
        return a.along < b.along || (a.along == b.along && a.across < b.across);
    };
    auto& [a, b, c] = corners;
    if (less(b, a)) std::swap(a, b);
    if (less(c, b)) std::swap(b, c);
    if (less(b, a)) std::swap(a, b);
    const double first = std::max(std::ceil(a.along - 0.5), 0.0);
    const double last = std::min(std::floor(c.along - 0.5), size - 1.0);
    if (!(first <= last)) return;
    const int end = static_cast<int>(last);
    for (int i = static_cast<int>(first); i <= end; ++i) {
        const double at = i + 0.5;
        // With a level edge at this very line, both its ends count.
        const double on_long = a.along == at ? a.across : crossing(a.along, a.across, c.along, c.across, at);
        const double on_short = at < b.along   ? crossing(a.along, a.across, b.along, b.across, at)
                                : at > b.along ? crossing(b.along, b.across, c.along, c.across, at)
                                               : b.across;
        double low = std::min(on_long, on_short), high = std::max(on_long, on_short);
        if (at == c.along) high = std::max({high, c.across}), low = std::min(low, c.across);
        span(i, low, high);
    }
}

class Canvas {
  public:
    explicit Canvas(int size_px) : size_(size_px), image_(size_px, size_px) {}

    void fill(const std::array<Point, 3>& p) {
        // Level arms of the crosses: whole rows of pixels.
        walk({Corner{p[0].y, p[0].x}, {p[1].y, p[1].x}, {p[2].y, p[2].x}}, size_,
             [this](int y, double low, double high) {
                 const auto [from, to] = pixels(low, high);
                 if (from >= size_ || to < 0) return;
                 const int start = std::max(from, 0);
                 std::memset(&image_.at(start, y), 1, static_cast<std::size_t>(std::min(to, size_ - 1) - start + 1));
             });
        // Upright arms: between the two ends of a column the centres are covered, and so the rows have drawn them.
        walk({Corner{p[0].x, p[0].y}, {p[1].x, p[1].y}, {p[2].x, p[2].y}}, size_,
             [this](int x, double low, double high) {
                 const auto [from, to] = pixels(low, high);
                 set(x, from);
                 set(x, to);
             });
    }

    [[nodiscard]] BinaryImage take() && { return std::move(image_); }

  private:
    /// First and last pixel of an interval, anything outside the image as -1 or size. An interval that ends on the
    /// border between two pixels does not take the next one, so that mirrored input gives mirrored output.
    [[nodiscard]] std::pair<int, int> pixels(double low, double high) const {
        const auto inside = [this](double v) { return std::clamp(v, -1.0, static_cast<double>(size_)); };
        const int from = static_cast<int>(std::floor(inside(low)));
        return {from, std::max(from, static_cast<int>(std::ceil(inside(high))) - 1)};
    }
    void set(int x, int y) {
        if (y >= 0 && y < size_) image_.at(x, y) = 1;
    }

    int size_;
    BinaryImage image_;
};

bool is_finite(Point p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}

}  // namespace

BinaryImage render_silhouette(const TriangleMesh& normalised, const Camera& camera, int size_px) {
    assert(size_px > 2 * kViewMarginPx);
    Canvas canvas(size_px);
    const std::size_t count = normalised.vertices.size();
    const double scale = pixels_per_unit(size_px), middle = size_px * 0.5;
    const Vec3 right = camera.right() * scale, down = camera.up * -scale;
    const auto project = [&](std::uint32_t i) {
        const Vec3& v = normalised.vertices[i];
        return Point{middle + dot(right, v), middle + dot(down, v)};
    };
    for (const auto& [i, j, k] : normalised.triangles) {
        if (i >= count || j >= count || k >= count) continue;
        const std::array<Point, 3> corners{project(i), project(j), project(k)};
        if (is_finite(corners[0]) && is_finite(corners[1]) && is_finite(corners[2])) canvas.fill(corners);
    }
    return std::move(canvas).take();
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
