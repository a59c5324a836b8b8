#include "ui/screens/gallery_screen.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

using ui::GalleryAction;
using ui::GalleryState;
using ui::NameEdit;
using ui::Rect;

namespace {

struct Stand {
    ui::FontSet fonts = *ui::FontSet::load();
    std::vector<ui::Strings> languages = *ui::Strings::load_all();
    ui::GalleryScreen screen{fonts, languages};
};

GalleryState state_of(int cards) {
    GalleryState state;
    for (int i = 0; i < cards; ++i) state.cards.push_back({"Design " + std::to_string(i), "2026-11-25", {}, i == 1});
    return state;
}

std::vector<Rect> rects_of(const ui::GalleryPage& page, GalleryAction action) {
    std::vector<Rect> found;
    for (const ui::BoardTouch::Target& t : page.targets)
        if (ui::gallery_action(t.item) == action) found.push_back(t.rect);
    return found;
}

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

std::set<std::string> texts_of(const ui::GalleryPage& page) {
    std::set<std::string> texts;
    for (const ui::DrawCommand& command : page.list.commands)
        if (const auto* text = std::get_if<ui::TextCommand>(&command)) texts.insert(text->text);
    return texts;
}

const std::vector<ui::SizePx> kSizes{{1920, 1080}, {1280, 800}, {3840, 2160}, {1080, 1920}};

}  // namespace

TEST_CASE("every touch in the gallery has room and stands apart, in all states and languages", "[gallery]") {
    const Stand stand;
    for (std::size_t language = 0; language < stand.languages.size(); ++language)
        for (const ui::SizePx size : kSizes)
            for (const ui::Hand hand : {ui::Hand::Right, ui::Hand::Left})
                for (const int variant : {0, 1, 2, 3}) {
                    GalleryState state = state_of(5);
                    state.language = language;
                    state.hand = hand;
                    state.bin = variant == 1;
                    if (variant == 2) state.deleted = "Dress";
                    if (variant == 3) state.rename = NameEdit{.text = "Dress"};
                    const ui::GalleryPage page = stand.screen.build(state, size);
                    REQUIRE(page.targets.size() > 5);
                    for (std::size_t i = 0; i < page.targets.size(); ++i) {
                        const Rect& r = page.targets[i].rect;
                        INFO("item " << page.targets[i].item << " at " << r.x << ", " << r.y << ", " << r.width << " x "
                                     << r.height << " of " << size.width);
                        CHECK(r.height >= 63.9);
                        CHECK(r.width >= (variant == 3 ? 50 : 63.9));
                        CHECK(r.x >= 0);
                        CHECK(r.right() <= size.width + 0.5);
                        for (std::size_t k = i + 1; k < page.targets.size(); ++k)
                            CHECK_FALSE(overlap(r, page.targets[k].rect));
                    }
                }
}

TEST_CASE("what can be touched is what the state offers", "[gallery]") {
    const Stand stand;
    const ui::GalleryPage kept = stand.screen.build(state_of(3), {1920, 1080});
    CHECK(rects_of(kept, GalleryAction::Open).size() == 3);
    CHECK(rects_of(kept, GalleryAction::Duplicate).size() == 3);
    CHECK(rects_of(kept, GalleryAction::Delete).size() == 2);  // the one on the sheet stays
    CHECK(rects_of(kept, GalleryAction::Restore).empty());
    CHECK(rects_of(kept, GalleryAction::New).size() == 1);
    GalleryState bin = state_of(3);
    bin.bin = true;
    const ui::GalleryPage thrown = stand.screen.build(bin, {1920, 1080});
    CHECK(rects_of(thrown, GalleryAction::Open).empty());
    CHECK(rects_of(thrown, GalleryAction::Restore).size() == 3);
    GalleryState writing = state_of(3);
    writing.rename = NameEdit{.text = "A"};
    const ui::GalleryPage keyboard = stand.screen.build(writing, {1920, 1080});
    CHECK(rects_of(keyboard, GalleryAction::Key).size() == keyboard.targets.size());
    CHECK(stand.screen.build(state_of(0), {1920, 1080}).targets.size() == 4);  // close, new, two shelves
}

TEST_CASE("the gallery scrolls to its last card and no card is touched under the header", "[gallery]") {
    const Stand stand;
    GalleryState state = state_of(40);
    state.scroll = stand.screen.build(state, {1280, 800}).most_scroll;
    REQUIRE(state.scroll > 2000);
    const ui::GalleryPage page = stand.screen.build(state, {1280, 800});
    CHECK(texts_of(page).count("Design 39") == 1);
    CHECK(texts_of(page).count("Design 0") == 0);
    CHECK(page.most_scroll == state.scroll);
    const Rect close = rects_of(page, GalleryAction::Close).front();
    for (const Rect& r : rects_of(page, GalleryAction::Open)) CHECK(r.centre_y() > close.bottom());
    CHECK(stand.screen.build(state_of(2), {1920, 1080}).most_scroll == 0);
}

TEST_CASE("left-handed, buttons stand on the other side", "[gallery]") {
    const Stand stand;
    GalleryState state = state_of(2);
    const Rect right = rects_of(stand.screen.build(state, {1920, 1080}), GalleryAction::Close).front();
    state.hand = ui::Hand::Left;
    const Rect left = rects_of(stand.screen.build(state, {1920, 1080}), GalleryAction::Close).front();
    CHECK(left.x == 1920 - right.right());
}

TEST_CASE("a name is written letter by letter", "[gallery]") {
    NameEdit edit{.text = "skirt", .shift = true};
    edit.type("é");  // in place of the old name, a capital
    edit.type("t");
    edit.type("é");
    CHECK(edit.text == "Été");
    edit.erase();
    CHECK(edit.text == "Ét");
    edit.type(" ");
    CHECK(edit.name() == "Ét");
    for (int i = 0; i < 60; ++i) edit.type("ü");
    CHECK(edit.text.size() == 3 + 1 + 2 * 37);
    NameEdit old{.text = "skirt"};
    old.erase();
    CHECK(old.text.empty());
    old.erase();
    CHECK(old.name().empty());
    for (const auto& [small, large] : std::vector<std::pair<std::string, std::string>>{
             {"a", "A"}, {"1", "1"}, {"ß", "ß"}, {"ö", "Ö"}, {"÷", "÷"}, {"œ", "Œ"}, {"ÿ", "Ÿ"}, {"’", "’"}})
        CHECK(ui::capital_of(small) == large);
}

TEST_CASE("every language brings the keys of its alphabet", "[gallery]") {
    const Stand stand;
    for (const ui::Strings& words : stand.languages) {
        std::set<std::string> keys;
        for (const ui::KeyboardKey& key : ui::keyboard_layout({}, words, {1280, 800}).keys) keys.insert(key.letter);
        INFO(words.code());
        for (char c = 'a'; c <= 'z'; ++c) CHECK(keys.count(std::string(1, c)) == 1);
        for (char c = '0'; c <= '9'; ++c) CHECK(keys.count(std::string(1, c)) == 1);
    }
}
