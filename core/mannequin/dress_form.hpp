#pragma once
// What a garment is drawn on and worn by: a closed mesh, with its parts and landmarks where they are known.

#include <optional>
#include <vector>

#include "core/mannequin/mannequin.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

struct DressForm {
    TriangleMesh mesh;                       ///< closed, centimetres, y up, facing +z
    std::vector<BodyPart> part_of_triangle;  ///< empty when not known
    std::vector<Landmark> landmarks;         ///< empty when not known
    std::optional<BodyMeasures> measures;    ///< of a mannequin; nothing for a body of the user's
};

[[nodiscard]] DressForm dress_form(const Mannequin& body);

/// For a body that stand_body stood up: with landmarks and parts where find_body finds them.
[[nodiscard]] DressForm dress_form(TriangleMesh own_body);

}  // namespace core
