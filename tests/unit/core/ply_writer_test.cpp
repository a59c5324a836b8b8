#include "core/exchange/ply_writer.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <sstream>

#include "core/exchange/mesh_reader.hpp"

namespace {

core::TriangleMesh triangle() {
    core::TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1.5, 0, 0}, {0, -2, 0.25}};
    mesh.triangles = {{0, 1, 2}};
    mesh.colours = {{255, 0, 7}, {1, 2, 3}, {9, 8, 200}};
    return mesh;
}

std::uint32_t u32_at(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

}  // namespace

TEST_CASE("a PLY file says what it holds and holds it", "[ply_writer]") {
    std::ostringstream out;
    REQUIRE(core::write_ply(out, triangle()));
    const std::string bytes = out.str();
    const std::size_t body = bytes.find("end_header\n") + 11;
    CHECK(bytes.starts_with("ply\nformat binary_little_endian 1.0\n"));
    CHECK(bytes.find("element vertex 3\n") != std::string::npos);
    CHECK(bytes.find("element face 1\n") != std::string::npos);
    CHECK(bytes.size() == body + 3 * 15 + 13);
    CHECK(std::bit_cast<float>(u32_at(bytes, body + 15)) == 1.5F);
    CHECK(std::bit_cast<float>(u32_at(bytes, body + 30 + 4)) == -2.0F);
    CHECK(static_cast<unsigned char>(bytes[body + 30 + 14]) == 200);  // blue of the third vertex
    CHECK(bytes[body + 45] == 3);
    CHECK(u32_at(bytes, body + 46 + 8) == 2);
}

TEST_CASE("a mesh without colours is written without colour properties", "[ply_writer]") {
    core::TriangleMesh mesh = triangle();
    mesh.colours.clear();
    std::ostringstream out;
    REQUIRE(core::write_ply(out, mesh));
    CHECK(out.str().find("red") == std::string::npos);
}

TEST_CASE("a PLY file whose first coordinate begins like a line end is read back", "[ply_writer]") {
    constexpr float kLikeALineEnd = std::bit_cast<float>(0x3F43D70AU);
    core::TriangleMesh mesh = triangle();
    mesh.vertices[0].x = kLikeALineEnd;
    const auto path = std::filesystem::temp_directory_path() / "croquis_ply_writer_test.ply";
    REQUIRE(core::write_ply_file(path, mesh));
    const auto back = core::read_mesh(path);
    std::filesystem::remove(path);
    REQUIRE(back);
    REQUIRE(back->vertices.size() == 3);
    CHECK(std::abs(back->vertices[0].x - kLikeALineEnd) < 1e-6);
    CHECK(back->vertices[2].y == -2.0);
}

TEST_CASE("a broken mesh is refused before anything is written", "[ply_writer]") {
    core::TriangleMesh mesh = triangle();
    SECTION("an index past the vertices") {
        mesh.triangles[0][1] = 3;
    }
    SECTION("a colour missing") {
        mesh.colours.pop_back();
    }
    std::ostringstream out;
    const auto result = core::write_ply(out, mesh);
    REQUIRE_FALSE(result);
    CHECK(result.error().code == core::ErrorCode::BadMesh);
    CHECK(out.str().empty());
}

TEST_CASE("a file that cannot be written is named", "[ply_writer]") {
    const std::filesystem::path path = "/nonexistent-folder/mesh.ply";
    const auto result = core::write_ply_file(path, triangle());
    REQUIRE_FALSE(result);
    CHECK(result.error().code == core::ErrorCode::WriteFailed);
    CHECK(result.error().where == path.string());
}
