#pragma once
// A stroke of the pen with the place of each of its samples.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/garment/drawing.hpp"

namespace core {

/// A stroke sample by sample, with where each lies; what cannot be lifted is marked.
struct LiftedStroke {
    struct Sample {
        std::size_t part;
        Point drawn;
        std::optional<Vec3> place;
    };
    std::vector<Sample> samples;
    std::optional<Error> fault;  ///< of the first that cannot be lifted
    std::size_t fault_part = 0;  ///< that it belongs to
    Vec3 fault_place;            ///< the last place before it

    LiftedStroke(const SketchStroke& stroke, const Obstacle& body);

    /// The parts with these samples alone.
    [[nodiscard]] SketchStroke stroke(const SketchStroke& like, std::size_t first, std::size_t end) const;

    /// The longest run of samples for which `kept` holds: [first, end).
    template <typename Test>
    [[nodiscard]] std::pair<std::size_t, std::size_t> longest(const Test& kept) const {
        std::pair<std::size_t, std::size_t> best{0, 0};
        for (std::size_t k = 0; k < samples.size();) {
            std::size_t end = k;
            while (end < samples.size() && kept(samples[end])) ++end;
            if (end - k > best.second - best.first) best = {k, end};
            k = std::max(end, k + 1);
        }
        return best;
    }
};

/// What is drawn beyond x = 0 is the image of the drawn half; a stroke across the middle keeps its longer side, up to
/// the middle itself. Samples nearer to the middle than half of `snap_cm` are on neither side.
[[nodiscard]] SketchStroke on_drawn_half(const SketchStroke& stroke, const Obstacle& body, double snap_cm);

}  // namespace core
