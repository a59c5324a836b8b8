#pragma once
// A plain list of strokes as JSON, easy to write by hand or by any program:
//
//     {"strokes": [{"points": [[x, y], [x, y], …]}, {"points": [[x, y, t_ms, pressure], …]}]}
//
// x and y in any unit, y down; t_ms and pressure (0 … 1) may be left out from the end, and t_ms may be null.

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/stroke/stroke.hpp"

namespace core {

/// BadFormat when the text is no such JSON or is longer than 16 MB; EmptyDrawing when there are no points. Where any
/// point has no time the whole drawing gets a constant pen speed (drawing_builder.hpp). Linear time.
[[nodiscard]] Result<Drawing> parse_stroke_list(std::string_view text);

/// The same from a file; errors name it.
[[nodiscard]] Result<Drawing> read_stroke_list(const std::string& path);

}  // namespace core
