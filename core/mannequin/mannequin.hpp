#pragma once
// A body to dress, made from measures alone: it stands on y = 0, faces +z, arms held away from the sides.
//
//     const auto body = core::make_mannequin(*core::measures_of_size("38"));

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/mannequin/body_measures.hpp"
#include "core/mannequin/body_shape.hpp"
#include "core/mannequin/landmark.hpp"
#include "core/mesh/plane_section.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

/// A measure as asked for and as a tape finds it on the mesh.
struct ReachedMeasure {
    std::string name;
    double asked_cm = 0.0, reached_cm = 0.0;
    CutPlane plane;  ///< girths: where the tape lies; heights: origin only
};

struct Mannequin {
    BodyMeasures measures;
    QuadMesh mesh;  ///< closed, centimetres, mirror-symmetric in x
    std::vector<BodyPart> part_of_quad;
    std::vector<Landmark> landmarks;
    std::vector<ReachedMeasure> girths, heights;
    bool closed = false;  ///< is_closed_manifold
};

/// The body with these measures. Girths are met as a tape lies, by the hull of a level cut (arms: across the arm).
/// ErrorCode::BadArgument as check_measures. The same measures give the same mesh. About 150 ms.
[[nodiscard]] Result<Mannequin> make_mannequin(const BodyMeasures& measures);

}  // namespace core
