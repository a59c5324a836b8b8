#pragma once
// Builds a clean TriangleMesh from loose triangles: equal corners become one vertex, useless triangles are left out.
//
//     core::MeshWelder welder;
//     welder.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
//     const core::TriangleMesh mesh = std::move(welder).finish();

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/triangle_mesh.hpp"

namespace core {

/// Coordinates beyond this, in any unit, count as not finite: their squares must stay representable.
inline constexpr double kLargestCoordinate = 1e100;

[[nodiscard]] bool is_usable(Vec3 p);  ///< every coordinate finite and within kLargestCoordinate

class MeshWelder {
  public:
    struct Corner {
        Vec3 position;
        Rgb colour{};
    };

    /// Adds a triangle. Left out are those with a corner that is not usable and those with two corners in one place; a
    /// triangle of area 0 with three distinct corners stays, for it is a line to be seen. Constant time on average.
    /// Corners with equal position and colour become one vertex, numbered in the order of first use.
    void add(const Corner& a, const Corner& b, const Corner& c);
    void add(Vec3 a, Vec3 b, Vec3 c) { add(Corner{a}, Corner{b}, Corner{c}); }

    [[nodiscard]] std::size_t triangle_count() const { return mesh_.triangles.size(); }
    [[nodiscard]] std::size_t left_out() const { return left_out_; }  ///< triangles not taken

    /// The mesh so far; its colours are empty when every corner was clay, so that nothing need be stored.
    [[nodiscard]] TriangleMesh finish() &&;

  private:
    [[nodiscard]] std::uint32_t vertex(const Corner& corner);
    void grow();

    TriangleMesh mesh_;
    std::vector<std::uint32_t> slots_;  // open addressing; kFree or a vertex index
    std::size_t left_out_ = 0;
};

}  // namespace core
