// Developer's look at the starter collection: every model rendered in profile and from the front corner, as one PNG.
//
//     croquis_contact_sheet OUT.png [CLASS...]     all classes when none is named; prints one line a model
//
// Each model takes two tiles: its plain profile or face (what a child would draw), and the view 35 degrees round, 18
// up.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include "core/silhouette/image.hpp"
#include "core/starter/starter_collection.hpp"
#include "core/views/camera.hpp"

namespace {

using core::TriangleMesh;
using core::Vec3;

constexpr int kTile = 150, kTilesAcross = 10, kSamples = 2;

core::Camera camera_at(double azimuth, double elevation) {
    const double a = azimuth * std::numbers::pi / 180.0, e = elevation * std::numbers::pi / 180.0;
    const Vec3 direction{std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
    const Vec3 right = core::normalised(core::cross({0.0, 1.0, 0.0}, direction));
    return {direction, core::cross(direction, right)};
}

TriangleMesh normalised_frame(TriangleMesh mesh) {
    Vec3 low = mesh.vertices.front(), high = low;
    for (const Vec3 v : mesh.vertices) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    double reach = 0.0;
    for (Vec3& v : mesh.vertices) {
        v = v - (low + high) * 0.5;
        reach = std::max(reach, core::length(v));
    }
    for (Vec3& v : mesh.vertices) v = v * (0.98 / reach);
    return mesh;
}

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh) {
    std::vector<Vec3> normals(mesh.vertices.size());
    for (const auto& t : mesh.triangles) {
        const Vec3 n =
            core::cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]);
        for (const auto i : t) normals[i] = normals[i] + n;
    }
    for (Vec3& n : normals) n = core::normalised(n);
    return normals;
}

/// Colour and depth at kSamples times the tile's resolution.
class Raster {
  public:
    explicit Raster(int size)
        : size_(size), depth_(static_cast<std::size_t>(size) * size, -1e9), colour_(depth_.size(), kPaper) {}

    void draw(const TriangleMesh& mesh, const core::Camera& camera) {
        const std::vector<Vec3> normals = vertex_normals(mesh);
        for (const auto& t : mesh.triangles) triangle(mesh, normals, t, camera);
    }
    [[nodiscard]] Vec3 at(int x, int y) const { return colour_[static_cast<std::size_t>(y) * size_ + x]; }

  private:
    static constexpr Vec3 kPaper{255.0, 253.0, 248.0};

    void triangle(const TriangleMesh& mesh, const std::vector<Vec3>& normals, const std::array<std::uint32_t, 3>& t,
                  const core::Camera& camera) {
        core::Point p[3];
        for (int i = 0; i < 3; ++i) {
            const core::Point q = camera.project(mesh.vertices[t[i]]);
            p[i] = {(q.x + 1.0) * 0.5 * size_, (1.0 - q.y) * 0.5 * size_};
        }
        const double area = core::cross(p[1] - p[0], p[2] - p[0]);
        if (std::abs(area) < 1e-9) return;
        const auto bounds = [&](auto value) {
            const auto [low, high] = std::minmax({value(p[0]), value(p[1]), value(p[2])});
            return std::pair{std::max(0, static_cast<int>(low)), std::min(size_ - 1, static_cast<int>(high))};
        };
        const auto [x0, x1] = bounds([](core::Point q) { return q.x; });
        const auto [y0, y1] = bounds([](core::Point q) { return q.y; });
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const core::Point q{x + 0.5, y + 0.5};
                const double a = core::cross(p[2] - p[1], q - p[1]) / area,
                             b = core::cross(p[0] - p[2], q - p[2]) / area;
                const double c = 1.0 - a - b;
                if (a < 0.0 || b < 0.0 || c < 0.0) continue;
                const auto mix = [&](const auto& values) {
                    return values[t[0]] * a + values[t[1]] * b + values[t[2]] * c;
                };
                const double depth = camera.nearness(mix(mesh.vertices));
                const std::size_t at = static_cast<std::size_t>(y) * size_ + x;
                if (depth <= depth_[at]) continue;
                depth_[at] = depth;
                colour_[at] = shade(mesh, t, {a, b, c}, core::normalised(mix(normals)), camera);
            }
    }

    static Vec3 shade(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t, Vec3 w, Vec3 normal,
                      const core::Camera& camera) {
        const auto colour = [&](int i) {
            const core::Rgb c = mesh.colours[t[i]];
            return Vec3{double(c.r), double(c.g), double(c.b)};
        };
        const Vec3 albedo = colour(0) * w.x + colour(1) * w.y + colour(2) * w.z;
        const Vec3 key = core::normalised(camera.direction + camera.up * 0.9 + camera.right() * -0.5);
        const double inward =
            core::dot(normal, camera.direction) < -0.15 ? 0.0 : 1.0;  // inside-out faces show as magenta
        if (inward == 0.0) return {255.0, 0.0, 255.0};
        const double light = 0.5 + 0.42 * std::max(0.0, core::dot(normal, key)) + 0.12 * normal.y;
        return albedo * std::min(light, 1.06);
    }

    int size_;
    std::vector<double> depth_;
    std::vector<Vec3> colour_;
};

