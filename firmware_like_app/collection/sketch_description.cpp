#include "firmware_like_app/collection/sketch_description.hpp"

#include "core/silhouette/contour.hpp"
#include "core/silhouette/drawing_readings.hpp"
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

/// Whether a picture is a solid silhouette already; the errors of core::ink_of.
core::Result<bool> is_solid(const core::GrayImage& image) {
    const core::InkOptions options;
    const core::GrayImage strength = core::ink_strength(image);
    const core::Result<core::Ink> ink = core::ink_of(strength, core::frame_of(strength, options), options);
    if (!ink) return core::unexpected(ink.error());
    return ink->filled;
}

core::Result<SketchDescription> describe_image(const core::GrayImage& image, const core::ShapeParameters& parameters) {
    const Stopwatch watch;
    const core::Result<bool> solid = is_solid(image);
    if (!solid) return core::unexpected(solid.error());
    if (*solid) return describe_object(core::object_mask(image), {}, watch.ms(), parameters);
    const core::Result<core::Silhouette> silhouette = core::find_silhouette(image, {});
    if (!silhouette) return core::unexpected(silhouette.error());
    return describe_object(silhouette->image, silhouette->raster, watch.ms(), parameters);
}

core::Result<std::vector<core::Silhouette>> readings_of(const core::Sketch& sketch) {
    if (!sketch.drawing) return core::drawing_readings(*sketch.image);
    return core::LiveReadings().all(*sketch.drawing);  // the same as drawing_readings, and faster
}

/// The error says which file.
template <typename T>
core::Result<T> of_file(core::Result<T> described, const std::string& path_spec) {
    if (described) return described;
    core::Error error = described.error();
    error.where = path_spec;
    return core::unexpected(std::move(error));
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

core::Result<std::vector<SketchDescription>> describe_silhouettes(const std::vector<core::Silhouette>& readings,
                                                                  double silhouette_ms,
                                                                  const core::ShapeParameters& parameters) {
    std::vector<SketchDescription> described;
    for (const core::Silhouette& reading : readings) {
        core::Result<SketchDescription> one = describe_silhouette(reading, silhouette_ms, parameters);
        if (one) {
            described.push_back(std::move(*one));
        } else if (described.empty()) {
            return core::unexpected(one.error());
        }
        silhouette_ms = 0.0;
    }
    return described;
}

core::Result<std::vector<SketchDescription>> describe_readings(const core::Sketch& sketch,
                                                               const core::ShapeParameters& parameters) {
    const Stopwatch watch;
    if (sketch.image) {
        const core::Result<bool> solid = is_solid(*sketch.image);
        if (!solid) return core::unexpected(solid.error());
        if (*solid) {
            core::Result<SketchDescription> only = describe_image(*sketch.image, parameters);
            if (!only) return core::unexpected(only.error());
            std::vector<SketchDescription> one;
            one.push_back(std::move(*only));
            return one;
        }
    }
    const core::Result<std::vector<core::Silhouette>> readings = readings_of(sketch);
    if (!readings) return core::unexpected(readings.error());
    return describe_silhouettes(*readings, watch.ms(), parameters);
}

core::Result<SketchDescription> describe_file(const std::string& path_spec, const core::ShapeParameters& parameters) {
    const core::Result<core::Sketch> sketch = read_any_sketch(path_spec);
    if (!sketch) return core::unexpected(sketch.error());
    return of_file(describe_sketch(*sketch, parameters), path_spec);
}

core::Result<std::vector<SketchDescription>> describe_file_readings(const std::string& path_spec,
                                                                    const core::ShapeParameters& parameters) {
    const core::Result<core::Sketch> sketch = read_any_sketch(path_spec);
    if (!sketch) return core::unexpected(sketch.error());
    return of_file(describe_readings(*sketch, parameters), path_spec);
}

std::vector<core::ComparableShape> comparable(const std::vector<SketchDescription>& readings) {
    std::vector<core::ComparableShape> shapes;
    shapes.reserve(readings.size());
    for (const SketchDescription& reading : readings) {
        shapes.push_back(core::comparable(reading.shape.descriptor, reading.contour));
    }
    return shapes;
}

}  // namespace app
