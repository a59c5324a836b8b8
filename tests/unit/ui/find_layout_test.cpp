#include "ui/screens/find_layout.hpp"

#include <catch2/catch.hpp>

using ui::Hand;
using ui::Rect;

namespace {

std::vector<Rect> touchable(const ui::FindLayout& l) {
    std::vector<Rect> all(l.tools.begin(), l.tools.end());
    all.push_back(l.language);
    all.push_back(l.hand_switch);
    return all;
}

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

}  // namespace

TEST_CASE("the regions of 1920 x 1080 are those of the design", "[layout]") {
    const ui::FindLayout l = ui::find_layout({1920, 1080}, Hand::Right);
    CHECK(l.board == Rect{0, 0, 672, 1080});
    CHECK(l.sheet == Rect{672, 0, 1248, 1080});
    CHECK(l.header == Rect{40, 32, 504, 72});
    CHECK(l.cards[0] == Rect{40, 128, 504, 296});
    CHECK(l.card_pictures[0] == Rect{112, 124, 400, 270});
    CHECK(l.cards[1] == Rect{40, 440, 244, 120});
    CHECK(l.cards[2] == Rect{300, 440, 244, 120});
    CHECK(l.cards[8] == Rect{300, 836, 244, 120});
    CHECK(l.tools[0] == Rect{560, 252, 88, 88});
    CHECK(l.tools[1] == Rect{560, 348, 88, 88});
    CHECK(l.tools[4].bottom() <= 252 + 520);
    CHECK(l.footer == Rect{40, 976, 504, 72});
    CHECK(l.language == Rect{40, 976, 244, 72});
    CHECK(l.hand_switch == Rect{300, 976, 244, 72});
}

TEST_CASE("left-handed, every block stands at width - x - its width", "[layout]") {
    for (const ui::SizePx size : {ui::SizePx{1920, 1080}, ui::SizePx{1280, 800}}) {
        const ui::FindLayout right = ui::find_layout(size, Hand::Right), left = ui::find_layout(size, Hand::Left);
        const auto mirrored = [&](const Rect& r) { return Rect{size.width - r.x - r.width, r.y, r.width, r.height}; };
        CHECK(left.board == mirrored(right.board));
        CHECK(left.sheet == mirrored(right.sheet));
        CHECK(left.header == mirrored(right.header));
        CHECK(left.cards[0] == mirrored(right.cards[0]));
        CHECK(left.footer == mirrored(right.footer));
        for (std::size_t i = 0; i < ui::kToolCount; ++i) CHECK(left.tools[i] == mirrored(right.tools[i]));
        // inside a block, reading order stays: second best on the left, languages before the hand
        CHECK(left.cards[1].x < left.cards[2].x);
        CHECK(left.language.x < left.hand_switch.x);
    }
}

TEST_CASE("4K is exactly twice the design", "[layout]") {
    const ui::FindLayout l = ui::find_layout({3840, 2160}, Hand::Right);
    CHECK(l.scale == 2);
    CHECK(l.cards[4] == Rect{600, 2 * (440 + 132), 488, 240});
    CHECK(l.ink_width_px == Approx(15));
}

TEST_CASE("on every size nothing overlaps, leaves the screen or is too small to touch", "[layout]") {
    for (const ui::SizePx size :
         {ui::SizePx{1280, 800}, ui::SizePx{1366, 768}, ui::SizePx{1600, 900}, ui::SizePx{1920, 1080},
          ui::SizePx{1920, 1200}, ui::SizePx{2560, 1080}, ui::SizePx{1080, 1920}, ui::SizePx{3840, 2160}}) {
        for (const Hand hand : {Hand::Right, Hand::Left}) {
            DYNAMIC_SECTION(size.width << "x" << size.height << (hand == Hand::Right ? " right" : " left")) {
                const ui::FindLayout l = ui::find_layout(size, hand);
                std::vector<Rect> all = touchable(l);
                const std::size_t touch = all.size();
                all.insert(all.end(), l.cards.begin(), l.cards.end());
                CHECK(l.sheet.width > size.width / 2.0);
                for (std::size_t i = 0; i < all.size(); ++i) {
                    CHECK(all[i].x >= l.board.x);
                    CHECK(all[i].right() <= l.board.right());
                    CHECK(all[i].bottom() <= size.height);
                    CHECK_FALSE(overlap(all[i], l.sheet));
                    for (std::size_t k = i + 1; k < all.size(); ++k) CHECK_FALSE(overlap(all[i], all[k]));
                    if (i < touch && l.scale >= 1) CHECK(std::min(all[i].width, all[i].height) >= 64);
                }
            }
        }
    }
}

TEST_CASE("on an upright screen the board stands above the sheet, and nothing overlaps", "[find layout]") {
    for (const ui::SizePx size : {ui::SizePx{1080, 1920}, ui::SizePx{1200, 1920}, ui::SizePx{2160, 3840}}) {
        for (const ui::Hand hand : {ui::Hand::Right, ui::Hand::Left}) {
            const ui::FindLayout l = ui::find_layout(size, hand);
            REQUIRE(l.upright);
            CHECK(l.sheet.y == l.board.bottom());
            CHECK(l.sheet.bottom() == size.height);
            CHECK(l.sheet.width == size.width);
            std::vector<ui::Rect> blocks(l.cards.begin(), l.cards.end());
            blocks.insert(blocks.end(), l.tools.begin(), l.tools.end());
            blocks.push_back(l.language);
            blocks.push_back(l.hand_switch);
            for (std::size_t i = 0; i < blocks.size(); ++i) {
                CHECK(blocks[i].height >= 64);
                CHECK(blocks[i].x >= 0);
                CHECK(blocks[i].right() <= size.width);
                CHECK(blocks[i].bottom() <= l.board.bottom());
                for (std::size_t k = i + 1; k < blocks.size(); ++k) {
                    const ui::Rect &a = blocks[i], &b = blocks[k];
                    const bool apart = a.right() <= b.x || b.right() <= a.x || a.bottom() <= b.y || b.bottom() <= a.y;
                    CHECK(apart);
                }
            }
        }
    }
}
