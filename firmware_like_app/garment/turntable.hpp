#pragma once
// Pictures of a dressed figure from all round, through OpenGL without a screen. Use one Turntable on one thread, with
// no other context current there.

#include <memory>
#include <vector>

#include "core/silhouette/image.hpp"
#include "firmware_like_app/garment/dressed_design.hpp"
#include "ui/draw/figure_stage.hpp"
#include "ui/gl/context.hpp"

namespace app {

class Turntable {
  public:
    /// Makes a context of its own and loads the figure. ErrorCode::NoDisplay where there is none.
    [[nodiscard]] static core::Result<Turntable> create(const DressedDesign& dressed);

    /// Number k of n pictures, beginning in front and going on to the figure's left, on the sheet's colour. Hidden
    /// layers are left out.
    [[nodiscard]] core::RgbaImage picture(int k, int n, ui::SizePx size);

  private:
    Turntable(std::unique_ptr<ui::Context> context, ui::FigureStage stage);
    std::unique_ptr<ui::Context> context_;  // outlives the stage
    ui::FigureStage stage_;
    ui::FigureStage::Look look_;
    double height_cm_ = 170;
};

/// What the pieces of a layer are made of, for ui::FigureStage.
[[nodiscard]] std::vector<ui::FabricLook> piece_looks(const DressedDesign& dressed, std::size_t layer);

}  // namespace app
