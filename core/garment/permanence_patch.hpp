#pragma once
// Places for the inner vertices of a quad mesh whose boundary is given: permanence patches on any topology.
//
//     core::PermanencePatch patch(topology.quads, topology.vertices, topology.boundary, -0.25);
//     patch.solve(vertices);          // the first topology.boundary are read, the others written
//     patch.set_alpha(-0.1);          // the same topology, flatter
//
// Each inner vertex of valence n is alpha * 4/n times the sum of its diagonal neighbours plus (1/n - alpha * 4/n) times
// the sum of its neighbours along edges (thesis 3.2.2, after Farin and Hansford's permanence principle). Multiplied by
// n, these equations are the gradient of
//
//     -4 alpha * 1/2 sum over quads |a - b + c - d|^2  +  (1 + 4 alpha) * 1/2 sum over edges |p - q|^2
//
// so the system is symmetric, and positive definite for alpha in (-1/4, 0]. We solve it by a sparse Cholesky factor
// (core/garment/frontal_factor.hpp), whose symbolic part is done once for a topology. alpha = 0 is harmonic and flat;
// towards alpha = -1/4, where a grid of four sides becomes the discrete Coons patch, the shape of the boundary travels
// further in.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

inline constexpr double kCoonsAlpha = -0.25, kHarmonicAlpha = 0.0;
/// What stands for -1/4 where a flow line closes up without reaching the boundary: there the system is singular.
inline constexpr double kClosedFlowAlpha = -0.2499;

class PermanencePatch {
  public:
    /// Vertices 0 … fixed - 1 are the boundary. The quads must be connected to it and name no vertex beyond
    /// vertex_count. Analyses and factorises: about 30 ms for 10,000 vertices. alpha: see set_alpha.
    PermanencePatch(std::span<const Quad> quads, std::uint32_t vertex_count, std::uint32_t fixed, double alpha);
    PermanencePatch(PermanencePatch&&) noexcept;
    PermanencePatch& operator=(PermanencePatch&&) noexcept;
    ~PermanencePatch();

    /// Factorises anew: about 5 ms for 10,000 vertices. Clamped to [-1/4, 0], or to [kClosedFlowAlpha, 0] where flow
    /// lines close up; not a number counts as 0.
    void set_alpha(double alpha);
    [[nodiscard]] double alpha() const;  ///< in use, after clamping

    /// Moves the inner vertices of `vertices` (vertex_count of them) to where the first `fixed` put them. Linear in the
    /// boundary: about 1.5 ms for 10,000 vertices. Coordinates must be finite.
    void solve(std::vector<Vec3>& vertices);

  private:
    struct System;
    std::unique_ptr<System> system_;
};

}  // namespace core
