#include "core/views/silhouette_render.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/mesh/normalise.hpp"
#include "core/views/cameras.hpp"

using core::BinaryImage;
using core::Camera;
using core::Point;
using core::TriangleMesh;
using core::Vec3;

namespace {

constexpr int kSize = 64;
const Camera kFront = core::camera_from({0, 0, 1});

TriangleMesh triangle(Vec3 a, Vec3 b, Vec3 c) {
    return {{a, b, c}, {{0, 1, 2}}, {}};
}

/// A square from -h to h in the plane of the image.
TriangleMesh square(double h) {
    return {{{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}};
}

long count(const BinaryImage& image) {
    return std::count(image.pixels.begin(), image.pixels.end(), 1);
}

/// The number of 8-connected components of ones.
int components(BinaryImage image) {
    int found = 0;
    std::vector<std::pair<int, int>> open;
    const auto visit = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= image.width || y >= image.height || image.at(x, y) == 0) return;
        image.at(x, y) = 0;
        open.emplace_back(x, y);
    };
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.at(x, y) == 0) continue;
            ++found;
            visit(x, y);
            while (!open.empty()) {
                const auto [px, py] = open.back();
                open.pop_back();
                for (int k = 0; k < 9; ++k) visit(px + k % 3 - 1, py + k / 3 - 1);
            }
        }
    }
    return found;
}

/// A lopsided body of many directions, as a test of what must hold for any mesh.
TriangleMesh bent_spike() {
    TriangleMesh mesh;
    for (int i = 0; i <= 40; ++i) {
        const double t = i / 40.0, r = 0.3 * (1.0 - t);
        const Vec3 middle{t, 0.5 * std::sin(3.0 * t), 0.4 * t * t};
        for (int k = 0; k < 6; ++k) {
            mesh.vertices.push_back(middle + Vec3{0, r * std::cos(k * 1.0472), 2 * r * std::sin(k * 1.0472)});
        }
    }
    for (std::uint32_t i = 0; i < 40; ++i) {
        for (std::uint32_t k = 0; k < 6; ++k) {
            const std::uint32_t a = 6 * i + k, b = 6 * i + (k + 1) % 6;
            mesh.triangles.push_back({a, b, a + 6});
            mesh.triangles.push_back({b, b + 6, a + 6});
        }
    }
    return *core::normalised_mesh(std::move(mesh));
}

}  // namespace

TEST_CASE("image plane and pixels translate into each other, with the margin left free", "[silhouette_render]") {
    CHECK(core::to_image_px({-1, 1}, kSize) == Point{core::kViewMarginPx, core::kViewMarginPx});
    CHECK(core::to_image_px({1, -1}, kSize) == Point{kSize - core::kViewMarginPx, kSize - core::kViewMarginPx});
    const Point p = core::to_image_plane(core::to_image_px({0.3, -0.7}, kSize), kSize);
    CHECK(p.x == Approx(0.3));
    CHECK(p.y == Approx(-0.7));
}

TEST_CASE("a square covers exactly its pixels", "[silhouette_render]") {
    const double ten_px = 10.0 / core::pixels_per_unit(kSize);
    const BinaryImage image = core::render_silhouette(square(ten_px), kFront, kSize);
    CHECK(image.width == kSize);
    CHECK(image.height == kSize);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const bool inside = x >= 22 && x < 42 && y >= 22 && y < 42;
            INFO("pixel " << x << ", " << y);
            REQUIRE(image.at(x, y) == (inside ? 1 : 0));
        }
    }
}

TEST_CASE("up is up and right is right", "[silhouette_render]") {
    const BinaryImage image =
        core::render_silhouette(triangle({0.5, 0.5, 0}, {0.9, 0.5, 0}, {0.9, 0.9, 0}), kFront, kSize);
    const Point corner = core::to_image_px({0.85, 0.6}, kSize);
    CHECK(image.at(static_cast<int>(corner.x), static_cast<int>(corner.y)) == 1);
    CHECK(image.at(kSize - 1 - static_cast<int>(corner.x), static_cast<int>(corner.y)) == 0);
    CHECK(image.at(static_cast<int>(corner.x), kSize - 1 - static_cast<int>(corner.y)) == 0);
}

TEST_CASE("which way a face is turned does not matter", "[silhouette_render]") {
    TriangleMesh mesh = bent_spike();
    const BinaryImage image = core::render_silhouette(mesh, kFront, kSize);
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 2) std::swap(mesh.triangles[i][0], mesh.triangles[i][2]);
    CHECK(core::render_silhouette(mesh, kFront, kSize).pixels == image.pixels);
}

TEST_CASE("how a surface is cut into triangles does not matter", "[silhouette_render]") {
    const double h = 0.7731;
    TriangleMesh fine;
    constexpr std::uint32_t kCuts = 200;  // far below a pixel each
    for (std::uint32_t i = 0; i <= kCuts; ++i) {
        for (std::uint32_t k = 0; k <= kCuts; ++k) {
            fine.vertices.push_back({h * (2.0 * i / kCuts - 1), h * (2.0 * k / kCuts - 1), 0});
            if (i == kCuts || k == kCuts) continue;
            const std::uint32_t at = i * (kCuts + 1) + k;
            fine.triangles.push_back({at, at + 1, at + kCuts + 1});
            fine.triangles.push_back({at + 1, at + kCuts + 2, at + kCuts + 1});
        }
    }
    CHECK(core::render_silhouette(fine, kFront, kSize).pixels ==
          core::render_silhouette(square(h), kFront, kSize).pixels);
}

