#pragma once
// Fills a region with quads when only the number of edges of each side is known: which vertices, which quads, no place
// in space yet (core/garment/permanence_patch.hpp gives them one).
//
//     const auto topology = core::fill_topology(std::array{6, 4, 3, 5, 4});   // one vertex of valence 5

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/mesh/quad_disc.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

/// Sides a region may have.
inline constexpr int kFewestSides = 2, kMostSides = 8;
/// Edges one side may have.
inline constexpr int kMostSideEdges = 1000;

struct RegionTopology {
    std::uint32_t boundary = 0;  ///< vertices 0 … boundary - 1 are the input, in order, from the first corner on
    std::uint32_t vertices = 0;
    std::vector<Quad> quads;      ///< anti-clockwise as the boundary
    std::vector<bool> is_corner;  ///< of each boundary vertex
    QuadDiscCounts counts;
};

/// Quads for a region of 2 to 8 sides with these numbers of edges, each 1 at least, an even number of at least 4 in
/// all: no such input fails. Inner vertices have valence 3, 4 or 5, and as few are irregular as the plans of
/// core/garment/fill_plan.hpp know of: one for 3 or 5 sides whose star has no negative distance, two for 4 and 6 sides
/// mostly, two more when a side is longer than the others together. The same input gives the same quads.
/// ErrorCode::BadArgument for every other input, saying which side is at fault. Time: 0.1 ms for sides of about 20
/// edges, in proportion to the quads beyond.
[[nodiscard]] Result<RegionTopology> fill_topology(std::span<const int> side_edges);

}  // namespace core
