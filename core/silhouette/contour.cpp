#include "core/silhouette/contour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/geometry/point_grid.hpp"
#include "core/geometry/polygon.hpp"
#include "core/geometry/ring_start.hpp"

namespace core {

BinaryImage object_mask(const GrayImage& image) {
    if (image.pixels.empty()) return BinaryImage(image.width, image.height);
    const auto white = [&image](int x, int y) { return image.at(x, y) >= 128; };
    long border = 0, border_white = 0;
    const auto count = [&](int x, int y) {
        ++border;
        border_white += white(x, y) ? 1 : 0;
    };
    for (int x = 0; x < image.width; ++x) {
        count(x, 0);
        count(x, image.height - 1);
    }
    for (int y = 0; y < image.height; ++y) {
        count(0, y);
        count(image.width - 1, y);
    }
    const bool page_is_white = border_white * 2 > border;
    BinaryImage mask(image.width, image.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        mask.pixels[i] = (image.pixels[i] >= 128) == page_is_white ? 0 : 1;
    }
    return mask;
}

namespace {

/// The side of a pixel that faces the background, with the outward normal as a quarter turn: 0 east, 1 north, 2 west, 3
/// south.
struct Crack {
    int x = 0, y = 0, normal = 0;
    friend bool operator==(const Crack&, const Crack&) = default;
};

constexpr std::array<int, 4> kDx{1, 0, -1, 0};
constexpr std::array<int, 4> kDy{0, -1, 0, 1};  // rows grow down

class CrackTracer {
  public:
    explicit CrackTracer(const BinaryImage& image) : image_(image), seen_(image.pixels.size(), 0) {}

    /// All closed contours: outer ones anti-clockwise, holes clockwise. Calls visit(ring) for each.
    template <typename Visit>
    void each_contour(Visit visit) {
        for (int y = 0; y < image_.height; ++y) {
            for (int x = 0; x < image_.width; ++x) {
                if (inside(x, y) && !inside(x, y - 1) && !seen_[image_.index(x, y)]) visit(trace({x, y, 1}));
            }
        }
    }

  private:
    [[nodiscard]] bool inside(int x, int y) const {
        return x >= 0 && y >= 0 && x < image_.width && y < image_.height && image_.at(x, y) != 0;
    }

    /// Walks with the object on the left. Pixels that touch at a corner are joined: the turn to the right is tried
    /// first.
    [[nodiscard]] Crack next(const Crack& c) const {
        const auto normal = static_cast<std::size_t>(c.normal);
        const std::size_t ahead = (normal + 1) % 4;
        const int qx = c.x + kDx[ahead], qy = c.y + kDy[ahead];
        const int rx = qx + kDx[normal], ry = qy + kDy[normal];
        if (inside(rx, ry)) return {rx, ry, (c.normal + 3) % 4};
        if (inside(qx, qy)) return {qx, qy, c.normal};
        return {c.x, c.y, (c.normal + 1) % 4};
    }

    Polygon trace(const Crack& start) {
        Polygon ring;
        Crack c = start;
        do {
            if (c.normal == 1) seen_[image_.index(c.x, c.y)] = 1;
            const auto n = static_cast<std::size_t>(c.normal);
            ring.push_back({c.x + 0.5 * kDx[n], -(c.y + 0.5 * kDy[n])});
            c = next(c);
        } while (!(c == start));
        return ring;
    }

    const BinaryImage& image_;
    std::vector<std::uint8_t> seen_;
};

/// Of equally low ones the leftmost.
template <typename Ring>
auto lowest_vertex(Ring& ring) {
    return std::min_element(ring.begin(), ring.end(),
                            [](Point a, Point b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
}

}  // namespace

Result<Polygon> largest_contour(const BinaryImage& image, double least_area) {
    Polygon best;
    double best_area = 0.0;
    CrackTracer(image).each_contour([&](Polygon ring) {
        const double area = signed_area(ring);
        if (area > best_area) {
            best_area = area;
            best = std::move(ring);
        }
    });
    if (best.empty()) return unexpected(ErrorCode::EmptyDrawing, "there is nothing drawn on it; draw one object");
    if (best_area < least_area) {
        return unexpected(ErrorCode::TooSmall, "what is drawn is only a dot; draw one object larger");
    }
    std::rotate(best.begin(), lowest_vertex(best), best.end());
    return best;
}

namespace {

/// The vertex farthest from the mean of all, of equally far ones the lowest, then leftmost. Exact for pixel edges, so
/// that a shape that is mirrored or turned by a quarter gives the same place of the shape.
std::size_t farthest_vertex(const Polygon& ring) {
    const Point lowest = *lowest_vertex(ring);
    Point sum;
    for (const Point p : ring) sum = sum + (p - lowest);
    const double n = static_cast<double>(ring.size());
    const auto key = [&](std::size_t i) {
        const Point from_mean = (ring[i] - lowest) * n - sum;
        return std::tuple(-dot(from_mean, from_mean), ring[i].y, ring[i].x);
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < ring.size(); ++i)
        if (key(i) < key(best)) best = i;
    return best;
}

/// From its farthest vertex on, and relative to the lowest: so it matters neither where the ring starts nor where it
/// lies.
Polygon from_farthest_vertex(const Polygon& ring) {
    Polygon out = ring;
    std::rotate(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(farthest_vertex(out)), out.end());
    const Point lowest = *lowest_vertex(ring);
    for (Point& p : out) p = p - lowest;
    return out;
}

/// Gaussian along the ring, of `sigma` points.
Polygon smoothed(const Polygon& ring, double sigma) {
    const int count = static_cast<int>(ring.size());
    const int reach = std::min(static_cast<int>(std::ceil(3.0 * sigma)), count / 2);
    std::vector<double> weight(static_cast<std::size_t>(reach) + 1);
    double sum = 0.0;
    for (int k = 0; k <= reach; ++k) {
        weight[static_cast<std::size_t>(k)] = sigma > 0.0 ? std::exp(-0.5 * k * k / (sigma * sigma)) : 1.0;
        sum += (k == 0 ? 1.0 : 2.0) * weight[static_cast<std::size_t>(k)];
    }
    Polygon smooth(ring.size());
    for (int i = 0; i < count; ++i) {
        Point p = ring[static_cast<std::size_t>(i)] * weight[0];
        for (int k = 1; k <= reach; ++k) {
            const Point a = ring[static_cast<std::size_t>((i + k) % count)];
            const Point b = ring[static_cast<std::size_t>((i - k + count) % count)];
            p = p + (a + b) * weight[static_cast<std::size_t>(k)];
        }
        smooth[static_cast<std::size_t>(i)] = p * (1.0 / sum);
    }
    return smooth;
}

constexpr int kFineEnough = 1000;  // points, to smooth a ring at the spacing it is wanted with

}  // namespace

Polygon smooth_contour(const Polygon& contour, int count, double sigma) {
    // Pixel edges are longer in some directions than in others: points are spaced evenly once that is smoothed away.
    const int finer = count < kFineEnough ? 3 : 1;
    const Polygon relative = from_farthest_vertex(contour);
    const Polygon fine = smoothed(resample_ring(relative, finer * count), finer * sigma);
    Polygon smooth = resample_ring(started_at(fine, ellipse_end(fine)), count);
    // On a grid that also holds all pixels, so that adding the place is exact and moving by whole pixels moves exactly.
    const int grid = finest_grid(smooth, std::int64_t{1} << 24);
    const Point lowest = *lowest_vertex(contour);
    for (Point& p : smooth) p = on_grid(p, grid) + lowest;
    return smooth;
}

}  // namespace core
