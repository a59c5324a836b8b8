#pragma once
// A garment as one mesh: its regions filled and welded along their seams, mirrored and joined.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/network.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

struct ClothPiece {
    std::string name;
    int layer = 0;
    std::size_t first = 0, count = 0;  ///< its quads
    QuadDiscCounts counts;
    double alpha = 0.0;  ///< in use
    int mirror_of = -1;  ///< the piece that this one is the image of
    PartSet parts = 0;   ///< of the body that it lies over; 0: not known
};

struct Cloth {
    QuadMesh mesh;
    std::vector<ClothPiece> pieces;
    std::vector<bool> drawn;  ///< of each vertex: on a line of the network, or on its mirror image
    /// Of each vertex in the middle of a line: its number in the network; -1 for the others. Empty when not known.
    std::vector<int> line;
    std::vector<QuadTexture> texture;  ///< of each quad; empty until lay_texture
};

/// One piece as a mesh of its own, and which vertex of the cloth each of its vertices is.
struct PieceMesh {
    QuadMesh mesh;
    std::vector<std::uint32_t> vertex;
};
[[nodiscard]] PieceMesh mesh_of_piece(const Cloth& cloth, const ClothPiece& piece);

/// A region that could not be made, and why; the others are.
struct ClothFault {
    std::string region;
    Error error;
};

struct BuiltCloth {
    Cloth cloth;
    std::vector<ClothFault> faults;
};

/// Fills every living region of these layers. Points of lines that regions share become one vertex. Faulty regions are
/// left out and named. The same network gives the same mesh.
[[nodiscard]] BuiltCloth build_cloth(const Network& network, int layer);

/// The cloth and its image beyond x = 0, as pieces with "_mirrored" added; vertices on the plane are welded. A piece
/// that reaches across the plane is not mirrored. Linear.
[[nodiscard]] Cloth mirrored_and_joined(const Cloth& half);

/// Edges with one quad (hems) and edges between two pieces (seams), each as two vertices, the smaller first, in order.
struct ClothEdges {
    std::vector<std::array<std::uint32_t, 2>> hems, seams;
};
[[nodiscard]] ClothEdges edges_of(const Cloth& cloth);

}  // namespace core
