#pragma once
// Named places of a body.

#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/point.hpp"

namespace core {

struct Landmark {
    std::string name;  ///< "nape", "shoulder_left", "waist_front", "knee_right", …
    Vec3 place;        ///< on the surface
};

/// The landmark with this name, or null.
[[nodiscard]] inline const Landmark* find_landmark(const std::vector<Landmark>& landmarks, std::string_view name) {
    for (const Landmark& l : landmarks)
        if (l.name == name) return &l;
    return nullptr;
}

}  // namespace core
