#include "ui/draw/damage.hpp"

#include <algorithm>
#include <random>

#include "tests/unit/ui/gl_fixture.hpp"
#include "ui/draw/painter.hpp"

using ui::Rect;

namespace {

constexpr ui::SizePx kSize{160, 120};
constexpr ui::PictureId kPicture{7};

ui::DrawList ground() {
    ui::DrawList list;
    list.box({0, 0, 160, 120}, 0, ui::palette::kSheet);
    return list;
}

/// Some command anywhere, also beyond the edges.
void add_random(ui::DrawList& list, const ui::FontSet& fonts, std::mt19937& random) {
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 10'000) / 10'000;
    };
    const double x = number(-10, 150), y = number(-10, 110);
    const Rect rect{x, y, number(4, 60), number(4, 40)};
    switch (random() % 6) {
        case 0:
            list.box(rect, number(0, 12), ui::palette::kWell, ui::palette::kInk, number(0, 3));
            break;
        case 1:
            list.shadow(rect, number(0, 12), 3, number(2, 9), ui::palette::kShade);
            break;
        case 2:
            list.text(fonts, "Ägypten, Ûjq", {ui::Face::SemiBold, number(9, 24), -0.02}, ui::palette::kInk, x, y);
            break;
        case 3:
            list.icon(ui::Icon::Hand, x, y, number(12, 40), 2, ui::palette::kMuted);
            break;
        case 4:
            list.wash(kPicture, rect, ui::palette::parts()[1], number(0, 1));
            break;
        default:
            list.ink(
                {{static_cast<float>(x), static_cast<float>(y), static_cast<float>(number(0, 160)), 60.0F, 3.0F, 1.0F}},
                ui::palette::kInk, {10, 10, 120, 90});
            break;
    }
}

}  // namespace

TEST_CASE("rectangles that lie close to each other become one, and those far apart stay", "[damage]") {
    ui::Damage damage;
    damage.add({10.4, 10.4, 20, 20});
    damage.add({0, 0, 0, 50});  // nothing
    REQUIRE(damage.rects().size() == 1);
    CHECK(damage.rects()[0] == Rect{10, 10, 21, 21});
    damage.add({25, 25, 30, 30});
    REQUIRE(damage.rects().size() == 1);
    CHECK(damage.rects()[0] == Rect{10, 10, 45, 45});
    damage.add({900, 900, 40, 40});
    CHECK(damage.rects().size() == 2);
    for (int i = 0; i < 40; ++i) damage.add({i * 300.0, (i % 7) * 900.0, 50, 50});
    CHECK(damage.rects().size() <= 8);
    CHECK(
        std::any_of(damage.rects().begin(), damage.rects().end(), [](const Rect& r) { return r.contains(905, 905); }));
}

TEST_CASE("a list differs where commands came, went or changed, and nowhere else", "[damage]") {
    const ui::FontSet fonts = *ui::FontSet::load();
    ui::DrawList before = ground(), now = ground();
    before.box({10, 10, 20, 20}, 4, ui::palette::kWell);
    before.box({100, 10, 20, 20}, 4, ui::palette::kWell);
    now.icon(ui::Icon::Pen, 60, 100, 20, 2, ui::palette::kInk);  // came
    now.box({10, 10, 20, 20}, 4, ui::palette::kWell);            // stayed
    now.box({100, 10, 20, 20}, 4, ui::palette::kLine);           // changed
    CHECK(ui::difference(before, before, fonts).empty());
    const ui::Damage damage = ui::difference(before, now, fonts);
    const auto inside = [&](double x, double y) {
        return std::any_of(damage.rects().begin(), damage.rects().end(),
                           [&](const Rect& r) { return r.contains(x, y); });
    };
    CHECK(inside(60, 100));
    CHECK(inside(110, 20));
    CHECK_FALSE(inside(20, 20));
    CHECK_FALSE(ui::difference(before, ground(), fonts).empty());
    CHECK_FALSE(ui::difference(ui::DrawList{}, now, fonts).empty());
}

TEST_CASE("drawing changes gives the pixels of drawing everything", "[damage]") {
    const auto context = test::gl();
    const ui::FontSet fonts = *ui::FontSet::load();
    auto changing = ui::Painter::create(fonts), whole = ui::Painter::create(fonts);
    REQUIRE((changing && whole));
    ui::Texture coverage({20, 20}, ui::PixelFormat::Coverage);
    std::vector<std::uint8_t> pixels(400, 130);
    coverage.upload(0, 0, {20, 20}, pixels);
    for (ui::Painter* painter : {&*changing, &*whole}) painter->set_picture(kPicture, &coverage);
    std::mt19937 random(31);
    const bool flip = GENERATE(false, true);
    ui::Target kept(kSize, ui::PixelFormat::Colour), anew(kSize, ui::PixelFormat::Colour);
    ui::DrawList list = ground();
    int parts = 0;
    for (int frame = 0; frame < 60; ++frame) {
        for (unsigned i = 0; i < 1 + random() % 3; ++i) {
            if (random() % 3 == 0 && list.commands.size() > 1) {
                list.commands.erase(list.commands.begin() + 1 +
                                    static_cast<std::ptrdiff_t>(random() % (list.commands.size() - 1)));
            } else {
                ui::DrawList one;
                add_random(one, fonts, random);
                list.commands.insert(
                    list.commands.begin() + 1 + static_cast<std::ptrdiff_t>(random() % list.commands.size()),
                    one.commands[0]);
            }
        }
        if (frame % 10 == 9) {  // the picture itself changes in a corner
            std::fill(pixels.begin(), pixels.begin() + 25, static_cast<std::uint8_t>(frame * 4));
            coverage.upload(0, 0, {5, 5}, {pixels.data(), 25});
            changing->picture_changed(kPicture, {0, 0, 5, 5});
        }
        kept.bind();
        changing->paint_changes(list, kSize, flip);
        if (changing->painted().area() < 160 * 120) ++parts;
        const std::vector<std::uint8_t> seen = kept.read_back().pixels;
        anew.bind();
        whole->paint(list, kSize, flip);
        REQUIRE(seen == anew.read_back().pixels);
    }
    CHECK(parts > 30);  // and not by drawing everything all the time
    kept.bind();
    changing->paint_changes(list, kSize, flip);
    CHECK(changing->painted().empty());
}
