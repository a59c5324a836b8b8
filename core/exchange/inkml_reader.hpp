#pragma once
// Digital ink in InkML (W3C, 2011): every <trace> of the document is a stroke.
//
// Read: channels in the order of the first <traceFormat> (X and Y without one), X and Y in any order among others, T in
// s, ms or us (ms where it has no unit), F or Pressure scaled by its "max" (or by the largest value found); points
// separated by commas, values by white space or by their own signs; the prefixes ! (explicit), ' (difference) and "
// (difference of differences), which hold until another prefix comes; * (as the last value) and ? (no value). Traces of
// type "penUp" are passed over. Not read: transforms of a canvas, references to other files, traceView.

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/stroke/stroke.hpp"

namespace core {

/// y is taken as growing down, as tablets report it. BadFormat when the text is no XML, is longer than 64 MB, nests
/// deeper than 200 elements, has no channels X and Y, or a trace holds something else than such values; EmptyDrawing
/// when it has no trace with points. Linear time.
[[nodiscard]] Result<Drawing> parse_inkml(std::string_view text);

/// The same from a file; errors name it.
[[nodiscard]] Result<Drawing> read_inkml(const std::string& path);

}  // namespace core
