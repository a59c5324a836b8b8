#pragma once
// The constrained Delaunay triangulation of a simple ring, its triangles' roles and its chords (thesis 5.1 and 5.2).
//
// No points are added, so n samples give n - 2 triangles and n - 3 chords, and the triangles form a tree.

#include <array>
#include <vector>

#include "core/base/result.hpp"
#include "core/geometry/point.hpp"

namespace core {

/// How many edges of a triangle lie on the outline: 2, 1 or 0.
enum class TriangleRole { Terminal, Sleeve, Junction };

/// An inner edge, between the samples u < v.
struct Chord {
    int u = 0;
    int v = 0;
    int inner = 0;  ///< the triangle whose third vertex lies between u and v: on the side of the arc u → v
    int outer = 0;  ///< the triangle on the side of the arc v → u
};

struct Triangle {
    std::array<int, 3> vertices{};  ///< samples, ascending, which is also anti-clockwise
    std::array<int, 3> chords{};    ///< chord along (0,1), (1,2), (2,0), or -1 for an edge of the outline
    [[nodiscard]] TriangleRole role() const {
        const int on_outline = (chords[0] < 0) + (chords[1] < 0) + (chords[2] < 0);
        return on_outline >= 2   ? TriangleRole::Terminal
               : on_outline == 1 ? TriangleRole::Sleeve
                                 : TriangleRole::Junction;
    }
};

struct Triangulation {
    std::vector<Triangle> triangles;
    std::vector<Chord> chords;  ///< ordered by (u, v)
};

/// Triangulates the inside of a simple anti-clockwise ring; exact predicates, so cocircular and collinear samples are
/// no trouble. BadOutline for fewer than three samples or a ring that crosses itself. n log n.
[[nodiscard]] Result<Triangulation> triangulate(const Polygon& ring);

/// The chords in the order in which an anti-clockwise walk along the outline meets them, each twice (fig. 5.3):
/// at every sample from the one that leads farthest back to the one that leads least ahead.
[[nodiscard]] std::vector<int> chords_along_outline(const Triangulation& triangulation, int sample_count);

}  // namespace core
