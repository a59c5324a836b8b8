#include "core/exchange/image_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <memory>

#include "core/exchange/file_bytes.hpp"

namespace {

// The decoder may not take more than one picture of the largest size needs, whatever a file claims.
constexpr std::size_t kMaxDecoderBlock = std::size_t{448} << 20;

void* limited_allocate(std::size_t size) {
    return size > kMaxDecoderBlock ? nullptr : std::malloc(size);
}
void* limited_reallocate(void* block, std::size_t size) {
    return size > kMaxDecoderBlock ? nullptr : std::realloc(block, size);
}

}  // namespace

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_BMP
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MALLOC(size) limited_allocate(size)
#define STBI_REALLOC(block, size) limited_reallocate(block, size)
#define STBI_FREE(block) std::free(block)
#include <stb/stb_image.h>

namespace core {
namespace {

bool starts_with(std::span<const std::byte> bytes, std::initializer_list<int> magic) {
    if (bytes.size() < magic.size()) return false;
    std::size_t i = 0;
    for (const int value : magic) {
        if (bytes[i++] != static_cast<std::byte>(value)) return false;
    }
    return true;
}

/// Luma of one pixel of grey, grey + alpha, RGB or RGBA, over white paper.
std::uint8_t luma_over_white(const stbi_uc* pixel, int channels) {
    const int luma = channels < 3 ? pixel[0] : (299 * pixel[0] + 587 * pixel[1] + 114 * pixel[2] + 500) / 1000;
    if (channels % 2 == 1) return static_cast<std::uint8_t>(luma);
    const int alpha = pixel[channels - 1];
    return static_cast<std::uint8_t>((luma * alpha + 255 * (255 - alpha) + 127) / 255);
}

Unexpected damaged() {
    return unexpected(ErrorCode::BadFormat,
                      "the picture is damaged or of a kind that is not read; save it again as PNG");
}

Unexpected too_large() {
    return unexpected(ErrorCode::BadFormat,
                      "the picture has more than 48 million pixels or a side of more than 20000; reduce it");
}

/// Whether every Huffman table of a JPEG has at most 256 codes; the decoder writes past its own table where one has
/// more. Walks from marker to marker as the decoder does, coded data included.
bool huffman_tables_fit(std::span<const std::byte> bytes) {
    const auto at = [&](std::size_t i) { return std::to_integer<unsigned>(bytes[i]); };
    for (std::size_t i = 2; i + 4 <= bytes.size();) {
        const unsigned marker = at(i + 1);
        const bool has_length = marker >= 0xC0 && marker < 0xFF && (marker < 0xD0 || marker > 0xD9);
        if (at(i) != 0xFF || !has_length) {
            ++i;
            continue;
        }
        const std::size_t end = std::min(bytes.size(), i + 2 + at(i + 2) * 256 + at(i + 3));
        for (std::size_t table = i + 4; marker == 0xC4 && table < end;) {
            unsigned codes = 0;
            for (std::size_t k = 1; k <= 16 && table + k < bytes.size(); ++k) codes += at(table + k);
            if (codes > 256) return false;
            table += 17 + codes;
        }
        i = std::max(end, i + 4);
    }
    return true;
}

/// Whether a BMP has all the rows that its header tells of; the decoder makes black ones of those that are missing. The
/// filling behind the last row may be left out. Headers of other kinds are left to the decoder.
bool bmp_is_whole(std::span<const std::byte> bytes) {
    const auto little_endian = [&](std::size_t at, std::size_t count) {
        std::uint64_t value = 0;
        for (std::size_t k = count; k > 0; --k) value = value << 8 | std::to_integer<std::uint64_t>(bytes[at + k - 1]);
        return value;
    };
    constexpr std::size_t kShortHeader = 12, kHeader = 40;
    constexpr auto kMostSide = static_cast<std::uint64_t>(kMaxImageSide_px);
    if (bytes.size() < 14 + kShortHeader) return false;
    const std::uint64_t header = little_endian(14, 4);
    if (header != kShortHeader && (header < kHeader || bytes.size() < 14 + kHeader)) return true;
    const bool is_short = header == kShortHeader;
    const std::uint64_t width = is_short ? little_endian(18, 2) : little_endian(18, 4);
    const auto signed_height = static_cast<std::int32_t>(is_short ? little_endian(20, 2) : little_endian(22, 4));
    const std::uint64_t height = static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(signed_height)));
    const std::uint64_t row_bits = width * little_endian(is_short ? 24 : 28, 2);
    if (height == 0 || width > kMostSide || height > kMostSide) return true;
    return little_endian(10, 4) + (height - 1) * ((row_bits + 31) / 32 * 4) + (row_bits + 7) / 8 <= bytes.size();
}

