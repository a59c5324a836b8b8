#pragma once
// Small picture files made in memory, so that a test can show what is in them.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/silhouette/image.hpp"

namespace support {

inline void append_be32(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>((value >> shift) & 0xFF));
}

inline std::string png_chunk(std::string_view type, std::string_view data) {
    std::string body(type);
    body += data;
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char c : body) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) ? 0xEDB88320u : 0u);
    }
    std::string chunk;
    append_be32(chunk, static_cast<std::uint32_t>(data.size()));
    chunk += body;
    append_be32(chunk, crc ^ 0xFFFFFFFFu);
    return chunk;
}

/// Stored (uncompressed) zlib stream.
inline std::string zlib_stored(std::string_view raw) {
    std::string out("\x78\x01");
    std::uint32_t a = 1, b = 0;
    for (const char c : raw) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    for (std::size_t at = 0; at == 0 || at < raw.size(); at += 65535) {
        const std::string_view block = raw.substr(at, 65535);
        const auto size = static_cast<unsigned>(block.size());
        out.push_back(at + block.size() >= raw.size() ? '\1' : '\0');
        for (const unsigned value : {size & 0xFF, size >> 8, ~size & 0xFF, (~size >> 8) & 0xFF}) {
            out.push_back(static_cast<char>(value));
        }
        out += block;
    }
    append_be32(out, (b << 16) | a);
    return out;
}

/// PNG colour types: 0 grey, 2 RGB, 3 palette, 4 grey + alpha, 6 RGBA. `rows` holds the packed rows one after the
/// other, `before_data` further chunks (PLTE, tRNS).
inline std::string make_png(int width, int height, int bits, int colour_type, std::string_view rows,
                            std::string_view before_data = {}) {
    std::string header;
    append_be32(header, static_cast<std::uint32_t>(width));
    append_be32(header, static_cast<std::uint32_t>(height));
    for (const int value : {bits, colour_type, 0, 0, 0}) header.push_back(static_cast<char>(value));
    const std::size_t row_bytes = height > 0 ? rows.size() / static_cast<std::size_t>(height) : 0;
    std::string raw;
    for (std::size_t at = 0; row_bytes > 0 && at + row_bytes <= rows.size(); at += row_bytes) {
        raw.push_back('\0');
        raw += rows.substr(at, row_bytes);
    }
    std::string png("\x89PNG\r\n\x1a\n");
    png += png_chunk("IHDR", header);
    png += before_data;
    png += png_chunk("IDAT", zlib_stored(raw));
    png += png_chunk("IEND", {});
    return png;
}

inline std::string make_png(const core::GrayImage& image) {
    return make_png(image.width, image.height, 8, 0,
                    std::string_view(reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size()));
}

}  // namespace support
