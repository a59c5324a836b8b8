#include "ui/draw/fabric.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace ui {
namespace {

constexpr int kPx = kFabricTile_px;

/// 0 … 1, the same for the same cell.
double grain(int x, int y, unsigned seed) {
    unsigned h = static_cast<unsigned>(x) * 0x9E3779B1U ^ static_cast<unsigned>(y) * 0x85EBCA77U ^ seed * 0xC2B2AE3DU;
    h ^= h >> 15;
    h *= 0x2C1B3C6DU;
    h ^= h >> 12;
    h *= 0x297A2D39U;
    h ^= h >> 15;
    return (h & 0xFFFFU) / 65535.0;
}

/// A thread across its width: bright in the middle.
double thread(double t) {
    return std::sin(t * std::numbers::pi);
}

/// How light a place is against the fabric's colour, and how much of a second, light colour it has.
struct Shade {
    double light = 1, second = 0;
};

Shade plain(int x, int y) {
    return {1 + 0.02 * (grain(x / 2, y / 2, 1) - 0.5), 0};
}

/// Warp and weft over and under by turns, threads of uneven thickness.
Shade linen(int x, int y) {
    constexpr int kThread = 8;
    const int column = x / kThread, row = y / kThread;
    const bool warp_up = (column + row) % 2 == 0;
    const double along = warp_up ? grain(column, 0, 3) : grain(0, row, 5);
    const double across = thread(((warp_up ? x : y) % kThread + 0.5) / kThread);
    return {0.80 + 0.16 * across + 0.12 * (along - 0.5) + 0.05 * (grain(x, y, 7) - 0.5), 0};
}

/// Twill: the coloured warp goes over three of the white weft, each row one further.
Shade denim(int x, int y) {
    constexpr int kThread = 4;
    const int column = x / kThread, row = y / kThread;
    const bool weft = (column + row) % 4 == 0;
    const double across = thread((x % kThread + 0.5) / kThread);
    return {0.80 + 0.16 * across + 0.10 * (grain(column, row / 6, 11) - 0.5), weft ? 0.30 : 0.0};
}

Shade stripe(int x, int y) {
    const double t = static_cast<double>(x) / kPx;
    return {1 + 0.03 * (grain(x, y / 4, 13) - 0.5), t < 0.5 ? 0.0 : 0.62};
}

Shade check(int x, int y) {
    const bool across = x < kPx / 2, along = y < kPx / 2;
    const double twill = (x + y) / 4 % 2 == 0 ? 0.03 : -0.03;
    return {1 + twill, across && along ? 0.0 : (across || along ? 0.36 : 0.72)};
}

/// Two dots a tile, set off against each other.
Shade dots(int x, int y) {
    double nearest = kPx;
    for (const auto& [cx, cy] : {std::pair{32.0, 32.0}, std::pair{96.0, 96.0}}) {
        nearest = std::min(nearest, std::hypot(x + 0.5 - cx, y + 0.5 - cy));
    }
    return {1 + 0.02 * (grain(x / 2, y / 2, 17) - 0.5), 0.85 * std::clamp(14.5 - nearest, 0.0, 1.0)};
}

/// Stockinette: columns of slanting loops.
Shade knit(int x, int y) {
    constexpr double kWide = 32, kHigh = 32;
    const double u = std::fmod(x + 0.5, kWide) / kWide, side = u < 0.5 ? 1 - 2 * u : 2 * u - 1;  // 0 in the middle
    const double slant = std::fmod(y + 0.5 + side * kHigh * 0.8, kHigh) / kHigh;
    const double loop = thread(slant) * thread(0.12 + 0.76 * (1 - std::abs(2 * side - 1)));
    return {0.66 + 0.40 * loop, 0};
}

Shade herringbone(int x, int y) {
    constexpr int kBand = kPx / 4, kRib = 16;
    const int band = x / kBand;
    const int along = (band % 2 == 0 ? y + x % kBand : y - x % kBand + kPx) % kRib;
    return {0.86 + 0.12 * thread((along + 0.5) / kRib), along < kRib / 2 ? 0.22 : 0.0};
}

Shade shade(Fabric fabric, int x, int y) {
    switch (fabric) {
        case Fabric::Plain:
            return plain(x, y);
        case Fabric::Linen:
            return linen(x, y);
        case Fabric::Denim:
            return denim(x, y);
        case Fabric::Stripe:
            return stripe(x, y);
        case Fabric::Check:
            return check(x, y);
        case Fabric::Dots:
            return dots(x, y);
        case Fabric::Knit:
            return knit(x, y);
        case Fabric::Herringbone:
            return herringbone(x, y);
    }
    return {};
}

constexpr std::array<std::string_view, kFabricCount> kNames{"plain", "linen", "denim", "stripe",
                                                            "check", "dots",  "knit",  "herringbone"};

}  // namespace

std::string_view fabric_name(Fabric fabric) {
    return kNames[static_cast<std::size_t>(fabric)];
}

Fabric fabric_of(std::string_view name) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (kNames[i] == name) return static_cast<Fabric>(i);
    }
    return Fabric::Plain;
}

double fabric_tile_cm(Fabric fabric) {
    constexpr std::array<double, kFabricCount> kTile{8, 4, 4, 4, 6, 6, 5, 6};
    return kTile[static_cast<std::size_t>(fabric)];
}

core::RgbaImage weave(Fabric fabric, Colour colour) {
    core::RgbaImage image;
    image.width = image.height = kPx;
    image.pixels.reserve(static_cast<std::size_t>(kPx) * kPx * 4);
    const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); };
    const Colour light = palette::kSheet;
    for (int y = 0; y < kPx; ++y) {
        for (int x = 0; x < kPx; ++x) {
            const Shade s = shade(fabric, x, y);
            const auto mixed = [&](double own, double other) { return (own + (other - own) * s.second) * s.light; };
            image.pixels.push_back(byte(mixed(colour.r, light.r)));
            image.pixels.push_back(byte(mixed(colour.g, light.g)));
            image.pixels.push_back(byte(mixed(colour.b, light.b)));
            image.pixels.push_back(255);
        }
    }
    return image;
}

Colour colour_of(std::string_view hex, Colour otherwise) {
    if (hex.size() != 7 || hex[0] != '#') return otherwise;
    std::uint32_t rgb = 0;
    for (const char c : hex.substr(1)) {
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : -1;
        if (digit < 0) return otherwise;
        rgb = rgb * 16 + static_cast<std::uint32_t>(digit);
    }
    return Colour::hex(rgb);
}

std::string hex_of(Colour colour) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", static_cast<unsigned>(std::lround(colour.r * 255)),
                  static_cast<unsigned>(std::lround(colour.g * 255)),
                  static_cast<unsigned>(std::lround(colour.b * 255)));
    return text.data();
}

}  // namespace ui
