#pragma once
// Descriptors with random parts and features, for tests of the matching alone.

#include <random>

#include "core/parts/describe.hpp"

namespace support {

/// `terminals` terminals on a bumpy ring of samples, and random wings over runs of them. The generator alone decides.
inline core::ShapeDescriptor random_descriptor(std::mt19937& random, int terminals) {
    const auto real = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 100'000) / 100'000.0;
    };
    core::ShapeDescriptor shape;
    const int a_part = 4, n = terminals * (a_part + 1);
    for (int i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * i / n, radius = real(5, 10);
        shape.samples.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const auto part = [&](int first, int count) {
        core::Part p;
        p.first_terminal = first;
        p.terminal_count = count;
        p.start_sample = first * (a_part + 1);
        p.end_sample = ((first + count - 1) * (a_part + 1) + a_part) % n;
        const double ranges[] = {20, 25, 3, 1, 1, 1, 1, 10, 1};
        for (std::size_t i = 0; i < core::kFeatureCount; ++i) p.features[i] = static_cast<float>(real(0, ranges[i]));
        for (float& r : p.signature) r = static_cast<float>(real(0, 6));
        return p;
    };
    shape.terminal_count = terminals;
    for (int t = 0; t < terminals; ++t) shape.parts.push_back(part(t, 1));
    const int wings = static_cast<int>(random() % 4);
    for (int w = 0; w < wings && terminals > 1; ++w) {
        const int count = 1 + static_cast<int>(random() % static_cast<unsigned>(terminals - 1));
        shape.parts.push_back(part(static_cast<int>(random() % static_cast<unsigned>(terminals)), count));
    }
    shape.stop_points = core::stop_points(shape.parts, terminals, false);
    return shape;
}

}  // namespace support
