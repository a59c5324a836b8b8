#pragma once
// The part descriptor of one silhouette (thesis chapter 5): the sampled outline, and the ring of its visual parts.
//
// A part is what one chord cuts off the shape, so it is an arc of the outline closed by that chord. Terminals are the
// smallest parts, numbered anti-clockwise from 0; a wing is a subtree of the skeleton that groups a run of them.

#include <array>
#include <cstddef>
#include <vector>

#include "core/geometry/point.hpp"

namespace core {

/// The geometric attributes of section 5.4, items 1 to 9, unweighted.
enum class Feature : std::size_t {
    Area,              ///< per cent of the shape's area
    Perimeter,         ///< per cent of the shape's perimeter
    Eccentricity,      ///< height away from the shape / width along it, of the least bounding rectangle; > 0
    Circularity,       ///< 4 pi a / p^2, in (0, 1]
    Rectangularity,    ///< area / area of the least bounding rectangle, in (0, 1]
    Convexity,         ///< reversed: (1 - hull perimeter / perimeter) * N_shape / N_hull, >= 0
    Solidity,          ///< reversed: (1 - area / hull area) * N_shape / N_hull, >= 0
    BendingEnergy,     ///< sum of discrete curvature over the arc, shape scaled to unit radius
    ChordLengthRatio,  ///< chord length / arc length, in (0, 1]
    Count,
};

inline constexpr std::size_t kFeatureCount = static_cast<std::size_t>(Feature::Count);
inline constexpr std::size_t kSignatureSize = 12;  ///< TerminalSamples of table 5.1

/// One visual part: a terminal, or a wing that groups `terminal_count` terminals from `first_terminal` on (cyclically).
struct Part {
    int first_terminal = 0;
    int terminal_count = 1;
    int start_sample = 0;  ///< the arc runs anti-clockwise from this sample of the outline …
    int end_sample = 0;    ///< … to this one (cyclically); the chord joins the two
    bool salient = false;  ///< large, long or bent (5.3.2)
    std::array<float, kFeatureCount> features{};
    std::array<float, kSignatureSize> signature{};  ///< distances to the centroid / unit length (5.4 item 10)

    friend bool operator==(const Part&, const Part&) = default;
};

/// Everything that matching needs of one shape. A shape without terminals has none and is described by `whole` alone.
struct ShapeDescriptor {
    std::vector<Point> samples;  ///< SampleSize points, anti-clockwise, y up, in the pixels of the image described
    int terminal_count = 0;
    std::vector<Part> parts;       ///< terminals first, in ring order, then the wings
    std::vector<int> stop_points;  ///< terminals at which a configuration may start (6.1), ascending
    Part whole;                    ///< the whole outline seen as one part; the fallback for shapes without parts
    double skeletal_length = 0.0;  ///< of 7.1.2, in pixels
    friend bool operator==(const ShapeDescriptor&, const ShapeDescriptor&) = default;
};

}  // namespace core
