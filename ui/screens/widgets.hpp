#pragma once
// Pieces that several screens draw alike: type, buttons, switches, steppers, bars, arcs.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/draw/draw_list.hpp"
#include "ui/gl/context.hpp"
#include "ui/screens/strings.hpp"

namespace ui {

/// Sizes for screens that fill everything: the design's pixels at 1920 × 1080, at 1080 × 1920 where the screen is
/// upright; below that lengths shrink evenly, text to 16 px and targets to 64 px at the least.
struct ScreenScale {
    SizePx screen;
    double scale = 1;
    bool upright = false;

    [[nodiscard]] static ScreenScale of(SizePx screen);
    [[nodiscard]] double px(double design) const;  ///< a length, in whole pixels
    [[nodiscard]] double target(double design) const;
    [[nodiscard]] TextStyle text(Face face, double design, double tracking = 0) const;
    [[nodiscard]] double width() const { return screen.width; }
    [[nodiscard]] double height() const { return screen.height; }
};

/// Distance of the baseline below the middle that centres capitals and figures.
[[nodiscard]] inline double cap_drop(const TextStyle& s) {
    return s.size_px * 0.364;
}
[[nodiscard]] inline Rect scaled(const Rect& r, double by) {
    return {r.centre_x() - r.width * by / 2, r.centre_y() - r.height * by / 2, r.width * by, r.height * by};
}

/// "{a} of {b}" with each name in braces replaced; a name that is not given stays as it is.
[[nodiscard]] std::string filled_in(std::string words, const std::vector<std::pair<std::string, std::string>>& values);
/// 1258 as the language writes it: "group" of its file stands between the thousands.
[[nodiscard]] std::string number_in(const Strings& words, std::int64_t number);
/// One digit after the decimal sign of the language, "decimal" of its file.
[[nodiscard]] std::string tenths_in(const Strings& words, double number);

/// Lines of words centred on x, the first baseline at y; "\n" begins a new line. Returns the y of the line that would
/// come next.
double draw_centred_lines(DrawList& list, const FontSet& fonts, const std::string& text, const TextStyle& style,
                          Colour colour, double x, double y, double width, double line_height);
/// One line, made smaller where it would be wider than that.
void draw_fitted(DrawList& list, const FontSet& fonts, const std::string& text, TextStyle style, Colour colour,
                 double x, double y, double width, Align align);

enum class ButtonKind { Primary, Plain, Destructive, Quiet };
/// `fill`: how far a button that must be held is along, 0 … 1.
void draw_button(DrawList& list, const FontSet& fonts, const Rect& rect, const std::string& words,
                 const TextStyle& style, ButtonKind kind, bool pressed, double line_px, bool on = true,
                 double fill = 0);

/// A row of choices, one of them chosen. `pressed`: the one under the tip.
void draw_switch(DrawList& list, const FontSet& fonts, const Rect& rect, const std::vector<std::string>& words,
                 std::size_t chosen, std::optional<std::size_t> pressed, double size_px);
/// The same by places: as high as the whole switch.
[[nodiscard]] std::vector<Rect> switch_segments(const Rect& rect, std::size_t count);

void draw_bar(DrawList& list, const Rect& rect, double share, Colour fill, Colour ground);

/// A circle's arc or an ellipse's, clockwise from `from` (0: to the right, quarter: down), in radians.
void draw_arc(DrawList& list, double cx, double cy, double rx, double ry, double from, double to, double line_px,
              Colour colour);
void draw_line(DrawList& list, core::Point a, core::Point b, double line_px, Colour colour);

}  // namespace ui
