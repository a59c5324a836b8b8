#pragma once
// The ink of the sheet in a picture that stays: each call draws only what is new, whatever is there already.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/stroke/stroke.hpp"
#include "ui/draw/ink_curve.hpp"
#include "ui/draw/palette.hpp"
#include "ui/gl/objects.hpp"

namespace ui {

class InkLayer {
  public:
    [[nodiscard]] static core::Result<InkLayer> create(SizePx size);

    /// What the layer shows.
    struct Ink {
        const std::vector<core::Stroke>& strokes;
        bool last_open = false;   ///< the pen still draws the last stroke
        std::uint64_t epoch = 0;  ///< another number when anything but appending happened
        InkFrame frame;
        double width_px = 7.5;
        std::span<const double> widths = {};  ///< of each stroke, as shares of width_px; none: all 1
        [[nodiscard]] double width_of(std::size_t stroke) const {
            return stroke < widths.size() ? width_px * widths[stroke] : width_px;
        }
    };
    /// Draws what was added since the last call, or everything anew when the epoch, frame or width changed. The newest
    /// span of an open stroke is left out, since the next sample may bend it: wet_end gives it. Returns the number of
    /// pieces drawn. Ink only ever darkens a pixel to the greatest cover of one piece, so the order never matters and
    /// joins are seamless.
    int update(const Ink& ink);

    /// The newest span of an open stroke, to be drawn over the layer in each frame. Constant size.
    [[nodiscard]] static std::vector<InkPiece> wet_end(const Ink& ink);

    /// Box of all ink in the layer, in its pixels; without size when there is none.
    [[nodiscard]] Rect inked() const { return inked_; }
    /// Box of the pixels that changed since the last call.
    [[nodiscard]] Rect take_changed() { return std::exchange(changed_, {}); }
    [[nodiscard]] const Texture& texture() const { return target_.texture(); }
    [[nodiscard]] core::RgbaImage read_back() const { return target_.read_back(); }
    /// A new, empty picture of that size; the next update draws everything.
    void resize(SizePx size);
    [[nodiscard]] SizePx size() const { return target_.size(); }

  private:
    InkLayer(Program program, SizePx size);
    Program program_;
    Target target_;
    VertexStream stream_;
    bool fresh_ = true;
    std::uint64_t epoch_ = 0;
    InkFrame frame_;
    double width_px_ = 0;
    std::size_t stroke_ = 0;  // the next span to draw
    std::size_t span_ = 0;
    Rect inked_, changed_;
};

}  // namespace ui
