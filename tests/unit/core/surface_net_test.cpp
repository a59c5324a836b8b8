#include "core/mesh/surface_net.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using core::FieldGrid;
using core::QuadMesh;
using core::Vec3;

namespace {

FieldGrid sampled(int n, const std::function<double(Vec3)>& field) {
    FieldGrid grid;
    grid.origin = {-1, -1, -1};
    grid.cell = 2.0 / (n - 1);
    grid.nx = grid.ny = grid.nz = n;
    grid.value.resize(static_cast<std::size_t>(n * n * n));
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                grid.value[grid.index(x, y, z)] = static_cast<float>(field(grid.place(x, y, z)));
    return grid;
}

/// By the divergence theorem: positive when the quads are anti-clockwise seen from outside.
double volume(const QuadMesh& mesh) {
    double sum = 0.0;
    for (const core::Quad& q : mesh.quads) {
        const Vec3 a = mesh.vertices[q[0]], b = mesh.vertices[q[1]], c = mesh.vertices[q[2]], d = mesh.vertices[q[3]];
        sum += core::dot(a, core::cross(b, c)) + core::dot(a, core::cross(c, d));
    }
    return sum / 6.0;
}

}  // namespace

TEST_CASE("a ball becomes a closed mesh of its volume", "[surface_net]") {
    const QuadMesh ball = core::surface_net(sampled(33, [](Vec3 p) { return core::length(p) - 0.8; }));
    CHECK(core::is_closed_manifold(ball));
    CHECK(volume(ball) == Approx(4.0 / 3.0 * 3.14159265 * 0.512).epsilon(0.02));
    CHECK(ball.vertices.size() == ball.quads.size() + 2);
}

TEST_CASE("where cells hold two sheets, joining them makes a manifold", "[surface_net]") {
    const auto noise = [](Vec3 p) {
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > 0.75) return 1.0;
        return std::sin(91.0 * p.x * p.y + 53.0 * p.z + 1.0) + std::sin(77.0 * p.y * p.z - 41.0 * p.x) + 0.9;
    };
    FieldGrid grid = sampled(21, noise);
    CHECK_FALSE(core::is_closed_manifold(core::surface_net(grid)));
    core::join_double_sheets(grid);
    const QuadMesh joined = core::surface_net(grid);
    CHECK(joined.quads.size() > 100);
    CHECK(core::is_closed_manifold(joined));
}

TEST_CASE("open, doubled and turned meshes are no closed manifolds", "[surface_net]") {
    const QuadMesh cube{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
    CHECK(core::is_closed_manifold(cube));
    QuadMesh open = cube;
    open.quads.pop_back();
    CHECK_FALSE(core::is_closed_manifold(open));
    QuadMesh turned = cube;
    std::swap(turned.quads[2][1], turned.quads[2][3]);
    CHECK_FALSE(core::is_closed_manifold(turned));
    QuadMesh doubled = cube;
    doubled.quads.push_back(cube.quads[0]);
    doubled.quads.push_back({1, 2, 3, 0});
    CHECK_FALSE(core::is_closed_manifold(doubled));
    QuadMesh pinched = cube;  // a second cube that shares one vertex
    for (std::size_t i = 0; i < 8; ++i) pinched.vertices.push_back(cube.vertices[i] * -1.0);
    for (core::Quad q : cube.quads) {
        for (std::uint32_t& v : q) v = v == 0 ? 0 : v + 8;
        pinched.quads.push_back({q[0], q[3], q[2], q[1]});
    }
    pinched.vertices.erase(pinched.vertices.begin() + 8);
    for (std::size_t i = 6; i < pinched.quads.size(); ++i)
        for (std::uint32_t& v : pinched.quads[i]) v -= v > 8 ? 1 : 0;
    CHECK_FALSE(core::is_closed_manifold(pinched));
}
