// Every format that assimp writes and reads, written by assimp and read by us: the same model comes back. (Not binary
// FBX: what assimp 5.2 writes it does not read.)

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <catch2/catch.hpp>

#include "core/exchange/mesh_file_check.hpp"
#include "core/exchange/mesh_reader.hpp"
#include "core/mesh/normalise.hpp"
#include "support/temporary_folder.hpp"

using core::TriangleMesh;

namespace {

/// A bar of 1 x 2 x 4 and a lid of one triangle, red and green.
const std::string kObj =
    "mtllib paint.mtl\no bar\n"
    "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 0 0 4\nv 1 0 4\nv 1 2 4\nv 0 2 4\n"
    "usemtl red\nf 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
    "o lid\nv 0 0 5\nv 1 0 5\nv 1 2 5\nusemtl green\nf 9 10 11\n";

core::Vec3 sides(const TriangleMesh& mesh) {
    core::Vec3 low = mesh.vertices.front(), high = low;
    for (const core::Vec3& v : mesh.vertices) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    return high - low;
}

}  // namespace

TEST_CASE("all extensions that folders are searched for can be read", "[mesh_formats]") {
    const Assimp::Importer importer;
    for (const std::string& extension : core::mesh_extensions()) {
        INFO(extension);
        CHECK(importer.IsExtensionSupported(extension));
    }
}

TEST_CASE("a model comes back from every format, whatever its unit and side up", "[mesh_formats]") {
    const support::TemporaryFolder folder;
    const std::string model = folder.write("model.obj", kObj);
    folder.write("paint.mtl", "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n");
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(model, aiProcess_Triangulate | aiProcess_GenNormals);
    REQUIRE(scene != nullptr);
    struct Format {
        std::string id, extension;
    };
    const std::vector<Format> formats{{"collada", "dae"}, {"x", "x"},      {"obj", "obj"},  {"stl", "stl"},
                                      {"stlb", "stl"},    {"ply", "ply"},  {"plyb", "ply"}, {"3ds", "3ds"},
                                      {"gltf2", "gltf"},  {"glb2", "glb"}, {"fbxa", "fbx"}, {"3mf", "3mf"},
                                      {"x3d", "x3d"}};
    for (const Format& format : formats) {
        DYNAMIC_SECTION(format.id) {
            const std::string path = folder.path(format.id + "_out." + format.extension);
            Assimp::Exporter exporter;
            REQUIRE(exporter.Export(scene, format.id, path) == aiReturn_SUCCESS);
            const auto mesh = core::read_mesh(path);
            INFO((mesh ? std::string() : mesh.error().sentence()));
            REQUIRE(mesh);
            CHECK(mesh->triangles.size() == 13);
            const auto normal = core::normalised_mesh(*mesh);
            REQUIRE(normal);
            std::vector<double> lengths{sides(*normal).x, sides(*normal).y, sides(*normal).z};
            std::sort(lengths.begin(), lengths.end());
            CHECK(lengths[1] / lengths[0] == Approx(2.0).epsilon(1e-3));
            CHECK(lengths[2] / lengths[0] == Approx(5.0).epsilon(1e-3));
        }
    }
}

TEST_CASE("an archive that unpacks to too much is refused before it is unpacked", "[mesh_formats]") {
    const support::TemporaryFolder folder;
    const std::string model = folder.write("model.obj", kObj);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(model, aiProcess_Triangulate);
    REQUIRE(scene != nullptr);
    const std::string path = folder.path("bomb.3mf");
    REQUIRE(Assimp::Exporter().Export(scene, "3mf", path) == aiReturn_SUCCESS);
    std::string bytes = *core::read_plain_file(path, 1 << 20);
    const std::size_t entry = bytes.find("PK\x01\x02");
    REQUIRE(entry != std::string::npos);
    SECTION("600 MB") {
        bytes.replace(entry + 24, 4, std::string("\x00\x00\xc3\x23", 4));
        folder.write("bomb.3mf", bytes);
        CHECK_THAT(core::read_mesh(path).error().sentence(),
                   Catch::Contains("bomb.3mf: the archive inside unpacks to"));
    }
    SECTION("more than 4 GB") {
        bytes.replace(entry + 24, 4, "\xff\xff\xff\xff");
        folder.write("bomb.3mf", bytes);
        CHECK(core::read_mesh(path).error().code == core::ErrorCode::BadMesh);
    }
    SECTION("no directory") {
        folder.write("bomb.3mf", bytes.substr(0, entry));
        CHECK_THAT(core::read_mesh(path).error().sentence(), Catch::Contains("has no directory"));
    }
    SECTION("a directory beyond the end of the file") {
        bytes.replace(bytes.rfind("PK\x05\x06") + 16, 4, std::string("\xff\xff\xff\x10", 4));
        folder.write("bomb.3mf", bytes);
        CHECK_THAT(core::read_mesh(path).error().sentence(), Catch::Contains("has no directory"));
    }
    SECTION("a directory that is no directory") {
        bytes.replace(entry, 4, "PK\x01\x03");
        folder.write("bomb.3mf", bytes);
        CHECK_THAT(core::read_mesh(path).error().sentence(), Catch::Contains("has no directory"));
    }
}
