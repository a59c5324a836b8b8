#pragma once
// Measures of bodies that could walk in: a size, with every measure a little off.

#include <random>

#include "core/mannequin/body_measures.hpp"

namespace support {

/// Every fourth a man. Girths differ by up to 6 % each, heights by 7 % together and 1.2 % each.
inline core::BodyMeasures random_body(unsigned seed) {
    std::mt19937 generator(seed);
    const auto about = [&](double spread) {
        return 1.0 + spread * (static_cast<double>(generator() % 2001) / 1000.0 - 1.0);
    };
    const bool man = seed % 4 == 3;
    core::BodyMeasures m = *core::measures_of_size(man ? "m" : std::to_string(36 + generator() % 9));
    const double tall = about(0.07);
    for (std::size_t k = 0; k < core::kMeasureCount; ++k) {
        const auto measure = static_cast<core::Measure>(k);
        const bool height = measure == core::Measure::Stature || measure == core::Measure::ArmLength ||
                            measure >= core::Measure::BustHeight;
        m.cm[k] *= height ? tall * about(0.012) : about(0.06);
    }
    if (!man)
        m[core::Measure::Bust] = m[core::Measure::UnderBust] + 10.0 + static_cast<double>(generator() % 100) / 10.0;
    return m;
}

}  // namespace support
