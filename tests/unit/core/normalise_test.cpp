#include "core/mesh/normalise.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

using core::ErrorCode;
using core::TriangleMesh;
using core::Vec3;

namespace {

/// A box of sides 4, 2, 1 with one corner at the origin, as a soup of two of its faces and a spike.
TriangleMesh some_model() {
    return {{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 1}, {1, 1, 1}}, {{0, 1, 2}, {0, 2, 3}, {2, 3, 4}}, {}};
}

TriangleMesh moved(TriangleMesh mesh, double scale, Vec3 by) {
    for (Vec3& p : mesh.vertices) p = p * scale + by;
    return mesh;
}

}  // namespace

TEST_CASE("a normalised mesh has its box at the origin and its farthest vertex at 1", "[normalise]") {
    const TriangleMesh mesh = *core::normalised_mesh(some_model());
    double farthest = 0.0;
    Vec3 low{9, 9, 9}, high{-9, -9, -9};
    for (const Vec3& p : mesh.vertices) {
        farthest = std::max(farthest, core::length(p));
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    CHECK(farthest == Approx(1.0));
    CHECK(core::length(low + high) == Approx(0.0).margin(1e-12));
    CHECK((high.x - low.x) / (high.y - low.y) == Approx(2.0));
}

TEST_CASE("unit and place of a model do not matter", "[normalise]") {
    const TriangleMesh expected = *core::normalised_mesh(some_model());
    for (const double scale : {1e-200, 1e-3, 25.4, 1e90}) {
        const TriangleMesh mesh = *core::normalised_mesh(moved(some_model(), scale, Vec3{7, -30, 2} * scale));
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            CHECK(core::length(mesh.vertices[i] - expected.vertices[i]) < 1e-12);
        }
    }
}

TEST_CASE("vertices that no face uses do not count", "[normalise]") {
    TriangleMesh stray = some_model();
    stray.vertices.push_back({1000, 0, std::numeric_limits<double>::infinity()});
    CHECK((*core::normalised_mesh(stray)).vertices[2] == (*core::normalised_mesh(some_model())).vertices[2]);
}

TEST_CASE("a mesh without faces or extent, or with a broken face, is refused", "[normalise]") {
    CHECK(core::normalised_mesh({}).error().code == ErrorCode::EmptyMesh);
    CHECK(core::normalised_mesh({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}, {}}).error().code ==
          ErrorCode::BadMesh);
    TriangleMesh broken = some_model();
    broken.triangles.push_back({0, 1, 5});
    CHECK(core::normalised_mesh(broken).error().code == ErrorCode::BadMesh);
    broken = some_model();
    broken.vertices[0].y = std::numeric_limits<double>::quiet_NaN();
    CHECK(core::normalised_mesh(broken).error().code == ErrorCode::BadMesh);
}
