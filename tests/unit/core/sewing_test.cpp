#include "core/garment/sewing.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/garment/design.hpp"
#include "core/garment/drape.hpp"
#include "support/cloth_grids.hpp"
#include "support/simple_body.hpp"

using core::QuadMesh;
using core::Vec3;

namespace {

const core::Obstacle& post() {
    static const core::Obstacle obstacle = *core::Obstacle::of_body(support::post(8.0, 40.0));
    return obstacle;
}

/// An upright square, its front to +z.
core::FinishedLayer hanging(int quads, Vec3 low, double wide, double high) {
    core::FinishedLayer layer;
    layer.fitted = support::one_piece(support::bent_grid(quads, quads, [=](double u, double v) {
        return Vec3{low.x + wide * u, low.y + high * v, low.z};
    }));
    return layer;
}

/// How far a sewn vertex is from where its cloth has it.
double slack(const core::SewnVertex& s, const std::vector<Vec3>& at) {
    const core::TriangleAxes axes = core::axes_of_triangle(at[s.on[0]], at[s.on[1]], at[s.on[2]]);
    Vec3 to = axes.along * s.off.x + axes.across * s.off.y + axes.normal * s.off.z;
    for (std::size_t k = 0; k < 3; ++k) to = to + at[s.on[k]] * s.share[k];
    return core::length(to - at[s.vertex]);
}

}  // namespace

TEST_CASE("a pocket is sewn all around, each vertex where it was drawn", "[sewing]") {
    const std::vector<core::FinishedLayer> layers{hanging(10, {30, 20, 0}, 30, 30), hanging(4, {38, 28, 0.6}, 9, 9)};
    const std::vector<core::SewnVertex> sewn = core::sewn(layers);
    REQUIRE(sewn.size() == 16);  // the border of 4 x 4 quads
    const QuadMesh all = core::joined_layers(layers);
    for (const core::SewnVertex& s : sewn) {
        CHECK(s.vertex >= 121);
        CHECK(s.share[0] + s.share[1] + s.share[2] == Approx(1.0));
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(s.on[k] < 121);
            CHECK(s.share[k] > -1e-9);
        }
        CHECK(s.off.z == Approx(0.6));
        CHECK(slack(s, all.vertices) == Approx(0.0).margin(1e-9));
    }
}

TEST_CASE("a loose sheet is sewn where its edge runs along an edge below, and only there", "[sewing]") {
    // a collar: its upper edge on the neckline, its lower edge farther off than any stitch
    core::FinishedLayer collar;
    collar.fitted = support::one_piece(support::bent_grid(8, 8, [](double u, double v) {
        return Vec3{32 + 26 * u, 42 + 8 * v, 0.4 + 4 * (1 - v)};
    }));
    const std::vector<core::FinishedLayer> layers{hanging(10, {30, 20, 0}, 30, 30), collar};
    const std::vector<core::SewnVertex> sewn = core::sewn(layers);
    REQUIRE_FALSE(sewn.empty());
    const QuadMesh all = core::joined_layers(layers);
    for (const core::SewnVertex& s : sewn) CHECK(all.vertices[s.vertex].y > 48.4);
    // a skirt over trousers: near, but neither a patch nor along a hem
    core::FinishedLayer skirt;
    skirt.fitted = support::one_piece(support::bent_grid(8, 8, [](double u, double v) {
        return Vec3{34 + 20 * u, 24 + 15 * v, 0.5 + 6 * (1 - v)};
    }));
    CHECK(core::sewn({hanging(10, {30, 20, 0}, 30, 30), skirt}).empty());
    CHECK(core::sewn({hanging(4, {0, 0, 0}, 5, 5)}).empty());
    CHECK(core::sewn({}).empty());
}

TEST_CASE("sewn cloth goes where its cloth goes; without stitches it falls", "[sewing]") {
    const std::vector<core::FinishedLayer> layers{hanging(10, {30, 20, 0}, 30, 30), hanging(4, {38, 28, 0.6}, 9, 9)};
    const QuadMesh all = core::joined_layers(layers);
    std::vector<bool> held(all.vertices.size(), false);
    std::fill_n(held.begin() + 110, 11, true);  // the top of the larger sheet
    const std::vector<core::SewnVertex> sewn = core::sewn(layers);
    held[sewn.front().vertex] = true;  // a band does not hold what is sewn
    core::Drape with(all, post(), {}, held, sewn), without(all, post(), {}, held);
    for (int k = 0; k < 60; ++k) with.step(), without.step();
    double most = 0, lowest = 1e9, fallen = 1e9;
    for (const core::SewnVertex& s : sewn) most = std::max(most, slack(s, with.places()));
    for (std::size_t v = 121; v < all.vertices.size(); ++v) {
        lowest = std::min(lowest, with.places()[v].y);
        fallen = std::min(fallen, without.places()[v].y);
    }
    CHECK(most < 0.5);
    CHECK(lowest > 24.0);
    CHECK(fallen < 20.0);
    CHECK(with.places()[115] == all.vertices[115]);
    with.reset();
    CHECK(with.places() == all.vertices);
}

TEST_CASE("a triangle without area has no axes and holds all the same", "[sewing]") {
    const core::TriangleAxes axes = core::axes_of_triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1});
    CHECK(axes.normal == Vec3{});
    CHECK(axes.across == Vec3{});
}
