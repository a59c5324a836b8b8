#include "firmware_like_app/kiosk/find_mode.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "tests/support/figures.hpp"
#include "ui/gl/headless_context.hpp"

using namespace std::chrono_literals;
using Kind = ui::WindowEvent::Kind;

namespace {

struct Kiosk {
    std::unique_ptr<ui::Context> context = std::move(*ui::make_headless_context());
    ui::FontSet fonts = *ui::FontSet::load();
    std::vector<ui::Strings> languages = *ui::Strings::load_all();
    std::unique_ptr<app::FindMode> find;
    std::int64_t now_us = 1'000'000;

    explicit Kiosk(app::Searcher* searcher, const app::FindOptions& options = {}) {
        auto made = app::FindMode::create(fonts, languages, searcher, options, {1280, 800});
        if (!made) FAIL(made.error().sentence());
        find = std::move(*made);
    }
    void event(Kind kind, double x, double y) {
        now_us += 8'000;
        find->pointer({kind, x, y, 1.0, now_us, false});
    }
    void tap(const ui::Rect& r) {
        event(Kind::Down, r.centre_x(), r.centre_y());
        event(Kind::Up, r.centre_x(), r.centre_y());
    }
    void stroke(double x0, double y0, double x1, double y1) {
        event(Kind::Down, x0, y0);
        for (int i = 1; i <= 10; ++i) event(Kind::Move, x0 + (x1 - x0) * i / 10, y0 + (y1 - y0) * i / 10);
        event(Kind::Up, x1, y1);
    }
    std::size_t strokes() const { return find->sketch().drawing().strokes.size(); }
    const ui::FindLayout& layout() const { return find->layout(); }
    ui::FindState state() const { return find->state(now_us); }
};

}  // namespace

TEST_CASE("ink goes on while a slow search runs, and the newest drawing is found in the end", "[find mode]") {
    test::FigureSearcher slow(test::make_animals(), 150ms);
    Kiosk kiosk(&slow);
    kiosk.stroke(700, 300, 1000, 310);
    const auto start = std::chrono::steady_clock::now();
    int pieces = 0;
    for (int i = 0; i < 12; ++i) {
        kiosk.stroke(700, 320 + i * 10, 1000, 330 + i * 10);
        kiosk.find->update(kiosk.now_us);
        pieces += kiosk.find->update_ink();
    }
    CHECK(pieces > 100);
    CHECK(kiosk.find->searches() <= 2);  // the first may have ended meanwhile, the others are still to come
    CHECK(std::chrono::steady_clock::now() - start < 5s);
    kiosk.find->search_and_wait();
    REQUIRE(kiosk.find->answer() != nullptr);
    CHECK(kiosk.find->searches() <= 4);  // thirteen strokes, but only the newest ones were searched
}

