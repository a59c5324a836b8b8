#include "core/exchange/off_reader.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

using core::ErrorCode;
using core::Rgb;
using core::TriangleMesh;

namespace {

const std::string kVertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

double area(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        sum +=
            0.5 * core::length(core::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
    }
    return sum;
}

}  // namespace

TEST_CASE("an OFF text is read whatever way its header is written", "[off_reader]") {
    const std::string body = kVertices + "3 0 1 2\n3 0 2 3\n";
    const std::vector<std::pair<std::string, std::string>> headers{
        {"plain", "OFF\n4 2 0\n"},
        {"counts on the same line", "OFF 4 2 0\n"},
        {"counts run into the word", "OFF4 2 0\n"},
        {"no word", "4 2 0\n"},
        {"no edge count", "OFF\n4 2\n"},
        {"comments and empty lines", "# made by hand\n\nOFF # yes\n# counts\n4 2 0 # four\n\n"},
        {"Windows line ends", "OFF\r\n4 2 0\r\n"},
        {"byte order mark", "\xEF\xBB\xBFOFF\n4 2 0\n"},
    };
    for (const auto& [name, header] : headers) {
        DYNAMIC_SECTION(name) {
            const auto mesh = core::read_off(header + body);
            REQUIRE(mesh.has_value());
            CHECK(mesh->vertices.size() == 4);
            CHECK(mesh->triangles.size() == 2);
            CHECK(mesh->colours.empty());
            CHECK(area(*mesh) == Approx(1.0));
        }
    }
}

TEST_CASE("colours of vertices and of faces are kept", "[off_reader]") {
    const auto coloured =
        core::read_off("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 0 0 255 255\n3 0 1 2\n");
    REQUIRE(coloured.has_value());
    CHECK(coloured->colours == std::vector<Rgb>{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}});

    const auto by_face = core::read_off("OFF\n4 2 0\n" + kVertices + "3 0 1 2 1.0 0.5 0\n3 0 2 3\n");
    REQUIRE(by_face.has_value());
    CHECK(by_face->vertices.size() == 6);  // the corners of two colours are two vertices
    CHECK(by_face->colours[by_face->triangles[0][1]] == Rgb{255, 128, 0});
    CHECK(by_face->colours[by_face->triangles[1][1]] == Rgb{});

    const auto with_normals =
        core::read_off("CNOFF\n3 1 0\n0 0 0 0 0 1 9 8 7\n1 0 0 0 0 1 9 8 7\n0 1 0 0 0 1 9 8 7\n3 0 1 2\n");
    REQUIRE(with_normals.has_value());
    CHECK(with_normals->colours[0] == Rgb{9, 8, 7});
    // A single number is a place in a colour table that the file does not hold.
    CHECK(core::read_off("OFF\n4 1 0\n" + kVertices + "4 0 1 2 3 7\n")->colours.empty());
}

TEST_CASE("faces of many corners are cut along the face, concave ones too", "[off_reader]") {
    const auto quad = core::read_off("OFF\n4 1 0\n" + kVertices + "4 0 1 2 3\n");
    CHECK(quad->triangles.size() == 2);
    const std::string letter_l = "OFF\n6 1 0\n0 0 5\n3 0 5\n3 1 5\n1 1 5\n1 3 5\n0 3 5\n6 3 4 5 0 1 2\n";
    const auto concave = core::read_off(letter_l);
    REQUIRE(concave.has_value());
    CHECK(concave->triangles.size() == 4);
    CHECK(area(*concave) == Approx(5.0));
}

TEST_CASE("what shows nothing is left out", "[off_reader]") {
    const auto mesh =
        core::read_off("OFF\n6 6 0\n" + kVertices + "nan 0 0\n0 0 0\n3 0 1 2\n3 0 1 1\n3 0 5 1\n3 1 2 4\n2 0 1\n0\n");
    REQUIRE(mesh.has_value());
    CHECK(mesh->triangles.size() == 1);
    CHECK(mesh->vertices.size() == 3);
}

TEST_CASE("a damaged OFF text is refused with the line and the reason", "[off_reader]") {
    struct Case {
        std::string name, text;
        ErrorCode code;
        std::string says;
    };
    const std::vector<Case> cases{
        {"empty", "", ErrorCode::BadFormat, "is this an OFF file?"},
        {"prose", "Once upon a time\n", ErrorCode::BadFormat, "is this an OFF file?"},
        {"counts that lie", "OFF\n4000000000 4000000000 0\n" + kVertices, ErrorCode::BadFormat, "promises more"},
        {"vertices that lie", "OFF\n999999999999 1 0\n" + kVertices, ErrorCode::BadFormat, "promises more"},
        {"negative counts", "OFF\n-4 -2 0\n" + kVertices, ErrorCode::BadFormat, "is this an OFF file?"},
        {"too few vertices", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n# that was all of it\n", ErrorCode::BadFormat,
         "cut short"},
        {"too few faces", "OFF\n4 3 0\n" + kVertices + "3 0 1 2\n", ErrorCode::BadFormat, "faces are missing"},
        {"faces missing", "OFF\n4 3 0\n" + kVertices + "3 0 1 2  \n     ", ErrorCode::BadFormat, "faces are missing"},
        {"face cut short", "OFF\n4 1 0\n" + kVertices + "3 0 1", ErrorCode::BadFormat, "line 7"},
        {"word for a number", "OFF\n4 1 0\n0 0 zero\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n", ErrorCode::BadFormat, "line 3"},
        {"corner out of range", "OFF\n4 1 0\n" + kVertices + "3 0 1 4\n", ErrorCode::BadMesh, "corner 4"},
        {"negative corner", "OFF\n4 1 0\n" + kVertices + "3 0 1 -1\n", ErrorCode::BadMesh, "corner -1"},
        {"endless face", "OFF\n4 1 0\n" + kVertices + "99999999 0 1 2\n", ErrorCode::BadFormat,
         "number of a face's corners"},
        {"no faces", "OFF\n4 0 0\n" + kVertices, ErrorCode::EmptyMesh, "no usable faces"},
        {"only useless faces", "OFF\n4 1 0\n" + kVertices + "3 0 0 0\n", ErrorCode::EmptyMesh, "no usable faces"},
        {"binary", "OFF BINARY\n\x01\x02", ErrorCode::BadFormat, "binary"},
        {"four dimensions", "4OFF\n4 1 0\n", ErrorCode::BadFormat, "three dimensions"},
    };
    for (const Case& bad : cases) {
        DYNAMIC_SECTION(bad.name) {
            const auto mesh = core::read_off(bad.text);
            REQUIRE_FALSE(mesh.has_value());
            CHECK(mesh.error().code == bad.code);
            CHECK_THAT(mesh.error().message, Catch::Contains(bad.says));
        }
    }
}
