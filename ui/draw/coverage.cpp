#include "ui/draw/coverage.hpp"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

/// Signed areas, summed along each row at the end; after Levien, "Inside the fastest font renderer", 2016.
class Accumulator {
  public:
    Accumulator(int width, int height)
        : width_(width),
          height_(height),
          cells_(static_cast<std::size_t>(width + 2) * static_cast<std::size_t>(height)) {}

    void line(core::Point a, core::Point b) {
        if (a.y == b.y) return;
        const double direction = a.y < b.y ? 1.0 : -1.0;
        if (a.y > b.y) std::swap(a, b);
        const double slope = (b.x - a.x) / (b.y - a.y);
        double x = a.x;
        if (a.y < 0) x -= a.y * slope;
        const int first = std::max(0, static_cast<int>(std::floor(a.y)));
        const int last = std::min(height_, static_cast<int>(std::ceil(b.y)));
        for (int y = first; y < last; ++y) {
            const double dy = std::min(y + 1.0, b.y) - std::max(static_cast<double>(y), a.y);
            const double next = x + slope * dy;
            row(y, std::min(x, next), std::max(x, next), dy * direction);
            x = next;
        }
    }

    [[nodiscard]] core::GrayImage image() const {
        core::GrayImage out(width_, height_);
        for (int y = 0; y < height_; ++y) {
            double sum = 0;
            const double* cell = &cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 2)];
            for (int x = 0; x < width_; ++x) {
                sum += cell[x];
                out.at(x, y) = static_cast<std::uint8_t>(std::lround(std::min(std::abs(sum), 1.0) * 255));
            }
        }
        return out;
    }

  private:
    /// One edge inside row y from x0 to x1: what it covers to its right, with sign.
    void row(int y, double x0, double x1, double d) {
        double* cell = &cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 2)];
        x0 = std::clamp(x0, 0.0, static_cast<double>(width_));
        x1 = std::clamp(x1, 0.0, static_cast<double>(width_));
        const int i0 = static_cast<int>(x0), i1 = static_cast<int>(std::ceil(x1));
        if (i1 <= i0 + 1) {
            const double inside = 1 - (0.5 * (x0 + x1) - i0);
            cell[i0] += d * inside;
            cell[i0 + 1] += d * (1 - inside);
            return;
        }
        const double s = 1 / (x1 - x0), f0 = x0 - i0, f1 = x1 - i1 + 1;
        const double a0 = 0.5 * s * (1 - f0) * (1 - f0), am = 0.5 * s * f1 * f1;
        cell[i0] += d * a0;
        if (i1 == i0 + 2) {
            cell[i0 + 1] += d * (1 - a0 - am);
        } else {
            const double a1 = s * (1.5 - f0);
            cell[i0 + 1] += d * (a1 - a0);
            for (int i = i0 + 2; i < i1 - 1; ++i) cell[i] += d * s;
            cell[i1 - 1] += d * (1 - (a1 + (i1 - i0 - 3) * s) - am);
        }
        cell[i1] += d * am;
    }

    int width_, height_;
    std::vector<double> cells_;
};

}  // namespace

CoverageImage fill_polygon(const core::Polygon& ring_px, int width, int height) {
    CoverageImage out;
    if (ring_px.size() < 3) return out;
    double left = ring_px[0].x, right = left, top = ring_px[0].y, bottom = top;
    for (const core::Point& p : ring_px) {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    out.x = static_cast<int>(std::floor(std::clamp(left, 0.0, static_cast<double>(width))));
    out.y = static_cast<int>(std::floor(std::clamp(top, 0.0, static_cast<double>(height))));
    const int x1 = static_cast<int>(std::ceil(std::clamp(right, 0.0, static_cast<double>(width))));
    const int y1 = static_cast<int>(std::ceil(std::clamp(bottom, 0.0, static_cast<double>(height))));
    if (x1 <= out.x || y1 <= out.y) return out;
    Accumulator cells(x1 - out.x, y1 - out.y);
    const core::Point origin{static_cast<double>(out.x), static_cast<double>(out.y)};
    for (std::size_t i = 0; i < ring_px.size(); ++i) {
        cells.line(ring_px[i] - origin, ring_px[(i + 1) % ring_px.size()] - origin);
    }
    out.coverage = cells.image();
    return out;
}

}  // namespace ui
