#include "core/exchange/obj_writer.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <sstream>

TEST_CASE("vertices keep their digits, pieces are groups", "[obj_writer]") {
    const core::QuadMesh mesh{{{0.1, -0.0, 1e-20}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                              {{0, 1, 2, 3}, {1, 4, 5, 2}}};
    std::ostringstream out;
    const std::vector<core::QuadGroup> groups{{"front left", 0, 1}, {"back", 1, 1}};
    REQUIRE(core::write_obj(out, mesh, groups));
    CHECK(out.str() ==
          "# made by Croquis\nv 0.1 0 1e-20\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\ng front_left\nf 1 2 3 4\n"
          "g back\nf 2 5 6 3\n");
    std::ostringstream plain;
    REQUIRE(core::write_obj(plain, mesh));
    CHECK(plain.str().find("g ") == std::string::npos);
}

TEST_CASE("texture places are written once for each vertex that has them", "[obj_writer]") {
    const core::QuadMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                              {{0, 1, 2, 3}, {1, 4, 5, 2}}};
    const std::vector<core::QuadTexture> texture{{{{0, 0}, {1, 0}, {1, 1}, {-0.0, 1}}},
                                                 {{{1, 0}, {2, 0}, {2, 1}, {7, 1}}}};
    std::ostringstream out;
    REQUIRE(core::write_obj(out, mesh, {}, texture));
    const std::string text = out.str();
    CHECK(text.find("vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 2 0\nvt 2 1\nvt 7 1\nf 1/1 2/2 3/3 4/4\nf 2/2 5/5 6/6 3/7\n") !=
          std::string::npos);
    CHECK(core::write_obj(out, mesh, {}, {texture.data(), 1}).error().code == core::ErrorCode::BadMesh);
}

TEST_CASE("a quad with a missing vertex, a stream and a path that fail", "[obj_writer]") {
    std::ostringstream out;
    CHECK(core::write_obj(out, {{{0, 0, 0}}, {{0, 0, 0, 1}}}).error().code == core::ErrorCode::BadMesh);
    out.setstate(std::ios::badbit);
    CHECK(core::write_obj(out, {{{0, 0, 0}}, {}}).error().code == core::ErrorCode::WriteFailed);
    CHECK(core::write_obj_file("/nowhere/x.obj", {}).error().where == "/nowhere/x.obj");
}
