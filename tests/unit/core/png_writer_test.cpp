#include "core/exchange/png_writer.hpp"

#include <png.h>
#include <unistd.h>

#include <catch2/catch.hpp>

namespace {

std::filesystem::path temporary(const char* name) {
    return std::filesystem::temp_directory_path() / (std::to_string(getpid()) + name);
}

}  // namespace

TEST_CASE("a picture written as PNG reads back pixel by pixel", "[png]") {
    core::RgbaImage image{3, 2, {}};
    for (int i = 0; i < 24; ++i) image.pixels.push_back(static_cast<std::uint8_t>(i * 10));
    const std::filesystem::path path = temporary("-picture.png");
    REQUIRE(core::write_png(path, image));
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&png, path.c_str()) != 0);
    png.format = PNG_FORMAT_RGBA;
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(png));
    REQUIRE(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr) != 0);
    CHECK(png.width == 3);
    CHECK(png.height == 2);
    CHECK(pixels == image.pixels);
    std::filesystem::remove(path);
}

TEST_CASE("a picture packed as PNG reads back pixel by pixel, with few colours and with many", "[png]") {
    for (const unsigned colours : {1U, 256U, 257U, 3000U}) {
        core::RgbaImage image{60, 50, {}};
        for (unsigned i = 0; i < 3000; ++i) {
            const unsigned c = i % colours;
            for (const unsigned byte : {c % 256, c / 256, 90U, c % 5 == 0 ? 0U : 255U}) {
                image.pixels.push_back(static_cast<std::uint8_t>(byte));
            }
        }
        const auto bytes = core::png_bytes(image);
        REQUIRE(bytes);
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        REQUIRE(png_image_begin_read_from_memory(&png, bytes->data(), bytes->size()) != 0);
        CHECK(((png.format & PNG_FORMAT_FLAG_COLORMAP) != 0) == (colours <= 256));
        png.format = PNG_FORMAT_RGBA;
        std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(png));
        REQUIRE(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr) != 0);
        CHECK(pixels == image.pixels);
        CHECK(*core::png_bytes(image) == *bytes);
    }
    CHECK(core::png_bytes({}).error().code == core::ErrorCode::BadArgument);
}

TEST_CASE("pictures that cannot be written are refused with the file's name", "[png]") {
    const core::RgbaImage image{1, 1, {1, 2, 3, 4}};
    const core::Result<void> nowhere = core::write_png("/nonexistent/folder/x.png", image);
    REQUIRE_FALSE(nowhere);
    CHECK(nowhere.error().code == core::ErrorCode::WriteFailed);
    CHECK(nowhere.error().where == "/nonexistent/folder/x.png");
    CHECK(core::write_png(temporary("-empty.png"), {}).error().code == core::ErrorCode::BadArgument);
    CHECK(core::write_png(temporary("-short.png"), {2, 2, {0, 0}}).error().code == core::ErrorCode::BadArgument);
}
