#pragma once
// Drawings of the Quick, Draw! collection: one JSON object a line, raw or simplified.
//
//     {"word":"horse", …, "drawing":[[[x,…],[y,…],[t ms,…]], …]}
//
// A path may end in ":N" for the N-th line of the file, counted from 0: "horse.ndjson:3".

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/stroke/stroke.hpp"

namespace core {

/// A file and a place in it.
struct LinePath {
    std::string file;
    std::size_t line = 0;
};

/// Splits "file.ndjson:N"; without ":N", or when what follows the last colon is no number, line 0 of the whole path.
[[nodiscard]] LinePath split_line_path(const std::string& path_spec);

/// One line. Coordinates are kept as they are, y down; times become microseconds from the first sample. Where a stroke
/// has no times the whole drawing gets a constant pen speed (drawing_builder.hpp). BadFormat when the line is no JSON,
/// is longer than 16 MB, has no "drawing" or strokes of another shape; EmptyDrawing when there are no points. Linear
/// time.
[[nodiscard]] Result<Drawing> parse_quickdraw_line(std::string_view line);

/// Reads one line of a file of any length, without holding the others in memory. BadArgument when the file has no such
/// line.
[[nodiscard]] Result<Drawing> read_quickdraw(const std::string& path_spec);

}  // namespace core
