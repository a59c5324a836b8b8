#pragma once
// Line drawings in SVG: every outline becomes strokes, in document order.
//
// Read: path (all commands), line, polyline, polygon, rect (its corners square), circle, ellipse, nested groups and svg
// elements, transforms. Passed over: what is defined but not drawn (defs, clipPath, mask, marker, pattern, symbol),
// text, pictures, elements with display none. Not read: use, style sheets, percentages (their number is taken as it
// is).

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/stroke/stroke.hpp"

namespace core {

/// y grows down as in SVG; times from a constant pen speed (drawing_builder.hpp). BadFormat when the text is no XML, is
/// longer than 64 MB, nests deeper than 200 elements, is no SVG, or holds a damaged path, point list, transform or
/// length, or a coordinate that is not finite; EmptyDrawing when nothing is drawn. Linear time.
[[nodiscard]] Result<Drawing> parse_svg(std::string_view text);

/// The same from a file; errors name it.
[[nodiscard]] Result<Drawing> read_svg(const std::string& path);

}  // namespace core
