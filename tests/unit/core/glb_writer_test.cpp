#include "core/exchange/glb_writer.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <sstream>

#include "core/exchange/mesh_reader.hpp"
#include "support/temporary_folder.hpp"

using core::GlbMesh;
using core::QuadMesh;

namespace {

const QuadMesh kTwo{{{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}, {200, 0, 0}, {200, 100, 0}},
                    {{0, 1, 2, 3}, {1, 4, 5, 2}}};

}  // namespace

TEST_CASE("a file has a node, a mesh and a material for each piece", "[glb_writer]") {
    std::ostringstream out;
    const std::vector<GlbMesh> meshes{{"left \"half\"", &kTwo, 0, 1, {255, 0, 0}, true},
                                      {"right", &kTwo, 1, 1, {0, 0, 255}, false}};
    REQUIRE(core::write_glb(out, meshes));
    const std::string bytes = out.str();
    CHECK(bytes.substr(0, 4) == "glTF");
    CHECK(bytes.size() % 4 == 0);
    CHECK(bytes.find("left \\\"half\\\"") != std::string::npos);
    CHECK(bytes.find("\"baseColorFactor\":[1.0,0.0,0.0,1.0]") != std::string::npos);
    CHECK(bytes.find("\"doubleSided\":false") != std::string::npos);
    std::ostringstream again;
    REQUIRE(core::write_glb(again, meshes));
    CHECK(again.str() == bytes);
}

TEST_CASE("the mesh is read back in metres", "[glb_writer]") {
    const support::TemporaryFolder folder;
    const auto path = folder.path("two.glb");
    REQUIRE(core::write_glb_file(path, std::vector<GlbMesh>{{"all", &kTwo, 0, 2, {200, 200, 200}, true}}));
    const auto mesh = core::read_mesh(path);
    REQUIRE(mesh);
    CHECK(mesh->triangles.size() == 4);
    CHECK(mesh->vertices.size() == 6);
    double right = 0.0;
    for (const core::Vec3& v : mesh->vertices) right = std::max(right, v.x);
    CHECK(right == Approx(2.0));
}

TEST_CASE("texture coordinates are in metres and run down; vertices with two are split", "[glb_writer]") {
    const std::vector<core::QuadTexture> texture{{{{0, 0}, {100, 0}, {100, 50}, {0, 50}}},
                                                 {{{100, 0}, {200, 0}, {200, 50}, {100, 25}}}};
    std::ostringstream out;
    REQUIRE(core::write_glb(out, std::vector<GlbMesh>{{"all", &kTwo, 0, 2, {}, true, &texture}}));
    const std::string bytes = out.str();
    CHECK(bytes.find("\"TEXCOORD_0\"") != std::string::npos);
    CHECK(bytes.find("\"count\":7,\"type\":\"VEC2\"") != std::string::npos);
    float down = 0.0F;
    std::memcpy(&down, bytes.data() + bytes.size() - 4 * 12 - 4 * 1, 4);  // the last value before twelve indices
    CHECK(down == Approx(-0.25F));
    const std::vector<core::QuadTexture> few(1);
    CHECK_FALSE(core::write_glb(out, std::vector<GlbMesh>{{"few", &kTwo, 0, 2, {}, true, &few}}));
}

TEST_CASE("faulty meshes and streams", "[glb_writer]") {
    std::ostringstream out;
    const QuadMesh bad{{{0, 0, 0}}, {{0, 0, 0, 7}}};
    CHECK(core::write_glb(out, std::vector<GlbMesh>{{"bad", &bad, 0, 1, {}, true}}).error().code ==
          core::ErrorCode::BadMesh);
    CHECK(core::write_glb(out, std::vector<GlbMesh>{{"few", &kTwo, 1, 2, {}, true}}).error().code ==
          core::ErrorCode::BadMesh);
    out.setstate(std::ios::badbit);
    CHECK(core::write_glb(out, {}).error().code == core::ErrorCode::WriteFailed);
    CHECK(core::write_glb_file("/nowhere/x.glb", {}).error().where == "/nowhere/x.glb");
}
