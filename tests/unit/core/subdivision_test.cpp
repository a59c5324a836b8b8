#include "core/garment/subdivision.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using core::Cloth;
using core::Vec3;

namespace {

/// Two pieces of n x n quads, joined along x = n, in the plane z = 0, their middles lifted.
Cloth two_pieces(int n) {
    Cloth cloth;
    const int wide = 2 * n;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= wide; ++i)
            cloth.mesh.vertices.push_back({1.0 * i, 1.0 * j, i % n == 0 || j == 0 || j == n ? 0.0 : 1.0});
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (wide + 1) + i); };
    for (int piece = 0; piece < 2; ++piece) {
        cloth.pieces.push_back(
            {piece == 0 ? "a" : "b", 0, cloth.mesh.quads.size(), static_cast<std::size_t>(n * n), {}, 0.0});
        for (int j = 0; j < n; ++j)
            for (int i = piece * n; i < (piece + 1) * n; ++i)
                cloth.mesh.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    cloth.drawn.assign(cloth.mesh.vertices.size(), false);
    return cloth;
}

}  // namespace

TEST_CASE("hems and seams keep their place, pieces their quads", "[subdivision]") {
    const Cloth fine = *core::subdivided(two_pieces(3), 2);
    REQUIRE(fine.pieces.size() == 2);
    CHECK(fine.pieces[1].name == "b");
    CHECK(fine.pieces[1].first == 144);
    CHECK(fine.pieces[1].count == 144);
    CHECK(fine.mesh.vertices.size() == 25 * 13);
    double tallest = 0.0;
    for (std::size_t v = 0; v < fine.mesh.vertices.size(); ++v) {
        const Vec3 p = fine.mesh.vertices[v];
        tallest = std::max(tallest, p.z);
        if (!fine.drawn[v]) continue;
        CHECK(p.z == Approx(0.0).margin(1e-9));
        CHECK((std::abs(p.x) < 1e-9 || std::abs(p.x - 3) < 1e-9 || std::abs(p.x - 6) < 1e-9 || std::abs(p.y) < 1e-9 ||
               std::abs(p.y - 3) < 1e-9));
    }
    CHECK(tallest > 0.5);
    for (std::size_t q = 0; q < fine.mesh.quads.size(); ++q) {
        double x = 0.0;
        for (const std::uint32_t v : fine.mesh.quads[q]) x += 0.25 * fine.mesh.vertices[v].x;
        CHECK((x < 3.0) == (q < 144));
    }
    const core::ClothEdges edges = core::edges_of(fine);
    CHECK(edges.seams.size() == 12);
    CHECK(edges.hems.size() == 72);
}

TEST_CASE("levels out of range and empty cloth", "[subdivision]") {
    CHECK_FALSE(core::subdivided(two_pieces(2), 0));
    CHECK_FALSE(core::subdivided(two_pieces(2), 4));
    CHECK(core::subdivided({}, 1)->mesh.quads.empty());
}
