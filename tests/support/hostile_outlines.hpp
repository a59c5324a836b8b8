#pragma once
// Outlines and pictures that make trouble: what pens, scanners and broken files could leave, and what nobody would
// draw.

#include <string>
#include <vector>

#include "core/geometry/point.hpp"
#include "core/silhouette/image.hpp"

namespace support {

/// How many kinds hostile_outline knows, the pictures among them.
inline constexpr int kHostileKinds = 24;

struct HostileOutline {
    std::string kind;
    core::Polygon ring;       ///< empty for a kind that is a picture
    core::BinaryImage image;  ///< 0 x 0 for a kind that is a ring
};

/// The `number`-th of an endless list, the same on every machine; kinds take turns.
[[nodiscard]] HostileOutline hostile_outline(unsigned number);

}  // namespace support
