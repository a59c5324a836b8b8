#include "support/mesh_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace support {
namespace {

using core::Vec3;

constexpr int kSamples = 3;  // a pixel and side

/// A larger picture with depth, averaged in the end.
struct Canvas {
    int width, height;
    std::vector<float> depth;
    std::vector<core::Rgb> colour;

    Canvas(int w, int h)
        : width(w),
          height(h),
          depth(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), -std::numeric_limits<float>::max()),
          colour(depth.size(), core::Rgb{255, 255, 255}) {}
    void put(int x, int y, double z, core::Rgb c) {
        if (x < 0 || y < 0 || x >= width || y >= height) return;
        const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        if (static_cast<float>(z) < depth[at]) return;
        depth[at] = static_cast<float>(z);
        colour[at] = c;
    }
};

/// Canvas coordinates: x right, y down, z towards the viewer.
struct Projection {
    double cos_yaw, sin_yaw, cos_pitch, sin_pitch;
    double scale = 1.0, centre_x = 0.0, centre_y = 0.0;

    explicit Projection(const PictureView& view) {
        const double yaw = view.yaw_degrees * std::numbers::pi / 180.0;
        const double pitch = view.pitch_degrees * std::numbers::pi / 180.0;
        cos_yaw = std::cos(yaw), sin_yaw = std::sin(yaw), cos_pitch = std::cos(pitch), sin_pitch = std::sin(pitch);
    }
    [[nodiscard]] Vec3 turned(Vec3 p) const {
        const double x = cos_yaw * p.x - sin_yaw * p.z, z = sin_yaw * p.x + cos_yaw * p.z;
        return {x, -(cos_pitch * p.y - sin_pitch * z), sin_pitch * p.y + cos_pitch * z};
    }
    [[nodiscard]] Vec3 operator()(Vec3 p) const {
        const Vec3 t = turned(p);
        return {t.x * scale + centre_x, t.y * scale + centre_y, t.z * scale};
    }
};

Projection fit(const std::vector<PictureMesh>& meshes, const PictureView& view) {
    Projection projection(view);
    double low_x = 1e300, low_y = 1e300, high_x = -1e300, high_y = -1e300;
    for (const PictureMesh& m : meshes)
        for (const Vec3 v : m.mesh->vertices) {
            const Vec3 p = projection.turned(v);
            low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
            low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
        }
    const double margin = 0.94 * kSamples;
    projection.scale =
        margin * std::min(view.width / std::max(high_x - low_x, 1e-9), view.height / std::max(high_y - low_y, 1e-9));
    projection.centre_x = kSamples * view.width * 0.5 - projection.scale * (low_x + high_x) * 0.5;
    projection.centre_y = kSamples * view.height * 0.5 - projection.scale * (low_y + high_y) * 0.5;
    return projection;
}

core::Rgb lit(core::Rgb colour, Vec3 normal) {
    const Vec3 n = core::normalised(normal);
    const Vec3 key = core::normalised({-0.4, -0.55, 0.75});
    const double facing = n.z < 0.0 ? -1.0 : 1.0;
    const double light = 0.32 + 0.68 * std::max(0.0, facing * core::dot(n, key));
    const double dim = n.z < 0.0 ? 0.82 : 1.0;  // the inner side
    const auto channel = [&](std::uint8_t c) {
        return static_cast<std::uint8_t>(std::clamp(c * light * dim, 0.0, 255.0));
    };
    return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

/// `shade` holds a normal for each corner.
void triangle(Canvas& canvas, const Vec3 (&p)[3], const Vec3 (&normal)[3], core::Rgb colour) {
    const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (std::abs(area) < 1e-12) return;
    const int y0 = std::max(0, static_cast<int>(std::floor(std::min({p[0].y, p[1].y, p[2].y}))));
    const int y1 = std::min(canvas.height - 1, static_cast<int>(std::ceil(std::max({p[0].y, p[1].y, p[2].y}))));
    const int x0 = std::max(0, static_cast<int>(std::floor(std::min({p[0].x, p[1].x, p[2].x}))));
    const int x1 = std::min(canvas.width - 1, static_cast<int>(std::ceil(std::max({p[0].x, p[1].x, p[2].x}))));
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            const double b = ((px - p[0].x) * (p[2].y - p[0].y) - (py - p[0].y) * (p[2].x - p[0].x)) / area;
            const double c = ((p[1].x - p[0].x) * (py - p[0].y) - (p[1].y - p[0].y) * (px - p[0].x)) / area;
            const double a = 1.0 - b - c;
            if (a < -1e-9 || b < -1e-9 || c < -1e-9) continue;
            canvas.put(x, y, a * p[0].z + b * p[1].z + c * p[2].z,
                       lit(colour, normal[0] * a + normal[1] * b + normal[2] * c));
        }
}

