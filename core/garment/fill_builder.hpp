#pragma once
// Makes the vertices and quads of a plan.

#include <optional>

#include "core/garment/fill_plan.hpp"
#include "core/garment/fill_topology.hpp"

namespace core {

/// The plan's quads, checked with count_quad_disc; nothing where pieces are so thin that the result is no disc with
/// valences 3 to 5. Linear in the quads.
[[nodiscard]] std::optional<RegionTopology> build_fill(const SideCounts& sides, const FillPlan& plan);

}  // namespace core
