#pragma once
// One lit model and its soft shadows on the graphics card, drawn into the target that is bound: what the pictures of
// cards and the turning model of a result share.

#include <vector>

#include "ui/draw/model_geometry.hpp"
#include "ui/gl/objects.hpp"

namespace ui {

/// How a model is seen and coloured.
struct ModelLook {
    core::Camera camera;
    double sx = 1, sy = -1, ox = 0, oy = 0;  ///< image plane to picture, which is -1 … 1 and y down: x * sx + ox
    bool mirrored = false;                   ///< shown flipped left-right; sx says so too
    bool own_colours = false;                ///< the mesh's colours instead of clay where no part colour lies
    const Texture* parts = nullptr;          ///< part colours in the image plane; none: no part has a colour
    float part_share = 0.0F;                 ///< of the part colour against the ground colour
};

class LitModel {
  public:
    [[nodiscard]] static core::Result<LitModel> create();

    /// Corners as ModelGeometry has them. Uploads them.
    void set_corners(const std::vector<float>& corners);
    /// Discs, each left, top, width, height (px of a picture of `size`), red, green, blue, strength.
    void draw_shadows(const std::vector<float>& quads, SizePx size);
    /// Over what is there. Cost: the model's triangles.
    void draw(const ModelLook& look) { draw(look, 0, triangles()); }
    /// Those triangles of it alone, over what is there. Cost: the triangles.
    void draw(const ModelLook& look, int first, int count);
    [[nodiscard]] int triangles() const { return corner_count_ / 3; }

  private:
    LitModel(Program model, Program soft);
    Program model_program_, soft_program_;
    VertexStream corners_, shadows_;
    Texture no_parts_;
    int corner_count_ = 0;
};

}  // namespace ui
