#pragma once
// Where a card's name stands, and how the model makes room for it.

#include <cstddef>
#include <string>
#include <vector>

#include "ui/draw/fonts.hpp"
#include "ui/draw/model_painter.hpp"
#include "ui/screens/find_layout.hpp"

namespace ui {

inline constexpr double kNameLineHeight = 1.2;  ///< of its size, where a name takes two lines

/// The lines of text on a card, in pixels from its top left corner.
struct CardText {
    TextStyle name, caption;
    double x = 0, name_baseline = 0, caption_baseline = 0;
    double most_px = 0;      ///< no line is wider
    bool captioned = false;  ///< whether there is a second, quiet line
};
[[nodiscard]] CardText card_text(const FindLayout& layout, std::size_t card);

/// One card's name and picture together.
struct CardPlace {
    std::vector<std::string> name;  ///< one line, or two on a small card
    ModelPictureOptions picture;
};
/// The model as large as its card lets it be while no line of text lies on it: beside the name, leaning away from it,
/// beside a name of two lines, or else below it. A name that is wider than the card ends in an ellipsis.
[[nodiscard]] CardPlace place_on_card(const FontSet& fonts, const FindLayout& layout, std::size_t card,
                                      const std::string& name, const std::string& caption, const CardModel& model);

}  // namespace ui
