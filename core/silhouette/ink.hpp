#pragma once
// Ink on a raster: where the pen left something, whether it came as strokes or as a picture.
//
// The first half of making a silhouette (closing.hpp is the second). Either source is laid into a raster that fits the
// drawing itself and not its page, so that every later radius is relative to the drawing's own size (thesis 7.2.2).

#include "core/base/result.hpp"
#include "core/geometry/point.hpp"
#include "core/silhouette/image.hpp"
#include "core/stroke/stroke.hpp"

namespace core {

/// How raster pixels and the source's own units correspond; the source is a Drawing (y down) or a picture's pixels.
/// Integer raster coordinates are pixel centres.
struct DrawingRaster {
    double scale = 1.0;  ///< raster pixels per unit of the source; > 0
    Point offset;        ///< raster position of the source's origin

    [[nodiscard]] Point to_raster(Point p) const { return p * scale + offset; }
    [[nodiscard]] Point to_drawing(Point p) const { return (p - offset) * (1.0 / scale); }
};

/// A rectangle in the source's units, y down. Empty when right < left.
struct Frame {
    double left = 0.0, top = 0.0, right = -1.0, bottom = -1.0;
    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return bottom - top; }
    [[nodiscard]] double diagonal() const { return length(Point{width(), height()}); }
};

struct InkOptions {
    int raster_px = 320;          ///< larger side of the drawing on the raster, margin not counted
    int margin_px = 20;           ///< free pixels on every side
    double stroke_share = 0.012;  ///< width of a stroke as a share of the drawing's diagonal
    double faint_share = 0.35;    ///< a pixel of a picture is ink from this share of the darkest ink on
    /// A drawing whose diagonal is smaller than this, in its own units, is a dot. 0: only a drawing with no extent is.
    double least_diagonal = 0.0;
};

struct Ink {
    BinaryImage mask;  ///< 1 where there is ink, strokes at least stroke_share wide
    DrawingRaster raster;
    bool filled = false;  ///< the source is a solid silhouette already, not line art; never set for a Drawing
};

/// The smallest rectangle round all samples. An empty drawing gives an empty frame.
[[nodiscard]] Frame frame_of(const Drawing& drawing);

/// The strokes drawn with a pen of constant width, as far as they lie in `frame`, which is fitted to the raster.
/// EmptyDrawing without strokes; TooSmall when the frame is a mere dot. Linear in samples and pixels.
[[nodiscard]] Result<Ink> ink_of(const Drawing& drawing, const Frame& frame, const InkOptions& options);

/// How strongly each pixel differs from the paper, 0 (paper) to 255, whatever the polarity: the paper is the median of
/// the picture's border. Pixels on the paper's other side count as paper.
[[nodiscard]] GrayImage ink_strength(const GrayImage& page);

/// The smallest rectangle round the pixels of `strength` that count as ink. Empty for an empty page.
[[nodiscard]] Frame frame_of(const GrayImage& strength, const InkOptions& options);

/// The ink of a picture inside `frame`, fitted to the raster; strokes thinner than stroke_share are widened to it. A
/// filled silhouette keeps its own resolution where that is at most 1024 pixels a side.
/// EmptyDrawing when no pixel stands out from the paper; TooSmall when what stands out is a mere dot.
[[nodiscard]] Result<Ink> ink_of(const GrayImage& strength, const Frame& frame, const InkOptions& options);

}  // namespace core
