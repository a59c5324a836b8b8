#pragma once
// Which vertices of a layer are sewn to the cloth below when a garment hangs: a pocket all around, a collar or a lining
// along the edge that it shares.
//
//     core::Drape drape(core::joined_layers(layers), body, {}, core::banded(layers, body), core::sewn(layers));

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/point.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

struct FinishedLayer;

/// A vertex that keeps its place over a triangle of other cloth.
struct SewnVertex {
    std::uint32_t vertex = 0;
    std::array<std::uint32_t, 3> on{};  ///< corners of the triangle
    std::array<double, 3> share{};      ///< of its nearest place; they add up to 1
    Vec3 off;                           ///< from there, along the first edge, across it, along the normal; cm
};

/// Axes of a triangle: along its first edge, across that in its plane, its normal. Without area they are zero.
struct TriangleAxes {
    Vec3 along, across, normal;
};
[[nodiscard]] TriangleAxes axes_of_triangle(Vec3 a, Vec3 b, Vec3 c);

/// Vertices on hems of the joined mesh (`joined_layers`), in order. A connected sheet whose hem lies on cloth below for
/// at least four fifths of its vertices (within 1 cm, so drawn on that cloth) is sewn wherever it does; another one
/// only where its hem runs along a hem below. Nothing is sewn to a layer farther out, or to the body. Of several layers
/// below, the nearest. Time: vertices on hems times quads below.
[[nodiscard]] std::vector<SewnVertex> sewn(const std::vector<FinishedLayer>& layers);

}  // namespace core
