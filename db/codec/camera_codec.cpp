#include "db/codec/camera_codec.hpp"

#include <cmath>

namespace db {

namespace {

constexpr std::uint8_t kCameraVersion = 1;
constexpr double kTolerance = 1e-6;

bool is_camera(const core::Camera& camera) {
    return std::abs(core::length(camera.direction) - 1.0) <= kTolerance &&
           std::abs(core::length(camera.up) - 1.0) <= kTolerance &&
           std::abs(core::dot(camera.direction, camera.up)) <= kTolerance;
}

void write(ByteWriter& out, core::Vec3 v) {
    out.f64(v.x);
    out.f64(v.y);
    out.f64(v.z);
}

core::Vec3 read(ByteReader& in) {
    core::Vec3 v;
    v.x = in.f64();
    v.y = in.f64();
    v.z = in.f64();
    return v;
}

}  // namespace

core::Result<Blob> encode_camera(const core::Camera& camera) {
    if (!is_camera(camera)) {
        return core::unexpected(core::ErrorCode::BadArgument,
                                "the camera's direction and up are no unit vectors at a right angle");
    }
    ByteWriter out(BlobKind::Camera, kCameraVersion);
    write(out, camera.direction);
    write(out, camera.up);
    return out.take();
}

core::Result<core::Camera> decode_camera(BlobView blob) {
    ByteReader in(blob);
    core::Camera camera;
    if (in.header(BlobKind::Camera, kCameraVersion) != 0) {
        camera.direction = read(in);
        camera.up = read(in);
        if (!is_camera(camera)) in.fail("it holds no camera");
    }
    if (const core::Result<void> done = in.finish(); !done) return core::unexpected(done.error());
    return camera;
}

}  // namespace db
