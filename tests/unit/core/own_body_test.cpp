#include "core/mannequin/own_body.hpp"

#include <catch2/catch.hpp>

#include "core/mannequin/body_mesher.hpp"
#include "core/mannequin/body_shape.hpp"
#include "core/mesh/distance_grid.hpp"
#include "support/simple_body.hpp"

using core::TriangleMesh;
using core::Vec3;

namespace {

/// A coarse mannequin, quickly made.
const TriangleMesh& figure() {
    static const TriangleMesh mesh =
        core::triangles_of(core::mesh_body(core::BodyShape(*core::measures_of_size("38"), core::BodyScales{}), 2.5));
    return mesh;
}

template <typename Change>
TriangleMesh changed(const Change& change) {
    TriangleMesh mesh = figure();
    for (Vec3& v : mesh.vertices) v = change(v);
    return mesh;
}

void check_stands(const TriangleMesh& mesh) {
    const auto body = core::stand_body(mesh);
    if (!body) FAIL(body.error().message);
    Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    double toe = -1e9, heel = 1e9;
    for (const Vec3& v : body->vertices) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
        if (v.y < 4.0) toe = std::max(toe, v.z), heel = std::min(heel, v.z);
    }
    CHECK(low.y == Approx(0.0).margin(1e-9));
    CHECK(high.y == Approx(168.0).margin(1.5));
    CHECK(high.x == Approx(-low.x).margin(0.5));
    CHECK(toe > -heel);
    CHECK(core::DistanceGrid::of_body(*body, {4.0, 4.0, 0.0})->distance({0, 100, 0}) < 0.0);
}

}  // namespace

TEST_CASE("a body stands up whatever side is up and whatever its unit", "[own_body]") {
    check_stands(figure());
    check_stands(changed([](Vec3 v) { return v * 0.01; }));
    check_stands(changed([](Vec3 v) { return Vec3{v.x, -v.z, v.y} * 10.0; }));           // z up, millimetres
    check_stands(changed([](Vec3 v) { return Vec3{-v.x, v.y, -v.z} * (1.0 / 2.54); }));  // facing -z, inches
    check_stands(changed([](Vec3 v) { return Vec3{v.z, v.y, -v.x}; }));                  // facing +x
    check_stands(changed([](Vec3 v) { return Vec3{v.y, v.x, -v.z} * 0.01; }));           // x up
}

TEST_CASE("inverted faces and colours do not matter", "[own_body]") {
    TriangleMesh mesh = figure();
    for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
    mesh.colours.assign(mesh.vertices.size(), {10, 20, 30});
    check_stands(mesh);
}

TEST_CASE("what is no closed body is refused", "[own_body]") {
    CHECK(core::stand_body({}).error().code == core::ErrorCode::EmptyMesh);
    TriangleMesh open = figure();
    open.triangles.pop_back();
    CHECK(core::stand_body(open).error().message.find("not closed") != std::string::npos);
    CHECK(core::stand_body(support::post(10, 60)).error().message.find("two legs") != std::string::npos);
}
