// Holds every screen of the kiosk against the picture of it that was looked at.
//
//     screen_references FOLDER [NAME]       compares; exit code 1 when a screen differs, its picture beside as
//     NAME.new.png UPDATE_GOLDEN=1 screen_references FOLDER [NAME]     writes the references anew, to be looked at
//
// A reference is small: the screen at its sizes side by side, each 120 pixels high; where a scene has several pictures,
// those of a size in a row and the sizes below each other. Screens may differ a little, as
// drivers and fonts do: by 2 of 255 in the mean, and by 20 in no block of 6 x 6 pixels.

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/exchange/png_writer.hpp"
#include "tests/support/scenes.hpp"

namespace {

constexpr int kHeight = 120, kGap = 6, kBlock = 6;
constexpr double kMostMean = 2.0, kMostBlock = 20.0;

std::size_t at(const core::RgbaImage& image, int x, int y) {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * 4;
}

/// Mean of the pixels under each small one.
core::RgbaImage smaller(const core::RgbaImage& image) {
    core::RgbaImage out;
    out.height = kHeight;
    out.width = static_cast<int>(std::lround(static_cast<double>(image.width) * kHeight / image.height));
    out.pixels.assign(static_cast<std::size_t>(out.width) * kHeight * 4, 255);
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const int x0 = x * image.width / out.width, x1 = std::max(x0 + 1, (x + 1) * image.width / out.width);
            const int y0 = y * image.height / out.height, y1 = std::max(y0 + 1, (y + 1) * image.height / out.height);
            for (std::size_t c = 0; c < 3; ++c) {
                int sum = 0;
                for (int v = y0; v < y1; ++v) {
                    for (int u = x0; u < x1; ++u) sum += image.pixels[at(image, u, v) + c];
                }
                out.pixels[at(out, x, y) + c] = static_cast<std::uint8_t>(sum / ((x1 - x0) * (y1 - y0)));
            }
        }
    }
    return out;
}

core::RgbaImage blank(int width, int height) {
    core::RgbaImage image;
    image.width = width;
    image.height = height;
    image.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 255);
    return image;
}

void put(core::RgbaImage& sheet, const core::RgbaImage& picture, int left, int top) {
    for (int y = 0; y < picture.height; ++y) {
        std::copy_n(picture.pixels.begin() + static_cast<std::ptrdiff_t>(at(picture, 0, y)), picture.width * 4,
                    sheet.pixels.begin() + static_cast<std::ptrdiff_t>(at(sheet, left, top + y)));
    }
}

/// Side by side.
core::RgbaImage row_of(const std::vector<core::RgbaImage>& pictures) {
    int width = 0;
    for (const core::RgbaImage& picture : pictures) width += picture.width + (width > 0 ? kGap : 0);
    core::RgbaImage row = blank(width, kHeight);
    int left = 0;
    for (const core::RgbaImage& picture : pictures) {
        put(row, picture, left, 0);
        left += picture.width + kGap;
    }
    return row;
}

core::RgbaImage sheet_of(const test::NamedScene& scene, const std::shared_ptr<test::StandBase>& base) {
    std::vector<core::RgbaImage> pictures, rows;
    for (const ui::SizePx size : test::all_sizes()) {
        if (!test::is_kept_at(scene, size)) continue;
        for (const core::RgbaImage& picture : test::pictures_of(scene, size, base)) {
            pictures.push_back(smaller(picture));
        }
        if (!scene.step) continue;
        rows.push_back(row_of(pictures));
        pictures.clear();
    }
    if (!scene.step) return row_of(pictures);
    int width = 0;
    for (const core::RgbaImage& row : rows) width = std::max(width, row.width);
    core::RgbaImage sheet = blank(width, static_cast<int>(rows.size()) * (kHeight + kGap) - kGap);
    for (std::size_t k = 0; k < rows.size(); ++k) put(sheet, rows[k], 0, static_cast<int>(k) * (kHeight + kGap));
    return sheet;
}

std::optional<core::RgbaImage> read(const std::filesystem::path& file) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&png, file.c_str()) == 0) return std::nullopt;
    png.format = PNG_FORMAT_RGBA;
    core::RgbaImage image;
    image.width = static_cast<int>(png.width);
    image.height = static_cast<int>(png.height);
    image.pixels.resize(PNG_IMAGE_SIZE(png));
    if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0) return std::nullopt;
    return image;
}

struct Difference {
    double mean = 0, worst_block = 0;
};

Difference difference(const core::RgbaImage& a, const core::RgbaImage& b) {
    Difference d;
    for (int y0 = 0; y0 < a.height; y0 += kBlock) {
        for (int x0 = 0; x0 < a.width; x0 += kBlock) {
            double sum = 0;
            int count = 0;
            for (int y = y0; y < std::min(y0 + kBlock, a.height); ++y) {
                for (int x = x0; x < std::min(x0 + kBlock, a.width); ++x, ++count) {
                    for (std::size_t c = 0; c < 3; ++c)
                        sum += std::abs(int{a.pixels[at(a, x, y) + c]} - int{b.pixels[at(b, x, y) + c]}) / 3.0;
                }
            }
            d.worst_block = std::max(d.worst_block, sum / count);
            d.mean += sum;
        }
    }
    d.mean /= static_cast<double>(a.width) * a.height;
    return d;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "screen_references FOLDER [NAME]\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const std::string only = argc > 2 ? argv[2] : "";
    const bool update = std::getenv("UPDATE_GOLDEN") != nullptr;
    int differing = 0, compared = 0;
    const auto base = std::make_shared<test::StandBase>();
    for (const test::NamedScene& scene : test::all_scenes()) {
        if (!only.empty() && scene.name != only) continue;
        const core::RgbaImage sheet = sheet_of(scene, base);
        const std::filesystem::path file = folder / (scene.name + ".png");
        if (update) {
            if (!core::write_png(file, sheet)) return 1;
            continue;
        }
        ++compared;
        const std::optional<core::RgbaImage> reference = read(file);
        Difference d{255, 255};
        if (reference && reference->width == sheet.width && reference->height == sheet.height)
            d = difference(*reference, sheet);
        const bool good = d.mean <= kMostMean && d.worst_block <= kMostBlock;
        std::printf("%-22s mean %5.2f, worst block %6.2f%s\n", scene.name.c_str(), d.mean, d.worst_block,
                    good ? "" : "  DIFFERS");
        if (good) continue;
        ++differing;
        (void)core::write_png(std::filesystem::current_path() / (scene.name + ".new.png"), sheet);
    }
    if (!update) std::printf("%d of %d screens differ\n", differing, compared);
    return differing == 0 && (update || compared > 0) ? 0 : 1;
}
