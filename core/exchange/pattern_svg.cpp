#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/exchange/pattern_files.hpp"

namespace core {
namespace {

using Style = SheetLine::Style;

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3f", value + 0.0);
    return text.data();
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (static_cast<unsigned char>(c) >= ' ')
            out += c;
    }
    return out;
}

const char* look_of(Style style) {
    switch (style) {
        case Style::Cut:
            return "class=\"cut\" stroke-width=\"0.5\"";
        case Style::Sew:
            return "class=\"sew\" stroke-width=\"0.3\" stroke-dasharray=\"4 2\"";
        case Style::Fold:
            return "class=\"fold\" stroke-width=\"0.5\" stroke-dasharray=\"0.5 2\" stroke-linecap=\"round\"";
        case Style::Grain:
            return "class=\"grain\" stroke-width=\"0.4\"";
        case Style::Notch:
            return "class=\"notch\" stroke-width=\"0.6\"";
        case Style::Frame:
            break;
    }
    return "class=\"frame\" stroke-width=\"0.2\"";
}

std::string path_data(const std::vector<Point>& points, bool closed) {
    std::string data;
    for (std::size_t i = 0; i < points.size(); ++i)
        data += (i == 0 ? "M" : " L") + number(points[i].x) + "," + number(points[i].y);
    return closed ? data + " Z" : data;
}

std::string head(const PatternSheet& sheet) {
    const std::string w = number(sheet.width_mm), h = number(sheet.height_mm);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w +
           "mm\" height=\"" + h + "mm\" viewBox=\"0 0 " + w + " " + h + "\">\n";
}

std::string texts_of(const PatternSheet& sheet) {
    std::string out = "<g font-family=\"sans-serif\" fill=\"black\">\n";
    for (const SheetText& t : sheet.texts)
        out += "<text x=\"" + number(t.at.x) + "\" y=\"" + number(t.at.y) + "\" font-size=\"" + number(t.height_mm) +
               "\">" + escaped(t.text) + "</text>\n";
    return out + "</g>\n";
}

/// From white over yellow to red.
std::string colour_of(double strain) {
    constexpr double kYellow = 0.02;
    const double to_yellow = std::clamp(strain / kYellow, 0.0, 1.0),
                 to_red = std::clamp((strain - kYellow) / (kDartStrain - kYellow), 0.0, 1.0);
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", to_red > 0.0 ? 255 - static_cast<int>(45.0 * to_red) : 255,
                  static_cast<int>(std::lround(255.0 - 25.0 * to_yellow - 190.0 * to_red)),
                  static_cast<int>(std::lround(255.0 - 175.0 * to_yellow - 40.0 * to_red)));
    return text.data();
}

}  // namespace

std::string sheet_svg(const PatternSheet& sheet) {
    std::string out = head(sheet) + "<g fill=\"none\" stroke=\"black\" stroke-linejoin=\"round\">\n";
    for (const SheetLine& line : sheet.lines)
        out += std::string("<path ") + look_of(line.style) + " d=\"" + path_data(line.points, line.closed) + "\"/>\n";
    return out + "</g>\n" + texts_of(sheet) + "</svg>\n";
}

std::string strain_svg(const Pattern& pattern, const PatternSheet& sheet) {
    std::string out = head(sheet) + "<g stroke=\"#00000030\" stroke-width=\"0.2\">\n";
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
        const PatternPiece& piece = pattern.pieces[p];
        const auto at = [&](Point q) {
            return Point{sheet.origin_mm[p].x + 10.0 * q.x, sheet.origin_mm[p].y - 10.0 * q.y};
        };
        for (std::size_t i = 0; i < piece.quads.size(); ++i) {
            const auto& q = piece.quads[i];
            out += "<path fill=\"" + colour_of(piece.strain[i]) + "\" d=\"" +
                   path_data({at(q[0]), at(q[1]), at(q[2]), at(q[3])}, true) + "\"/>\n";
        }
        if (piece.high_strain <= kDartStrain) continue;
        const Point dart = at(piece.most_strained);
        out += "<circle cx=\"" + number(dart.x) + "\" cy=\"" + number(dart.y) +
               "\" r=\"12\" fill=\"none\" stroke=\"black\" stroke-width=\"1\"/>\n";
    }
    return out + "</g>\n" + texts_of(sheet) + "</svg>\n";
}

}  // namespace core
