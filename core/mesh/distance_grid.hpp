#pragma once
// Signed distances to a surface, sampled on a grid: of closed bodies everywhere, of sheets of cloth near them.
//
//     const auto field = core::DistanceGrid::of_body(body_triangles, {});
//     field->sample(p).distance;      // cm if the mesh is in cm; negative inside

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/result.hpp"
#include "core/geometry/point.hpp"
#include "core/mesh/field_sample.hpp"
#include "core/mesh/quad_mesh.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

struct DistanceGridOptions {
    double cell = 1.25;
    double margin = 12.0;  ///< of a body's grid around it; a point beyond is taken to the nearest place inside
    double reach = 4.0;    ///< of a sheet's grid to either side; beyond it the sheet is not felt
};

class DistanceGrid {
  public:
    /// Beyond a sheet's reach.
    static constexpr double kFar = 1e6;

    /// The mesh must be closed and its triangles anti-clockwise seen from outside: ErrorCode::BadMesh otherwise. Within
    /// a cell and a half of the surface distances are exact at the corners of the grid and interpolated between them;
    /// farther away they come from sweeps (Zhao 2005), a few per cent long. About 200 ms for a mannequin.
    [[nodiscard]] static Result<DistanceGrid> of_body(const TriangleMesh& mesh, const DistanceGridOptions& options);

    /// Of an open sheet whose quads are anti-clockwise seen from its outer side: negative behind it, positive before
    /// it; where the nearest point lies on its border the distance has no sign. kFar beyond reach.
    [[nodiscard]] static DistanceGrid of_sheet(const QuadMesh& mesh, const DistanceGridOptions& options);

    [[nodiscard]] FieldSample sample(Vec3 p) const;
    [[nodiscard]] double distance(Vec3 p) const;
    /// Distance and the slope of the one cell of the grid around p: a third of the time of sample, less smooth.
    [[nodiscard]] FieldSample quick_sample(Vec3 p) const;

  private:
    DistanceGrid(Vec3 low, Vec3 high, double cell);
    void measure_band(const TriangleMesh& mesh, double band, bool sheet);
    void sweep();
    [[nodiscard]] std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny_) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(nx_) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] Vec3 place(int x, int y, int z) const { return low_ + Vec3{x * cell_, y * cell_, z * cell_}; }

    Vec3 low_;
    double cell_ = 1.0;
    int nx_ = 0, ny_ = 0, nz_ = 0;
    std::vector<float> value_;
    bool sheet_ = false;
};

/// Two triangles for every quad, cut from its first to its third corner.
[[nodiscard]] TriangleMesh triangles_of(const QuadMesh& mesh);

/// Every edge has two triangles that pass it in opposite directions. n log n.
[[nodiscard]] bool is_closed(const TriangleMesh& mesh);

}  // namespace core
