#pragma once
// The radii that closing tries, in pixels, for a drawing of a given size: one definition for the silhouette made in one
// go and for the one that grows with the pen.

#include <array>
#include <cmath>
#include <cstdint>

#include "core/silhouette/capsule.hpp"
#include "core/silhouette/closing.hpp"

namespace core {

/// A region that no disc of radius `radius` can leave is filled by such discs when it holds a roomier place.
struct ClosingLevel {
    double radius = 0.0;
    int wall2 = 0;  ///< a pixel is wall when its squared distance to ink is at most this
    int room2 = 0;  ///< somewhere the region's squared distance to ink must be at least this
};

struct ClosingLevels {
    static constexpr int kRadii = 9;            ///< radii tried besides 0: the closing radius and its fractions
    static constexpr double kRadiusStep = 1.4;  ///< each of them is this much smaller than the one before
    std::array<ClosingLevel, kRadii> levels;    ///< ascending
    int border = 0;                             ///< free pixels so that the widest walls leave a way round
    int reach = 0;                              ///< distances above this need not be known
    int join2 = 0;                              ///< squared distance to which separate pieces are joined
    double stray = 0.0;                         ///< pieces with a smaller diagonal are stray marks
    std::int64_t half = 0;                      ///< half the pen's width, in sixteenths of a pixel
};

/// `diagonal` in pixels is what the options' shares are of.
[[nodiscard]] inline ClosingLevels closing_levels(const SilhouetteOptions& options, double diagonal) {
    constexpr double kTouching = 1.5;  // 8-neighbours
    const double closing = options.closing_share * diagonal;
    const auto squared = [](double r) { return static_cast<int>(std::floor(r * r)); };
    ClosingLevels out;
    double r = closing * std::pow(ClosingLevels::kRadiusStep, -(ClosingLevels::kRadii - 1));
    for (ClosingLevel& level : out.levels) {
        const double room = r * (1.0 + (options.room - 1.0) * (0.4 + (closing > 0.0 ? 0.6 * r / closing : 0.6)));
        level = {r, squared(r), static_cast<int>(std::ceil(room * room))};
        out.reach = static_cast<int>(std::ceil(std::fmax(room, r))) + 1;
        r *= ClosingLevels::kRadiusStep;
    }
    out.border = std::max(options.ink.margin_px, static_cast<int>(std::ceil(closing)) + 2);
    out.join2 = squared(options.joining_share * diagonal + kTouching);
    out.stray = options.stray_share * diagonal;
    out.half =
        std::max<std::int64_t>(kSubpixels / 2, std::llround(options.ink.stroke_share * diagonal * kSubpixels / 2));
    return out;
}

}  // namespace core
