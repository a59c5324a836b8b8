#include "core/views/picture_render.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace core {
namespace {

constexpr int kFiner = 2;             // drawn pixels a side of one of the picture
constexpr double kMarginPx = 5.0;     // of the picture, at least, on every side
constexpr float kShadeSteps = 32.0F;  // brightness from 0 to 1

/// A corner as it is drawn: finer pixels, y down, larger depth nearer.
struct Corner {
    float x = 0.0F, y = 0.0F, depth = 0.0F;
};

struct Pixel {
    float depth = -std::numeric_limits<float>::infinity();
    std::uint8_t r = 0, g = 0, b = 0;
    [[nodiscard]] bool covered() const { return depth > -std::numeric_limits<float>::infinity(); }
};

/// From the image plane to finer pixels.
struct Frame {
    double scale = 1.0;
    Point middle;
    double centre_x = 0.0, centre_y = 0.0;

    [[nodiscard]] Corner place(const Camera& camera, Vec3 v) const {
        const Point p = camera.project(v);
        return {static_cast<float>(centre_x + (p.x - middle.x) * scale),
                static_cast<float>(centre_y - (p.y - middle.y) * scale), static_cast<float>(camera.nearness(v))};
    }
};

bool is_finite(Vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_sound(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& face) {
    return std::all_of(face.begin(), face.end(),
                       [&mesh](std::uint32_t i) { return i < mesh.vertices.size() && is_finite(mesh.vertices[i]); });
}

/// Fits the box of what the camera sees into the picture; nothing where there is nothing to see.
std::optional<Frame> frame_of(const TriangleMesh& mesh, const Camera& camera, PictureSize size) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Point low{kFar, kFar}, high{-kFar, -kFar};
    for (const auto& face : mesh.triangles) {
        if (!is_sound(mesh, face)) continue;
        for (const std::uint32_t i : face) {
            const Point p = camera.project(mesh.vertices[i]);
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    }
    if (!(low.x <= high.x)) return std::nullopt;
    const double width = std::max(high.x - low.x, 1e-9), height = std::max(high.y - low.y, 1e-9);
    const double room_x = std::max(size.width_px - 2 * kMarginPx, 1.0);
    const double room_y = std::max(size.height_px - 2 * kMarginPx, 1.0);
    return Frame{kFiner * std::min(room_x / width, room_y / height), midpoint(low, high), 0.5 * kFiner * size.width_px,
                 0.5 * kFiner * size.height_px};
}

/// The picture while it is drawn.
class Canvas {
  public:
    explicit Canvas(PictureSize size)
        : width_(kFiner * size.width_px),
          height_(kFiner * size.height_px),
          pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

    void draw(std::array<Corner, 3> t, const Rgb& colour) {
        // In one order, so that winding changes no rounding.
        std::sort(t.begin(), t.end(), [](const Corner& a, const Corner& b) {
            return a.y != b.y ? a.y < b.y : a.x != b.x ? a.x < b.x : a.depth < b.depth;
        });
        const float nearest = std::max({t[0].depth, t[1].depth, t[2].depth});
        const float farthest = std::min({t[0].depth, t[1].depth, t[2].depth});
        const Plane plane(t);
        const auto put = [&](int x, int y) {
            const float depth = plane.depth(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            set(x, y, std::clamp(depth, farthest, nearest), colour);
        };
        const float top = std::min({t[0].y, t[1].y, t[2].y}), bottom = std::max({t[0].y, t[1].y, t[2].y});
        const int first = first_centre(top), last = last_centre(bottom, height_);
        for (int y = std::max(first, 0); y <= last; ++y) draw_row(t, y, put);
        if (first <= last) return;
        // Between two rows of centres: a line along the nearer one.
        const int y = static_cast<int>(std::floor(0.5F * (top + bottom)));
        const float left = std::min({t[0].x, t[1].x, t[2].x}), right = std::max({t[0].x, t[1].x, t[2].x});
        for (int x = static_cast<int>(std::floor(left)); x <= static_cast<int>(std::floor(right)); ++x) put(x, y);
    }

    [[nodiscard]] RgbaImage averaged() const {
        RgbaImage image;
        image.width = width_ / kFiner;
        image.height = height_ / kFiner;
        image.pixels.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                for (const std::uint8_t byte : average(x, y)) image.pixels.push_back(byte);
            }
        }
        return image;
    }

  private:
    /// Depth over the triangle's plane; of the first corner where it is seen edge-on.
    class Plane {
      public:
        explicit Plane(const std::array<Corner, 3>& t) : at_(t[0]) {
            const float x1 = t[1].x - t[0].x, y1 = t[1].y - t[0].y, d1 = t[1].depth - t[0].depth;
            const float x2 = t[2].x - t[0].x, y2 = t[2].y - t[0].y, d2 = t[2].depth - t[0].depth;
            const float twice_area = x1 * y2 - x2 * y1;
            if (std::abs(twice_area) < 1e-6F) return;
            along_x_ = (d1 * y2 - d2 * y1) / twice_area;
            along_y_ = (x1 * d2 - x2 * d1) / twice_area;
        }
        [[nodiscard]] float depth(float x, float y) const {
            return at_.depth + along_x_ * (x - at_.x) + along_y_ * (y - at_.y);
        }

      private:
        Corner at_;
        float along_x_ = 0.0F, along_y_ = 0.0F;
    };

    static int first_centre(float top) { return static_cast<int>(std::ceil(std::max(top, -1.0F) - 0.5F)); }
    static int last_centre(float bottom, int rows) {
        return static_cast<int>(std::floor(std::min(bottom, static_cast<float>(rows)) - 0.5F));
    }

    /// The pixels of one row whose centres lie inside, or the one that holds the middle where there are none.
    template <typename Put>
    void draw_row(const std::array<Corner, 3>& t, int y, const Put& put) const {
        const float at = static_cast<float>(y) + 0.5F;
        float left = std::numeric_limits<float>::infinity(), right = -left;
        for (std::size_t k = 0; k < 3; ++k) {
            const Corner &a = t[k], &b = t[(k + 1) % 3];
            if (std::min(a.y, b.y) > at || std::max(a.y, b.y) < at) continue;
            const float share = a.y == b.y ? 0.0F : (at - a.y) / (b.y - a.y);
            const float x = a.x + share * (b.x - a.x);
            left = std::min({left, x, a.y == b.y ? b.x : x});
            right = std::max({right, x, a.y == b.y ? b.x : x});
        }
        if (!(left <= right)) return;
        const int from = first_centre(left), to = last_centre(right, width_);
        if (from > to) return put(static_cast<int>(std::floor(0.5F * (left + right))), y);
        for (int x = std::max(from, 0); x <= to; ++x) put(x, y);
    }

    void set(int x, int y, float depth, const Rgb& colour) {
        if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
        Pixel& pixel =
            pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
        if (depth > pixel.depth) pixel = {depth, colour.r, colour.g, colour.b};
    }

    [[nodiscard]] std::array<std::uint8_t, 4> average(int x, int y) const {
        int r = 0, g = 0, b = 0, covered = 0;
        for (int i = 0; i < kFiner * kFiner; ++i) {
            const Pixel& p =
                pixels_[static_cast<std::size_t>(kFiner * y + i / kFiner) * static_cast<std::size_t>(width_) +
                        static_cast<std::size_t>(kFiner * x + i % kFiner)];
            if (!p.covered()) continue;
            r += p.r, g += p.g, b += p.b, ++covered;
        }
        if (covered == 0) return {0, 0, 0, 0};
        const auto mean = [covered](int sum) { return few((sum + covered / 2) / covered); };
        return {mean(r), mean(g), mean(b), static_cast<std::uint8_t>(255 * covered / (kFiner * kFiner))};
    }

    /// The nearest of 32 values, so that most pictures have few enough colours for a palette.
    static std::uint8_t few(int value) {
        const int level = std::min(value + 4, 255) >> 3;
        return static_cast<std::uint8_t>(level << 3 | level >> 2);
    }

    int width_, height_;
    std::vector<Pixel> pixels_;
};

/// Light from the camera and from above it on the left, the same for both sides of a face.
float brightness(Vec3 normal, const Camera& camera) {
    const double size = length(normal);
    if (!(size > 0.0)) return 0.6F;
    const Vec3 lamp = normalised(camera.direction + camera.up * 0.9 - camera.right() * 0.6);
    Vec3 facing = normal * (1.0 / size);
    const double towards = dot(facing, camera.direction);
    constexpr double kEdgeOn = 1e-9;  // then the lit side counts
    if (towards < -kEdgeOn || (towards < kEdgeOn && dot(facing, lamp) < 0.0)) facing = facing * -1.0;
    const double light = 0.30 + 0.28 * dot(facing, camera.direction) + 0.46 * std::max(0.0, dot(facing, lamp));
    return std::round(kShadeSteps * static_cast<float>(std::min(light, 1.0))) / kShadeSteps;
}

Rgb shaded(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& face, float light) {
    std::array<int, 3> sum{};
    for (const std::uint32_t i : face) {
        const Rgb c = mesh.colours.empty() ? Rgb{} : mesh.colours[i];
        sum[0] += c.r, sum[1] += c.g, sum[2] += c.b;
    }
    const auto byte = [light](int s) {
        return static_cast<std::uint8_t>(std::lround(light * static_cast<float>(s) / 3.0F));
    };
    return {byte(sum[0]), byte(sum[1]), byte(sum[2])};
}

}  // namespace

RgbaImage render_picture(const TriangleMesh& mesh, const Camera& camera, PictureSize size) {
    Canvas canvas(size);
    const std::optional<Frame> frame = frame_of(mesh, camera, size);
    if (!frame) return canvas.averaged();
    for (const auto& face : mesh.triangles) {
        if (!is_sound(mesh, face)) continue;
        const Vec3 a = mesh.vertices[face[0]], b = mesh.vertices[face[1]], c = mesh.vertices[face[2]];
        const float light = brightness(cross(b - a, c - a), camera);
        canvas.draw({frame->place(camera, a), frame->place(camera, b), frame->place(camera, c)},
                    shaded(mesh, face, light));
    }
    return canvas.averaged();
}

}  // namespace core
