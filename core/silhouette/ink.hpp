#pragma once
// Ink on a raster: where the pen left something, whether it came as strokes or as a picture.
//
// The first half of making a silhouette (closing.hpp is the second). Either source is laid into a raster that fits the
// drawing itself and not its page, so that every later radius is relative to the drawing's own size (thesis 7.2.2).
//
// A picture is fitted exactly. A drawing grows while it is made, so its raster grows in steps of a fourth root of two
// (DrawingLayout): between two steps every pixel keeps its value when the drawing grows, and shares of the diagonal are
// off by at most a tenth.

#include "core/base/result.hpp"
#include "core/geometry/point.hpp"
#include "core/silhouette/capsule.hpp"
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
    int raster_px = 320;          ///< larger side of a picture's ink on the raster, margin not counted
    int diagonal_px = 440;        ///< largest diagonal of a drawing on the raster; the smallest is 0.84 of it
    int margin_px = 20;           ///< free pixels on every side
    double stroke_share = 0.012;  ///< width of a stroke as a share of the drawing's diagonal
    double faint_share = 0.35;    ///< a pixel of a picture is ink from this share of the darkest ink on
    /// A drawing whose diagonal is smaller than this, in its own units, is a dot. 0: only a drawing with no extent is.
    double least_diagonal = 0.0;
};

struct Ink {
    BinaryImage mask;  ///< 1 where there is ink, strokes at least stroke_share wide
    DrawingRaster raster;
    bool filled = false;       ///< the source is a solid silhouette already, not line art; never set for a Drawing
    double diagonal_px = 0.0;  ///< what later shares are of
};

/// How a drawing lies on the endless grid of its raster. Depends on the first sample, where its origin is, and on the
/// diagonal, in steps; so it is the same for a drawing that is moved, and for one that is twice as large but for twice
/// the scale.
struct DrawingLayout {
    double scale = 1.0;        ///< grid pixels per unit
    Point origin;              ///< in units, at grid pixel (0, 0)
    double diagonal_px = 0.0;  ///< what later shares are of: the middle of the diagonals that this step is for

    [[nodiscard]] FixedPoint place(const PenSample& sample) const;
    friend bool operator==(const DrawingLayout&, const DrawingLayout&) = default;
};

/// EmptyDrawing without strokes; TooSmall when all samples lie within a mere dot.
[[nodiscard]] Result<DrawingLayout> layout_of(const Drawing& drawing, const InkOptions& options);
/// The same from what is known: where the first sample lies, and the rectangle round all.
[[nodiscard]] Result<DrawingLayout> layout_of(Point first, const Frame& frame, const InkOptions& options);

/// The smallest rectangle round all samples. An empty drawing gives an empty frame.
[[nodiscard]] Frame frame_of(const Drawing& drawing);

/// The smallest rectangle of grid pixels round all samples; right and bottom belong to it.
struct GridBox {
    int left = 0, top = 0, right = -1, bottom = -1;
    void take(FixedPoint p);
    [[nodiscard]] bool empty() const { return right < left; }
    friend bool operator==(const GridBox&, const GridBox&) = default;
};
[[nodiscard]] GridBox box_of(const Drawing& drawing, const DrawingLayout& layout);

/// The strokes drawn with a pen that is twice `half` sixteenths of a pixel wide, with `border` pixels on every side of
/// the samples' box. The drawing is not empty. Linear in the drawing's length and in pixels.
[[nodiscard]] Ink ink_of(const Drawing& drawing, const DrawingLayout& layout, std::int64_t half, int border);

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
