#include "core/mesh/plane_section.hpp"

#include <catch2/catch.hpp>

#include "core/mesh/crossings.hpp"

using core::CutPlane;
using core::QuadMesh;
using core::Vec3;

namespace {

QuadMesh box(Vec3 low, Vec3 high) {
    QuadMesh mesh;
    for (int k = 0; k < 8; ++k)
        mesh.vertices.push_back(
            {(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y, (k & 4) != 0 ? high.z : low.z});
    mesh.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return mesh;
}

QuadMesh joined(QuadMesh a, const QuadMesh& b) {
    const auto shift = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const core::Quad& q : b.quads) a.quads.push_back({q[0] + shift, q[1] + shift, q[2] + shift, q[3] + shift});
    return a;
}

CutPlane level(Vec3 at) {
    return {at, {1, 0, 0}, {0, 0, -1}};
}

}  // namespace

TEST_CASE("a tape around a box and around one of two boxes", "[plane_section]") {
    const QuadMesh two = joined(box({0, 0, 0}, {3, 5, 2}), box({10, 0, 0}, {11, 5, 1}));
    CHECK(core::plane_section(two, level({0, 2, 0})).size() == 2);
    CHECK(core::tape_length(two, level({1, 2, 1})) == Approx(10.0));
    CHECK(core::tape_length(two, level({10.5, 2, 0.5})) == Approx(4.0));
    CHECK(core::tape_length(two, level({9, 2, 0})) == Approx(4.0));   // the nearest
    CHECK(core::tape_length(two, level({1, 5, 1})) == Approx(10.0));  // through vertices
    CHECK(core::tape_length(two, level({1, 9, 1})) == 0.0);
}

TEST_CASE("a tape bridges hollows", "[plane_section]") {
    const QuadMesh u =
        joined(joined(box({0, 0, 0}, {6, 5, 1}), box({0, 0, 0.5}, {1, 5, 4})), box({5, 0, 0.5}, {6, 5, 4}));
    // three pieces that overlap but share no edge: the piece that holds the origin counts
    CHECK(core::tape_length(u, level({3, 2, 0.5})) == Approx(14.0));
    CHECK(core::hull_length({{0, 0}, {6, 0}, {6, 4}, {5, 4}, {5, 1}, {1, 1}, {1, 4}, {0, 4}}) == Approx(20.0));
}

TEST_CASE("crossings of two meshes and of a mesh with itself", "[crossings]") {
    const QuadMesh a = box({0, 0, 0}, {2, 2, 2}), apart = box({3, 0, 0}, {4, 1, 1}),
                   into = box({1, 0.5, 0.5}, {3, 1.5, 1.2});
    CHECK(core::mesh_crossings(a, apart).empty());
    CHECK_FALSE(core::mesh_crossings(a, into).empty());
    CHECK(core::mesh_crossings(a, box({0.5, 0.5, 0.5}, {1, 1, 1})).empty());  // inside, without touching
    CHECK(core::self_crossings(a).empty());
    CHECK(core::self_crossings(joined(a, into)).size() == core::mesh_crossings(a, into).size());
    CHECK(core::self_crossings({}).empty());
}
