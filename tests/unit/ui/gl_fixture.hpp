#pragma once
// A real OpenGL ES context without a screen for tests, and looking at the pixels of a picture.

#include <catch2/catch.hpp>
#include <memory>

#include "ui/gl/headless_context.hpp"
#include "ui/gl/objects.hpp"

namespace test {

/// Member order matters in tests: the context first, so that it goes last.
inline std::unique_ptr<ui::Context> gl() {
    core::Result<std::unique_ptr<ui::Context>> context = ui::make_headless_context();
    if (!context) FAIL(context.error().sentence());
    return std::move(*context);
}

struct Pixel {
    int r, g, b, a;
};

inline Pixel pixel(const core::RgbaImage& image, int x, int y) {
    const std::size_t i =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * 4;
    return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2], image.pixels[i + 3]};
}

}  // namespace test
