#pragma once
// What the pen snaps to while a garment is drawn.

#include <string>
#include <vector>

#include "core/garment/network.hpp"
#include "core/mannequin/landmark.hpp"

namespace core {

struct SnapTarget {
    enum class Kind { None, Vertex, Landmark, Line, Middle };
    Kind kind = Kind::None;
    Vec3 place;        ///< None: where the pen is
    std::string name;  ///< of the landmark or line
};

/// What an end drawn at `place` would be joined to, within `reach`: the nearest vertex of the layer, else the nearest
/// landmark, else the nearest place on a line of the layer, else, if `to_middle`, the plane x = 0. Linear in the points
/// of the lines.
[[nodiscard]] SnapTarget snap_target(const Network& network, int layer, const std::vector<Landmark>& landmarks,
                                     Vec3 place, double reach, bool to_middle);

}  // namespace core
