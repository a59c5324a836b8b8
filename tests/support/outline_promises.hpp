#pragma once
// What describing and comparing promise for every outline, whatever it is.

#include <cmath>
#include <string>

#include "core/fusion/fused_match.hpp"

namespace support {

/// The first promise that these readings break, or nothing: all numbers finite, distance 0 to itself, finite, not
/// negative and the same both ways to others.
class OutlinePromises {
  public:
    /// `others` are what every outline is compared with.
    explicit OutlinePromises(std::vector<core::ComparableShape> others) : others_(std::move(others)) {}

    [[nodiscard]] std::string broken(const core::OutlineReadings& readings) {
        for (const core::Part& part : readings.parts.parts) {
            for (const auto feature : part.features) {
                if (!std::isfinite(feature)) return "a feature is not finite";
            }
        }
        const core::ComparableShape shape = core::comparable(readings);
        if (matcher_.distance(shape, shape) != 0.0) return "its distance to itself is not 0";
        for (const core::ComparableShape& other : others_) {
            const double there = matcher_.distance(shape, other), back = matcher_.distance(other, shape);
            if (!std::isfinite(there) || there < 0.0) return "a distance is no distance";
            if (there != back) return "a distance is not the same both ways";
        }
        return {};
    }

  private:
    std::vector<core::ComparableShape> others_;
    core::FusedMatcher matcher_;
};

}  // namespace support
