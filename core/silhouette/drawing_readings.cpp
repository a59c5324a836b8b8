#include "core/silhouette/drawing_readings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace core {

namespace {

constexpr double kWider = 2.5;
constexpr double kDoubtfulShare = 0.01;
constexpr double kSamePixel = 1e-6;  // rounding of offsets

std::size_t object_pixels(const Silhouette& silhouette) {
    const auto& pixels = silhouette.image.pixels;
    return pixels.size() - static_cast<std::size_t>(std::count(pixels.begin(), pixels.end(), std::uint8_t{0}));
}

Result<std::vector<Silhouette>> competing(Result<Silhouette> plain, Result<Silhouette> wide) {
    if (!plain) return unexpected(plain.error());
    std::vector<Silhouette> readings;
    readings.push_back(std::move(*plain));
    if (wide && is_doubtful(readings.front(), *wide)) readings.push_back(std::move(*wide));
    return readings;
}

}  // namespace

SilhouetteOptions wide_reading(const SilhouetteOptions& options) {
    SilhouetteOptions wide = options;
    wide.closing_share *= kWider;
    wide.joining_share *= kWider;
    return wide;
}

bool is_doubtful(const Silhouette& plain, const Silhouette& wide) {
    if (plain.raster.scale != wide.raster.scale) return true;
    // The margins differ: how many pixels farther right and down the same place is on the wide raster.
    const Point by = wide.raster.offset - plain.raster.offset;
    const auto right = static_cast<int>(std::lround(by.x)), down = static_cast<int>(std::lround(by.y));
    if (std::abs(by.x - right) > kSamePixel || std::abs(by.y - down) > kSamePixel) return true;
    std::size_t common = 0;
    for (int y = std::max(0, -down); y < std::min(plain.image.height, wide.image.height - down); ++y) {
        for (int x = std::max(0, -right); x < std::min(plain.image.width, wide.image.width - right); ++x) {
            common += plain.image.at(x, y) != 0 && wide.image.at(x + right, y + down) != 0 ? 1 : 0;
        }
    }
    const std::size_t object = object_pixels(plain), other = object_pixels(wide);
    return static_cast<double>(object + other - 2 * common) > kDoubtfulShare * static_cast<double>(object);
}

Result<std::vector<Silhouette>> drawing_readings(const Drawing& drawing, const SilhouetteOptions& options) {
    return competing(find_silhouette(drawing, options), find_silhouette(drawing, wide_reading(options)));
}

Result<std::vector<Silhouette>> drawing_readings(const GrayImage& page, const SilhouetteOptions& options) {
    return competing(find_silhouette(page, options), find_silhouette(page, wide_reading(options)));
}

Result<Silhouette> LiveReadings::plain(const Drawing& drawing) {
    plain_.follow(drawing);
    return plain_.silhouette();
}

Result<std::vector<Silhouette>> LiveReadings::all(const Drawing& drawing) {
    wide_.follow(drawing);
    return competing(plain(drawing), wide_.silhouette());
}

}  // namespace core
