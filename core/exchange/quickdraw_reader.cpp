#include "core/exchange/quickdraw_reader.hpp"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/exchange/drawing_builder.hpp"
#include "core/exchange/file_bytes.hpp"

namespace core {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxLineBytes = std::size_t{16} << 20;

Unexpected bad(std::string why, const std::string& where = {}) {
    return unexpected(ErrorCode::BadFormat, std::move(why), where);
}

bool all_numbers(const Json& values) {
    if (!values.is_array()) return false;
    for (const Json& value : values) {
        if (!value.is_number()) return false;
    }
    return true;
}

bool is_stroke(const Json& stroke) {
    if (!stroke.is_array() || stroke.size() < 2) return false;
    const std::size_t columns = std::min<std::size_t>(stroke.size(), 3);
    for (std::size_t i = 0; i < columns; ++i) {
        if (!all_numbers(stroke[i]) || stroke[i].size() != stroke[0].size()) return false;
    }
    return true;
}

void add_stroke(DrawingBuilder& builder, const Json& stroke) {
    builder.begin_stroke();
    const bool timed = stroke.size() > 2;
    for (std::size_t i = 0; i < stroke[0].size(); ++i) {
        const auto time_us = timed ? std::optional(stroke[2][i].get<double>() * 1000.0) : std::nullopt;
        if (!builder.add(stroke[0][i].get<double>(), stroke[1][i].get<double>(), time_us)) return;
    }
}

/// The line's text, or an error; `in` stands at the start of the file.
Result<std::string> line_of(std::istream& in, const LinePath& path) {
    const auto no_such_line = [&](std::size_t lines) {
        return unexpected(ErrorCode::BadArgument,
                          "the file has " + std::to_string(lines) + (lines == 1 ? " line" : " lines") +
                              ", so there is no line " + std::to_string(path.line) + "; lines count from 0",
                          path.file);
    };
    for (std::size_t i = 0; i < path.line; ++i) {
        in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        if (in.eof()) return no_such_line(i + (in.gcount() > 0 ? 1 : 0));
    }
    std::string line;
    for (int c = in.get(); c != std::char_traits<char>::eof() && c != '\n'; c = in.get()) {
        if (line.size() >= kMaxLineBytes)
            return bad("the line is longer than 16 MB; give a smaller drawing", path.file);
        line.push_back(static_cast<char>(c));
    }
    if (line.empty() && in.eof()) return no_such_line(path.line);
    return line;
}

}  // namespace

LinePath split_line_path(const std::string& path_spec) {
    const std::size_t colon = path_spec.rfind(':');
    if (colon == std::string::npos || colon + 1 == path_spec.size()) return {path_spec, 0};
    std::size_t line = 0;
    const char* end = path_spec.data() + path_spec.size();
    const auto [rest, failure] = std::from_chars(path_spec.data() + colon + 1, end, line);
    if (failure != std::errc() || rest != end) return {path_spec, 0};
    return {path_spec.substr(0, colon), line};
}

Result<Drawing> parse_quickdraw_line(std::string_view line) {
    if (line.size() > kMaxLineBytes) return bad("the line is longer than 16 MB; give a smaller drawing");
    const Json document = Json::parse(line, nullptr, false);
    if (document.is_discarded() || !document.is_object()) {
        return bad("the line is no JSON object; give a line of a Quick, Draw! file");
    }
    const auto drawing = document.find("drawing");
    if (drawing == document.end() || !drawing->is_array()) {
        return bad("the line has no \"drawing\" list; give a line of a Quick, Draw! file");
    }
    DrawingBuilder builder;
    for (const Json& stroke : *drawing) {
        if (!is_stroke(stroke)) {
            return bad("a stroke of the drawing is not [[x, …], [y, …]] with an optional [t, …] of equal length");
        }
        add_stroke(builder, stroke);
    }
    return std::move(builder).finish();
}

Result<Drawing> read_quickdraw(const std::string& path_spec) {
    std::error_code failure;
    const LinePath path =
        std::filesystem::exists(path_spec, failure) ? LinePath{path_spec, 0} : split_line_path(path_spec);
    if (Result<void> ordinary = check_ordinary_file(path.file); !ordinary) return unexpected(ordinary.error());
    std::ifstream in(path.file, std::ios::binary);
    const Result<std::string> line = line_of(in, path);
    if (!line) return unexpected(line.error());
    Result<Drawing> drawing = parse_quickdraw_line(*line);
    if (!drawing) return unexpected(drawing.error().code, drawing.error().message, path_spec);
    return drawing;
}

}  // namespace core
