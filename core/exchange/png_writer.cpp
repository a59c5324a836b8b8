#include "core/exchange/png_writer.hpp"

#include <png.h>

#include <string>

namespace core {

Result<void> write_png(const std::filesystem::path& path, const RgbaImage& image) {
    const std::size_t bytes = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    if (image.width <= 0 || image.height <= 0 || image.pixels.size() != bytes) {
        return unexpected(ErrorCode::BadArgument, "there are no pixels to write as a picture", path.string());
    }
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGBA;
    png.flags = PNG_IMAGE_FLAG_FAST;
    if (png_image_write_to_file(&png, path.c_str(), 0, image.pixels.data(), 0, nullptr) == 0) {
        return unexpected(ErrorCode::WriteFailed,
                          std::string("the picture cannot be written (") + png.message +
                              "); check that the folder exists and has room",
                          path.string());
    }
    return {};
}

}  // namespace core