void put(core::RgbaImage& sheet, const Raster& raster, int left, int top) {
    for (int y = 0; y < kTile; ++y)
        for (int x = 0; x < kTile; ++x) {
            Vec3 sum;
            for (int j = 0; j < kSamples; ++j)
                for (int i = 0; i < kSamples; ++i) sum = sum + raster.at(x * kSamples + i, y * kSamples + j);
            sum = sum * (1.0 / (kSamples * kSamples));
            const std::size_t at = (static_cast<std::size_t>(top + y) * sheet.width + left + x) * 4;
            const double values[3]{sum.x, sum.y, sum.z};
            for (int c = 0; c < 3; ++c)
                sheet.pixels[at + c] = static_cast<std::uint8_t>(std::clamp(values[c], 0.0, 255.0));
            sheet.pixels[at + 3] = 255;
        }
}

/// The azimuth that shows more of the model: its side or its face.
double best_azimuth(const TriangleMesh& mesh) {
    double wide_x = 0.0, wide_z = 0.0;
    for (const Vec3 v : mesh.vertices) {
        wide_x = std::max(wide_x, std::abs(v.x));
        wide_z = std::max(wide_z, std::abs(v.z));
    }
    return wide_z > wide_x ? 90.0 : 0.0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::puts("use: croquis_contact_sheet OUT.png [CLASS...]");
        return 2;
    }
    const std::set<std::string, std::less<>> wanted(argv + 2, argv + argc);
    std::vector<core::StarterModel> models;
    for (core::StarterModel& m : core::starter_collection())
        if (wanted.empty() || wanted.contains(m.class_name)) models.push_back(std::move(m));
    const int rows = (static_cast<int>(models.size()) * 2 + kTilesAcross - 1) / kTilesAcross;
    core::RgbaImage sheet{kTile * kTilesAcross, kTile * rows, {}};
    sheet.pixels.assign(static_cast<std::size_t>(sheet.width) * sheet.height * 4, 255);
    int tile = 0;
    for (const core::StarterModel& m : models) {
        std::printf("row %d  %-16s %-24s %6zu triangles\n", tile / kTilesAcross, m.class_name.c_str(), m.name.c_str(),
                    m.mesh.triangles.size());
        const TriangleMesh mesh = normalised_frame(m.mesh);
        const double azimuth = best_azimuth(mesh);
        for (const auto& [turn, up] : {std::pair{0.0, 0.0}, std::pair{azimuth > 0 ? -35.0 : 35.0, 18.0}}) {
            Raster raster(kTile * kSamples);
            raster.draw(mesh, camera_at(azimuth + turn, up));
            put(sheet, raster, tile % kTilesAcross * kTile, tile / kTilesAcross * kTile);
            ++tile;
        }
    }
    return stbi_write_png(argv[1], sheet.width, sheet.height, 4, sheet.pixels.data(), 0) ? 0 : 1;
}
