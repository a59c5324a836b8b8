#include "firmware_like_app/kiosk/own_fabrics.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <span>

#include "core/exchange/file_bytes.hpp"
#include "core/exchange/image_reader.hpp"

namespace app {
namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargest_bytes = 16U << 20;

bool is_png(const fs::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".png";
}

std::size_t at(const core::RgbaImage& image, int x, int y) {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * 4;
}

/// The mean of the pixels under each of the tile's, over white where the picture is clear.
core::RgbaImage tile_of(const core::RgbaImage& image) {
    const int side = std::min(image.width, image.height), left = (image.width - side) / 2,
              top = (image.height - side) / 2;
    core::RgbaImage out;
    out.width = out.height = std::min(side, kOwnTile_px);
    out.pixels.assign(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 4, 255);
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const int x0 = left + x * side / out.width, x1 = left + (x + 1) * side / out.width;
            const int y0 = top + y * side / out.height, y1 = top + (y + 1) * side / out.height;
            for (std::size_t c = 0; c < 3; ++c) {
                std::int64_t sum = 0;
                for (int v = y0; v < y1; ++v) {
                    for (int u = x0; u < x1; ++u) {
                        const int alpha = image.pixels[at(image, u, v) + 3];
                        sum += (int{image.pixels[at(image, u, v) + c]} * alpha + 255 * (255 - alpha)) / 255;
                    }
                }
                out.pixels[at(out, x, y) + c] = static_cast<std::uint8_t>(sum / ((x1 - x0) * (y1 - y0)));
            }
        }
    }
    return out;
}

core::Result<core::RgbaImage> read_tile(const fs::path& file) {
    std::error_code error;
    if (fs::file_size(file, error) > kLargest_bytes || error) {
        return core::unexpected(core::ErrorCode::BadFormat, "the picture is larger than 16 MB");
    }
    const core::Result<std::string> bytes = core::read_file_bytes(file.string(), kLargest_bytes);
    if (!bytes) return core::unexpected(bytes.error());
    const core::Result<core::RgbaImage> image = core::decode_rgba_image(std::as_bytes(std::span(*bytes)));
    if (!image) return core::unexpected(image.error());
    return tile_of(*image);
}

}  // namespace

OwnFabrics read_own_fabrics(const fs::path& folder) {
    OwnFabrics out;
    if (folder.empty()) return out;
    std::vector<fs::path> files;
    std::error_code error;
    for (auto it = fs::directory_iterator(folder, error); !error && it != fs::directory_iterator();
         it.increment(error)) {
        if (is_png(it->path())) files.push_back(it->path());
    }
    if (error) out.problem = folder.string() + ": " + error.message();
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        if (out.fabrics.size() == kMostOwnFabrics) break;
        core::Result<core::RgbaImage> tile = read_tile(file);
        if (tile) {
            out.fabrics.push_back({file.stem().string(), file.string(), std::move(*tile)});
        } else if (out.problem.empty()) {
            out.problem = file.filename().string() + ": " + tile.error().message;
        }
    }
    return out;
}

}  // namespace app
