#pragma once
// Landmarks and parts of a body that stands as a mannequin does, found on its mesh by level cuts.

#include <optional>
#include <vector>

#include "core/mannequin/body_shape.hpp"
#include "core/mannequin/landmark.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

struct FoundBody {
    std::vector<Landmark> landmarks;  ///< names as a mannequin's: levels (neck, bust, …) front, back, left, right;
                                      ///< nape, crotch; shoulders, elbows, wrists, knees, ankles
    std::vector<BodyPart> part_of_triangle;
};

/// For a mesh that stand_body stood up, arms away from the sides: the crotch is where two legs become one cut, the
/// armpit where arms part from the trunk, neck, waist and wrist are narrow, the hip is wide, bust and knee follow from
/// the proportions of the reference figure. Nothing where legs or arms are not found: arms that touch the sides, or are
/// raised above the armpit. About 150 cuts, 2 ms each for 33,000 triangles.
[[nodiscard]] std::optional<FoundBody> find_body(const TriangleMesh& body);

}  // namespace core
