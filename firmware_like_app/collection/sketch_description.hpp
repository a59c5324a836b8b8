#pragma once
// From a drawing or a picture to its silhouette and both descriptors, with the time each step took.

#include <vector>

#include "core/base/result.hpp"
#include "core/contour/contour_descriptor.hpp"
#include "core/exchange/sketch_reader.hpp"
#include "core/fusion/fused_match.hpp"
#include "core/parts/describe.hpp"
#include "core/silhouette/closing.hpp"

namespace app {

struct SketchDescription {
    core::DescribedShape shape;       ///< the part descriptor with its steps
    core::ContourDescriptor contour;  ///< the second reading of the same outline
    core::DrawingRaster raster;       ///< the descriptor's points, y turned down again, are raster pixels of this
    double silhouette_ms = 0.0;
    double describe_ms = 0.0;

    /// A point of the descriptor in the units of the drawing, y down.
    [[nodiscard]] core::Point to_drawing(core::Point p) const { return raster.to_drawing({p.x, -p.y}); }
};

/// A solid silhouette is taken as it is; line art and strokes are closed and filled (thesis 7.2.2).
/// EmptyDrawing, TooSmall or BadOutline when there is nothing to describe.
[[nodiscard]] core::Result<SketchDescription> describe_sketch(const core::Sketch& sketch,
                                                              const core::ShapeParameters& parameters = {});
[[nodiscard]] core::Result<SketchDescription> describe_drawing(const core::Drawing& drawing,
                                                               const core::ShapeParameters& parameters = {});
/// The same of a silhouette that is known already, and took that long to make.
[[nodiscard]] core::Result<SketchDescription> describe_silhouette(const core::Silhouette& silhouette,
                                                                  double silhouette_ms,
                                                                  const core::ShapeParameters& parameters = {});

/// The same of the readings of one drawing (core/silhouette/drawing_readings.hpp), in order, which together took that
/// long to make: the time is told by the first. Those after the first that cannot be described are left out.
[[nodiscard]] core::Result<std::vector<SketchDescription>> describe_silhouettes(
    const std::vector<core::Silhouette>& readings, double silhouette_ms, const core::ShapeParameters& parameters = {});
/// All readings of a drawing or picture, the one of describe_sketch first.
[[nodiscard]] core::Result<std::vector<SketchDescription>> describe_readings(
    const core::Sketch& sketch, const core::ShapeParameters& parameters = {});

/// A picture, a drawing, or what a pen drew in a trace or a tablet's recording. UnknownFormat naming what can be read.
[[nodiscard]] core::Result<core::Sketch> read_any_sketch(const std::string& path_spec);

/// Reads and describes a file; the path stands in the error's `where`.
[[nodiscard]] core::Result<SketchDescription> describe_file(const std::string& path_spec,
                                                            const core::ShapeParameters& parameters = {});
[[nodiscard]] core::Result<std::vector<SketchDescription>> describe_file_readings(
    const std::string& path_spec, const core::ShapeParameters& parameters = {});

/// Made ready for a search.
[[nodiscard]] std::vector<core::ComparableShape> comparable(const std::vector<SketchDescription>& readings);

}  // namespace app