TEST_CASE("a needle thinner than a pixel stays in one piece in every direction", "[silhouette_render]") {
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const double a = degrees * 3.14159265358979 / 180.0;
        const Vec3 tip{0.97 * std::cos(a), 0.97 * std::sin(a), 0.0},
            side{-0.004 * std::sin(a), 0.004 * std::cos(a), 0.0};
        const BinaryImage image =
            core::render_silhouette(triangle(tip * -1.0 + side, tip * -1.0 - side, tip), kFront, 256);
        INFO(degrees << " degrees");
        CHECK(components(image) == 1);
        CHECK(count(image) >=
              static_cast<long>(1.9 * 126 * std::max(std::abs(std::cos(a)), std::abs(std::sin(a)))) - 2);
        CHECK(count(image) < 800);
    }
}

TEST_CASE("a thin wire made of many small triangles stays in one piece from all sides", "[silhouette_render]") {
    TriangleMesh wire;
    for (std::uint32_t i = 0; i <= 300; ++i) {
        const double t = i * 0.02, r = 0.9 - 0.002 * i;
        const Vec3 p{r * std::cos(t), 0.2 * std::sin(3 * t), r * std::sin(t)};
        wire.vertices.push_back(p);
        wire.vertices.push_back(p + Vec3{0.0007, 0.0003, -0.0005});
        if (i == 0) continue;
        wire.triangles.push_back({2 * i - 2, 2 * i - 1, 2 * i});
        wire.triangles.push_back({2 * i - 1, 2 * i + 1, 2 * i});
    }
    for (const Camera& camera : core::cameras()) CHECK(components(core::render_silhouette(wire, camera, 128)) == 1);
}

TEST_CASE("a triangle without area draws a line, a sheet seen edge-on too", "[silhouette_render]") {
    const BinaryImage line =
        core::render_silhouette(triangle({-0.8, 0.11, 0}, {0.8, 0.11, 0}, {0.1, 0.11, 0}), kFront, kSize);
    CHECK(components(line) == 1);
    CHECK(count(line) == Approx(1.6 * core::pixels_per_unit(kSize)).margin(1.5));
    const BinaryImage sheet = core::render_silhouette(square(0.8), core::camera_from({1, 0, 0}), kSize);
    CHECK(components(sheet) == 1);
    CHECK(count(sheet) == Approx(1.6 * core::pixels_per_unit(kSize)).margin(1.5));
}

TEST_CASE("separate parts stay separate and holes stay open", "[silhouette_render]") {
    TriangleMesh two = triangle({-0.8, 0, 0}, {-0.4, 0, 0}, {-0.6, 0.4, 0});
    for (const Vec3& p : {Vec3{0.8, 0, 0}, Vec3{0.4, 0, 0}, Vec3{0.6, 0.4, 0}}) two.vertices.push_back(p);
    two.triangles.push_back({3, 4, 5});
    CHECK(components(core::render_silhouette(two, kFront, kSize)) == 2);

    TriangleMesh frame = square(0.9);
    for (const Vec3& p : square(0.4).vertices) frame.vertices.push_back(p);
    frame.triangles = {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5}, {2, 3, 6}, {3, 7, 6}, {3, 0, 7}, {0, 4, 7}};
    const BinaryImage image = core::render_silhouette(frame, kFront, kSize);
    CHECK(image.at(32, 32) == 0);
    CHECK(components(image) == 1);
}

TEST_CASE("opposite cameras see mirror images up to a pixel at the outline", "[silhouette_render]") {
    const TriangleMesh mesh = bent_spike();
    for (const int c : core::representative_cameras()) {
        const BinaryImage seen = core::render_silhouette(mesh, core::cameras()[static_cast<std::size_t>(c)], kSize);
        const int other = core::opposite_camera(c);
        const BinaryImage behind =
            core::mirrored(core::render_silhouette(mesh, core::cameras()[static_cast<std::size_t>(other)], kSize));
        long different = 0;
        for (std::size_t i = 0; i < seen.pixels.size(); ++i) different += seen.pixels[i] != behind.pixels[i] ? 1 : 0;
        INFO("cameras " << c << " and " << other);
        CHECK(count(seen) > 100);
        CHECK(different <= 4);
    }
}

TEST_CASE("a normalised model leaves the margin free", "[silhouette_render]") {
    const TriangleMesh mesh = bent_spike();
    for (const Camera& camera : core::cameras()) {
        const BinaryImage image = core::render_silhouette(mesh, camera, kSize);
        for (int i = 0; i < kSize; ++i) {
            CHECK(image.at(i, 0) + image.at(0, i) + image.at(i, kSize - 1) + image.at(kSize - 1, i) == 0);
        }
    }
}

TEST_CASE("what is out of the picture, out of range or not finite does no harm", "[silhouette_render]") {
    CHECK(count(core::render_silhouette(square(50.0), kFront, kSize)) == kSize * kSize);
    CHECK(count(core::render_silhouette(square(1e300), kFront, kSize)) == 0);  // not finite in the picture
    CHECK(count(core::render_silhouette(triangle({5, 5, 0}, {6, 5, 0}, {5, 6, 0}), kFront, kSize)) == 0);
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    CHECK(count(core::render_silhouette(triangle({nan, 0, 0}, {1, 0, 0}, {0, 1, 0}), kFront, kSize)) == 0);
    CHECK(count(core::render_silhouette(triangle({0, -inf, 0}, {1, inf, 0}, {0, 1, 0}), kFront, kSize)) == 0);
    TriangleMesh broken = square(0.5);
    broken.triangles = {{0, 1, 9}};
    CHECK(count(core::render_silhouette(broken, kFront, kSize)) == 0);
    CHECK(count(core::render_silhouette({}, kFront, kSize)) == 0);
}
