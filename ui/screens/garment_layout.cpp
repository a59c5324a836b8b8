#include "ui/screens/garment_layout.hpp"

#include <algorithm>
#include <cmath>

#include "ui/screens/placer.hpp"

namespace ui {
namespace {

/// The numbers of one arrangement, in pixels of its design picture, right-handed.
struct Numbers {
    double width, height, board, margin;
    double wordmark_baseline;
    Rect modes;
    Rect tools;  // x, y, then width and height of one tool
    double tool_column;
    double tool_rows[5];
    double dividers[3];  // below the top of the tools; 0: none
    double offset_label, stepper_y, stepper_height;
    double tools_width;
    double pages_y, pages_height;
    Rect views;  // x, y, then width and height of one tile
    double tile_gap, column_width;
    double head_y, head_height, rows_y, row_height, row_pitch;
    double folds_label, slider_y;
    double footer_y, footer_height;
    double name_baseline, where_baseline;
};

constexpr Numbers kWide{1920,
                        1080,
                        672,
                        40,
                        81,
                        {256, 32, 288, 72},
                        {40, 128, 100, 100},
                        104,
                        {0, 116, 220, 336, 460},
                        {107, 327, 447},
                        735,
                        748,
                        72,
                        204,
                        852,
                        72,
                        {256, 128, 186, 204},
                        12,
                        384,
                        566,
                        64,
                        630,
                        64,
                        70,
                        872,
                        888,
                        976,
                        72,
                        62,
                        91};
constexpr Numbers kCompact{1280,
                           800,
                           496,
                           24,
                           62,
                           {184, 20, 288, 64},
                           {24, 100, 72, 76},
                           76,
                           {0, 82, 162, 244, 326},
                           {0, 0, 0},
                           523,
                           532,
                           64,
                           148,
                           620,
                           64,
                           {184, 100, 140, 122},
                           8,
                           288,
                           354,
                           52,
                           406,
                           64,
                           68,
                           630,
                           640,
                           712,
                           64,
                           46,
                           72};

/// Tools, stepper and pages: one block of the board.
void place_tools(GarmentLayout& out, const Placer& at, const Numbers& n) {
    const Rect block = at.block(n.tools.x, n.tools.y, n.tools_width, n.pages_y + n.pages_height - n.tools.y);
    const auto slot = [&](std::size_t row, std::size_t column) {
        return at.inside(block, static_cast<double>(column) * n.tool_column, n.tool_rows[row], n.tools.width,
                         n.tools.height);
    };
    for (std::size_t i = 0; i < kGarmentSlots; ++i) out.tools[i] = slot(i / 2, i % 2);
    out.undo = slot(4, 0);
    out.redo = slot(4, 1);
    for (std::size_t i = 0; i < out.dividers.size(); ++i) {
        if (n.dividers[i] > 0) out.dividers[i] = at.inside(block, 16, n.dividers[i], n.tools_width - 32, 2);
    }
    out.offset_label_baseline = at.round(n.offset_label);
    out.stepper = at.inside(block, 0, n.stepper_y - n.tools.y, n.tools_width, n.stepper_height);
    out.pages = at.inside(block, 0, n.pages_y - n.tools.y, n.tools_width, n.pages_height);
}

/// Views, list and folds: the other block.
void place_column(GarmentLayout& out, const Placer& at, const Numbers& n) {
    const Rect block = at.block(n.views.x, n.views.y, n.column_width, n.height - n.views.y);
    const auto down = [&](double y) { return y - n.views.y; };
    for (std::size_t i = 0; i < kGarmentTiles; ++i) {
        const double column = static_cast<double>(i % 2), row = i < 2 ? 0.0 : 1.0;
        out.tiles[i] = at.inside(block, column * (n.views.width + n.tile_gap), row * (n.views.height + n.tile_gap),
                                 n.views.width, n.views.height);
    }
    out.list_head = at.inside(block, 0, down(n.head_y), n.column_width, n.head_height);
    out.add_layer = at.inside(block, n.column_width - 66, down(n.head_y), 66, n.head_height);
    for (std::size_t i = 0; i < kGarmentRows; ++i) {
        out.rows[i] =
            at.inside(block, 0, down(n.rows_y) + static_cast<double>(i) * n.row_pitch, n.column_width, n.row_height);
    }
    out.row_pitch = at.round(n.row_pitch);
    out.list = {out.rows[0].x, out.rows[0].y, out.rows[0].width, out.rows.back().bottom() - out.rows[0].y};
    out.folds_label_baseline = at.round(n.folds_label);
    out.slider = at.inside(block, 0, down(n.slider_y), n.column_width, 64);
}

void place_tile_pictures(GarmentLayout& out) {
    for (std::size_t i = 0; i < kGarmentTiles; ++i) out.tile_pictures[i] = out.tiles[i].shrunk(2);
}

/// The drawer has the board to itself, in one column.
void place_drawer(GarmentLayout& out, double margin, double top, double foot, double foot_height) {
    const Rect& b = out.board;
    const double s = out.scale, width = b.width - 2 * margin;
    const double head = std::round(72 * s);
    const double button = std::max(std::round(72 * s), 64.0);
    out.drawer_close = {b.right() - margin - button, top, button, button};
    out.drawer_title_baseline = top + head * 0.66;
    out.drawer_sizes = {b.x + margin, top + button + std::round((out.compact ? 10 : 20) * s), width, button};
    // what is left between the sizes and the foot is shared by the measures, two rows of buttons below
    const double first = out.drawer_sizes.bottom() + std::round((out.compact ? 8 : 18) * s), gap = std::round(12 * s);
    out.drawer_left = {b.x + margin, foot, std::round(width * 0.48) - gap / 2, foot_height};
    out.drawer_right = {out.drawer_left.right() + gap, foot, b.x + margin + width - out.drawer_left.right() - gap,
                        foot_height};
    out.drawer_language = {out.drawer_left.x, foot - foot_height - gap, out.drawer_left.width, foot_height};
    out.drawer_hand = {out.drawer_right.x, out.drawer_language.y, out.drawer_right.width, foot_height};
    const double last = out.drawer_language.y - std::round(6 * s);
    const int columns = out.upright ? 2 : 1, lines = (kBodySliders + columns - 1) / columns;
    const double pitch = (last - first) / lines;
    const double column_gap = std::round(40 * s);
    const double wide = std::round((width - (columns - 1) * column_gap) / columns);
    for (int i = 0; i < kBodySliders; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const int column = i / lines;
        const double y = first + pitch * (i % lines), x = b.x + margin + (wide + column_gap) * column;
        out.drawer_label_baselines[at] = std::round(y + pitch * 0.36);
        out.drawer_sliders[at] = {x, std::round(y + pitch * 0.72 - 32), wide, 64};
    }
    out.drawer_list = {b.x + margin, out.drawer_sizes.y, width, foot - std::round(16 * s) - out.drawer_sizes.y};
}

/// The figure stands in the middle of the sheet, under the view's name where that is beside it.
void place_figure(GarmentLayout& out, double name_y, double where_y, double name_x) {
    out.name_x = out.sheet.x + std::round(name_x);
    out.name_baseline = out.sheet.y + name_y;
    out.where_baseline = out.sheet.y + where_y;
    const double margin = std::round(44 * out.scale);
    out.figure = {out.sheet.x, out.sheet.y + margin, out.sheet.width, out.sheet.height - 2 * margin};
}

/// Board above, sheet below: tools in two rows of five, views in one of four.
GarmentLayout upright_layout(SizePx screen, Hand hand) {
    GarmentLayout out;
    out.screen = screen;
    out.hand = hand;
    out.upright = true;
    out.scale = std::min(screen.width / 1080.0, screen.height / 1920.0);
    const Placer at(screen, Hand::Right, out.scale);
    const double width = screen.width, margin = at.round(40), inner = width - 2 * margin;
    out.board = {0, 0, width, at.round(720)};
    out.sheet = {0, out.board.height, width, screen.height - out.board.height};
    out.wordmark_x = margin;
    out.wordmark_baseline = at.round(81);
    out.mode_switch = {margin + at.round(216), at.round(32), at.round(288), at.round(72)};
    const double gap = at.round(12), tile = std::floor((inner - 3 * gap) / 4);
    for (std::size_t i = 0; i < kGarmentTiles; ++i) {
        out.tiles[i] = {margin + static_cast<double>(i) * (tile + gap), at.round(124), tile, at.round(236)};
    }
    const double tools_width = at.round(5 * 104 - 4);
    const double tools_x = hand == Hand::Right ? margin : width - margin - tools_width;
    const auto slot = [&](std::size_t row, std::size_t column) {
        return Rect{tools_x + at.round(static_cast<double>(column) * 104),
                    at.round(376 + static_cast<double>(row) * 108), at.round(100), at.round(100)};
    };
    for (std::size_t i = 0; i < kGarmentSlots; ++i) out.tools[i] = slot(i / 4, i % 4);
    out.undo = slot(0, 4);
    out.redo = slot(1, 4);
    const double side = inner - tools_width - at.round(40),
                 side_x = hand == Hand::Right ? width - margin - side : margin;
    out.offset_label_baseline = at.round(398);
    out.stepper = {side_x, at.round(410), side, at.round(72)};
    out.pages = {side_x, at.round(500), side, at.round(72)};
    const double foot = at.round(612), height = at.round(72);
    out.body = {margin, foot, at.round(240), height};
    out.layers_button = {out.body.right() + gap, foot, at.round(320), height};
    out.export_button = {out.layers_button.right() + gap, foot, width - margin - out.layers_button.right() - gap,
                         height};
    // in the drawer
    const double list_y = at.round(220);
    out.list_head = {margin, at.round(128), inner, at.round(72)};
    out.add_layer = {width - margin - at.round(72) - at.round(100), at.round(128), at.round(72), at.round(72)};
    for (std::size_t i = 0; i < kGarmentRows; ++i) {
        out.rows[i] = {margin, list_y + static_cast<double>(i) * at.round(76), inner, at.round(70)};
    }
    out.row_pitch = at.round(76);
    out.list = {margin, list_y, inner, out.rows.back().bottom() - list_y};
    out.folds_label_baseline = at.round(490);
    out.slider = {margin, at.round(506), inner, 64};
    place_tile_pictures(out);
    place_drawer(out, margin, at.round(32), foot, height);
    place_figure(out, at.round(60), at.round(92), at.round(40));
    return out;
}

}  // namespace

GarmentLayout garment_layout(SizePx screen, Hand hand) {
    if (screen.height > screen.width && screen.width >= 600) return upright_layout(screen, hand);
    GarmentLayout out;
    out.screen = screen;
    out.hand = hand;
    out.compact = screen.width < 1920 || screen.height < 1080;
    const Numbers& n = out.compact ? kCompact : kWide;
    out.scale = std::min(screen.width / n.width, screen.height / n.height);
    const Placer at(screen, hand, out.scale);
    const double taller = std::max(0.0, screen.height / out.scale - n.height);  // the footer stays at the bottom

    out.board = at.block(0, 0, n.board, 0);
    out.board.height = screen.height;
    out.sheet = {hand == Hand::Right ? out.board.right() : 0.0, 0, screen.width - out.board.width,
                 static_cast<double>(screen.height)};
    out.wordmark_x = at.block(n.margin, 0, n.modes.x + n.modes.width - n.margin, 1).x;
    out.wordmark_baseline = at.round(n.wordmark_baseline);
    const Rect header = at.block(n.margin, n.modes.y, n.modes.x + n.modes.width - n.margin, n.modes.height);
    out.mode_switch = at.inside(header, n.modes.x - n.margin, 0, n.modes.width, n.modes.height);
    place_tools(out, at, n);
    place_column(out, at, n);
    const double foot = n.footer_y + taller;
    out.body = at.block(n.tools.x, foot, n.tools_width, n.footer_height);
    out.export_button = at.block(n.views.x, foot, n.column_width, n.footer_height);
    place_tile_pictures(out);
    place_drawer(out, at.round(n.margin), at.round(n.modes.y), at.round(foot), at.round(n.footer_height));
    place_figure(out, at.round(n.name_baseline), at.round(n.where_baseline),
                 out.compact ? 24 * out.scale : 40 * out.scale);
    return out;
}

}  // namespace ui
