#include "core/garment/pattern/flatten.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/cloth_grids.hpp"

using core::Point;
using core::QuadMesh;
using core::Vec3;

namespace {

double width_of(const std::vector<Point>& at) {
    double most = 0.0;
    for (const Point p : at) most = std::max(most, p.x);
    return most;
}

}  // namespace

TEST_CASE("what a plane can be bent into is laid flat without strain", "[flatten]") {
    const QuadMesh cylinder = support::cylinder_panel(24, 20, 10.0, 30.0);
    const auto flat = core::flatten(cylinder, {});
    REQUIRE(flat);
    CHECK(flat->largest_strain < 1e-3);
    CHECK(flat->mean_strain <= flat->high_strain);
    CHECK(flat->high_strain <= flat->largest_strain);
    double around = 0.0;  // the sum of the chords
    for (std::size_t i = 0; i < 24; ++i) around += core::length(cylinder.vertices[i + 1] - cylinder.vertices[i]);
    CHECK(width_of(flat->places) == Approx(around).epsilon(1e-3));
    CHECK(flat->places.front().x == Approx(0.0).margin(0.01));  // up is up: the first vertex is the lower left one
    CHECK(flat->places.front().y == Approx(0.0).margin(0.01));

    const QuadMesh cone = support::cone_panel(20, 16, 40.0, 12.0, 55.0);
    const auto fan = core::flatten(cone, {});
    REQUIRE(fan);
    CHECK(fan->largest_strain < 1e-3);
    const double slant = std::hypot(55.0, 28.0);
    CHECK(core::distance(fan->places.front(), fan->places[16 * 21]) == Approx(slant).epsilon(1e-3));
}

TEST_CASE("the border keeps its length where the middle cannot", "[flatten]") {
    const QuadMesh dome = support::bent_grid(12, 12, [](double u, double v) {
        const double x = 24 * (u - 0.5), z = 24 * (v - 0.5);
        return Vec3{x, std::sqrt(400.0 - x * x - z * z), -z};
    });
    core::FlattenOptions plain;
    plain.length_rounds = 0;
    const auto border = *core::disc_border(dome);
    const auto worst = [&](const core::FlatPiece& flat) {
        double most = 0.0;
        for (std::size_t i = 0; i < border.size(); ++i) {
            const std::uint32_t a = border[i], b = border[(i + 1) % border.size()];
            const double space = core::length(dome.vertices[b] - dome.vertices[a]);
            most = std::max(most, std::abs(core::distance(flat.places[a], flat.places[b]) / space - 1.0));
        }
        return most;
    };
    const auto rigid = core::flatten(dome, plain), exact = core::flatten(dome, {});
    REQUIRE(rigid);
    REQUIRE(exact);
    CHECK(worst(*exact) < 0.5 * worst(*rigid));
    CHECK(worst(*exact) < 0.005);
    CHECK(exact->mean_strain > 0.005);  // a sphere is no plane
    CHECK(exact->mean_strain < 0.08);
    for (const core::Quad& q : dome.quads) {
        const Point a = exact->places[q[0]], b = exact->places[q[1]], c = exact->places[q[2]];
        CHECK(core::cross(b - a, c - a) > 0.0);
    }
}

TEST_CASE("a level piece lies along its length", "[flatten]") {
    const QuadMesh strip = support::bent_grid(20, 4, [](double u, double v) { return Vec3{40 * u, 3.0, -8 * v}; });
    const auto flat = core::flatten(strip, {});
    REQUIRE(flat);
    CHECK(width_of(flat->places) == Approx(8.0).epsilon(1e-6));
    CHECK(flat->largest_strain < 1e-6);
}

TEST_CASE("what is no disc is refused", "[flatten]") {
    QuadMesh mesh = support::bent_grid(3, 3, [](double u, double v) { return Vec3{u, v, 0}; });
    QuadMesh holed = mesh;
    holed.quads.erase(holed.quads.begin() + 4);
    CHECK(core::flatten(holed, {}).error().message.find("disc") != std::string::npos);
    QuadMesh thin = mesh;
    thin.vertices.assign(thin.vertices.size(), {1, 1, 1});
    CHECK(core::flatten(thin, {}).error().message.find("area") != std::string::npos);
    QuadMesh loose = mesh;
    loose.vertices.push_back({});
    CHECK_FALSE(core::flatten(loose, {}));
    QuadMesh wrong = mesh;
    wrong.quads[0][0] = 99;
    CHECK_FALSE(core::flatten(wrong, {}));
    CHECK_FALSE(core::flatten({}, {}));
    QuadMesh parts = mesh;
    parts.quads = {mesh.quads[0], mesh.quads[8]};
    CHECK_FALSE(core::flatten(parts, {}));
    REQUIRE(core::flatten(mesh, {}));
}
