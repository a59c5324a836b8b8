#include "input/formats/any_ink.hpp"

#include <filesystem>
#include <fstream>
#include <utility>

#include "core/exchange/file_bytes.hpp"
#include "core/exchange/sketch_reader.hpp"
#include "input/formats/decode_capture.hpp"
#include "input/pipeline/stroke_builder.hpp"
#include "input/trace/decode_trace.hpp"

namespace input {
namespace {

core::Result<AnyInk> from_trace(const std::string& path) {
    core::Result<Trace> trace = read_trace(path);
    if (!trace) return core::unexpected(trace.error());
    AnyInk ink{std::move(*trace), "trace", {}};
    ink.warning = ink.trace.damage();
    return ink;
}

core::Result<AnyInk> from_capture(const std::string& path, const Capture& capture) {
    const Surroundings around = find_surroundings(path);
    const DecodedCapture decoded = decode_capture(capture, around);
    if (decoded.why_none) return core::unexpected(core::ErrorCode::BadFormat, *decoded.why_none, path);
    AnyInk ink{trace_of_capture(capture, around), std::string(format_name(capture.format)), {}};
    if (decoded.malformed) ink.warning = *decoded.malformed;
    return ink;
}

core::Result<AnyInk> from_drawing(const std::string& path_spec) {
    core::Result<core::Sketch> sketch = core::read_sketch(path_spec);
    if (!sketch) return core::unexpected(sketch.error());
    if (!sketch->drawing) {
        return core::unexpected(
            core::ErrorCode::UnknownFormat,
            "a picture has no strokes; give a trace, a tablet's recording, InkML, SVG or Quick-Draw "
            "line",
            path_spec);
    }
    return AnyInk{trace_of_drawing(*sketch->drawing), "drawing", {}};
}

}  // namespace

core::Result<AnyInk> read_any_ink(const std::string& path_spec) {
    std::error_code missing;
    if (std::filesystem::exists(path_spec, missing)) {
        if (core::Result<void> ordinary = core::check_ordinary_file(path_spec); !ordinary) {
            return core::unexpected(ordinary.error());
        }
    }
    std::ifstream in(path_spec, std::ios::binary);
    std::string start(64, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    if (looks_like_trace(start)) return from_trace(path_spec);
    const core::Result<Capture> capture = read_capture(path_spec);
    if (capture) return from_capture(path_spec, *capture);
    if (capture.error().code == core::ErrorCode::BadFormat) return core::unexpected(capture.error());
    core::Result<AnyInk> drawing = from_drawing(path_spec);
    if (drawing || drawing.error().code != core::ErrorCode::UnknownFormat) return drawing;
    if (path_spec.ends_with(".trace")) return from_trace(path_spec);
    return core::unexpected(
        core::ErrorCode::UnknownFormat,
        "this holds no pen's movements that can be read; give a .trace, hid-recorder, usbhid-dump, evemu "
        "or libinput record output, InkML, SVG or a Quick-Draw line",
        path_spec);
}

core::Result<core::Drawing> read_drawing_of_ink(const std::string& path_spec) {
    const core::Result<AnyInk> ink = read_any_ink(path_spec);
    if (!ink) return core::unexpected(ink.error());
    core::Drawing drawing = drawing_of(strokes_of(decode_trace(ink->trace).samples));
    if (drawing.empty()) return core::unexpected(core::ErrorCode::EmptyDrawing, "no pen draws in this", path_spec);
    return drawing;
}

}  // namespace input
