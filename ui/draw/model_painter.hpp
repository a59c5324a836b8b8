#pragma once
// Draws a lit model into a picture with a transparent ground: what stands on a card.

#include <utility>
#include <vector>

#include "ui/draw/lit_model.hpp"

namespace ui {

struct ModelPictureOptions {
    SizePx size{400, 270};        ///< of the place on screen; the picture holds twice as many pixels each way
    double margin = 0.05;         ///< of the picture, kept free left, right and above
    double ground_margin = 0.08;  ///< kept free below, where the shadow lies
    bool own_colours = false;     ///< the mesh's colours instead of clay where no part colour lies
    double lean = 0;      ///< share of the picture's width by which free room at the sides may shift the model right
    double headroom = 0;  ///< share of the picture's height above the model that is kept free beyond the margin
};

/// Where a picture of ModelPainter shows the image plane: pixels of `size`, y down.
struct PicturePlace {
    double scale_px = 1;    ///< pixels a unit of the plane
    core::Point origin_px;  ///< where the plane's origin lies
    bool mirrored = false;  ///< the plane's x runs to the left
};
[[nodiscard]] PicturePlace picture_place(const CardModel& model, const ModelPictureOptions& options);
/// Pixels from the picture's left edge to the model between two heights of the picture, y down: all of the width where
/// nothing of the model is. Of a triangle its box counts.
[[nodiscard]] double free_at_left(const CardModel& model, const ModelPictureOptions& options, double from_y,
                                  double to_y);

class ModelPainter {
  public:
    [[nodiscard]] static core::Result<ModelPainter> create();

    /// The model seen by its camera, filling the picture, with its shadow on the ground. Twice the size asked for with
    /// four samples a pixel, so that it is smooth when shown at that size. Cost: the model's triangles.
    [[nodiscard]] Texture paint(const CardModel& model, const ModelPictureOptions& options);
    /// Paints a small picture that nobody sees, so that the driver builds its programs before the first that is seen:
    /// in software that takes a tenth of a second.
    void warm_up();
    /// The same as pixels, for files and tests.
    [[nodiscard]] core::RgbaImage paint_image(const CardModel& model, const ModelPictureOptions& options);

  private:
    explicit ModelPainter(LitModel model) : model_(std::move(model)) {}
    Target& draw(const CardModel& model, const ModelPictureOptions& options);
    Target& target_of(SizePx size);
    LitModel model_;
    std::vector<Target> targets_;  // of the sizes in use, newest first: their buffers are large, and made anew too slow
};

}  // namespace ui
