#include "core/mesh/distance_grid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/mesh/surface_net.hpp"

using core::DistanceGrid;
using core::QuadMesh;
using core::Vec3;

namespace {

QuadMesh ball(double radius) {
    core::FieldGrid grid;
    grid.origin = {-12, -12, -12};
    grid.nx = grid.ny = grid.nz = 25;
    grid.value.resize(25 * 25 * 25);
    for (int z = 0; z < 25; ++z)
        for (int y = 0; y < 25; ++y)
            for (int x = 0; x < 25; ++x)
                grid.value[grid.index(x, y, z)] = static_cast<float>(core::length(grid.place(x, y, z)) - radius);
    QuadMesh mesh = core::surface_net(grid);
    for (Vec3& v : mesh.vertices) v = core::normalised(v) * radius;
    return mesh;
}

/// n x n quads over [0, 10] x [0, 10], facing +z.
QuadMesh sheet(int n) {
    QuadMesh mesh;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) mesh.vertices.push_back({10.0 * i / n, 10.0 * j / n, 0.0});
    const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) mesh.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return mesh;
}

}  // namespace

TEST_CASE("distances to a ball, near and far, inside and outside", "[distance_grid]") {
    const auto grid = DistanceGrid::of_body(core::triangles_of(ball(8.0)), {1.0, 6.0, 0.0});
    REQUIRE(grid);
    for (int k = 0; k < 60; ++k) {
        const Vec3 d = core::normalised({std::sin(k * 1.3), std::cos(k * 0.7), std::sin(k * 0.37 + 1.0)});
        CHECK(grid->distance(d * 8.0) == Approx(0.0).margin(0.08));
        CHECK(grid->distance(d * 9.0) == Approx(1.0).margin(0.1));
        CHECK(grid->distance(d * 12.0) == Approx(4.0).margin(0.4));
        CHECK(grid->distance(d * 5.0) == Approx(-3.0).margin(0.3));
        const core::FieldSample s = grid->sample(d * 9.0);
        CHECK(core::dot(s.gradient, d) > 0.98);
    }
    CHECK(grid->distance({30, 0, 0}) == Approx(22.0).margin(1.0));  // beyond the grid
}

TEST_CASE("a mesh that is not closed is refused", "[distance_grid]") {
    CHECK(DistanceGrid::of_body(core::triangles_of(sheet(3)), {}).error().code == core::ErrorCode::BadMesh);
    CHECK_FALSE(DistanceGrid::of_body({}, {}));
    core::TriangleMesh turned = core::triangles_of(ball(8.0));
    CHECK(core::is_closed(turned));
    std::swap(turned.triangles[3][0], turned.triangles[3][1]);
    CHECK_FALSE(core::is_closed(turned));
}

TEST_CASE("a sheet has two sides, and none beside its border", "[distance_grid]") {
    const DistanceGrid grid = DistanceGrid::of_sheet(sheet(5), {0.5, 0.0, 3.0});
    CHECK(grid.distance({5, 5, 2}) == Approx(2.0));
    CHECK(grid.distance({5, 5, -2}) == Approx(-2.0));
    CHECK(grid.distance({11, 5, -1}) == Approx(std::sqrt(2.0)).margin(0.05));
    CHECK(grid.distance({5, 5, 3.6}) == DistanceGrid::kFar);
    CHECK(grid.distance({5, 5, 99}) == DistanceGrid::kFar);
    CHECK(grid.sample({5, 5, -1}).gradient.z == Approx(1.0));
    CHECK(core::length(grid.sample({5, 5, 50}).gradient) == 0.0);
}
