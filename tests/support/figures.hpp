#pragma once
// A few animals made of rounded limbs, and a small searcher over them: for tests of the screen that need real meshes,
// cameras and parts without an index.

#include <chrono>
#include <string>
#include <vector>

#include "core/geometry/point.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "firmware_like_app/kiosk/searcher.hpp"

namespace test {

/// A limb: a capsule between two points with a radius at each end.
struct Limb {
    core::Vec3 from, to;
    double r0 = 0.1, r1 = 0.1;
    int colour = -1;
};

/// Normalised as core/views/camera.hpp says; the limbs too.
struct Figure {
    std::string name;
    std::vector<Limb> limbs;
    core::TriangleMesh mesh;
};

/// Limbs as closed triangle meshes, centred and scaled so that the farthest vertex is at distance 1.
[[nodiscard]] Figure make_figure(std::string name, std::vector<Limb> limbs);
[[nodiscard]] Figure make_quadruped(std::string name, double neck, double legs, double tail);
/// Nine different animals.
[[nodiscard]] std::vector<Figure> make_animals();

/// Ranks figures by how close the shape of their box comes to that of the drawing; lays their limbs over the drawing.
/// Deterministic. `pause` makes it slow, for tests of what happens meanwhile.
class FigureSearcher : public app::Searcher {
  public:
    explicit FigureSearcher(std::vector<Figure> figures, std::chrono::milliseconds pause = {});
    app::SearchAnswer search(const core::Drawing& drawing, std::stop_token stop) override;

  private:
    struct Entry {
        Figure figure;
        std::shared_ptr<const core::TriangleMesh> mesh;
    };
    std::vector<Entry> entries_;
    std::chrono::milliseconds pause_;
};

/// A horse as strokes of a steady pen, in a 400 × 300 sheet, about three seconds long.
[[nodiscard]] core::Drawing make_horse_drawing();

}  // namespace test
