#pragma once
// Checks and counts for quads that fill one boundary ring: the topology of a piece of cloth.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/quad_mesh.hpp"

namespace core {

/// Irregular is a vertex with another number of quads than a plain grid has there: 4 inside, 2 on a side, 1 at a
/// corner.
struct QuadDiscCounts {
    int irregular_interior = 0;
    int irregular_boundary = 0;
    std::array<int, 6> interior_by_valence{};  ///< index: valence, 3 to 5
    [[nodiscard]] int irregular() const { return irregular_interior + irregular_boundary; }
};

/// Counts of a disc of quads; nothing unless all of this holds. Vertices 0 … is_corner.size() - 1 are the boundary in
/// anti-clockwise order, each once; every edge between other vertices has one quad on either side; the quads are
/// anti-clockwise, have four different corners and form one disc; inner vertices have 3 to 5 quads, boundary vertices 1
/// to 4. Linear time.
[[nodiscard]] std::optional<QuadDiscCounts> count_quad_disc(std::span<const Quad> quads, std::uint32_t vertex_count,
                                                            const std::vector<bool>& is_corner);

}  // namespace core
