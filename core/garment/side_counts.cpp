#include "core/garment/side_counts.hpp"

namespace core {

std::optional<SideCounts> star_distances(const SideCounts& sides) {
    if (sides.n != 3 && sides.n != 5) return std::nullopt;
    SideCounts distances;
    for (int i = 0; i < sides.n; ++i) {
        int twice = 0;
        for (int k = 0; k < sides.n; ++k) twice += k % 2 == 0 ? sides[i + 1 + 2 * k] : -sides[i + 1 + 2 * k];
        if (twice < 0 || twice % 2 != 0) return std::nullopt;
        distances.push_back(twice / 2);
    }
    return distances;
}

}  // namespace core
