#pragma once
// Cloth under gravity: how the garment hangs, for a preview; it can always be put back to its drawn form.
//
//     core::Drape drape(mesh, obstacle, {});
//     for (int k = 0; k < 300; ++k) drape.step();      // five seconds
//     drape.places();                                  // now
//     drape.reset();                                   // as drawn
//
// Extended position based dynamics, many substeps of one iteration (M. Macklin and others, Small steps in physics
// simulation, 2019): edges keep their lengths, diagonals and the spans over two quads give way a little against shear
// and bending, the body pushes out along its distance field with friction, and vertices of sheets that touch keep
// apart by a radius (found with a grid). In vertex order: the same steps give the same places.

#include <cstdint>
#include <vector>

#include "core/garment/obstacle.hpp"
#include "core/garment/sewing.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

struct DrapeOptions {
    double gravity_cm_s2 = 981.0;
    int substeps = 8;             ///< of 1/60 s
    double clearance_cm = 0.4;    ///< from the body, whose field is rounder than its ridges; coarse quads keep more
    double shear_softness = 0.5;  ///< compliance against that of a vertex in one substep; 0: stiff
    double bend_softness = 20.0;
    double body_friction = 0.6;  ///< tangential against normal correction
    double cloth_friction = 0.1;
    double drag_per_s = 1.0;  ///< share of the speed that air takes in a second, about
    double floor_cm = 0.0;    ///< height of the ground that cloth lies down on
};

class Drape {
  public:
    /// `cloth` as drawn and fitted, outside of the obstacle; its lengths are the rest lengths. `held` vertices stay
    /// where they are, unless they are sewn; it may be empty. The obstacle must outlive the drape.
    Drape(const QuadMesh& cloth, const Obstacle& obstacle, const DrapeOptions& options, std::vector<bool> held = {},
          std::vector<SewnVertex> sewn = {});

    /// 1/60 s. About 10 ms for 10,000 vertices.
    void step();

    /// Back to the drawn form, at rest.
    void reset();

    [[nodiscard]] const std::vector<Vec3>& places() const { return at_; }
    [[nodiscard]] double mean_speed_cm_s() const;
    [[nodiscard]] double thickness_cm() const { return thickness_; }  ///< that sheets keep apart

  private:
    struct Link {
        std::uint32_t a, b;
        double rest, softness;
    };
    struct Contact {
        std::uint32_t a, b;
        double least;
    };

    void add_links();
    void find_contacts();
    void add_contacts(std::uint32_t vertex);
    void sort_by_cell(double size);
    [[nodiscard]] std::size_t cell_of(Vec3 p) const;
    [[nodiscard]] bool is_linked(std::uint32_t low, std::uint32_t high) const;
    void substep(double seconds);
    void keep_lengths();
    void keep_sewn();
    void keep_apart();
    void keep_outside();
    void stay_above_floor();

    QuadMesh rest_;
    const Obstacle& obstacle_;
    DrapeOptions options_;
    std::vector<double> weight_;               // inverse mass, 0 for held vertices
    std::vector<Link> links_;                  // by their lower vertex
    std::vector<std::uint32_t> linked_start_;  // of each vertex: its first link as the lower one
    std::vector<Contact> contacts_;
    std::vector<SewnVertex> sewn_;
    std::vector<Vec3> at_, before_, speed_;
    double thickness_ = 0.0, clearance_ = 0.0;
    double since_search_ = 0.0;  // how far a vertex may have moved since contacts were looked for
    bool searched_ = false;
    std::vector<double> free_;  // of each vertex: how far it may move before it can touch the body
    // the grid: vertices sorted by cell, with a layer of empty cells around
    struct Sorted {
        Vec3 at;
        std::uint32_t vertex;
    };
    Vec3 low_;
    double cell_size_ = 1.0;
    std::size_t nx_ = 0, ny_ = 0;
    std::vector<std::uint32_t> cell_start_;
    std::vector<std::size_t> cell_;  // of each vertex
    std::vector<Sorted> sorted_;
};

/// All layers of a garment as one mesh, inner ones first.
struct FinishedLayer;
[[nodiscard]] QuadMesh joined_layers(const std::vector<FinishedLayer>& layers);

/// Vertices of such a mesh that a band would hold: on a hem, near to what is below it and near to the top of their
/// layer (a waist, a neckline). Without them a loose skirt slides off.
[[nodiscard]] std::vector<bool> banded(const std::vector<FinishedLayer>& layers, const Obstacle& body);

/// Takes the places of such a mesh back to the layers.
void put_places(const std::vector<Vec3>& places, std::vector<FinishedLayer>& layers);

}  // namespace core
