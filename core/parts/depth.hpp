#pragma once
// Depth of the interior nodes, the root and the tree, by merging terminals away in simulation (thesis 5.3.1).

#include <vector>

#include "core/skeleton/skeleton.hpp"

namespace core {

/// The tree of pieces. A graph without interior node, a single piece or two, has root -1 and depth -1 everywhere.
struct PartTree {
    int root = -1;
    std::vector<int> parent;        ///< node towards the root; -1 for the root and without a root
    std::vector<int> parent_chord;  ///< the chord to it; -1 likewise
    std::vector<int>
        iteration;  ///< in which an interior node became a compound terminal; -1 for terminals, and for the root
    std::vector<int> depth;      ///< 0 at the root, growing away from it
    std::vector<int> bottom_up;  ///< all nodes but the root, children before parents
};

/// In iteration k every interior node that has one neighbour left which is no terminal, and whose terminal neighbours
/// each have less than (first + k * step) per cent of area and of perimeter, becomes a terminal itself. The junction
/// that remains last is the root; where there is no junction, the sleeve that remains last.
[[nodiscard]] PartTree part_tree(const Skeleton& skeleton, const ShapeParameters& parameters);

}  // namespace core
