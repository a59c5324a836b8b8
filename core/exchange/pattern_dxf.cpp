#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <set>

#include "core/exchange/pattern_files.hpp"

namespace core {
namespace {

enum Layer { kCut = 1, kTurn = 2, kCurve = 3, kNotch = 4, kFold = 6, kGrain = 7, kSew = 14, kText = 15 };
constexpr std::array<int, 8> kLayers{kCut, kTurn, kCurve, kNotch, kFold, kGrain, kSew, kText};
constexpr double kTextHeight_mm = 5.0;

class DxfText {
  public:
    void pair(int code, const std::string& value) { text_ += std::to_string(code) + "\n" + value + "\n"; }
    void pair(int code, int value) { pair(code, std::to_string(value)); }
    void pair(int code, double value) {
        std::array<char, 32> digits{};
        std::snprintf(digits.data(), digits.size(), "%.4f", value + 0.0);
        pair(code, std::string(digits.data()));
    }
    void place(Point mm, int first = 10) {
        pair(first, mm.x);
        pair(first + 10, mm.y);
        pair(first + 20, 0.0);
    }
    void entity(const char* kind, int layer) {
        pair(0, std::string(kind));
        pair(8, layer);
    }
    void point(int layer, Point mm) {
        entity("POINT", layer);
        place(mm);
    }
    void line(int layer, Point from, Point to) {
        entity("LINE", layer);
        place(from);
        place(to, 11);
    }
    void polyline(int layer, const std::vector<Point>& points, bool closed) {
        entity("POLYLINE", layer);
        pair(66, 1);
        place({});
        pair(70, closed ? 1 : 0);
        for (const Point p : points) {
            entity("VERTEX", layer);
            place(p);
        }
        entity("SEQEND", layer);
    }
    void words(Point mm, const std::string& words) {
        entity("TEXT", kText);
        place(mm);
        pair(40, kTextHeight_mm);
        pair(1, words);
    }
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    std::string text_;
};

std::vector<Point> in_mm(const std::vector<Point>& cm) {
    std::vector<Point> out;
    out.reserve(cm.size());
    for (const Point p : cm) out.push_back(p * 10.0);
    return out;
}

/// Letters, digits, "_" and "-", each name once.
std::vector<std::string> block_names(const Pattern& pattern) {
    std::vector<std::string> names;
    std::set<std::string> used;
    for (const PatternPiece& piece : pattern.pieces) {
        std::string name;
        for (const char c : piece.name) name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
        if (name.empty()) name = "piece";
        std::string free = name;
        for (int k = 2; !used.insert(free).second; ++k) free = name + "_" + std::to_string(k);
        names.push_back(free);
    }
    return names;
}

/// Texts of other letters are no part of DXF R12.
std::string plain(const std::string& text) {
    std::string out;
    for (const char c : text) out += c >= ' ' && c <= '~' ? c : '_';
    return out;
}

void add_header(DxfText& out) {
    for (const auto& [code, value] :
         {std::pair(0, "SECTION"), std::pair(2, "HEADER"), std::pair(9, "$ACADVER"), std::pair(1, "AC1009"),
          std::pair(9, "$MEASUREMENT"), std::pair(70, "1"), std::pair(0, "ENDSEC"), std::pair(0, "SECTION"),
          std::pair(2, "TABLES"), std::pair(0, "TABLE"), std::pair(2, "LAYER")})
        out.pair(code, std::string(value));
    out.pair(70, static_cast<int>(kLayers.size()));
    for (const int layer : kLayers) {
        out.pair(0, std::string("LAYER"));
        out.pair(2, layer);
        out.pair(70, 0);
        out.pair(62, 7);
        out.pair(6, std::string("CONTINUOUS"));
    }
    out.pair(0, std::string("ENDTAB"));
    out.pair(0, std::string("ENDSEC"));
}

void add_block(DxfText& out, const Pattern& pattern, const PatternPiece& piece, const std::string& name) {
    out.entity("BLOCK", kCut);
    out.pair(2, name);
    out.pair(70, 0);
    out.place({});
    out.pair(3, name);
    out.polyline(kCut, in_mm(piece.cut_line), true);
    for (const PatternSide& side : piece.sides) {
        const std::vector<Point> line = in_mm(side.line);
        out.polyline(kSew, line, false);
        out.point(kTurn, line.front());
        for (std::size_t i = 1; i + 1 < line.size(); ++i) out.point(kCurve, line[i]);
        if (side.kind == PatternSide::Kind::Fold) out.line(kFold, line.front(), line.back());
    }
    for (const PatternNotch& notch : piece.notches) out.point(kNotch, notch.at * 10.0);
    out.line(kGrain, piece.grain[0] * 10.0, piece.grain[1] * 10.0);
    Point at = (piece.grain[0] + piece.grain[1]) * 5.0 + Point{3.0, 0.0};
    for (const std::string& words : {"Piece Name: " + plain(piece.name), "Quantity: " + std::to_string(piece.copies),
                                     "Style Name: " + plain(pattern.name), std::string("Units: METRIC, millimetres")}) {
        out.words(at, words);
        at.y -= 1.5 * kTextHeight_mm;
    }
    out.entity("ENDBLK", kCut);
}

}  // namespace

std::string pattern_dxf(const Pattern& pattern, const PatternSheet& sheet) {
    DxfText out;
    add_header(out);
    const std::vector<std::string> names = block_names(pattern);
    out.pair(0, std::string("SECTION"));
    out.pair(2, std::string("BLOCKS"));
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) add_block(out, pattern, pattern.pieces[p], names[p]);
    out.pair(0, std::string("ENDSEC"));
    out.pair(0, std::string("SECTION"));
    out.pair(2, std::string("ENTITIES"));
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
        out.entity("INSERT", kCut);
        out.pair(2, names[p]);
        out.place({sheet.origin_mm[p].x, sheet.height_mm - sheet.origin_mm[p].y});
    }
    out.pair(0, std::string("ENDSEC"));
    out.pair(0, std::string("EOF"));
    return out.text();
}

}  // namespace core
