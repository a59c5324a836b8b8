#include "core/garment/pattern/sheet.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace core {
namespace {

constexpr double kGap_mm = 20.0, kMargin_mm = 5.0, kHead_mm = kTestSquare_mm + 2.0 * kMargin_mm + 10.0;
constexpr double kArrow_mm = 5.0, kNotch_mm = 5.0;
using Style = SheetLine::Style;

struct Box {
    Point low{1e300, 1e300}, high{-1e300, -1e300};
    void add(Point p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
};

Box box_of(const PatternPiece& piece) {
    Box box;
    for (const Point p : piece.cut_line) box.add(p);
    for (const PatternSide& side : piece.sides)
        for (const Point p : side.line) box.add(p);
    return box;
}

std::string cut_text(const PatternPiece& piece) {
    if (piece.on_fold) return "cut 1 on the fold";
    return piece.copies == 2 ? "cut 2, one mirrored" : "cut 1";
}

/// Draws one piece; its (0, 0) comes to lie at `origin`.
class PieceDrawer {
  public:
    PieceDrawer(const PatternPiece& piece, Point origin, PatternSheet& sheet)
        : piece_(piece), origin_(origin), sheet_(sheet) {}

    void draw() {
        add(Style::Cut, piece_.cut_line, true);
        for (const PatternSide& side : piece_.sides)
            add(side.kind == PatternSide::Kind::Fold ? Style::Fold : Style::Sew, side.line, false);
        for (const PatternNotch& n : piece_.notches)
            add(Style::Notch, {n.at, n.at + n.outward * (0.1 * kNotch_mm)}, false);
        const auto& [low, high] = piece_.grain;
        add(Style::Grain, {low, high}, false);
        const double a = 0.1 * kArrow_mm;
        add(Style::Grain, {high + Point{-0.5 * a, -a}, high, high + Point{0.5 * a, -a}}, false);
        add(Style::Grain, {low + Point{-0.5 * a, a}, low, low + Point{0.5 * a, a}}, false);
        write();
    }

  private:
    [[nodiscard]] Point at(Point p) const { return {origin_.x + 10.0 * p.x, origin_.y - 10.0 * p.y}; }

    void add(Style style, const std::vector<Point>& points, bool closed) {
        SheetLine line{style, {}, closed};
        for (const Point p : points) line.points.push_back(at(p));
        sheet_.lines.push_back(std::move(line));
    }

    /// Beside the grain line, in letters that fit the piece.
    void write() {
        const Box box = box_of(piece_);
        const double height = std::clamp(0.35 * (box.high.x - box.low.x), 2.5, 7.0);
        Point where = at((piece_.grain[0] + piece_.grain[1]) * 0.5) + Point{2.0, -height};
        for (const std::string& text : {piece_.name, cut_text(piece_), strain_text()}) {
            if (text.empty()) continue;
            sheet_.texts.push_back({where, height, text});
            where.y += 1.3 * height;
        }
    }

    [[nodiscard]] std::string strain_text() const {
        if (piece_.high_strain <= kDartStrain) return {};
        std::array<char, 64> text{};
        std::snprintf(text.data(), text.size(), "strain up to %.0f %%: wants a dart", 100.0 * piece_.high_strain);
        return text.data();
    }

    const PatternPiece& piece_;
    Point origin_;
    PatternSheet& sheet_;
};

void draw_head(const Pattern& pattern, PatternSheet& sheet) {
    const double m = kMargin_mm, s = kTestSquare_mm;
    sheet.lines.push_back({Style::Frame, {{m, m}, {m + s, m}, {m + s, m + s}, {m, m + s}}, true});
    sheet.texts.push_back({{m + 4.0, m + 0.5 * s}, 5.0, "test square: 100 mm"});
    sheet.texts.push_back({{m + s + 8.0, m + 12.0}, 9.0, pattern.name});
    sheet.texts.push_back({{m + s + 8.0, m + 24.0}, 5.0, "full line: cut"});
    sheet.texts.push_back({{m + s + 8.0, m + 32.0}, 5.0, "dashed: sew"});
    sheet.texts.push_back({{m + s + 8.0, m + 40.0}, 5.0, "dots: fold"});
}

}  // namespace

PatternSheet lay_out_sheet(const Pattern& pattern, double width_cm) {
    PatternSheet sheet;
    draw_head(pattern, sheet);
    double widest = kTestSquare_mm + 2.0 * kMargin_mm + 80.0;
    double x = kMargin_mm, top = kHead_mm, row = 0.0;
    for (const PatternPiece& piece : pattern.pieces) {
        const Box box = box_of(piece);
        const double wide = 10.0 * (box.high.x - box.low.x), high = 10.0 * (box.high.y - box.low.y);
        if (x > kMargin_mm && x + wide + kMargin_mm > 10.0 * width_cm) x = kMargin_mm, top += row + kGap_mm, row = 0.0;
        const Point origin{x - 10.0 * box.low.x, top + 10.0 * box.high.y};
        PieceDrawer(piece, origin, sheet).draw();
        sheet.origin_mm.push_back(origin);
        x += wide + kGap_mm;
        row = std::max(row, high);
        widest = std::max(widest, x - kGap_mm + kMargin_mm);
    }
    sheet.width_mm = widest;
    sheet.height_mm = top + row + kMargin_mm;
    return sheet;
}

}  // namespace core
