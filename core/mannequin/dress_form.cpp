#include "core/mannequin/dress_form.hpp"

#include <utility>

#include "core/mannequin/body_finder.hpp"
#include "core/mesh/distance_grid.hpp"

namespace core {

DressForm dress_form(const Mannequin& body) {
    DressForm form;
    form.mesh = triangles_of(body.mesh);
    for (const BodyPart part : body.part_of_quad) form.part_of_triangle.insert(form.part_of_triangle.end(), 2, part);
    form.landmarks = body.landmarks;
    form.measures = body.measures;
    return form;
}

DressForm dress_form(TriangleMesh own_body) {
    DressForm form;
    if (std::optional<FoundBody> found = find_body(own_body)) {
        form.part_of_triangle = std::move(found->part_of_triangle);
        form.landmarks = std::move(found->landmarks);
    }
    form.mesh = std::move(own_body);
    return form;
}

}  // namespace core
