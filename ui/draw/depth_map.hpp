#pragma once
// How near the figure is in each part of the picture: what tells a line on its back from one on its front. No GL.

#include <array>
#include <cstdint>
#include <vector>

#include "ui/draw/figure_camera.hpp"
#include "ui/gl/context.hpp"

namespace ui {

class DepthMap {
  public:
    /// An empty picture of `size`, one cell for each `cell_px` pixels.
    void clear(const FigureCamera& camera, SizePx size, int cell_px = 4);
    /// Linear in triangles and in the cells they cover.
    void add(const std::vector<core::Vec3>& vertices, const std::vector<std::array<std::uint32_t, 3>>& triangles);
    void add(const std::vector<core::Vec3>& vertices, const std::vector<std::array<std::uint32_t, 4>>& quads);

    /// Whether something lies before the place by more than `slack_cm`. Places off the picture are not hidden.
    [[nodiscard]] bool hides(core::Vec3 place, double slack_cm = 1.5) const;
    /// Whether anything is drawn within `reach_px` of a place of the picture.
    [[nodiscard]] bool covered(core::Point px, double reach_px) const;
    [[nodiscard]] const FigureCamera& camera() const { return camera_; }

  private:
    struct Corner {
        double x = 0, y = 0, near = 0;
    };
    [[nodiscard]] Corner corner(core::Vec3 place) const;
    void fill(const Corner& a, const Corner& b, const Corner& c);

    FigureCamera camera_;
    int cell_px_ = 4, width_ = 0, height_ = 0;
    std::vector<float> near_;
};

}  // namespace ui