using Pixels = std::unique_ptr<stbi_uc, void (*)(void*)>;

struct Decoded {
    Pixels pixels{nullptr, stbi_image_free};
    int width = 0, height = 0, channels = 0;
};

/// `channels`: how many are wanted, 0: as many as the file has.
Result<Decoded> decode(std::span<const std::byte> bytes, int channels) {
    if (!looks_like_image(bytes)) {
        return unexpected(ErrorCode::UnknownFormat, "this is no PNG, BMP or JPEG picture; give one of these");
    }
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return damaged();
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());

    if (starts_with(bytes, {'B', 'M'}) && !bmp_is_whole(bytes)) return damaged();
    if (starts_with(bytes, {0xFF, 0xD8}) && !huffman_tables_fit(bytes)) return damaged();
    Decoded out;
    if (!stbi_info_from_memory(data, size, &out.width, &out.height, &out.channels)) return damaged();
    if (out.width <= 0 || out.height <= 0) return damaged();
    if (out.width > kMaxImageSide_px || out.height > kMaxImageSide_px ||
        static_cast<long long>(out.width) * out.height > kMaxImagePixels) {
        return too_large();
    }
    out.pixels.reset(stbi_load_from_memory(data, size, &out.width, &out.height, &out.channels, channels));
    if (!out.pixels) return damaged();
    if (channels > 0) out.channels = channels;
    return out;
}

}  // namespace

bool looks_like_image(std::span<const std::byte> bytes) {
    return starts_with(bytes, {0x89, 'P', 'N', 'G'}) || starts_with(bytes, {0xFF, 0xD8, 0xFF}) ||
           starts_with(bytes, {'B', 'M'});
}

Result<GrayImage> decode_gray_image(std::span<const std::byte> bytes) {
    const Result<Decoded> decoded = decode(bytes, 0);
    if (!decoded) return unexpected(decoded.error());
    GrayImage image(decoded->width, decoded->height);
    const auto channels = static_cast<std::size_t>(decoded->channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = luma_over_white(decoded->pixels.get() + i * channels, decoded->channels);
    }
    return image;
}

Result<RgbaImage> decode_rgba_image(std::span<const std::byte> bytes) {
    constexpr std::size_t kChannels = 4;
    const Result<Decoded> decoded = decode(bytes, static_cast<int>(kChannels));
    if (!decoded) return unexpected(decoded.error());
    const std::size_t count =
        static_cast<std::size_t>(decoded->width) * static_cast<std::size_t>(decoded->height) * kChannels;
    return RgbaImage{decoded->width, decoded->height, {decoded->pixels.get(), decoded->pixels.get() + count}};
}

Result<GrayImage> read_gray_image(const std::string& path) {
    const Result<std::string> bytes = read_file_bytes(path);
    if (!bytes) return unexpected(bytes.error());
    Result<GrayImage> image = decode_gray_image(std::as_bytes(std::span(*bytes)));
    if (!image) return unexpected(image.error().code, image.error().message, path);
    return image;
}

}  // namespace core
