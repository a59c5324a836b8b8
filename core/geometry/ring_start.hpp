#pragma once
// Where on a ring to begin, whatever point it is given from: a place that goes with the shape when it is turned, scaled
// or mirrored, and hardly moves with the noise of pixels.

#include "core/geometry/point.hpp"

namespace core {

/// An end of the long axis of the ring's first-harmonic ellipse (Kuhl and Giardina 1982), in which every edge has a
/// say, as a share of the perimeter from ring[0] on, in [0, 1). The other end lies half a perimeter on; which of the
/// two comes out depends on where the ring starts. A ring whose ellipse is a circle gives any place, one without length
/// 0. Linear.
[[nodiscard]] double ellipse_end(const Polygon& ring);

/// The point at a share of the perimeter from ring[0] on, share in [0, 1].
[[nodiscard]] Point at_share(const Polygon& ring, double share);

/// The same ring with its point at `share` put in front, one point more than before.
[[nodiscard]] Polygon started_at(const Polygon& ring, double share);

}  // namespace core