void line(Canvas& canvas, Vec3 a, Vec3 b, core::Rgb colour) {
    const int steps = static_cast<int>(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y))) + 1;
    for (int i = 0; i <= steps; ++i) {
        const Vec3 p = a + (b - a) * (static_cast<double>(i) / steps);
        for (const int dy : {0, 1})
            for (const int dx : {0, 1})
                canvas.put(static_cast<int>(p.x) + dx, static_cast<int>(p.y) + dy, p.z + 2.5, colour);
    }
}

std::vector<Vec3> corner_normals(const std::vector<Vec3>& places, const core::QuadMesh& mesh) {
    std::vector<Vec3> normals(places.size());
    for (const core::Quad& q : mesh.quads) {
        // y is turned down on the canvas, so the order of the product is turned round as well
        const Vec3 n = core::cross(places[q[3]] - places[q[1]], places[q[2]] - places[q[0]]);
        for (const std::uint32_t v : q) normals[v] = normals[v] + n;
    }
    return normals;
}

void draw(Canvas& canvas, const PictureMesh& picture, const Projection& projection) {
    const core::QuadMesh& mesh = *picture.mesh;
    std::vector<Vec3> places;
    for (const Vec3 v : mesh.vertices) places.push_back(projection(v));
    const std::vector<Vec3> normals = corner_normals(places, mesh);
    for (const core::Quad& q : mesh.quads)
        for (const int k : {0, 2}) {
            const auto i = q[0], j = q[static_cast<std::size_t>(k == 0 ? 1 : 2)],
                       l = q[static_cast<std::size_t>(k == 0 ? 2 : 3)];
            triangle(canvas, {places[i], places[j], places[l]}, {normals[i], normals[j], normals[l]}, picture.colour);
        }
    if (!picture.wire) return;
    const auto darker = [](std::uint8_t c) { return static_cast<std::uint8_t>(c * 2 / 5); };
    const core::Rgb ink{darker(picture.colour.r), darker(picture.colour.g), darker(picture.colour.b)};
    for (const core::Quad& q : mesh.quads)
        for (std::size_t k = 0; k < 4; ++k) line(canvas, places[q[k]], places[q[(k + 1) % 4]], ink);
}

}  // namespace

core::RgbaImage draw_meshes(const std::vector<PictureMesh>& meshes, const PictureView& view) {
    Canvas canvas(view.width * kSamples, view.height * kSamples);
    const Projection projection = fit(meshes, view);
    for (const PictureMesh& m : meshes) draw(canvas, m, projection);
    core::RgbaImage image{view.width, view.height, {}};
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            int r = 0, g = 0, b = 0;
            for (int k = 0; k < kSamples * kSamples; ++k) {
                const auto at =
                    static_cast<std::size_t>(y * kSamples + k / kSamples) * static_cast<std::size_t>(canvas.width) +
                    static_cast<std::size_t>(x * kSamples + k % kSamples);
                r += canvas.colour[at].r, g += canvas.colour[at].g, b += canvas.colour[at].b;
            }
            for (const int sum : {r, g, b})
                image.pixels.push_back(static_cast<std::uint8_t>(sum / (kSamples * kSamples)));
            image.pixels.push_back(255);
        }
    return image;
}

core::RgbaImage side_by_side(const std::vector<core::RgbaImage>& pictures) {
    core::RgbaImage all{0, pictures.front().height, {}};
    for (const core::RgbaImage& p : pictures) all.width += p.width;
    for (int y = 0; y < all.height; ++y)
        for (const core::RgbaImage& p : pictures) {
            const auto row = static_cast<std::ptrdiff_t>(y) * p.width * 4;
            all.pixels.insert(all.pixels.end(), p.pixels.begin() + row, p.pixels.begin() + row + p.width * 4);
        }
    return all;
}

}  // namespace support
