#include "core/exchange/sketch_reader.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/exchange/file_bytes.hpp"
#include "core/exchange/image_reader.hpp"
#include "core/exchange/inkml_reader.hpp"
#include "core/exchange/quickdraw_reader.hpp"
#include "core/exchange/stroke_list_reader.hpp"
#include "core/exchange/svg_reader.hpp"

namespace core {
namespace {

enum class Kind { Unknown, Picture, Svg, InkMl, QuickDraw, StrokeList };

Result<Sketch> as_sketch(Result<Drawing> drawing) {
    if (!drawing) return unexpected(drawing.error());
    Sketch sketch;
    sketch.drawing = std::move(*drawing);
    return sketch;
}

Result<Sketch> as_sketch(Result<GrayImage> image) {
    if (!image) return unexpected(image.error());
    Sketch sketch;
    sketch.image = std::move(*image);
    return sketch;
}

Kind kind_by_content(std::string_view start) {
    if (looks_like_image(std::as_bytes(std::span(start)))) return Kind::Picture;
    if (start.starts_with("\xEF\xBB\xBF")) start.remove_prefix(3);
    const std::size_t first = start.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return Kind::Unknown;
    const auto place = [&](std::string_view name) { return std::min(start.find(name), start.size()); };
    if (start[first] == '<') {
        const std::size_t svg = std::min(place("<svg"), place(":svg")), ink = std::min(place("<ink"), place(":ink"));
        if (svg == ink) return Kind::Unknown;
        return svg < ink ? Kind::Svg : Kind::InkMl;
    }
    if (start[first] == '{') {
        const std::size_t quick = place("\"drawing\""), strokes = place("\"strokes\"");
        if (quick == strokes) return Kind::Unknown;
        return quick < strokes ? Kind::QuickDraw : Kind::StrokeList;
    }
    return Kind::Unknown;
}

Kind kind_by_extension(const std::string& path) {
    static constexpr std::array<std::pair<std::string_view, Kind>, 9> kKinds{{{"png", Kind::Picture},
                                                                              {"bmp", Kind::Picture},
                                                                              {"jpg", Kind::Picture},
                                                                              {"jpeg", Kind::Picture},
                                                                              {"svg", Kind::Svg},
                                                                              {"inkml", Kind::InkMl},
                                                                              {"ndjson", Kind::QuickDraw},
                                                                              {"jsonl", Kind::QuickDraw},
                                                                              {"json", Kind::StrokeList}}};
    const std::string extension = lower_extension(path);
    for (const auto& [name, kind] : kKinds) {
        if (name == extension) return kind;
    }
    return Kind::Unknown;
}

/// The first 64 kB of the file; empty when it cannot be read, which its reader then reports.
std::string start_of(const std::string& path) {
    std::string start(std::size_t{1} << 16, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    return start;
}

}  // namespace

Result<Sketch> read_sketch(const std::string& path_spec) {
    std::error_code failure;
    const std::string path = std::filesystem::exists(path_spec, failure) ? path_spec : split_line_path(path_spec).file;
    if (Result<void> ordinary = check_ordinary_file(path); !ordinary) return unexpected(ordinary.error());
    Kind kind = kind_by_content(start_of(path));
    if (kind == Kind::Unknown) kind = kind_by_extension(path);
    switch (kind) {
        case Kind::Picture:
            return as_sketch(read_gray_image(path));
        case Kind::Svg:
            return as_sketch(read_svg(path));
        case Kind::InkMl:
            return as_sketch(read_inkml(path));
        case Kind::QuickDraw:
            return as_sketch(read_quickdraw(path_spec));
        case Kind::StrokeList:
            return as_sketch(read_stroke_list(path));
        case Kind::Unknown:
            break;
    }
    return unexpected(
        ErrorCode::UnknownFormat,
        "this is no drawing that can be read; give PNG, BMP, JPEG, SVG, InkML, Quick-Draw NDJSON or a stroke list",
        path);
}

}  // namespace core
