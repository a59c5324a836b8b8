#pragma once
// Two rows of points: what is like each other step by step, and unlike across.

#include <cmath>
#include <vector>

namespace support {

/// Distances of 2 x `each` points, the rows `gap` apart and their points 1 apart, a little unevenly; row by row.
inline std::vector<float> chain_distances(std::size_t each, double gap) {
    const std::size_t n = 2 * each;
    const auto x = [each](std::size_t i) {
        const auto k = static_cast<double>(i % each);
        return k + 0.1 * std::sin(7.0 * k + (i < each ? 0.0 : 1.0));
    };
    std::vector<float> d(n * n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const double across = (i < each) == (j < each) ? 0.0 : gap;
            d[i * n + j] = static_cast<float>(std::hypot(x(i) - x(j), across));
        }
    }
    return d;
}

}  // namespace support
