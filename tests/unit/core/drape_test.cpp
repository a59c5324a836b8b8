#include "core/garment/drape.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/garment/design.hpp"
#include "core/mesh/crossings.hpp"
#include "support/cloth_grids.hpp"
#include "support/simple_body.hpp"

using core::QuadMesh;
using core::Vec3;

namespace {

const core::Obstacle& post() {
    static const core::Obstacle obstacle = *core::Obstacle::of_body(support::post(8.0, 40.0));
    return obstacle;
}

/// A square of cloth above the post's top.
QuadMesh sheet(double y, double size = 30.0) {
    return support::bent_grid(24, 24, [=](double u, double v) { return Vec3{size * (u - 0.5), y, size * (0.5 - v)}; });
}

double worst_stretch(const QuadMesh& rest, const std::vector<Vec3>& at) {
    double worst = 0.0;
    for (const core::Quad& q : rest.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t a = q[k], b = q[(k + 1) % 4];
            worst = std::max(worst, core::length(at[b] - at[a]) / core::length(rest.vertices[b] - rest.vertices[a]));
        }
    return worst;
}

}  // namespace

TEST_CASE("a cloth falls on a post and hangs over it, outside of it", "[drape]") {
    const QuadMesh cloth = sheet(42.0);
    core::Drape drape(cloth, post(), {});
    for (int k = 0; k < 120; ++k) drape.step();
    QuadMesh hanging{drape.places(), cloth.quads};
    double lowest = 1e300;
    for (const Vec3& p : hanging.vertices) {
        lowest = std::min(lowest, p.y);
        CHECK(post().distance(p) > 0.1);
    }
    CHECK(lowest < 36.0);  // the edges hang
    CHECK(lowest > 15.0);  // it did not fall off
    CHECK(core::mesh_crossings(hanging, post().surfaces()[0]).empty());
    CHECK(worst_stretch(cloth, drape.places()) < 1.15);
    drape.reset();
    CHECK(drape.places() == cloth.vertices);
    CHECK(drape.mean_speed_cm_s() == 0.0);
}

TEST_CASE("the same steps give the same places; held vertices stay", "[drape]") {
    const QuadMesh cloth = sheet(50.0, 12.0);
    std::vector<bool> held(cloth.vertices.size(), false);
    std::fill_n(held.begin(), 25, true);
    core::Drape one(cloth, post(), {}, held), two(cloth, post(), {}, held);
    for (int k = 0; k < 20; ++k) one.step(), two.step();
    CHECK(one.places() == two.places());
    CHECK(one.places()[0] == cloth.vertices[0]);
    CHECK(one.places()[24] == cloth.vertices[24]);
    CHECK(one.places()[12 * 25 + 12].y < 49.0);
    CHECK(worst_stretch(cloth, one.places()) < 1.3);
}

TEST_CASE("a cloth that falls on another stays above it", "[drape]") {
    core::FinishedLayer lower, upper;
    lower.fitted = support::one_piece(sheet(41.0, 14.0), "lower");
    upper.fitted = support::one_piece(sheet(46.0, 12.0), "upper");
    std::vector<core::FinishedLayer> layers{lower, upper};
    const QuadMesh both = core::joined_layers(layers);
    REQUIRE(both.quads.size() == 2 * 24 * 24);
    core::Drape drape(both, post(), {});
    for (int k = 0; k < 60; ++k) drape.step();
    core::put_places(drape.places(), layers);
    CHECK(core::mesh_crossings(layers[0].fitted.mesh, layers[1].fitted.mesh).empty());
    // it may slide, but where the two touch it is the outer one
    std::size_t touching = 0;
    for (const Vec3& above : layers[1].fitted.mesh.vertices)
        for (const Vec3& below : layers[0].fitted.mesh.vertices)
            if (core::length(above - below) < 0.6) {
                ++touching;
                CHECK(post().distance(above) > post().distance(below) - 0.1);
            }
    CHECK(touching > 20);
    CHECK(core::self_crossings({drape.places(), both.quads}).empty());
}

TEST_CASE("a band at the top of a layer holds it, its lower hem hangs", "[drape]") {
    core::FinishedLayer tube;
    tube.fitted = support::one_piece(support::bent_grid(30, 12, [](double u, double v) {
        const double angle = 6.0 * (u - 0.5), radius = 13.0 - 4.5 * v;
        return Vec3{radius * std::sin(angle), 10 + 20 * v, radius * std::cos(angle)};
    }));
    const std::vector<bool> held = core::banded({tube}, post());
    std::size_t count = 0;
    for (std::size_t v = 0; v < held.size(); ++v) {
        count += held[v] ? 1 : 0;
        if (held[v]) CHECK(tube.fitted.mesh.vertices[v].y > 20.0);
    }
    CHECK(count >= 31);
    CHECK(count < 50);
}

TEST_CASE("a cloth that slides off lies down on the floor", "[drape]") {
    QuadMesh cloth = support::bent_grid(16, 16, [](double u, double v) {
        return Vec3{60.0 + 16.0 * u, 9.0 + 5.0 * v, 16.0 * (0.5 - v)};
    });
    core::Drape drape(cloth, post(), {});
    for (int k = 0; k < 90; ++k) drape.step();
    for (const Vec3& p : drape.places()) {
        CHECK(p.y >= 0.39);
        CHECK(p.y < 3.0);
    }
    CHECK(drape.mean_speed_cm_s() < 5.0);
    CHECK(worst_stretch(cloth, drape.places()) < 1.2);
}

TEST_CASE("vertices that meet fast or far from all others keep apart", "[drape]") {
    // two sheets, one falling from above on one that is held, and a third so far away that cells must grow
    core::FinishedLayer lower, upper, far;
    lower.fitted = support::one_piece(sheet(60.0, 12.0), "lower");
    upper.fitted = support::one_piece(sheet(75.0, 10.0), "upper");
    far.fitted = support::one_piece(sheet(40000.0, 10.0), "far");
    const QuadMesh all = core::joined_layers({lower, upper, far});
    std::vector<bool> held(all.vertices.size(), false);
    std::fill_n(held.begin(), lower.fitted.mesh.vertices.size(), true);
    core::Drape drape(all, post(), {}, held);
    for (int k = 0; k < 25; ++k) drape.step();
    const std::size_t count = lower.fitted.mesh.vertices.size();
    for (std::size_t v = count; v < 2 * count; ++v) CHECK(drape.places()[v].y > 60.0);
}

TEST_CASE("nothing to hang is no fault", "[drape]") {
    core::Drape drape({}, post(), {});
    drape.step();
    CHECK(drape.places().empty());
}
