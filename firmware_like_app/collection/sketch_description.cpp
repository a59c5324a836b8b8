#include "firmware_like_app/collection/sketch_description.hpp"

#include "core/silhouette/contour.hpp"
#include "core/silhouette/live_silhouette.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "input/formats/any_ink.hpp"

namespace app {

namespace {

core::Result<SketchDescription> describe_object(const core::BinaryImage& image, core::DrawingRaster raster,
                                                double silhouette_ms, const core::ShapeParameters& parameters) {
    SketchDescription out;
    out.raster = raster;
    const Stopwatch contour_watch;
    const core::Result<core::Polygon> contour = core::largest_contour(image);
    if (!contour) return core::unexpected(contour.error());
    out.silhouette_ms = silhouette_ms + contour_watch.ms();
    const Stopwatch describe_watch;
    core::Result<core::DescribedShape> shape = core::describe_in_steps(*contour, parameters);
    if (!shape) return core::unexpected(shape.error());
    out.shape = std::move(*shape);
    const core::Result<core::ContourDescriptor> whole = core::describe_contour(*contour);
    if (!whole) return core::unexpected(whole.error());
    out.contour = *whole;
    out.describe_ms = describe_watch.ms();
    return out;
}

core::Result<SketchDescription> describe_image(const core::GrayImage& image, const core::ShapeParameters& parameters) {
    const Stopwatch watch;
    const core::InkOptions options;
    const core::GrayImage strength = core::ink_strength(image);
    const core::Result<core::Ink> ink = core::ink_of(strength, core::frame_of(strength, options), options);
    if (!ink) return core::unexpected(ink.error());
    if (ink->filled) return describe_object(core::object_mask(image), {}, watch.ms(), parameters);
    const core::Result<core::Silhouette> silhouette = core::find_silhouette(image, {});
    if (!silhouette) return core::unexpected(silhouette.error());
    return describe_object(silhouette->image, silhouette->raster, watch.ms(), parameters);
}

}  // namespace

core::Result<SketchDescription> describe_drawing(const core::Drawing& drawing,
                                                 const core::ShapeParameters& parameters) {
    const Stopwatch watch;
    core::LiveSilhouette live;  // the same as find_silhouette, and faster
    live.follow(drawing);
    const core::Result<core::Silhouette> silhouette = live.silhouette();
    if (!silhouette) return core::unexpected(silhouette.error());
    return describe_silhouette(*silhouette, watch.ms(), parameters);
}

core::Result<SketchDescription> describe_silhouette(const core::Silhouette& silhouette, double silhouette_ms,
                                                    const core::ShapeParameters& parameters) {
    return describe_object(silhouette.image, silhouette.raster, silhouette_ms, parameters);
}

core::Result<SketchDescription> describe_sketch(const core::Sketch& sketch, const core::ShapeParameters& parameters) {
    return sketch.drawing ? describe_drawing(*sketch.drawing, parameters) : describe_image(*sketch.image, parameters);
}

core::Result<core::Sketch> read_any_sketch(const std::string& path_spec) {
    core::Result<core::Sketch> sketch = core::read_sketch(path_spec);
    if (sketch || sketch.error().code != core::ErrorCode::UnknownFormat) return sketch;
    core::Result<core::Drawing> drawing = input::read_drawing_of_ink(path_spec);
    if (!drawing && drawing.error().code == core::ErrorCode::UnknownFormat) {
        return core::unexpected(core::ErrorCode::UnknownFormat,
                                "this is no drawing that can be read; give PNG, BMP, JPEG, SVG, InkML, Quick-Draw "
                                "NDJSON, a stroke list, a trace or a tablet's recording",
                                path_spec);
    }
    if (!drawing) return core::unexpected(drawing.error());
    core::Sketch out;
    out.drawing = std::move(*drawing);
    return out;
}

core::Result<SketchDescription> describe_file(const std::string& path_spec, const core::ShapeParameters& parameters) {
    const core::Result<core::Sketch> sketch = read_any_sketch(path_spec);
    if (!sketch) return core::unexpected(sketch.error());
    core::Result<SketchDescription> description = describe_sketch(*sketch, parameters);
    if (!description) {
        core::Error error = description.error();
        error.where = path_spec;
        return core::unexpected(std::move(error));
    }
    return description;
}

}  // namespace app
