#pragma once
// What cloth must stay outside of: a body, and the cloth that is worn below.

#include <optional>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/part_surface.hpp"
#include "core/mesh/distance_grid.hpp"

namespace core {

class Obstacle {
  public:
    /// The body must be closed, in centimetres, y up. ErrorCode::BadMesh otherwise.
    [[nodiscard]] static Result<Obstacle> of_body(const TriangleMesh& body);
    /// The same, with the parts of the body where the form knows them.
    [[nodiscard]] static Result<Obstacle> of_body(const DressForm& form);

    /// Cloth worn below: what is drawn and fitted from now on stays on its outer side.
    void add_layer(const QuadMesh& cloth);

    /// The least distance to the body and to every layer near by.
    [[nodiscard]] FieldSample sample(Vec3 p) const;
    [[nodiscard]] double distance(Vec3 p) const;
    [[nodiscard]] FieldSample quick_sample(Vec3 p) const;  ///< see DistanceGrid::quick_sample

    /// The surfaces themselves: the body, then each layer.
    [[nodiscard]] const std::vector<QuadMesh>& surfaces() const { return surfaces_; }

    /// The body by its parts; empty when these are not known.
    [[nodiscard]] const PartSurface& parts() const { return parts_; }

    /// Where a ray comes within `offset` of the surface for the first time, along a unit direction; nothing within
    /// `reach`. Starts that are nearer already give the start.
    [[nodiscard]] std::optional<Vec3> first_hit(Vec3 origin, Vec3 direction, double offset, double reach) const;

    /// The place on a ray that is nearest to the surface, sampled every half centimetre.
    [[nodiscard]] Vec3 nearest_pass(Vec3 origin, Vec3 direction, double reach) const;

  private:
    Obstacle(DistanceGrid body, PartSurface parts) : body_(std::move(body)), parts_(std::move(parts)) {}
    DistanceGrid body_;
    PartSurface parts_;
    std::vector<DistanceGrid> layers_;
    std::vector<QuadMesh> surfaces_;
};

}  // namespace core
