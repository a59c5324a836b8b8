#pragma once
// A pattern as one large drawing in millimetres: what is printed and plotted.

#include <string>
#include <vector>

#include "core/garment/pattern/pattern.hpp"

namespace core {

struct SheetLine {
    enum class Style { Cut, Sew, Fold, Grain, Notch, Frame };
    Style style = Style::Cut;
    std::vector<Point> points;  ///< mm from the upper left corner, y down
    bool closed = false;
};

struct SheetText {
    Point at;  ///< the left end of its base line, mm
    double height_mm = 5.0;
    std::string text;
};

struct PatternSheet {
    double width_mm = 0.0, height_mm = 0.0;
    std::vector<SheetLine> lines;
    std::vector<SheetText> texts;
    std::vector<Point> origin_mm;  ///< of each piece: where its (0, 0) lies
};

inline constexpr double kTestSquare_mm = 100.0;

/// All pieces next to each other in rows no wider than `width_cm` (if no piece is wider), 2 cm apart, with a test
/// square and the name above them. Each piece: cut line, sew line, fold, grain with arrow heads, notches, its name, how
/// often it is cut, and a warning where it wants a dart.
[[nodiscard]] PatternSheet lay_out_sheet(const Pattern& pattern, double width_cm);

}  // namespace core
