#include "core/exchange/mesh_reader.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

using core::ErrorCode;
using core::Rgb;
using core::Vec3;
namespace fs = std::filesystem;

namespace {

/// A folder of files that goes when the test ends.
class Folder {
  public:
    Folder() : path_(fs::temp_directory_path() / ("croquis-mesh-reader-" + std::to_string(std::random_device{}()))) {
        fs::create_directories(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { fs::remove_all(path_); }
    [[nodiscard]] fs::path write(const std::string& name, const std::string& content) const {
        std::ofstream(path_ / name, std::ios::binary) << content;
        return path_ / name;
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

template <typename T>
std::string bytes_of(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

std::string base64(const std::string& bytes) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63U];
        }
    }
    return text;
}

/// One triangle, its node moved by (10, 0, 0) and doubled, the material red; `count` vertices promised.
std::string gltf(const std::string& count) {
    const std::string buffer = base64(bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
           R"("nodes":[{"mesh":0,"translation":[10,0,0],"scale":[2,2,2]}],)"
           R"("materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":)" +
           count +
           R"(,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
           R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)" +
           buffer + R"("}]})";
}

std::string binary_stl(std::uint32_t promised) {
    std::string stl(80, ' ');
    stl += bytes_of<std::uint32_t>({promised});
    stl += bytes_of<float>({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) + std::string(2, '\0');
    return stl;
}

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n";

}  // namespace

