#pragma once
// Where the pen is against where the screen shows it: crosses that were touched become one correction.

#include <array>
#include <cstddef>
#include <vector>

#include "core/geometry/point.hpp"

namespace app {

inline constexpr std::size_t kCrossCount = 9;
/// Places of the crosses in their order, shares of the screen: three rows of three, a tenth from the edges.
[[nodiscard]] core::Point cross_at(std::size_t index);

/// A cross and where the pen said it was, both in shares of the screen.
struct CrossHit {
    core::Point cross, pen;
};

struct AlignmentFit {
    enum class Fault {
        None,
        Missed,  ///< what is left over is too much: some crosses were not hit
        FarOff   ///< the tablet seems to be turned, mirrored or of quite another size
    };
    Fault fault = Fault::None;
    std::array<double, 6> align{1, 0, 0, 0, 1, 0};  ///< see input::CalibrationOptions::align
    double worst = 0;                               ///< farthest miss after the correction, in heights of the screen
};

/// The affine map from pen to crosses with the least squares of what is left. `aspect`: width of the screen by its
/// height. Fewer than four hits, or hits on one line, are Missed. Linear in the hits.
[[nodiscard]] AlignmentFit fit_alignment(const std::vector<CrossHit>& hits, double aspect);

}  // namespace app
