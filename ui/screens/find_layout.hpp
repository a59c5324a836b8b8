#pragma once
// Where everything of Find stands, for a size of screen and a drawing hand (design table "Grid and regions").

#include <array>

#include "ui/draw/palette.hpp"
#include "ui/gl/context.hpp"
#include "ui/screens/card_rail.hpp"

namespace ui {

enum class Hand { Right, Left };
inline constexpr int kToolCount = 5;  ///< Pen, Eraser, Undo, Redo, New

/// All in pixels of the screen.
struct FindLayout {
    SizePx screen;
    Hand hand = Hand::Right;
    bool compact = false;  ///< the arrangement for screens below 1920 × 1080
    bool upright = false;  ///< the board above the sheet
    double scale = 1;      ///< pixels per pixel of the design picture of this arrangement
    Rect board, sheet, header, footer;
    double wordmark_baseline = 0;
    Rect mode_switch;                    ///< Find / Garment, in the header
    std::array<Rect, kCardCount> cards;  ///< the best one first, then row by row
    std::array<Rect, kCardCount> card_pictures;
    std::array<Rect, kToolCount> tools;
    std::array<Rect, 2> dividers;  ///< after Eraser and after Redo; without size where there is none
    Rect language, hand_switch;
    double ink_width_px = 7.5;  ///< at full pressure

    /// A length of the design on this screen.
    [[nodiscard]] double px(double design) const { return design * scale; }
};

/// 1920 × 1080 and larger: the wide arrangement, scaled by the smaller ratio. Smaller screens: that of 1280 × 800.
/// Upright screens: the board above the sheet, by the ratio to 1080 × 1920; the hand swaps the ends of the tools' row.
/// Left-handed, the board's blocks stand at width − x − their width; what is inside a block keeps its reading order.
[[nodiscard]] FindLayout find_layout(SizePx screen, Hand hand);

}  // namespace ui
