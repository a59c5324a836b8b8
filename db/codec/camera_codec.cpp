#include "db/codec/camera_codec.hpp"

#include <algorithm>
#include <cmath>

#include "core/views/cameras.hpp"

namespace db {

namespace {

constexpr std::uint8_t kVectors = 1, kNumber = 2;  // layouts
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
    const auto& known = core::cameras();
    const auto same = [&camera](const core::Camera& c) { return c.direction == camera.direction && c.up == camera.up; };
    if (const auto found = std::find_if(known.begin(), known.end(), same); found != known.end()) {
        ByteWriter out(BlobKind::Camera, kNumber);
        out.varint(static_cast<std::uint64_t>(found - known.begin()));
        return out.take();
    }
    ByteWriter out(BlobKind::Camera, kVectors);
    write(out, camera.direction);
    write(out, camera.up);
    return out.take();
}

core::Result<core::Camera> decode_camera(BlobView blob) {
    ByteReader in(blob);
    core::Camera camera;
    switch (in.header(BlobKind::Camera, kNumber)) {
        case kVectors:
            camera.direction = read(in);
            camera.up = read(in);
            if (!is_camera(camera)) in.fail("it holds no camera");
            break;
        case kNumber:
            camera = core::cameras()[static_cast<std::size_t>(in.integer(core::kCameraCount - 1))];
            break;
        default:
            break;  // the reader has noted the fault
    }
    if (const core::Result<void> done = in.finish(); !done) return core::unexpected(done.error());
    return camera;
}

}  // namespace db
