#pragma once
// The graph of the pieces, which for a shape without holes is a tree, and the skeleton drawn through them
// (thesis 5.2, 5.3).

#include <vector>

#include "core/skeleton/segmentation.hpp"

namespace core {

struct CatNode {
    PieceKind kind = PieceKind::Whole;
    std::vector<int> neighbours;  ///< nodes
    std::vector<int> chords;      ///< the chord to each neighbour
    Point centroid;               ///< of the piece's area
};

/// One straight stretch of the skeleton within a node.
struct SkeletalSegment {
    int node = 0;
    Point from;
    Point to;
};

struct CatGraph {
    std::vector<CatNode> nodes;  ///< as the segmentation's pieces
    std::vector<SkeletalSegment> skeleton;
};

/// Nodes and edges from pieces and cutting chords; skeletal segments from the middle of each chord to the
/// centroid in terminals and junctions, from middle to middle in sleeves.
[[nodiscard]] CatGraph cat_graph(const Polygon& samples, const Triangulation& triangulation, const Segmentation& s);

/// Sum of the skeletal segments of terminals and sleeves and of the three longest of each junction (7.1.2), in the unit
/// of the samples. 0 for a shape that is not cut.
[[nodiscard]] double skeletal_length(const CatGraph& graph);

}  // namespace core
