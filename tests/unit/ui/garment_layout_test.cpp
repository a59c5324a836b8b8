#include "ui/screens/garment_layout.hpp"

#include <catch2/catch.hpp>

using ui::Hand;
using ui::Rect;

namespace {

/// What can be touched on the board at once, without the list's rows on upright screens, which are in a drawer.
std::vector<Rect> touchable(const ui::GarmentLayout& l) {
    std::vector<Rect> all(l.tools.begin(), l.tools.end());
    all.insert(all.end(), {l.undo, l.redo, l.stepper, l.pages, l.mode_switch, l.body, l.export_button});
    all.insert(all.end(), l.tiles.begin(), l.tiles.end());
    if (l.upright) {
        all.push_back(l.layers_button);
    } else {
        all.insert(all.end(), l.rows.begin(), l.rows.end());
        all.push_back(l.slider);
    }
    return all;
}

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

}  // namespace

TEST_CASE("Garment's regions of 1920 x 1080 are those of the design", "[garment layout]") {
    const ui::GarmentLayout l = ui::garment_layout({1920, 1080}, Hand::Right);
    CHECK(l.board == Rect{0, 0, 672, 1080});
    CHECK(l.sheet == Rect{672, 0, 1248, 1080});
    CHECK(l.mode_switch == Rect{256, 32, 288, 72});
    CHECK(l.tools[0] == Rect{40, 128, 100, 100});
    CHECK(l.tools[1] == Rect{144, 128, 100, 100});
    CHECK(l.redo.bottom() == 128 + 560);
    CHECK(l.tiles[0] == Rect{256, 128, 186, 204});
    CHECK(l.tiles[3] == Rect{454, 344, 186, 204});
    CHECK(l.rows[0].width == 384);
    CHECK(l.rows[1].y - l.rows[0].y == 70);
    CHECK(l.rows[2].bottom() < 852);
    CHECK(l.slider == Rect{256, 888, 384, 64});
    CHECK(l.body == Rect{40, 976, 204, 72});
    CHECK(l.export_button == Rect{256, 976, 384, 72});
}

TEST_CASE("left-handed, Garment's blocks are mirrored and keep their order inside", "[garment layout]") {
    for (const ui::SizePx size : {ui::SizePx{1920, 1080}, ui::SizePx{1280, 800}}) {
        const ui::GarmentLayout right = ui::garment_layout(size, Hand::Right);
        const ui::GarmentLayout left = ui::garment_layout(size, Hand::Left);
        const auto mirrored = [&](const Rect& r) { return Rect{size.width - r.x - r.width, r.y, r.width, r.height}; };
        CHECK(left.board == mirrored(right.board));
        CHECK(left.sheet == mirrored(right.sheet));
        CHECK(left.slider == mirrored(right.slider));
        CHECK(left.stepper == mirrored(right.stepper));
        CHECK(left.body == mirrored(right.body));
        CHECK(left.tools[0].x < left.tools[1].x);
        CHECK(left.tiles[0].x < left.tiles[1].x);
    }
}

TEST_CASE("4K is Garment twice as large", "[garment layout]") {
    const ui::GarmentLayout l = ui::garment_layout({3840, 2160}, Hand::Right);
    CHECK(l.scale == 2);
    CHECK(l.tiles[3] == Rect{908, 688, 372, 408});
}

TEST_CASE("Garment overlaps nowhere and can be touched everywhere, on every size", "[garment layout]") {
    for (const ui::SizePx size :
         {ui::SizePx{1280, 800}, ui::SizePx{1366, 768}, ui::SizePx{1600, 900}, ui::SizePx{1920, 1080},
          ui::SizePx{1920, 1200}, ui::SizePx{2560, 1080}, ui::SizePx{1080, 1920}, ui::SizePx{3840, 2160}}) {
        for (const Hand hand : {Hand::Right, Hand::Left}) {
            DYNAMIC_SECTION(size.width << "x" << size.height << (hand == Hand::Right ? " right" : " left")) {
                const ui::GarmentLayout l = ui::garment_layout(size, hand);
                const std::vector<Rect> all = touchable(l);
                for (std::size_t i = 0; i < all.size(); ++i) {
                    CHECK(all[i].x >= l.board.x);
                    CHECK(all[i].right() <= l.board.right());
                    CHECK(all[i].bottom() <= l.board.bottom());
                    CHECK_FALSE(overlap(all[i], l.sheet));
                    for (std::size_t k = i + 1; k < all.size(); ++k) CHECK_FALSE(overlap(all[i], all[k]));
                    if (l.scale >= 1) CHECK(std::min(all[i].width, all[i].height) >= 64);
                }
            }
        }
    }
}

TEST_CASE("the body's drawer lies on the board, its sliders apart", "[garment layout]") {
    for (const ui::SizePx size : {ui::SizePx{1280, 800}, ui::SizePx{1920, 1080}, ui::SizePx{1080, 1920}}) {
        const ui::GarmentLayout l = ui::garment_layout(size, Hand::Left);
        std::vector<Rect> all(l.drawer_sliders.begin(), l.drawer_sliders.end());
        for (const Rect& slider : all) {
            CHECK(slider.y >= l.drawer_sizes.bottom() - 8);  // above its line there is its name
            CHECK(slider.bottom() <= l.drawer_language.y + 12);
        }
        all.insert(all.end(), {l.drawer_language, l.drawer_hand, l.drawer_left, l.drawer_right});
        for (std::size_t i = 0; i < all.size(); ++i) {
            CHECK(all[i].height >= 64);
            CHECK(all[i].x >= l.board.x);
            CHECK(all[i].right() <= l.board.right());
            for (std::size_t k = i + 1; k < all.size() && i < ui::kBodySliders - 1; ++k) {
                if (k < ui::kBodySliders) CHECK_FALSE(overlap(all[i], all[k]));
            }
        }
        CHECK(l.drawer_right.bottom() <= l.board.bottom());
    }
}
