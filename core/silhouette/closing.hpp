#pragma once
// From line art to one closed, filled silhouette, relative to the drawing's own size (thesis 7.2.2).
//
//     const core::Result<core::Silhouette> s = core::find_silhouette(drawing, {});
//     const core::Point on_the_sheet = s->raster.to_drawing({x_px, y_px});
//
// The thesis erodes and fills with one fixed element. A fixed element that closes the gaps of a large outline also
// fills the space between two legs, so here the gap allowed grows with the region behind it: for a series of radii r up
// to the closing radius, a region that no disc of radius r can leave, and that holds such a disc, is filled. Parallel
// limbs are never joined by this, however near; strokes that enclose nothing stay as lines of the pen's width.

#include "core/base/result.hpp"
#include "core/silhouette/image.hpp"
#include "core/silhouette/ink.hpp"
#include "core/stroke/stroke.hpp"

namespace core {

/// Shares are of the diagonal of the drawing's own rectangle.
struct SilhouetteOptions {
    InkOptions ink;
    double closing_share = 0.07;  ///< largest radius r: gaps up to twice this share are closed
    double room =
        1.6;  ///< the region behind a gap of 2 r must hold a disc of radius room * r at the largest r, less below
    double joining_share = 0.03;  ///< a separate piece this near to the object is joined to it by a stroke
    double stray_share = 0.06;    ///< separate pieces with a smaller diagonal are stray marks and never joined
};

struct Silhouette {
    BinaryImage image;     ///< one 8-connected object of 1s without holes, free of the border by the margin
    DrawingRaster raster;  ///< raster pixels <-> the drawing's units, or the picture's pixels
};

/// The silhouette of what is drawn. A picture that is a solid silhouette already only loses its holes and lesser
/// objects. Where the object fills less than 0.7 of the raster, because stray marks lie far off, it is found again on
/// its own. EmptyDrawing for an empty page, TooSmall for a dot; a single line gives a thin silhouette. y grows down.
/// About 15 ms for the default raster on one core.
[[nodiscard]] Result<Silhouette> find_silhouette(const Drawing& drawing, const SilhouetteOptions& options);
[[nodiscard]] Result<Silhouette> find_silhouette(const GrayImage& page, const SilhouetteOptions& options);

/// The image of find_silhouette alone.
[[nodiscard]] Result<BinaryImage> silhouette_of(const Drawing& drawing, const SilhouetteOptions& options = {});
[[nodiscard]] Result<BinaryImage> silhouette_of(const GrayImage& page, const SilhouetteOptions& options = {});

}  // namespace core
