#include "core/mesh/simplify.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/views/cameras.hpp"
#include "core/views/silhouette_render.hpp"

using core::ErrorCode;
using core::Rgb;
using core::TriangleMesh;
using core::Vec3;

namespace {

/// A unit ball of 2 * 80 * 80 triangles, its upper half red, its lower half green; no vertex is shared.
TriangleMesh ball() {
    TriangleMesh mesh;
    const auto at = [](int i, int k) {
        const double v = i * 3.14159265358979 / 80, u = k * 2 * 3.14159265358979 / 80;
        return Vec3{std::sin(v) * std::cos(u), std::cos(v), std::sin(v) * std::sin(u)};
    };
    for (int i = 0; i < 80; ++i) {
        for (int k = 0; k < 80; ++k) {
            const Vec3 corners[] = {at(i, k), at(i + 1, k), at(i, k + 1), at(i, k + 1), at(i + 1, k), at(i + 1, k + 1)};
            for (const Vec3& p : corners) {
                const auto index = static_cast<std::uint32_t>(mesh.vertices.size());
                if (index % 3 == 0) mesh.triangles.push_back({index, index + 1, index + 2});
                mesh.vertices.push_back(p);
                mesh.colours.push_back(i < 40 ? Rgb{200, 0, 0} : Rgb{0, 200, 0});
            }
        }
    }
    return mesh;
}

}  // namespace

TEST_CASE("a simplified mesh has few triangles, and looks like the mesh from every side", "[simplify]") {
    const TriangleMesh mesh = ball();
    const TriangleMesh small = *core::simplified_mesh(mesh, 1000);
    CHECK(small.triangles.size() <= 1000);
    CHECK(small.triangles.size() > 500);
    for (const int c : core::representative_cameras()) {
        const core::Camera& camera = core::cameras()[static_cast<std::size_t>(c)];
        const core::BinaryImage a = core::render_silhouette(mesh, camera, 128),
                                b = core::render_silhouette(small, camera, 128);
        int different = 0, object = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            different += a.pixels[i] != b.pixels[i] ? 1 : 0;
            object += a.pixels[i];
        }
        CHECK(different < 0.03 * object);
    }
}

TEST_CASE("colours stay what they were, and where they were", "[simplify]") {
    const TriangleMesh small = *core::simplified_mesh(ball(), 600);
    REQUIRE(small.colours.size() == small.vertices.size());
    for (std::size_t i = 0; i < small.vertices.size(); ++i) {
        const bool red = small.colours[i] == Rgb{200, 0, 0};
        CHECK((red || small.colours[i] == Rgb{0, 200, 0}));
        if (std::abs(small.vertices[i].y) > 0.25) CHECK(red == (small.vertices[i].y > 0.0));
    }
}

TEST_CASE("a small mesh comes back unchanged, and the result repeats", "[simplify]") {
    const TriangleMesh mesh = ball();
    CHECK(core::simplified_mesh(mesh, mesh.triangles.size())->vertices == mesh.vertices);
    CHECK(core::simplified_mesh(mesh, 300)->vertices == core::simplified_mesh(mesh, 300)->vertices);
    CHECK(core::simplified_mesh({}, 10)->empty());
}

TEST_CASE("what cannot be simplified is refused", "[simplify]") {
    CHECK(core::simplified_mesh(ball(), 3).error().code == ErrorCode::BadArgument);
    TriangleMesh broken = ball();
    broken.triangles[5][1] = 4000000;
    CHECK(core::simplified_mesh(broken, 100).error().code == ErrorCode::BadMesh);
    broken = ball();
    broken.vertices[7].x = std::numeric_limits<double>::quiet_NaN();
    CHECK(core::simplified_mesh(broken, 100).error().code == ErrorCode::BadMesh);
}
