#pragma once
// Strokes for other programs: InkML (W3C, 2011), SVG, and a line of the Quick, Draw! collection.

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "input/pipeline/stroke_builder.hpp"

namespace input {

/// Channels X and Y in mm (in thousandths of the area where the device has no size), T in microseconds from the first
/// sample, F from 0 to 1, and where every sample has them OTx and OTy in degrees. Reading it with core::parse_inkml
/// gives the drawing that drawing_of() makes.
[[nodiscard]] std::string inkml_text(const std::vector<PenStroke>& strokes);

/// One path a stroke, in mm, as wide as a fine pen, with a margin around what is drawn.
[[nodiscard]] std::string svg_text(const std::vector<PenStroke>& strokes);

/// {"word":"","drawing":[[[x…],[y…],[ms…]]…]}
[[nodiscard]] std::string quickdraw_text(const std::vector<PenStroke>& strokes);

/// Writes the text under a name of its own first, so that `path` is whole or what it was. WriteFailed naming the file.
[[nodiscard]] core::Result<void> write_whole_file(const std::string& path, const std::string& text);

}  // namespace input
