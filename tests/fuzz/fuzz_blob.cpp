// Any bytes through every decoder. What decodes must encode, and come back the same.

#include <cstdint>
#include <cstdlib>

#include "db/codec/camera_codec.hpp"
#include "db/codec/contour_codec.hpp"
#include "db/codec/descriptor_codec.hpp"
#include "db/codec/mesh_codec.hpp"
#include "db/codec/points_codec.hpp"

namespace {

template <typename T, typename Encode, typename Same>
void try_blob(db::BlobView blob, core::Result<T> (*decode)(db::BlobView), Encode encode, Same same) {
    const core::Result<T> decoded = decode(blob);
    if (!decoded) return;
    const core::Result<db::Blob> again = encode(*decoded);
    if (!again) std::abort();
    const core::Result<T> twice = decode(*again);
    if (!twice || !same(*decoded, *twice)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const db::BlobView blob = std::as_bytes(std::span(data, size));
    const auto equal = [](const auto& a, const auto& b) { return a == b; };
    try_blob(blob, db::decode_polygon, db::encode_polygon, equal);
    try_blob(blob, db::decode_descriptor, db::encode_descriptor, equal);
    try_blob(blob, db::decode_contour, db::encode_contour, equal);
    try_blob(blob, db::decode_camera, db::encode_camera,
             [](const core::Camera& a, const core::Camera& b) { return a.direction == b.direction && a.up == b.up; });
    try_blob(blob, db::decode_mesh, db::encode_mesh, [](const core::TriangleMesh& a, const core::TriangleMesh& b) {
        return a.vertices == b.vertices && a.triangles == b.triangles && a.colours == b.colours;
    });
    return 0;
}
