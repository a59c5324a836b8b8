#pragma once
// A camera as a blob, exact: one of the 50 of core/views/cameras.hpp by its number in 3 bytes (layout 2), any other by
// its vectors in 50 (layout 1).

#include "core/base/result.hpp"
#include "core/views/camera.hpp"
#include "db/codec/bytes.hpp"

namespace db {

/// BadArgument unless direction and up are unit vectors at a right angle (to 1e-6).
[[nodiscard]] core::Result<Blob> encode_camera(const core::Camera& camera);

/// Damaged for bytes that encode_camera cannot have written.
[[nodiscard]] core::Result<core::Camera> decode_camera(BlobView blob);

}  // namespace db
