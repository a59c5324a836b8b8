#pragma once
// Where everything of Garment stands, for a size of screen and a drawing hand (design table "Grid and regions").

#include <array>

#include "ui/draw/palette.hpp"
#include "ui/gl/context.hpp"
#include "ui/screens/find_layout.hpp"

namespace ui {

inline constexpr int kGarmentSlots = 8;  ///< tools of one page of the grid, without Undo and Redo
inline constexpr int kGarmentTiles = 4;  ///< small views: Front, Side, Back, 3D
inline constexpr int kGarmentRows = 3;   ///< rows of the list that are seen at once
inline constexpr int kGarmentPages = 3;  ///< of the tools: drawing, shaping, the design as a whole
inline constexpr int kBodySliders = 7;   ///< measures of the drawer

/// All in pixels of the screen.
struct GarmentLayout {
    SizePx screen;
    Hand hand = Hand::Right;
    bool compact = false;  ///< the arrangement for screens below 1920 × 1080
    bool upright = false;  ///< the board above the sheet; layers and folds are in a drawer
    double scale = 1;      ///< pixels per pixel of the design picture of this arrangement
    Rect board, sheet;
    double wordmark_x = 0, wordmark_baseline = 0;
    Rect mode_switch;

    std::array<Rect, kGarmentSlots> tools;  ///< row by row, two in a row
    Rect undo, redo;
    std::array<Rect, 3> dividers;
    double offset_label_baseline = 0;
    Rect stepper;  ///< its first and last 64 take touches
    Rect pages;

    std::array<Rect, kGarmentTiles> tiles, tile_pictures;
    Rect list_head, add_layer;  ///< head of layers and history; the plus
    std::array<Rect, kGarmentRows> rows;
    Rect list;  ///< all rows together: what a drag scrolls
    double row_pitch = 70;
    double folds_label_baseline = 0;
    Rect slider;  ///< of the folds; 64 high, its line in the middle

    Rect body, export_button;
    Rect layers_button;  ///< upright only: opens the drawer; else without size

    // the drawer that covers the board: body, fabrics, and upright the layers
    Rect drawer_close, drawer_sizes, drawer_list;
    double drawer_title_baseline = 0;
    std::array<Rect, kBodySliders> drawer_sliders;  ///< 64 high, the line in the middle
    std::array<double, kBodySliders> drawer_label_baselines{};
    Rect drawer_left, drawer_right;     ///< the two buttons at the foot
    Rect drawer_language, drawer_hand;  ///< in the body drawer's foot

    double name_x = 0, name_baseline = 0, where_baseline = 0;  ///< of the view, on the sheet
    Rect figure;                                               ///< on the sheet: where the figure stands

    /// A length of the design on this screen.
    [[nodiscard]] double px(double design) const { return design * scale; }
};

/// As find_layout: wide from 1920 × 1080 on, scaled by the smaller ratio; compact below; upright from 600 px of width.
/// Left-handed, blocks of the board stand at width − x − their width and keep their reading order inside.
[[nodiscard]] GarmentLayout garment_layout(SizePx screen, Hand hand);

}  // namespace ui
