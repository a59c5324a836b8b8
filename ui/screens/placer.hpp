#pragma once
// From the numbers of a design picture to rectangles on the screen, for whichever hand draws.

#include <cmath>

#include "ui/draw/palette.hpp"
#include "ui/gl/context.hpp"
#include "ui/screens/find_layout.hpp"

namespace ui {

/// `scale`: pixels of the screen per pixel of the design picture. Everything comes out at whole pixels.
class Placer {
  public:
    Placer(SizePx screen, Hand hand, double scale) : screen_(screen), hand_(hand), scale_(scale) {}
    /// A block of the board, mirrored as a whole.
    [[nodiscard]] Rect block(double x, double y, double width, double height) const {
        const Rect r{round(x), round(y), round(width), round(height)};
        return hand_ == Hand::Right ? r : Rect{screen_.width - r.x - r.width, r.y, r.width, r.height};
    }
    /// Something inside a block, at its offset from the block's corner.
    [[nodiscard]] Rect inside(const Rect& block, double x, double y, double width, double height) const {
        return {block.x + round(x), block.y + round(y), round(width), round(height)};
    }
    [[nodiscard]] double round(double design) const { return std::round(design * scale_); }

  private:
    SizePx screen_;
    Hand hand_;
    double scale_;
};

}  // namespace ui
