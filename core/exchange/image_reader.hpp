#pragma once
// Pictures from files: PNG, BMP and JPEG as one byte of grey a pixel.
//
//     const core::Result<core::GrayImage> page = core::read_gray_image("horse.png");
//
// Colour becomes luma (Rec. 601), transparency shows white paper, 16-bit values keep their upper byte.

#include <cstddef>
#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/silhouette/image.hpp"

namespace core {

/// Limits that are checked before anything is decoded, so that a small file cannot ask for much memory.
inline constexpr int kMaxImageSide_px = 20'000;
inline constexpr long long kMaxImagePixels = 48'000'000;

/// Whether the bytes begin as a PNG, BMP or JPEG file does. Says nothing about the rest. Constant time.
[[nodiscard]] bool looks_like_image(std::span<const std::byte> bytes);

/// Decodes a whole PNG (1 to 16 bit, palette, grey, RGB, with or without alpha), BMP or JPEG file held in memory.
/// UnknownFormat when the bytes are none of these; BadFormat when the picture is damaged, has no pixels or exceeds the
/// limits above. `where` is left empty. Linear in pixels; at most about 16 bytes of memory a pixel while decoding.
[[nodiscard]] Result<GrayImage> decode_gray_image(std::span<const std::byte> bytes);

/// The same in colour; opacity 255 where the file has none.
[[nodiscard]] Result<RgbaImage> decode_rgba_image(std::span<const std::byte> bytes);

/// Grey, from a file; errors name it. FileMissing and FileUnreadable as read_file_bytes gives them.
[[nodiscard]] Result<GrayImage> read_gray_image(const std::string& path);

}  // namespace core
