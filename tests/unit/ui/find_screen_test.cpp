#include "ui/screens/find_screen.hpp"

#include "tests/unit/ui/gl_fixture.hpp"
#include "ui/draw/painter.hpp"
#include "ui/screens/notice_screen.hpp"

namespace {

struct Screen {
    ui::FontSet fonts = *ui::FontSet::load();
    std::vector<ui::Strings> languages = *ui::Strings::load_all();
    ui::FindScreen find{fonts, languages};
    ui::NoticeScreen notice{fonts, languages};
};

std::vector<std::string> texts(const ui::DrawList& list) {
    std::vector<std::string> out;
    for (const ui::DrawCommand& command : list.commands) {
        if (const auto* text = std::get_if<ui::TextCommand>(&command)) out.push_back(text->text);
    }
    return out;
}

bool has(const std::vector<std::string>& all, const std::string& text) {
    return std::find(all.begin(), all.end(), text) != all.end();
}

core::RgbaImage paint(const Screen& screen, const ui::DrawList& list, ui::SizePx size) {
    core::Result<ui::Painter> painter = ui::Painter::create(screen.fonts);
    REQUIRE(painter);
    ui::Target target(size, ui::PixelFormat::Colour);
    target.bind();
    painter->paint(list, size, false);
    return target.read_back();
}

}  // namespace

TEST_CASE("an empty sheet says what to do, in every language", "[find]") {
    const Screen s;
    const ui::FindLayout layout = ui::find_layout({1920, 1080}, ui::Hand::Right);
    ui::FindState state;
    CHECK(has(texts(s.find.draw(state, layout)), "Draw one object from the side."));
    state.language = 1;
    CHECK(has(texts(s.find.draw(state, layout)), "Dessinez un objet de profil."));
    state.sheet_empty = false;
    CHECK_FALSE(has(texts(s.find.draw(state, layout)), "Dessinez un objet de profil."));
}

TEST_CASE("what cannot be done takes no touch", "[find]") {
    const Screen s;
    const ui::FindLayout layout = ui::find_layout({1920, 1080}, ui::Hand::Right);
    const auto hit = [&](const ui::FindState& state, std::size_t tool) {
        ui::BoardTouch touch;
        const ui::Rect& r = layout.tools[tool];
        if (const auto intent = touch.press(s.find.targets(state, layout), r.centre_x(), r.centre_y())) return true;
        return touch.release().has_value();
    };
    ui::FindState state;
    CHECK(hit(state, 0));
    CHECK(hit(state, 1));
    for (const std::size_t off : {2U, 3U, 4U}) CHECK_FALSE(hit(state, off));
    state.can_undo = state.can_redo = true;
    state.sheet_empty = false;
    for (const std::size_t on : {2U, 3U, 4U}) CHECK(hit(state, on));
}

TEST_CASE("undo acts on the press, other tools on release inside the target", "[find]") {
    const std::vector<ui::BoardTouch::Target> targets{{ui::Control::Undo, 0, {0, 0, 80, 80}},
                                                      {ui::Control::Eraser, 0, {0, 100, 80, 80}}};
    ui::BoardTouch touch;
    REQUIRE(touch.press(targets, 40, 40));
    CHECK_FALSE(touch.release());
    CHECK_FALSE(touch.press(targets, 40, 140));
    CHECK(touch.pressed() == ui::Control::Eraser);
    touch.move(200, 140);
    CHECK_FALSE(touch.pressed());
    CHECK_FALSE(touch.release());
    CHECK_FALSE(touch.press(targets, 40, 140));
    const auto intent = touch.release();
    REQUIRE(intent);
    CHECK(intent->control == ui::Control::Eraser);
}

