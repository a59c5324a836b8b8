#include "core/garment/fitting.hpp"

#include <catch2/catch.hpp>

#include "core/garment/design.hpp"
#include "core/mesh/crossings.hpp"
#include "support/cloth_grids.hpp"
#include "support/simple_body.hpp"

using core::BodyPart;
using core::Vec3;

namespace {

/// Two posts side by side, as legs: the left at x = 8, the right at x = -8, each of radius 6.
core::DressForm two_legs() {
    core::DressForm form;
    for (const double x : {8.0, -8.0}) {
        const core::TriangleMesh post = support::post(6.0, 60.0);
        const auto shift = static_cast<std::uint32_t>(form.mesh.vertices.size());
        for (const Vec3& v : post.vertices) form.mesh.vertices.push_back(v + Vec3{x, 0, 0});
        for (const auto& t : post.triangles) form.mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
        form.part_of_triangle.insert(form.part_of_triangle.end(), post.triangles.size(),
                                     x > 0 ? BodyPart::LegLeft : BodyPart::LegRight);
    }
    return form;
}

/// A flat strip between the legs that went through the right one, beyond its middle.
core::Cloth strip(core::PartSet parts) {
    core::Cloth cloth = support::one_piece(support::bent_grid(8, 8, [](double u, double v) {
        return Vec3{-9.0, 20 + 20 * v, 6 - 12 * u};
    }));
    cloth.pieces[0].parts = parts;
    return cloth;
}

}  // namespace

TEST_CASE("cloth in another leg goes back to its own", "[fitting]") {
    const auto legs = core::Obstacle::of_body(two_legs());
    REQUIRE(legs);
    core::Cloth left = strip(core::part_bit(BodyPart::LegLeft)), right = strip(core::part_bit(BodyPart::LegRight));
    const core::FittingReport report = core::fit_cloth(left, *legs, {});
    CHECK(report.deepest_before_cm > 4.0);
    CHECK(report.deepest_after_cm == 0.0);
    const auto inner_share = [](const core::Cloth& cloth) {
        double between = 0.0;
        for (const Vec3& v : cloth.mesh.vertices) between += v.x > -4.0 ? 1.0 : 0.0;
        return between / static_cast<double>(cloth.mesh.vertices.size());
    };
    CHECK(inner_share(left) > 0.7);  // on the inner side of the right leg
    (void)core::fit_cloth(right, *legs, {});
    CHECK(inner_share(right) < inner_share(left));  // its own leg: the nearest way out
}

TEST_CASE("cloth that passes through itself is parted, or counted", "[fitting]") {
    const auto post = core::Obstacle::of_body(support::post(5.0, 60.0));
    // two facing sheets beside the post, their outer sides to each other, the tip of the one through the other
    core::Cloth cloth = support::one_piece(support::bent_grid(10, 10, [](double u, double v) {
        return Vec3{8.0, 20 + 20 * v, 10 - 20 * u};
    }));  // outer side: +x
    const core::QuadMesh other = support::bent_grid(10, 10, [](double u, double v) {
        const double bulge = std::exp(-12.0 * ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)));
        return Vec3{8.5 - 0.8 * bulge, 20.7 + 20 * v, -10.3 + 20 * u};  // outer side: -x
    });
    const auto shift = static_cast<std::uint32_t>(cloth.mesh.vertices.size());
    cloth.pieces.push_back({"other", 0, cloth.mesh.quads.size(), other.quads.size(), {}, 0.0});
    cloth.mesh.vertices.insert(cloth.mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const core::Quad& q : other.quads)
        cloth.mesh.quads.push_back({q[0] + shift, q[1] + shift, q[2] + shift, q[3] + shift});
    cloth.drawn.resize(cloth.mesh.vertices.size(), false);
    REQUIRE_FALSE(core::self_crossings(cloth.mesh).empty());
    const core::FittingReport report = core::fit_cloth(cloth, *post, {});
    CHECK(report.self_crossings_before > 0);
    CHECK(report.self_crossings == 0);
    CHECK(core::self_crossings(cloth.mesh).empty());
    CHECK(core::fitting_warning(report).empty());
}

TEST_CASE("what a fit leaves is said in one sentence", "[fitting]") {
    core::FittingReport report;
    report.deepest_after_cm = 1.25;
    CHECK(core::fitting_warning(report) ==
          "The cloth stays up to 1.25 cm inside what is below it: draw it looser there.");
    report.self_crossings = 1;
    CHECK(core::fitting_warning(report).find("and passes through itself at 1 place:") != std::string::npos);
}
