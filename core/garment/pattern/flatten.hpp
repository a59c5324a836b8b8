#pragma once
// A curved piece of cloth laid flat with little strain.
//
//     const auto flat = core::flatten(piece_mesh, {});
//     flat->places[v];            // where vertex v comes to lie, in the mesh's unit
//
// Three steps: a conformal map (B. Lévy and others, Least squares conformal maps, 2002) as a start; local and global
// rounds towards rigid triangles (L. Liu and others, A local/global approach to mesh parameterization, 2008), one
// factorisation for all; then, if asked, Gauss-Newton on the lengths of edges and diagonals, in which edges of the
// border weigh more, so that what is sewn together stays as long on both sides.

#include <vector>

#include "core/base/result.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

struct FlattenOptions {
    int rounds = 30;             ///< local and global, most
    int length_rounds = 12;      ///< Gauss-Newton, most; 0: none
    double border_weight = 8.0;  ///< of the length of a border edge against that of an inner one
};

struct FlatPiece {
    std::vector<Point> places;   ///< of each vertex; anti-clockwise as the quads seen from their outer side
    std::vector<double> strain;  ///< of each quad: the larger of its two principal stretches, |stretch - 1|
    double mean_strain = 0.0, largest_strain = 0.0;  ///< mean by area
    double high_strain = 0.0;  ///< exceeded by a hundredth of the area: slivers of quads do not count
};

/// Lays a disc of quads flat. What a plane can be bent into comes out within 0.1 % everywhere. Turned so that what is
/// up (y) in space on the whole is up in the plane, its lower left corner at the origin; a piece that lies level is
/// turned so that its longest extent is up. ErrorCode::BadMesh when the quads are no disc (holes, several parts, an
/// edge of three quads), when a vertex is unused, or a quad has no area. Without length rounds 40 ms for 2,000
/// vertices, with them 150.
[[nodiscard]] Result<FlatPiece> flatten(const QuadMesh& piece, const FlattenOptions& options);

/// The border of a disc of quads: its vertices in order, anti-clockwise seen from the outer side, the first of them the
/// smallest. ErrorCode::BadMesh as flatten.
[[nodiscard]] Result<std::vector<std::uint32_t>> disc_border(const QuadMesh& piece);

}  // namespace core
