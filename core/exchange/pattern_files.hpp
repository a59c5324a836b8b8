#pragma once
// Patterns as files: SVG and tiled PDF at 1:1, DXF after AAMA, seams as JSON, a map of strain.
//
//     core::write_pattern_folder("out", pattern);     // pattern.svg, pattern-a4.pdf, …, pattern.dxf, seams.json, …

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/pattern/sheet.hpp"

namespace core {

/// The sheet as SVG, one unit a millimetre.
[[nodiscard]] std::string sheet_svg(const PatternSheet& sheet);

/// Width of fabric that pieces are laid out on.
inline constexpr double kFabricWidth_cm = 140.0;

struct PaperSize {
    const char* name;
    double width_mm, height_mm;
};
inline constexpr PaperSize kA4{"a4", 210.0, 297.0}, kA3{"a3", 297.0, 420.0}, kLetter{"letter", 215.9, 279.4};

/// What a page keeps free at each edge, and by how much neighbouring pages overlap.
inline constexpr double kPageMargin_mm = 10.0, kPageOverlap_mm = 10.0;

/// The sheet on as many pages as it takes, in rows, pages that nothing would be on left out. Each page: its row and
/// column, a frame, and crosses where the neighbours' crosses come to lie. The same sheet gives the same bytes.
[[nodiscard]] Result<std::string> sheet_pdf(const PatternSheet& sheet, const PaperSize& paper);

/// DXF R12 in millimetres, one block a piece after ANSI/AAMA-292: layer 1 cut line, 2 turn points, 3 curve points, 4
/// notches, 6 fold, 7 grain, 14 sew line, 15 texts. Blocks are named as their pieces, letters that DXF does not take
/// replaced by "_".
[[nodiscard]] std::string pattern_dxf(const Pattern& pattern, const PatternSheet& sheet);

/// Pieces, sides with their lengths, seams with both lengths and mismatch, strain. Lengths in millimetres.
[[nodiscard]] std::string pattern_json(const Pattern& pattern);

/// All pieces, their quads coloured from white (no strain) over yellow (2 %) to red (kDartStrain and more); a circle
/// where a dart is wanted.
[[nodiscard]] std::string strain_svg(const Pattern& pattern, const PatternSheet& sheet);

/// pattern.svg, pattern-a4.pdf, pattern-a3.pdf, pattern-letter.pdf, pattern.dxf, seams.json, strain.svg in a folder,
/// which is made if it is not there. Gives the paths. ErrorCode::WriteFailed with the file at fault.
[[nodiscard]] Result<std::vector<std::string>> write_pattern_folder(const std::filesystem::path& folder,
                                                                    const Pattern& pattern);

}  // namespace core
