#pragma once
// A mesh made ready for the graphics card, and a card's whole subject: mesh, camera, part colours. No GL in here, so a
// worker thread can prepare it while the screen goes on.

#include <memory>
#include <vector>

#include "core/mesh/triangle_mesh.hpp"
#include "core/views/camera.hpp"
#include "ui/draw/part_map.hpp"

namespace ui {

/// Three corners a triangle, nine floats a corner: position, normal, colour (0 … 1).
struct ModelGeometry {
    std::vector<float> corners;
    [[nodiscard]] int corner_count() const { return static_cast<int>(corners.size() / 9); }
};

/// Smooth normals over equal positions, with an edge kept where faces meet at more than 50 degrees; windings may differ
/// from face to face. Triangles without area are left out. Time: triangles times the faces round a corner.
[[nodiscard]] ModelGeometry make_model_geometry(const core::TriangleMesh& mesh);

/// What one card shows.
struct CardModel {
    std::shared_ptr<const ModelGeometry> geometry;
    core::Camera camera;
    bool mirrored = false;                              ///< shown flipped left-right
    core::RgbaImage part_map;                           ///< of bake_part_map; empty: all clay
    double left = -1, right = 1, bottom = -1, top = 1;  ///< box in the image plane, before mirroring, y up
    /// Where the model stands: spans of the plane's x along its lowest line.
    std::vector<core::Point> contacts;
    /// How far it reaches to the left and right (x, y) in each of these equal bands of its height, lowest first; where
    /// nothing of it is, x is larger than y.
    std::vector<core::Point> reaches;
};

/// `map_size`: pixels of the part map. Without parts the model is all clay.
[[nodiscard]] CardModel make_card_model(std::shared_ptr<const ModelGeometry> geometry, const core::Camera& camera,
                                        bool mirrored, const std::vector<PartRegion>& parts, int map_size = 192);

}  // namespace ui
