#pragma once
// Writes pictures as PNG files.

#include <filesystem>

#include "core/base/result.hpp"
#include "core/silhouette/image.hpp"

namespace core {

/// Writes an 8-bit RGBA PNG. The same pixels give the same bytes. ErrorCode::WriteFailed naming the file when the
/// folder is missing or the disk refuses; ErrorCode::BadArgument for a picture without pixels or with too few of them.
[[nodiscard]] Result<void> write_png(const std::filesystem::path& path, const RgbaImage& image);

}  // namespace core
