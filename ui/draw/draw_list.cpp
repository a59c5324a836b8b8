#include "ui/draw/draw_list.hpp"

namespace ui {

void DrawList::text(const FontSet& fonts, const std::string& text, const TextStyle& style, Colour colour, double x,
                    double y, Align align) {
    if (align != Align::Left) x -= fonts.width_px(text, style) * (align == Align::Centre ? 0.5 : 1.0);
    commands.emplace_back(TextCommand{text, style, colour, x, y});
}

}  // namespace ui
