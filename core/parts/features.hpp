#pragma once
// The ten features of a visual part (thesis 5.4) and its salience (5.3.2, 5.5).

#include "core/parts/descriptor.hpp"
#include "core/skeleton/arc_measures.hpp"
#include "core/skeleton/segmentation.hpp"

namespace core {

/// Fills in features and signature of the part that the chord from `arc.from` to `arc.to` cuts off.
/// from == to is the whole outline seen as a part: its chord has no length and its eccentricity is long / short side.
[[nodiscard]] Part measure_part(const Polygon& samples, const ArcMeasures& arcs, Arc arc,
                                const ShapeParameters& parameters);

/// Large, long or bent.
[[nodiscard]] bool is_salient(const Polygon& samples, const ArcMeasures& arcs, const Part& part,
                              const ShapeParameters& parameters);

}  // namespace core
