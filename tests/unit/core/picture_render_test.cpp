#include "core/views/picture_render.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "core/views/cameras.hpp"

using core::Camera;
using core::RgbaImage;
using core::TriangleMesh;

namespace {

/// A square that faces +z, from -1 to 1, cut in two.
TriangleMesh square(double z = 0.0, core::Rgb colour = {}) {
    TriangleMesh mesh;
    mesh.vertices = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.colours.assign(4, colour);
    return mesh;
}

std::uint8_t alpha(const RgbaImage& image, int x, int y) {
    return image.pixels[static_cast<std::size_t>((y * image.width + x) * 4 + 3)];
}
std::uint8_t red(const RgbaImage& image, int x, int y) {
    return image.pixels[static_cast<std::size_t>((y * image.width + x) * 4)];
}

int covered(const RgbaImage& image) {
    int count = 0;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) count += image.pixels[i] > 0 ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("a model fills the picture but for a margin", "[picture]") {
    const RgbaImage image = core::render_picture(square(), Camera{});
    REQUIRE(image.width == 192);
    REQUIRE(image.height == 144);
    CHECK(covered(image) == 134 * 134);
    CHECK(alpha(image, 96, 4) == 0);
    CHECK(alpha(image, 96, 5) == 255);
    CHECK(alpha(image, 96, 138) == 255);
    CHECK(alpha(image, 96, 139) == 0);
}

TEST_CASE("the nearer face hides the other, in whichever order they come", "[picture]") {
    for (const bool near_first : {true, false}) {
        TriangleMesh mesh = square(near_first ? 0.5 : -0.5, near_first ? core::Rgb{200, 0, 0} : core::Rgb{0, 200, 0});
        const TriangleMesh other =
            square(near_first ? -0.5 : 0.5, near_first ? core::Rgb{0, 200, 0} : core::Rgb{200, 0, 0});
        mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
        mesh.colours.insert(mesh.colours.end(), other.colours.begin(), other.colours.end());
        for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
        CHECK(red(core::render_picture(mesh, Camera{}), 96, 72) > 100);
    }
}

TEST_CASE("winding does not matter", "[picture]") {
    TriangleMesh flipped = square();
    for (auto& t : flipped.triangles) std::swap(t[0], t[1]);
    for (const Camera& camera : core::cameras()) {
        CAPTURE(camera.direction.x, camera.direction.y, camera.direction.z);
        CHECK((core::render_picture(flipped, camera).pixels == core::render_picture(square(), camera).pixels));
    }
}

TEST_CASE("faces of different slope differ in brightness", "[picture]") {
    TriangleMesh roof;
    roof.vertices = {{-1, -1, 0}, {0, -1, 1}, {0, 1, 1}, {-1, 1, 0}, {1, -1, 0}, {1, 1, 0}};
    roof.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
    const RgbaImage image = core::render_picture(roof, Camera{});
    CHECK(red(image, 60, 72) > red(image, 130, 72) + 20);  // the lamp is on the left
}

TEST_CASE("what is thinner than a pixel still shows", "[picture]") {
    for (const bool upright : {true, false}) {
        TriangleMesh wire = square();
        for (auto& v : wire.vertices) (upright ? v.x : v.y) *= 1e-4;
        CHECK(covered(core::render_picture(wire, Camera{})) >= 130);
    }
    const TriangleMesh edge_on = square();
    CHECK(covered(core::render_picture(edge_on, Camera{{1, 0, 0}, {0, 1, 0}})) >= 130);
}

TEST_CASE("faces that cannot be drawn are passed over", "[picture]") {
    TriangleMesh mesh = square();
    mesh.vertices.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
    mesh.vertices.push_back({0, std::numeric_limits<double>::infinity(), 0});
    mesh.colours.assign(6, {});
    mesh.triangles.push_back({0, 1, 4});
    mesh.triangles.push_back({0, 1, 5});
    mesh.triangles.push_back({0, 1, 99});
    CHECK((core::render_picture(mesh, Camera{}).pixels == core::render_picture(square(), Camera{}).pixels));
    CHECK(covered(core::render_picture({}, Camera{})) == 0);
}

TEST_CASE("a picture of one colour has few enough colours for a palette", "[picture]") {
    TriangleMesh fan;
    fan.vertices.push_back({0, 0, 1});
    for (int i = 0; i < 200; ++i) fan.vertices.push_back({std::cos(0.0314 * i), std::sin(0.0314 * i), 0});
    for (std::uint32_t i = 1; i < 200; ++i) fan.triangles.push_back({0, i, i + 1});
    const RgbaImage image = core::render_picture(fan, core::cameras()[30]);
    std::set<std::array<std::uint8_t, 4>> colours;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        colours.insert({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2], image.pixels[i + 3]});
    }
    CHECK(colours.size() > 5);
    CHECK(colours.size() <= 256);
}
