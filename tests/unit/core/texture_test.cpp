#include "core/garment/texture.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/garment/subdivision.hpp"
#include "support/cloth_grids.hpp"

namespace {

double worst_edge(const core::Cloth& cloth) {
    double worst = 0.0;
    for (std::size_t q = 0; q < cloth.mesh.quads.size(); ++q)
        for (std::size_t k = 0; k < 4; ++k) {
            const double space = core::length(cloth.mesh.vertices[cloth.mesh.quads[q][(k + 1) % 4]] -
                                              cloth.mesh.vertices[cloth.mesh.quads[q][k]]);
            worst = std::max(worst,
                             std::abs(core::distance(cloth.texture[q][k], cloth.texture[q][(k + 1) % 4]) / space - 1));
        }
    return worst;
}

}  // namespace

TEST_CASE("texture coordinates are lengths along the cloth, on the refined surface too", "[texture]") {
    core::Cloth cloth = support::one_piece(support::cylinder_panel(24, 12, 10.0, 25.0));
    const core::TextureReport report = core::lay_texture(cloth);
    CHECK(report.left_out.empty());
    CHECK(report.largest_strain < 1e-3);
    CHECK(worst_edge(cloth) < 1e-3);
    for (const int levels : {1, 2}) {
        const core::Cloth fine = *core::subdivided(cloth, levels);
        REQUIRE(fine.texture.size() == fine.mesh.quads.size());
        CHECK(worst_edge(fine) < 0.02);
    }
    cloth.texture.clear();
    CHECK(core::subdivided(cloth, 1)->texture.empty());
}

TEST_CASE("a mirrored piece has mirrored texture, a piece that is no disc none", "[texture]") {
    core::Cloth half = support::one_piece(support::bent_grid(4, 4, [](double u, double v) {
        return core::Vec3{8 * u, 10 * v, 0.0};
    }));
    core::Cloth whole = core::mirrored_and_joined(half);
    REQUIRE(whole.pieces.size() == 2);
    CHECK(core::lay_texture(whole).left_out.empty());
    CHECK(worst_edge(whole) < 1e-6);
    double left = 0.0;
    for (std::size_t q = 16; q < 32; ++q)
        for (const core::Point p : whole.texture[q]) left = std::min(left, p.x);
    CHECK(left == Approx(-8.0));
    whole.mesh.quads.erase(whole.mesh.quads.begin() + 5);
    whole.pieces[0].count = 15;
    whole.pieces.pop_back();
    CHECK(core::lay_texture(whole).left_out == std::vector<std::string>{"piece"});
}