TEST_CASE("the painted screen has board, sheet, chosen tool and text in their colours", "[find]") {
    const auto context = test::gl();
    const Screen s;
    for (const ui::Hand hand : {ui::Hand::Right, ui::Hand::Left}) {
        const ui::FindLayout l = ui::find_layout({1280, 800}, hand);
        const core::RgbaImage image = paint(s, s.find.draw({}, l), l.screen);
        const auto at = [&](double x, double y) {
            return test::pixel(image, static_cast<int>(x), static_cast<int>(y));
        };
        CHECK(at(l.sheet.centre_x(), 100).b == 0xF8);
        CHECK(at(l.board.centre_x(), 3).b == 0xE7);
        CHECK(at(l.tools[0].x + 10, l.tools[0].y + 30).r == 0x1E);
        int dark = 0;  // the hint's title
        for (int x = static_cast<int>(l.sheet.x) + 20; x < l.sheet.right() - 20; ++x) {
            for (int y = 350; y < 400; ++y) dark += at(x, y).r < 90 ? 1 : 0;
        }
        CHECK(dark > 1500);
    }
}

TEST_CASE("the wash multiplies the part's colour at 42 per cent, under the ink", "[find]") {
    const auto context = test::gl();
    const Screen s;
    ui::DrawList list;
    list.box({0, 0, 20, 20}, 0, ui::palette::kSheet);
    list.wash(ui::PictureId{5}, {0, 0, 20, 20}, ui::palette::parts()[0].faded(ui::palette::kWashShare), 1);
    core::Result<ui::Painter> painter = ui::Painter::create(s.fonts);
    REQUIRE(painter);
    ui::Texture full({1, 1}, ui::PixelFormat::Coverage);
    const std::vector<std::uint8_t> covered{255};
    full.upload(0, 0, {1, 1}, covered);
    painter->set_picture(ui::PictureId{5}, &full);
    ui::Target target({20, 20}, ui::PixelFormat::Colour);
    target.bind();
    painter->paint(list, {20, 20}, false);
    const test::Pixel p = test::pixel(target.read_back(), 10, 10);
    CHECK(p.r == Approx(0xFF * (1 - 0.42 + 0.42 * 0x75 / 255.0)).margin(1.5));
    CHECK(p.b == Approx(0xF8 * (1 - 0.42 + 0.42 * 0xF1 / 255.0)).margin(1.5));
}

TEST_CASE("a notice says what is missing and offers a way on, on every screen in every language", "[find]") {
    const Screen s;
    for (const ui::SizePx size :
         {ui::SizePx{1280, 800}, ui::SizePx{1920, 1080}, ui::SizePx{1080, 1920}, ui::SizePx{3840, 2160}}) {
        const ui::FindLayout layout = ui::find_layout(size, ui::Hand::Right);
        for (int notice = 1; notice <= static_cast<int>(ui::Notice::NoTablet); ++notice) {
            for (std::size_t language = 0; language < s.languages.size(); ++language) {
                ui::NoticeState state;
                state.notice = static_cast<ui::Notice>(notice);
                state.language = language;
                state.done = 412;
                state.total = 1258;
                state.minutes_left = 6;
                const ui::DrawList list = s.notice.draw(state, layout);
                const bool touch = state.notice == ui::Notice::NoTablet;
                CHECK(has(texts(list), s.languages[language][touch ? "draw_by_touch" : "start_drawing"]));
                for (const ui::DrawCommand& command : list.commands) {
                    if (const auto* t = std::get_if<ui::TextCommand>(&command)) {
                        CHECK(t->x >= 0);
                        CHECK(t->x + s.fonts.width_px(t->text, t->style) <= size.width);
                        CHECK(t->text.find('{') == std::string::npos);
                        CHECK(t->text.find('_') == std::string::npos);  // no key without words
                    }
                }
                const auto targets = s.notice.targets(state, layout);
                CHECK(targets.back().control == ui::Control::StartDrawing);
                CHECK(targets.back().rect.height >= 64);
                CHECK(targets.back().rect.width <= size.width);
            }
        }
    }
}
