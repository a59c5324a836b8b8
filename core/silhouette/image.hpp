#pragma once
// Raster images as plain values. Row 0 is the top row; y grows down, unlike everywhere else in core.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// One byte a pixel. Empty when width or height is 0.
struct GrayImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;  ///< width * height, row by row; 0 black … 255 white

    GrayImage() = default;
    GrayImage(int w, int h, std::uint8_t value = 0)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}
    [[nodiscard]] std::uint8_t& at(int x, int y) { return pixels[index(x, y)]; }
    [[nodiscard]] std::uint8_t at(int x, int y) const { return pixels[index(x, y)]; }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// The same layout holding 0 (outside) and 1 (object).
using BinaryImage = GrayImage;

/// Four bytes a pixel: red, green, blue, alpha (not premultiplied).
struct RgbaImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;  ///< width * height * 4
};

}  // namespace core
