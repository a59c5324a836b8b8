#include "db/codec/mesh_codec.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "db_fixtures.hpp"
#include "hostile_blob.hpp"

using core::TriangleMesh;
using fixture::Random;

namespace {

TriangleMesh round_trip(const TriangleMesh& mesh) {
    return fixture::value(db::decode_mesh(fixture::value(db::encode_mesh(mesh))));
}

/// A sphere of rings, as regular as display meshes are.
TriangleMesh sphere(std::uint32_t rings, std::uint32_t around) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        for (std::uint32_t j = 0; j < around; ++j) {
            const double theta = std::numbers::pi * i / rings;
            const double phi = 2.0 * std::numbers::pi * j / around;
            mesh.vertices.push_back(
                {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)});
            mesh.colours.push_back({.r = static_cast<std::uint8_t>(i < rings / 2 ? 200 : 40), .g = 90, .b = 20});
            if (i == rings) continue;
            const std::uint32_t a = i * around + j;
            const std::uint32_t b = i * around + (j + 1) % around;
            mesh.triangles.push_back({a, b, a + around});
            mesh.triangles.push_back({b, b + around, a + around});
        }
    }
    return mesh;
}

}  // namespace

TEST_CASE("a mesh keeps its triangles and colours, its vertices move by half a step at most", "[mesh]") {
    Random random(21);
    for (int i = 0; i < 100; ++i) {
        const TriangleMesh mesh =
            fixture::random_mesh(random, fixture::whole(random, 1, 200), fixture::whole(random, 0, 300), i % 2 == 0);
        const TriangleMesh once = round_trip(mesh);
        CHECK(once.triangles == mesh.triangles);
        CHECK(once.colours == mesh.colours);
        REQUIRE(once.vertices.size() == mesh.vertices.size());
        for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
            const core::Vec3 moved = once.vertices[k] - mesh.vertices[k];
            CHECK(std::max({std::abs(moved.x), std::abs(moved.y), std::abs(moved.z)}) <= 1.0 / 65534.0 + 1e-12);
        }
        CHECK(fixture::same_mesh(round_trip(once), once));
    }
}

TEST_CASE("an empty mesh is a mesh", "[mesh]") {
    CHECK(fixture::same_mesh(round_trip({}), {}));
}

TEST_CASE("a regular mesh of 2,000 triangles takes less than 14 kB", "[mesh]") {
    const TriangleMesh mesh = sphere(25, 40);
    REQUIRE(mesh.triangles.size() == 2000);
    CHECK(fixture::value(db::encode_mesh(mesh)).size() < 14000);
}

TEST_CASE("a mesh that is not sound is not stored", "[mesh]") {
    Random random(22);
    TriangleMesh mesh = fixture::random_mesh(random, 10, 10, true);
    SECTION("outside the frame") {
        mesh.vertices[3].y = 1.01;
    }
    SECTION("not a number") {
        mesh.vertices[3].y = std::numeric_limits<double>::quiet_NaN();
    }
    SECTION("an index without vertex") {
        mesh.triangles[4][1] = 10;
    }
    SECTION("a colour short") {
        mesh.colours.pop_back();
    }
    const core::Result<db::Blob> refused = db::encode_mesh(mesh);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == core::ErrorCode::BadMesh);
}

TEST_CASE("a mesh blob cut off or changed gives an error or a sound mesh", "[mesh][hostile]") {
    Random random(23);
    const db::Blob blob = fixture::value(db::encode_mesh(fixture::random_mesh(random, 20, 30, true)));
    fixture::try_every_cut_and_flip<TriangleMesh>(blob, db::decode_mesh, db::encode_mesh, fixture::same_mesh);
}

TEST_CASE("a blob that promises a million million triangles sets nothing aside for them", "[mesh][hostile]") {
    db::ByteWriter out(db::BlobKind::Mesh, 1);
    out.varint(0);
    out.varint(1'000'000'000'000);
    CHECK(fixture::sentence(db::decode_mesh(out.bytes())).find("cut off") != std::string::npos);
}
