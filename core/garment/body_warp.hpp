#pragma once
// Carries what was made for one body to another of other proportions, by their landmarks.

#include <optional>
#include <vector>

#include "core/mannequin/landmark.hpp"

namespace core {

class BodyWarp {
  public:
    /// A smooth map of space that takes each landmark of `from` to the one of the same name of `to`: an affine map and
    /// a sum of distances to the landmarks, the smoothest such map (polyharmonic splines; J. Duchon 1977). Nothing when
    /// the two have fewer than 8 names in common, or these lie in a plane.
    [[nodiscard]] static std::optional<BodyWarp> between(const std::vector<Landmark>& from,
                                                         const std::vector<Landmark>& to);

    /// Cost: one distance a landmark.
    [[nodiscard]] Vec3 operator()(Vec3 p) const;

  private:
    std::vector<Vec3> centres_, weights_;
    Vec3 shift_, x_, y_, z_;  // of the affine part
};

}  // namespace core
