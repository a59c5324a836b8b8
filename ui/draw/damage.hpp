#pragma once
// What of a frame has to be drawn anew when the frame before it is still there: where two lists of commands differ.

#include <vector>

#include "ui/draw/draw_list.hpp"

namespace ui {

/// A few rectangles of whole pixels. Those that lie on or close to each other become one, so that what is drawn twice
/// or in vain stays small against the cost of going through a list once more.
class Damage {
  public:
    /// Grown to whole pixels; one without width or height adds nothing.
    void add(const Rect& rect);
    [[nodiscard]] const std::vector<Rect>& rects() const { return rects_; }
    [[nodiscard]] bool empty() const { return rects_.empty(); }
    /// Sum over the rectangles, px².
    [[nodiscard]] double area() const;

  private:
    std::vector<Rect> rects_;
};

[[nodiscard]] bool overlap(const Rect& a, const Rect& b);
/// The part of both; without width or height when there is none.
[[nodiscard]] Rect common(const Rect& a, const Rect& b);

/// The smallest that holds both.
[[nodiscard]] Rect around(const Rect& a, const Rect& b);

/// Pixels that the command may change: its box, grown by soft edges and by what letters reach beyond their line.
[[nodiscard]] Rect reach_of(const DrawCommand& command, const FontSet& fonts);

/// Where the picture of `now` may differ from that of `before`, both painted onto the same ground: the reach of all
/// commands that are not in both, the others being in both in the same order. Contents of pictures count as unchanged.
/// Time: the lists' lengths, times the number of commands that came or went in one place.
[[nodiscard]] Damage difference(const DrawList& before, const DrawList& now, const FontSet& fonts);

}  // namespace ui
