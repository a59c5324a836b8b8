#include "ui/screens/find_layout.hpp"

#include <algorithm>
#include <cmath>

#include "ui/screens/placer.hpp"

namespace ui {
namespace {

/// The numbers of one arrangement, in pixels of its design picture, right-handed.
struct Numbers {
    double width, height;
    double board;
    Rect header;
    double wordmark_baseline;
    Rect modes;
    Rect best, best_picture;
    double small_y, small_pitch, small_width, small_height, small_picture;
    double tools_x, tools_y, tool_width, tool_height;
    double tool_offsets[kToolCount];
    double divider_offsets[2];
    Rect footer;
    double language_width, hand_x, hand_width;
    double ink_width;
};

constexpr Numbers kWide{1920,
                        1080,
                        672,
                        {40, 32, 504, 72},
                        81,
                        {256, 32, 288, 72},
                        {40, 128, 504, 296},
                        {112, 124, 400, 270},
                        440,
                        132,
                        244,
                        120,
                        160,
                        560,
                        252,
                        88,
                        88,
                        {0, 96, 216, 312, 432},
                        {204, 420},
                        {40, 976, 504, 72},
                        244,
                        260,
                        244,
                        7.5};
constexpr Numbers kCompact{1280,
                           800,
                           496,
                           {24, 20, 376, 64},
                           62,
                           {160, 20, 240, 64},
                           {24, 100, 376, 212},
                           {92, 100, 284, 186},
                           324,
                           92,
                           182,
                           84,
                           116,
                           412,
                           176,
                           72,
                           76,
                           {0, 80, 176, 256, 352},
                           {0, 0},
                           {24, 712, 376, 64},
                           204,
                           216,
                           160,
                           5.5};

void place_cards(FindLayout& out, const Placer& at, const Numbers& n) {
    out.cards[0] = at.block(n.best.x, n.best.y, n.best.width, n.best.height);
    out.card_pictures[0] = at.inside(out.cards[0], n.best_picture.x - n.best.x, n.best_picture.y - n.best.y,
                                     n.best_picture.width, n.best_picture.height);
    const double columns = n.best.width - n.small_width;  // the right column ends with the best card
    const Rect rail = at.block(n.best.x, n.small_y, n.best.width, 4 * n.small_pitch);
    for (std::size_t i = 0; i < kCardCount - 1; ++i) {
        const std::size_t row_index = i / 2;
        const auto row = static_cast<double>(row_index);
        const Rect card = at.inside(rail, i % 2 == 0 ? 0 : columns, row * n.small_pitch, n.small_width, n.small_height);
        out.cards[i + 1] = card;
        out.card_pictures[i + 1] =
            at.inside(card, n.small_width - n.small_picture, 1, n.small_picture - 1, n.small_height - 2);
    }
}

void place_tools(FindLayout& out, const Placer& at, const Numbers& n, double down) {
    for (std::size_t i = 0; i < kToolCount; ++i) {
        out.tools[i] = at.block(n.tools_x, n.tools_y + n.tool_offsets[i] + down, n.tool_width, n.tool_height);
    }
    if (n.divider_offsets[0] <= 0) return;
    for (std::size_t i = 0; i < 2; ++i) {
        const double y = n.tools_y + n.divider_offsets[i] - 1 + down;
        out.dividers[i] = at.block(n.tools_x + (n.tool_width - 40) / 2, y, 40, 2);
    }
}

/// Board above, sheet below (design picture 15).
FindLayout upright_layout(SizePx screen, Hand hand) {
    FindLayout out;
    out.screen = screen;
    out.hand = hand;
    out.upright = true;
    out.scale = std::min(screen.width / 1080.0, screen.height / 1920.0);
    const Placer at(screen, Hand::Right, out.scale);
    const double width = screen.width, margin = at.round(40);
    out.board = {0, 0, width, at.round(720)};
    out.sheet = {0, out.board.height, width, screen.height - out.board.height};
    out.header = {margin, at.round(32), width - 2 * margin, at.round(72)};
    out.wordmark_baseline = at.round(81);
    out.mode_switch = {margin + at.round(216), at.round(32), at.round(288), at.round(72)};

    // the rail: the best card with four beside it, four below, across the whole width
    const double inner = width - 2 * margin, gap = at.round(12);
    const double best = std::round(inner * 0.504), beside = inner - best - at.round(16);
    out.cards[0] = {margin, at.round(128), best, at.round(316)};
    out.card_pictures[0] = {margin + best - at.round(436), at.round(132), at.round(424), at.round(264)};
    for (std::size_t i = 0; i < kCardCount - 1; ++i) {
        Rect& card = out.cards[i + 1];
        const double column = static_cast<double>(i < 4 ? i % 2 : i - 4);
        if (i < 4) {
            const double wide = std::round((beside - gap) / 2);
            card = {margin + best + at.round(16) + column * (wide + gap), at.round(i < 2 ? 128 : 290), wide,
                    at.round(i < 2 ? 150 : 154)};
        } else {
            const double wide = std::round((inner - 3 * gap) / 4);
            card = {margin + column * (wide + gap), at.round(460), wide, at.round(128)};
        }
        const double picture = std::min(card.width - at.round(72), at.round(160));
        out.card_pictures[i + 1] = {card.right() - picture, card.y + 1, picture - 1, card.height - 2};
    }
    const double offsets[kToolCount] = {0, 100, 220, 318, 440};
    for (std::size_t i = 0; i < kToolCount; ++i) {
        const double side = at.round(88), x = margin + at.round(offsets[i]);
        out.tools[i] = {hand == Hand::Right ? x : width - x - side, at.round(608), side, side};
    }
    out.footer = {margin, at.round(32), inner, at.round(72)};
    out.language = {width - margin - at.round(240), at.round(32), at.round(240), at.round(72)};
    out.hand_switch = {hand == Hand::Right ? width - margin - at.round(244) : margin, at.round(616), at.round(244),
                       at.round(72)};
    out.ink_width_px = 7.5 * out.scale;
    return out;
}

}  // namespace

FindLayout find_layout(SizePx screen, Hand hand) {
    if (screen.height > screen.width && screen.width >= 600) return upright_layout(screen, hand);
    FindLayout out;
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
    out.header = at.block(n.header.x, n.header.y, n.header.width, n.header.height);
    out.wordmark_baseline = at.round(n.wordmark_baseline);
    out.mode_switch = at.inside(out.header, n.modes.x - n.header.x, 0, n.modes.width, n.modes.height);
    place_cards(out, at, n);
    place_tools(out, at, n, taller / 2);
    out.footer = at.block(n.footer.x, n.footer.y + taller, n.footer.width, n.footer.height);
    out.language = at.inside(out.footer, 0, 0, n.language_width, n.footer.height);
    out.hand_switch = at.inside(out.footer, n.hand_x, 0, n.hand_width, n.footer.height);
    out.ink_width_px = n.ink_width * out.scale;
    return out;
}

}  // namespace ui