TEST_CASE("meshes of the usual formats are read", "[mesh_reader]") {
    const Folder folder;
    const std::vector<std::pair<std::string, std::string>> files{
        {"triangle.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"triangle.OFF", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"relative.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n"},
        {"text.stl",
         "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
         "endsolid t\n"},
        {"binary.stl", binary_stl(1)},
        {"triangle.ply", kPly},
        {"triangle.gltf", gltf("3")},
    };
    for (const auto& [name, content] : files) {
        DYNAMIC_SECTION(name) {
            const auto mesh = core::read_mesh(folder.write(name, content));
            INFO((mesh ? std::string("read") : mesh.error().sentence()));
            REQUIRE(mesh.has_value());
            CHECK(mesh->vertices.size() == 3);
            CHECK(mesh->triangles.size() == 1);
        }
    }
}

TEST_CASE("faces of many corners, equal corners and useless faces come out as clean triangles", "[mesh_reader]") {
    const Folder folder;
    const auto mesh = core::read_mesh(folder.write(
        "mixed.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\nv 9 9 9\nf 1 2 3 4\nf 5 3 4\nf 1 1 2\nl 1 2\np 3\n"));
    REQUIRE(mesh.has_value());
    CHECK(mesh->triangles.size() == 3);
    CHECK(mesh->vertices.size() == 4);  // 5 is 1 again, 6 is used by no face
}

TEST_CASE("nodes place their meshes and materials colour them", "[mesh_reader]") {
    const Folder folder;
    const auto mesh = core::read_mesh(folder.write("placed.gltf", gltf("3")));
    REQUIRE(mesh.has_value());
    CHECK(mesh->vertices == std::vector<Vec3>{{10, 0, 0}, {12, 0, 0}, {10, 2, 0}});
    CHECK(mesh->colours == std::vector<Rgb>(3, Rgb{255, 0, 0}));

    (void)folder.write("paint.mtl", "newmtl leaf\nKd 0.2 0.6 0.4\n");
    const auto painted = core::read_mesh(
        folder.write("painted.obj", "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl leaf\nf 1 2 3\n"));
    REQUIRE(painted.has_value());
    CHECK(painted->colours == std::vector<Rgb>(3, Rgb{51, 153, 102}));

    const auto by_vertex = core::read_mesh(folder.write("vertex.ply", kPly));
    REQUIRE(by_vertex.has_value());
    CHECK(by_vertex->colours == std::vector<Rgb>{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}});

    const auto bare = core::read_mesh(folder.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    CHECK(bare->colours.empty());
}

TEST_CASE("a file that cannot be used is refused in one sentence that names it", "[mesh_reader]") {
    const Folder folder;
    struct Case {
        std::string name, content;
        ErrorCode code;
        std::string says;
    };
    const std::string zip = std::string("PK\x03\x04\x14\x00\x00\x00\x08\x00", 10) + std::string(200, 'z');
    std::string long_ply = kPly;
    long_ply.replace(long_ply.find("vertex 3"), 8, "vertex 3000000000");
    std::string endless = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
    for (int i = 0; i < 7000; ++i) endless += " 1 2 3";
    const std::vector<Case> cases{
        {"endless.obj", endless + "\n", ErrorCode::BadMesh, "20000 corners"},
        {"nothing.obj", "", ErrorCode::BadFormat, "empty"},
        {"nothing.off", "", ErrorCode::BadFormat, "empty"},
        {"zip.obj", zip, ErrorCode::UnknownFormat, "archive"},
        {"zip.off", zip, ErrorCode::UnknownFormat, "archive"},
        {"zip.stl", zip, ErrorCode::UnknownFormat, "archive"},
        {"letter.txt", "Dear all,\n", ErrorCode::UnknownFormat, "no kind of model file"},
        {"no_extension", "v 0 0 0\n", ErrorCode::UnknownFormat, "no kind of model file"},
        {"bytes.obj", std::string("v 0 0\0 0\n", 9), ErrorCode::BadFormat, "not the text"},
        {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", ErrorCode::EmptyMesh, "no usable faces"},
        {"lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", ErrorCode::EmptyMesh, "no usable faces"},
        {"flat.obj", "v 0 0 0\nv 1 0 0\nf 1 2 2\n", ErrorCode::EmptyMesh, "no usable faces"},
        {"range.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ErrorCode::BadMesh, "corner 3"},
        {"nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 inf 0\n3 0 1 2\n", ErrorCode::EmptyMesh, "no usable faces"},
        {"short.stl", binary_stl(4000000000U), ErrorCode::BadFormat, "cut short"},
        {"tiny.stl", "abc", ErrorCode::BadFormat, "cut short"},
        {"short.ply", long_ply, ErrorCode::BadFormat, "cut short"},
        {"other.ply", "polygons\n", ErrorCode::BadFormat, "PLY"},
        {"huge.gltf", gltf("4000000000"), ErrorCode::BadFormat, "more data than is read"},
        {"broken.gltf", "{\"asset\":", ErrorCode::BadFormat, "cannot be read"},
        {"broken.dae", "<COLLADA><library_geometries>", ErrorCode::BadFormat, "cannot be read"},
        {"prose.3ds", "Once upon a time there was a mesh.\n", ErrorCode::BadFormat, "cannot be read"},
    };
    for (const Case& bad : cases) {
        DYNAMIC_SECTION(bad.name) {
            const fs::path path = folder.write(bad.name, bad.content);
            const auto mesh = core::read_mesh(path);
            REQUIRE_FALSE(mesh.has_value());
            CHECK(mesh.error().code == bad.code);
            CHECK(mesh.error().where == path.string());
            CHECK_THAT(mesh.error().message, Catch::Contains(bad.says));
            CHECK(std::count(mesh.error().message.begin(), mesh.error().message.end(), '\n') == 0);
        }
    }
}

TEST_CASE("a corner number out of range in an OBJ file is refused or left out", "[mesh_reader]") {
    const Folder folder;
    const auto mesh = core::read_mesh(folder.write("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 77\n"));
    if (mesh)
        CHECK(mesh->triangles.size() == 1);
    else
        CHECK_THAT(mesh.error().sentence(), Catch::Contains("range.obj"));
}

TEST_CASE("what is no ordinary file is refused", "[mesh_reader]") {
    const Folder folder;
    CHECK(core::read_mesh(folder.path() / "missing.off").error().code == ErrorCode::FileMissing);
    fs::create_directories(folder.path() / "folder.off");
    CHECK(core::read_mesh(folder.path() / "folder.off").error().code == ErrorCode::FileUnreadable);
    const fs::path large = folder.write("large.obj", "v 0 0 0\n");
    fs::resize_file(large, core::kLargestMeshFileBytes + 1);  // a hole, no disk space
    CHECK(core::read_mesh(large).error().code == ErrorCode::FileUnreadable);
    CHECK_THAT(core::read_mesh(large).error().message, Catch::Contains("larger"));
}

TEST_CASE("a material that is a device is not opened", "[mesh_reader]") {
    const Folder folder;
    const auto mesh =
        core::read_mesh(folder.write("device.obj", "mtllib /dev/zero\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"));
    CHECK(mesh.has_value());
}

TEST_CASE("folders are searched for the known extensions in any case", "[mesh_reader]") {
    CHECK(std::is_sorted(core::mesh_extensions().begin(), core::mesh_extensions().end()));
    CHECK(core::has_mesh_extension("a/b.off"));
    CHECK(core::has_mesh_extension("a/B.GlTF"));
    CHECK_FALSE(core::has_mesh_extension("a/b.txt"));
    CHECK_FALSE(core::has_mesh_extension("a/off"));
}

TEST_CASE("damaged copies of good files are read or refused, never worse", "[mesh_reader]") {
    const Folder folder;
    const std::vector<std::pair<std::string, std::string>> files{
        {"a.off", "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2\n"},
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"},
        {"a.stl", binary_stl(1)},
        {"a.ply", kPly},
        {"a.gltf", gltf("3")},
    };
    std::mt19937 random(7);
    int read = 0, refused = 0;
    for (const auto& [name, good] : files) {
        for (int i = 0; i < 40; ++i) {
            std::string bad = good;
            for (unsigned k = 0; k <= random() % 4; ++k) bad[random() % bad.size()] = static_cast<char>(random() % 128);
            if (random() % 4 == 0) bad.resize(random() % bad.size());
            const auto mesh = core::read_mesh(folder.write(name, bad));
            ++(mesh ? read : refused);
            if (!mesh) continue;
            for (const auto& triangle : mesh->triangles) {
                for (const std::uint32_t v : triangle) REQUIRE(v < mesh->vertices.size());
            }
        }
    }
    CHECK(read > 0);
    CHECK(refused > 0);
}