TEST_CASE("the best match lies under the ink as a shadow, fades in, can be switched off, and leaves with the drawing",
          "[find mode]") {
    test::FigureSearcher figures(test::make_animals());
    Kiosk kiosk(&figures);
    const auto frames_until = [&](auto done) {
        for (int i = 0; i < 1000 && !done(); ++i) {
            kiosk.now_us += 16'667;
            kiosk.find->update(kiosk.now_us);
            std::this_thread::sleep_for(2ms);
        }
        return done();
    };
    CHECK(kiosk.state().shadows.empty());
    kiosk.stroke(700, 300, 1000, 310);
    kiosk.stroke(1000, 310, 980, 500);
    REQUIRE(frames_until([&] { return !kiosk.state().shadows.empty(); }));
    CHECK(kiosk.state().shadows[0].opacity < 0.5);
    REQUIRE(frames_until([&] { return kiosk.state().shadows[0].opacity == 1; }));
    const ui::ShadowPart shadow = kiosk.state().shadows[0];
    CHECK(shadow.rect.x < 1000);
    CHECK(shadow.rect.right() > 700);
    kiosk.find->show_shadow(false);
    CHECK(kiosk.state().shadows.empty());
    kiosk.find->show_shadow(true);
    CHECK(kiosk.state().shadows.size() == 1);
    kiosk.tap(kiosk.layout().tools[4]);  // New
    CHECK(kiosk.state().shadows.empty());
    kiosk.find->update(kiosk.now_us + 500'000);
    CHECK(kiosk.state().shadows.empty());
}

TEST_CASE("what a stroke brings between frames is searched without waiting for the next", "[find mode]") {
    test::FigureSearcher figures(test::make_animals());
    Kiosk kiosk(&figures);
    const auto searched = [&](std::uint64_t count) {
        for (int i = 0; i < 500 && kiosk.find->searches() < count; ++i) std::this_thread::sleep_for(10ms);
        return kiosk.find->searches() == count;
    };
    kiosk.event(Kind::Down, 700, 300);
    for (int i = 1; i <= 20; ++i) kiosk.event(Kind::Move, 700 + i * 15, 300 + i);
    kiosk.find->search_news();
    CHECK(searched(1));
    kiosk.find->search_news();  // nothing new
    std::this_thread::sleep_for(30ms);
    CHECK(kiosk.find->searches() == 1);
    kiosk.event(Kind::Move, 1000, 500);
    kiosk.find->search_news();
    CHECK(searched(2));
    kiosk.event(Kind::Up, 1000, 500);
    CHECK(searched(3));
    kiosk.find->search_news();  // no stroke is drawn
    std::this_thread::sleep_for(30ms);
    CHECK(kiosk.find->searches() == 3);
}

TEST_CASE("tools work by touch: eraser, undo, redo, new and taking back new", "[find mode]") {
    Kiosk kiosk(nullptr);
    kiosk.stroke(700, 200, 1000, 200);
    kiosk.stroke(700, 400, 1000, 400);
    kiosk.tap(kiosk.layout().tools[1]);
    kiosk.stroke(850, 180, 850, 230);
    CHECK(kiosk.strokes() == 1);
    kiosk.tap(kiosk.layout().tools[2]);
    CHECK(kiosk.strokes() == 2);
    kiosk.tap(kiosk.layout().tools[3]);
    CHECK(kiosk.strokes() == 1);
    kiosk.tap(kiosk.layout().tools[4]);
    CHECK(kiosk.strokes() == 0);
    CHECK(kiosk.state().sheet_cleared);
    CHECK(kiosk.state().tool == ui::Tool::Pen);
    kiosk.tap(kiosk.layout().tools[2]);
    CHECK(kiosk.strokes() == 1);
    CHECK_FALSE(kiosk.state().sheet_cleared);
}

TEST_CASE("undo leaves exactly the picture that was there before", "[find mode]") {
    Kiosk kiosk(nullptr);
    const auto picture = [&] {
        kiosk.find->update_ink();
        ui::Target target({1280, 800}, ui::PixelFormat::Colour);
        target.bind();
        kiosk.find->draw(kiosk.now_us, false);
        return target.read_back().pixels;
    };
    kiosk.stroke(700, 200, 1000, 260);
    const auto before = picture();
    kiosk.stroke(720, 180, 980, 400);
    const auto after = picture();
    CHECK(before != after);
    kiosk.tap(kiosk.layout().tools[2]);
    // the redo button is on now: compare the sheet alone
    const auto sheet = [&](const std::vector<std::uint8_t>& pixels) {
        std::vector<std::uint8_t> out;
        for (std::size_t y = 0; y < 800; ++y) {
            const auto row = pixels.begin() + static_cast<std::ptrdiff_t>((y * 1280 + 500) * 4);
            out.insert(out.end(), row, row + 780 * 4);
        }
        return out;
    };
    CHECK(sheet(picture()) == sheet(before));
    kiosk.tap(kiosk.layout().tools[3]);
    CHECK(sheet(picture()) == sheet(after));
}

TEST_CASE("the hand switch mirrors the board and keeps the drawing", "[find mode]") {
    Kiosk kiosk(nullptr);
    kiosk.stroke(700, 200, 1000, 200);
    const double sheet_before = kiosk.layout().sheet.x;
    kiosk.tap(kiosk.layout().hand_switch);
    CHECK(kiosk.find->hand() == ui::Hand::Left);
    CHECK(kiosk.layout().sheet.x == 0);
    CHECK(sheet_before > 0);
    CHECK(kiosk.strokes() == 1);
    kiosk.stroke(100, 300, 300, 300);  // the sheet takes ink where it is now
    CHECK(kiosk.strokes() == 2);
}

TEST_CASE("a resize keeps the drawing on the sheet", "[find mode]") {
    Kiosk kiosk(nullptr);
    kiosk.stroke(700, 200, 1200, 700);
    for (const ui::SizePx size : {ui::SizePx{1920, 1080}, ui::SizePx{800, 600}, ui::SizePx{1280, 800}}) {
        kiosk.find->resize(size);
        kiosk.find->update_ink();
        const ui::FindState state = kiosk.state();
        CHECK(state.inked.width > 10);
        CHECK(state.inked.x >= 0);
        CHECK(state.inked.right() <= kiosk.layout().sheet.width);
        CHECK(state.inked.bottom() <= kiosk.layout().sheet.height);
    }
    kiosk.find->resize({0, 0});  // as minimised windows report
    CHECK(kiosk.layout().screen == ui::SizePx{1280, 800});
}

TEST_CASE("the wash comes when the pen has rested and goes with the next tip", "[find mode]") {
    test::FigureSearcher searcher(test::make_animals());
    Kiosk kiosk(&searcher);
    kiosk.stroke(700, 300, 1100, 310);
    kiosk.stroke(1100, 310, 1100, 600);
    kiosk.find->search_and_wait();
    kiosk.find->update(kiosk.now_us);
    REQUIRE_FALSE(kiosk.state().wash.empty());
    CHECK(kiosk.state().wash[0].opacity == 0);
    kiosk.now_us += 700'000;
    kiosk.find->update(kiosk.now_us);
    kiosk.now_us += 600'000;
    CHECK(kiosk.state().wash[0].opacity == 1);
    kiosk.event(Kind::Down, 900, 500);
    kiosk.now_us += 80'000;
    kiosk.find->update(kiosk.now_us);
    CHECK(kiosk.state().wash[0].opacity == 0);
}

TEST_CASE("results of a sheet that was emptied never come back", "[find mode]") {
    test::FigureSearcher slow(test::make_animals(), 60ms);
    Kiosk kiosk(&slow);
    kiosk.stroke(700, 300, 1100, 310);
    kiosk.tap(kiosk.layout().tools[4]);
    for (int i = 0; i < 30; ++i) {
        std::this_thread::sleep_for(10ms);
        kiosk.now_us += 16'000;
        kiosk.find->update(kiosk.now_us);
    }
    CHECK(kiosk.find->answer() == nullptr);
    CHECK_FALSE(kiosk.state().cards[0].now.has_value());
}

TEST_CASE("losing the focus ends the stroke where it is", "[find mode]") {
    Kiosk kiosk(nullptr);
    kiosk.event(Kind::Down, 700, 300);
    kiosk.event(Kind::Move, 800, 300);
    kiosk.find->cancel_pointer(kiosk.now_us);
    CHECK_FALSE(kiosk.find->sketch().open());
    kiosk.event(Kind::Move, 900, 300);
    CHECK(kiosk.find->sketch().drawing().strokes[0].samples.size() == 2);
}

TEST_CASE("a frame is only due when something changed", "[find mode]") {
    Kiosk kiosk(nullptr);
    ui::Target target({1280, 800}, ui::PixelFormat::Colour);
    const auto draw = [&] {
        kiosk.find->update_ink();
        target.bind();
        kiosk.find->draw(kiosk.now_us, false);
    };
    CHECK(kiosk.find->changed(kiosk.now_us));
    draw();
    kiosk.event(Kind::Move, 900, 300);
    CHECK_FALSE(kiosk.find->changed(kiosk.now_us));
    kiosk.stroke(700, 300, 900, 300);
    CHECK(kiosk.find->changed(kiosk.now_us));
    draw();
    CHECK_FALSE(kiosk.find->changed(kiosk.now_us));
}

TEST_CASE("the board's words are those that the shell gives", "[find mode]") {
    Kiosk kiosk(nullptr);
    const std::string hint = kiosk.state().board_message;
    kiosk.find->set_board_key("no_collection_board");
    CHECK(kiosk.state().board_message != hint);
}

TEST_CASE("a tap on a card opens it, and only where there is one", "[find mode]") {
    test::FigureSearcher searcher(test::make_animals());
    Kiosk kiosk(&searcher);
    kiosk.tap(kiosk.layout().cards[2]);
    CHECK_FALSE(kiosk.find->take_opened_card());
    kiosk.stroke(700, 300, 1100, 310);
    kiosk.stroke(1100, 310, 1100, 600);
    kiosk.find->search_and_wait();
    kiosk.find->settle(false);
    kiosk.tap(kiosk.layout().cards[2]);
    const auto opened = kiosk.find->take_opened_card();
    REQUIRE(opened);
    CHECK(opened->model == kiosk.find->answer()->answer.best[2].id);
    CHECK_FALSE(kiosk.find->take_opened_card());
    CHECK(kiosk.strokes() == 2);
}

TEST_CASE("a wipe leaves nothing: no ink, no history, no cards, no language, no hand, no tool", "[find mode]") {
    test::FigureSearcher searcher(test::make_animals());
    const auto frame = [](Kiosk& k) {
        k.find->update_ink();
        ui::Target target({1280, 800}, ui::PixelFormat::Colour);
        target.bind();
        k.find->draw(k.now_us, false);
        return target.read_back().pixels;
    };
    const std::vector<std::uint8_t> untouched = [&] {
        Kiosk k(&searcher);
        return frame(k);
    }();
    const auto is_untouched = [&](Kiosk& k) { return frame(k) == untouched; };
    Kiosk kiosk(&searcher);
    kiosk.stroke(700, 300, 1100, 310);
    kiosk.stroke(1100, 310, 1100, 600);
    kiosk.find->search_and_wait();
    kiosk.find->settle(true);
    kiosk.tap(kiosk.layout().hand_switch);
    kiosk.find->set_language(2);
    kiosk.tap(kiosk.layout().tools[1]);
    kiosk.event(Kind::Down, 300, 300);  // still erasing
    CHECK(kiosk.find->has_work());
    CHECK_FALSE(is_untouched(kiosk));

    kiosk.find->wipe(0, ui::Hand::Right);
    CHECK_FALSE(kiosk.find->has_work());
    CHECK_FALSE(kiosk.state().can_undo);
    CHECK_FALSE(kiosk.state().can_redo);
    CHECK(kiosk.find->answer() == nullptr);
    CHECK(kiosk.find->hand() == ui::Hand::Right);
    CHECK(kiosk.find->language() == 0);
    CHECK(is_untouched(kiosk));
    kiosk.tap(kiosk.layout().tools[2]);  // undo brings nothing back
    CHECK(kiosk.strokes() == 0);
    kiosk.now_us += 100'000;
    kiosk.find->update(kiosk.now_us);
    CHECK(is_untouched(kiosk));
}

namespace {

/// What a pen does, as the desk of pens gives it.
ui::WindowEvent pen(Kiosk& kiosk, Kind kind, double x, double y, bool eraser = false, double pressure = 0.5) {
    kiosk.now_us += 8'000;
    ui::WindowEvent event{kind, x, y, pressure, kiosk.now_us};
    event.pen = true;
    event.eraser = eraser;
    return event;
}

}  // namespace

TEST_CASE("a pen draws with its pressure, and its other end erases whatever tool is chosen", "[find mode]") {
    Kiosk kiosk(nullptr);
    kiosk.find->pointer(pen(kiosk, Kind::Move, 800, 300));
    CHECK(kiosk.state().pen_px == core::Point{800, 300});
    kiosk.find->pointer(pen(kiosk, Kind::Down, 800, 300, false, 0.25));
    kiosk.find->pointer(pen(kiosk, Kind::Move, 900, 300, false, 0.75));
    CHECK_FALSE(kiosk.state().pen_px);
    kiosk.find->pointer(pen(kiosk, Kind::Up, 900, 300, false, 0.0));
    REQUIRE(kiosk.strokes() == 1);
    const std::vector<core::PenSample>& samples = kiosk.find->sketch().drawing().strokes[0].samples;
    CHECK(samples.front().pressure == 0.25);
    CHECK(samples.back().pressure == 0.75);

    kiosk.find->pointer(pen(kiosk, Kind::Move, 850, 320, true));
    CHECK(kiosk.state().tool == ui::Tool::Eraser);  // shown as chosen while it is near
    CHECK(kiosk.state().eraser_px);
    kiosk.find->pointer(pen(kiosk, Kind::Down, 850, 305, true));
    kiosk.find->pointer(pen(kiosk, Kind::Up, 850, 305, true));
    CHECK(kiosk.strokes() == 0);
    kiosk.find->pointer(pen(kiosk, Kind::Leave, 850, 305));
    CHECK(kiosk.state().tool == ui::Tool::Pen);
    CHECK_FALSE(kiosk.state().eraser_px);
    CHECK_FALSE(kiosk.state().pen_px);
}

TEST_CASE("what a palm drew or erased leaves no trace, also not in undo", "[find mode]") {
    Kiosk kiosk(nullptr);
    kiosk.event(Kind::Down, 700, 300);
    kiosk.event(Kind::Move, 800, 300);
    kiosk.event(Kind::TakeBack, 800, 300);
    CHECK(kiosk.strokes() == 0);
    CHECK_FALSE(kiosk.state().can_undo);
    CHECK_FALSE(kiosk.state().can_redo);

    kiosk.stroke(700, 300, 900, 300);
    kiosk.tap(kiosk.layout().tools[1]);
    kiosk.event(Kind::Down, 800, 300);
    CHECK(kiosk.strokes() == 0);
    kiosk.event(Kind::TakeBack, 800, 300);
    CHECK(kiosk.strokes() == 1);
    kiosk.tap(kiosk.layout().tools[2]);  // undoes the stroke, not the erasing
    CHECK(kiosk.strokes() == 0);
}

TEST_CASE("ink ahead of the pen is shown, never kept, and ends with the stroke", "[find mode]") {
    Kiosk kiosk(nullptr);
    kiosk.find->pointer(pen(kiosk, Kind::Down, 800, 300));
    kiosk.find->pointer(pen(kiosk, Kind::Move, 820, 300));
    kiosk.find->look_ahead(pen(kiosk, Kind::Move, 836, 300));
    REQUIRE_FALSE(kiosk.state().ahead_ink.empty());
    CHECK(kiosk.state().ahead_ink.back().x1 == Approx(836));
    CHECK(kiosk.find->sketch().drawing().strokes[0].samples.size() == 2);
    kiosk.find->look_ahead({});
    CHECK(kiosk.state().ahead_ink.empty());
    kiosk.find->look_ahead(pen(kiosk, Kind::Move, 836, 300));
    kiosk.find->pointer(pen(kiosk, Kind::Up, 830, 300));
    CHECK(kiosk.state().ahead_ink.empty());
}

TEST_CASE("the pen pressed again draws the finer line, and once more the normal one", "[find mode]") {
    Kiosk kiosk(nullptr);
    kiosk.stroke(700, 200, 1000, 200);
    kiosk.tap(kiosk.layout().tools[0]);
    CHECK(kiosk.state().fine_pen);
    kiosk.stroke(700, 300, 1000, 300);
    CHECK(kiosk.find->sketch().widths() == std::vector<double>{1.0, 0.5});
    kiosk.tap(kiosk.layout().tools[1]);
    kiosk.tap(kiosk.layout().tools[0]);  // back from the eraser: the width stays
    CHECK(kiosk.state().fine_pen);
    kiosk.tap(kiosk.layout().tools[0]);
    CHECK_FALSE(kiosk.state().fine_pen);
}

TEST_CASE("drawing only what changed gives the pixels of the whole frame at every frame", "[find mode]") {
    test::FigureSearcher searcher(test::make_animals());
    Kiosk kiosk(&searcher);
    ui::Target kept({1280, 800}, ui::PixelFormat::Colour), anew({1280, 800}, ui::PixelFormat::Colour);
    bool first = true;
    int frames = 0;
    const auto frame = [&](std::int64_t later_us) {
        kiosk.now_us += later_us;
        kiosk.find->update(kiosk.now_us);
        kiosk.find->update_ink();
        kept.bind();
        if (std::exchange(first, false)) {
            kiosk.find->draw(kiosk.now_us, false);
        } else {
            kiosk.find->draw_changes(kiosk.now_us, false);
        }
        const std::vector<std::uint8_t> seen = kept.read_back().pixels;
        anew.bind();
        kiosk.find->draw(kiosk.now_us, false);
        REQUIRE(seen == anew.read_back().pixels);
        ++frames;
    };
    frame(0);
    kiosk.event(Kind::Down, 700, 300);
    for (int i = 1; i <= 4; ++i) {
        kiosk.event(Kind::Move, 700 + i * 60, 300 + (i % 2) * 25);
        kiosk.find->look_ahead(ui::WindowEvent{Kind::Move, 715.0 + i * 60, 310, 1.0, kiosk.now_us, false});
        frame(8'000);
    }
    kiosk.event(Kind::Up, 940, 330);
    kiosk.stroke(940, 330, 940, 600);
    frame(16'000);
    kiosk.find->search_and_wait();
    for (int i = 0; i < 8; ++i) frame(45'000);  // cards come and fade
    kiosk.now_us += 700'000;
    for (int i = 0; i < 3; ++i) frame(90'000);  // the wash comes
    kiosk.event(Kind::Down, 800, 650);
    frame(40'000);  // and goes
    kiosk.event(Kind::Up, 800, 650);
    kiosk.tap(kiosk.layout().tools[1]);
    kiosk.event(Kind::Down, 800, 650);
    frame(16'000);  // the eraser's ring, an undone stroke, another language, an empty sheet
    kiosk.event(Kind::Up, 800, 650);
    kiosk.tap(kiosk.layout().tools[2]);
    frame(16'000);
    kiosk.find->set_language(2);
    frame(16'000);
    kiosk.tap(kiosk.layout().tools[4]);
    frame(16'000);
    CHECK(frames > 20);
}
