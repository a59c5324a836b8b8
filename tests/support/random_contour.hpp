#pragma once
// Whole-contour descriptors without an outline behind them: every number that one may hold.

#include <random>

#include "core/contour/contour_descriptor.hpp"

namespace support {

inline int random_in(std::mt19937_64& random, int low, int high) {
    return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
}

/// `roughness` 1 takes any value from point to point, less stays nearer to the value before.
inline core::ContourDescriptor random_contour(std::mt19937_64& random, double roughness = 1.0) {
    core::ContourDescriptor out;
    for (std::size_t k = 0; k < core::kFrameChannels; ++k) {
        const int greatest = k < core::kFrameStretches ? core::kGreatestHeight : core::kGreatestAhead;
        double value = random_in(random, -greatest, greatest);
        for (std::int8_t& number : out.frames[k]) {
            value += roughness * (random_in(random, -greatest, greatest) - value);
            number = static_cast<std::int8_t>(value);
        }
    }
    for (auto& ring : out.cover) {
        for (std::uint8_t& cell : ring) cell = static_cast<std::uint8_t>(random_in(random, 0, 255));
    }
    out.complexity = static_cast<float>(random_in(random, 0, 1000)) / 1000.0F;
    return out;
}

}  // namespace support
