#include "core/exchange/png_writer.hpp"

#include <png.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <unordered_map>

namespace core {

namespace {

Result<png_image> header_of(const RgbaImage& image) {
    const std::size_t bytes = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    if (image.width <= 0 || image.height <= 0 || image.pixels.size() != bytes) {
        return unexpected(ErrorCode::BadArgument, "there are no pixels to write as a picture");
    }
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGBA;
    return png;
}

}  // namespace

Result<void> write_png(const std::filesystem::path& path, const RgbaImage& image) {
    Result<png_image> png = header_of(image);
    if (!png) return unexpected(png.error().code, png.error().message, path.string());
    png->flags = PNG_IMAGE_FLAG_FAST;
    if (png_image_write_to_file(&*png, path.c_str(), 0, image.pixels.data(), 0, nullptr) == 0) {
        return unexpected(ErrorCode::WriteFailed,
                          std::string("the picture cannot be written (") + png->message +
                              "); check that the folder exists and has room",
                          path.string());
    }
    return {};
}

namespace {

/// The picture as numbers of colours, where they are few enough for PNG's palette.
struct Palette {
    std::vector<std::uint8_t> colours;  ///< RGBA, in the order of first use
    std::vector<std::uint8_t> numbers;  ///< one a pixel
};

std::optional<Palette> palette_of(const RgbaImage& image) {
    constexpr std::size_t kMostColours = 256;
    Palette palette;
    std::unordered_map<std::uint32_t, std::uint8_t> known;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        std::uint32_t colour = 0;
        std::memcpy(&colour, &image.pixels[i], sizeof colour);
        const auto [entry, fresh] = known.try_emplace(colour, static_cast<std::uint8_t>(known.size()));
        if (known.size() > kMostColours) return std::nullopt;
        if (fresh) {
            for (std::size_t k = 0; k < 4; ++k) palette.colours.push_back(image.pixels[i + k]);
        }
        palette.numbers.push_back(entry->second);
    }
    return palette;
}

}  // namespace

Result<std::vector<std::byte>> png_bytes(const RgbaImage& image) {
    Result<png_image> png = header_of(image);
    if (!png) return unexpected(png.error());
    const std::optional<Palette> palette = palette_of(image);
    if (palette) {
        png->format = PNG_FORMAT_RGBA_COLORMAP;
        png->colormap_entries = static_cast<png_uint_32>(palette->colours.size() / 4);
    }
    const std::uint8_t* pixels = palette ? palette->numbers.data() : image.pixels.data();
    const std::uint8_t* colours = palette ? palette->colours.data() : nullptr;
    std::vector<std::byte> bytes(PNG_IMAGE_PNG_SIZE_MAX(*png));
    png_alloc_size_t size = bytes.size();
    if (png_image_write_to_memory(&*png, bytes.data(), &size, 0, pixels, 0, colours) == 0) {
        return unexpected(ErrorCode::Internal, std::string("the picture cannot be packed (") + png->message + ")");
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace core
