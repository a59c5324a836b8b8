#include "db/codec/camera_codec.hpp"

#include "core/views/cameras.hpp"
#include "db_fixtures.hpp"
#include "hostile_blob.hpp"

namespace {

bool same(const core::Camera& a, const core::Camera& b) {
    return a.direction == b.direction && a.up == b.up;
}

}  // namespace

TEST_CASE("a camera comes back bit for bit", "[camera]") {
    fixture::Random random(5);
    for (int i = 0; i < 100; ++i) {
        const core::Camera camera = fixture::random_camera(random);
        const db::Blob blob = fixture::value(db::encode_camera(camera));
        CHECK(blob.size() == 50);
        CHECK(same(fixture::value(db::decode_camera(blob)), camera));
    }
}

TEST_CASE("the cameras that look at models take three bytes", "[camera]") {
    for (const core::Camera& camera : core::cameras()) {
        const db::Blob blob = fixture::value(db::encode_camera(camera));
        CHECK(blob.size() == 3);
        CHECK(same(fixture::value(db::decode_camera(blob)), camera));
    }
    const db::Blob beyond{std::byte{'C'}, std::byte{2}, std::byte{50}};
    CHECK(fixture::sentence(db::decode_camera(beyond)).find("out of range") != std::string::npos);
}

TEST_CASE("what is no camera is not stored", "[camera]") {
    CHECK_FALSE(db::encode_camera({.direction = {0, 0, 2}, .up = {0, 1, 0}}));
    CHECK_FALSE(db::encode_camera({.direction = {0, 0, 1}, .up = {0, 0, 1}}));
}

TEST_CASE("a camera blob cut off or changed gives an error or a camera", "[camera][hostile]") {
    fixture::Random random(6);
    const core::Camera camera = GENERATE(true, false) ? fixture::random_camera(random) : core::cameras()[40];
    const db::Blob blob = fixture::value(db::encode_camera(camera));
    fixture::try_every_cut_and_flip<core::Camera>(blob, db::decode_camera, db::encode_camera, same);
}
