#pragma once
// Writes pictures as PNG files.

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/base/result.hpp"
#include "core/silhouette/image.hpp"

namespace core {

/// Writes an 8-bit RGBA PNG. The same pixels give the same bytes. ErrorCode::WriteFailed naming the file when the
/// folder is missing or the disk refuses; ErrorCode::BadArgument for a picture without pixels or with too few of them.
[[nodiscard]] Result<void> write_png(const std::filesystem::path& path, const RgbaImage& image);

/// The same pixels as bytes, packed tightly: with a palette where there are at most 256 colours. About 2 ms for a
/// picture of 192 x 144.
[[nodiscard]] Result<std::vector<std::byte>> png_bytes(const RgbaImage& image);

}  // namespace core
