#include "firmware_like_app/garment/gallery_desk.hpp"

#include <catch2/catch.hpp>

#include "core/exchange/png_writer.hpp"
#include "tests/support/temporary_folder.hpp"

using app::GalleryDesk;
using app::GalleryWish;
using ui::GalleryAction;

namespace {

constexpr std::int64_t kDay_us = 86'400'000'000;

struct Stand {
    support::TemporaryFolder folder;
    ui::FontSet fonts = *ui::FontSet::load();
    std::vector<ui::Strings> languages = *ui::Strings::load_all();
    std::int64_t now_us = 100 * kDay_us;
    app::GalleryOptions options{.bin_days = 30, .store = {.now_us = [this] { return now_us; }}};
    db::DesignStore store = *db::DesignStore::open(folder.path("designs.db"), db::OpenMode::Create, options.store);
    GalleryDesk desk{fonts, languages, folder.path("designs.db"), options};

    std::int64_t add(const std::string& name) {
        core::Design design;
        design.name = name;
        design.body = *core::measures_of_size("38");
        now_us += 1;
        return *store.create(design);
    }
    std::optional<GalleryWish> press(GalleryAction action, std::size_t index = 0) {
        now_us += 1;
        return desk.press(ui::gallery_item(action, index), now_us);
    }
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> out;
        for (const ui::GalleryCard& card : desk.state().cards) out.push_back(card.name);
        return out;
    }
    void write(const std::string& name) {
        for (const char c : name) {
            const auto keys = ui::keyboard_layout(*desk.state().rename, languages[0], {1920, 1080}).keys;
            for (std::size_t k = 0; k < keys.size(); ++k)
                if (keys[k].letter == std::string(1, c)) {
                    press(GalleryAction::Key, k);
                    break;
                }
        }
        key(ui::KeyboardKey::Kind::Save);
    }
    void key(ui::KeyboardKey::Kind kind) {
        const auto keys = ui::keyboard_layout(*desk.state().rename, languages[0], {1920, 1080}).keys;
        for (std::size_t k = 0; k < keys.size(); ++k)
            if (keys[k].kind == kind) {
                press(GalleryAction::Key, k);
                return;
            }
    }
};

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("designs are copied, renamed, deleted and put back by touch", "[gallery_desk]") {
    Stand stand;
    stand.add("dress");
    const std::int64_t skirt = stand.add("skirt");
    const std::int64_t open = stand.add("jacket");
    stand.desk.open(open, 0, ui::Hand::Right);
    CHECK(stand.names() == Names{"jacket", "skirt", "dress"});
    CHECK(stand.desk.state().cards[0].open);

    CHECK_FALSE(stand.press(GalleryAction::Duplicate, 2));
    CHECK(stand.names() == Names{"dress – copy", "jacket", "skirt", "dress"});
    stand.press(GalleryAction::Rename, 0);
    REQUIRE(stand.desk.state().rename);
    CHECK(stand.desk.state().rename->text == "dress – copy");
    stand.write("Gown2");
    CHECK_FALSE(stand.desk.state().rename);
    CHECK(stand.names() == Names{"Gown2", "jacket", "skirt", "dress"});

    stand.press(GalleryAction::Delete, 2);
    CHECK(stand.names() == Names{"Gown2", "jacket", "dress"});
    CHECK(stand.desk.state().deleted == "skirt");
    stand.press(GalleryAction::UndoDelete);
    CHECK(stand.names() == Names{"Gown2", "jacket", "skirt", "dress"});
    CHECK(stand.desk.state().deleted.empty());
    stand.press(GalleryAction::Delete, 2);
    stand.desk.update(stand.now_us + 7'000'000);
    CHECK_FALSE(stand.desk.state().deleted.empty());
    stand.desk.update(stand.now_us + 8'000'001);
    CHECK(stand.desk.state().deleted.empty());
    stand.press(GalleryAction::Delete, 1);  // on the sheet
    CHECK(stand.names().size() == 3);

    stand.press(GalleryAction::Shelf, 1);
    CHECK(stand.names() == Names{"skirt"});
    stand.press(GalleryAction::Restore, 0);
    CHECK(stand.names().empty());
    stand.press(GalleryAction::Shelf, 0);
    CHECK(stand.names() == Names{"Gown2", "jacket", "skirt", "dress"});

    const auto wish = stand.press(GalleryAction::Open, 2);
    REQUIRE(wish);
    CHECK(wish->kind == GalleryWish::Kind::Open);
    CHECK(wish->id == skirt);
    CHECK(stand.press(GalleryAction::New)->kind == GalleryWish::Kind::New);
    CHECK(stand.press(GalleryAction::Close)->kind == GalleryWish::Kind::Close);
    CHECK_FALSE(stand.press(GalleryAction::Open, 99));
}

TEST_CASE("the name of the design on the sheet goes through its journal", "[gallery_desk]") {
    Stand stand;
    const std::int64_t open = stand.add("jacket");
    stand.desk.open(open, 0, ui::Hand::Right);
    stand.press(GalleryAction::Rename, 0);
    stand.write("Coat");
    CHECK(stand.desk.take_new_name() == "Coat");
    CHECK_FALSE(stand.desk.take_new_name());
    CHECK(stand.names() == Names{"Coat"});
    CHECK(stand.store.find(open)->name == "jacket");  // the mode's journal stores it
    stand.press(GalleryAction::Rename, 0);
    stand.key(ui::KeyboardKey::Kind::Erase);
    stand.key(ui::KeyboardKey::Kind::Save);  // nothing to save
    CHECK(stand.desk.state().rename);
    stand.key(ui::KeyboardKey::Kind::Cancel);
    CHECK_FALSE(stand.desk.state().rename);
}

TEST_CASE("the bin empties itself; pictures are handed out once", "[gallery_desk]") {
    Stand stand;
    const std::int64_t dress = stand.add("dress"), skirt = stand.add("skirt");
    core::RgbaImage image{3, 4, std::vector<std::uint8_t>(48, 200)};
    REQUIRE(stand.store.set_thumbnail(skirt, *core::png_bytes(image)));
    REQUIRE(stand.store.remove(dress));
    stand.now_us += 31 * kDay_us;
    stand.desk.open(0, 2, ui::Hand::Left);
    CHECK(stand.store.list(db::Shelf::Bin)->empty());
    stand.desk.look({1280, 800}, 5);
    const auto pictures = stand.desk.take_pictures();
    REQUIRE(pictures.size() == 1);
    CHECK(pictures[0].second.pixels == image.pixels);
    CHECK(stand.desk.state().cards[0].picture == pictures[0].first);
    CHECK(stand.desk.take_pictures().empty());
    CHECK(stand.desk.state().cards[0].date.size() == 10);
}

TEST_CASE("of many designs only the pictures on the screen are read, some at a time, and the others let go",
          "[gallery_desk]") {
    constexpr ui::SizePx kScreen{1280, 800};
    Stand stand;
    const std::vector<std::byte> png = *core::png_bytes({3, 4, std::vector<std::uint8_t>(48, 200)});
    for (int k = 0; k < 40; ++k) REQUIRE(stand.store.set_thumbnail(stand.add("d" + std::to_string(k)), png));
    stand.add("without");
    stand.desk.open(0, 0, ui::Hand::Right);
    CHECK(stand.desk.take_pictures().empty());
    const std::size_t seen = stand.desk.page(kScreen, std::nullopt).seen.size();
    REQUIRE(seen >= 4);
    REQUIRE(seen <= 12);
    stand.desk.look(kScreen, 2);  // the one without and the first
    const auto first = stand.desk.take_pictures();
    REQUIRE(first.size() == 1);
    CHECK_FALSE(stand.desk.state().cards[0].picture);
    CHECK(stand.desk.state().cards[1].picture == first[0].first);
    stand.desk.look(kScreen, 100);
    CHECK(stand.desk.take_pictures().size() == seen - 2);
    stand.desk.look(kScreen, 100);
    CHECK(stand.desk.take_pictures().empty());
    CHECK(stand.desk.shows(first[0].first));

    stand.desk.scroll(1e6, kScreen);
    stand.desk.look(kScreen, 100);
    const std::size_t last = stand.desk.take_pictures().size();
    CHECK(last > 0);
    CHECK(last <= seen);
    CHECK_FALSE(stand.desk.shows(first[0].first));
    CHECK_FALSE(stand.desk.state().cards[1].picture);
    CHECK(stand.desk.state().cards.back().picture);

    const ui::PictureId kept = *stand.desk.state().cards.back().picture;
    stand.press(GalleryAction::Rename, stand.desk.state().cards.size() - 1);
    stand.write("z");
    stand.desk.look(kScreen, 100);
    CHECK(stand.desk.state().cards.size() == 41);
    CHECK(stand.desk.shows(kept) == (stand.desk.state().cards.back().picture == kept));
}

TEST_CASE("a file that is none is said, and nothing else happens", "[gallery_desk]") {
    Stand stand;
    GalleryDesk desk(stand.fonts, stand.languages, stand.folder.write("diary.txt", "Dear diary"), stand.options);
    desk.open(0, 0, ui::Hand::Right);
    CHECK(desk.state().cards.empty());
    CHECK(desk.state().message == "diary.txt: This is no file of designs. Staff: name another one in the settings.");
    const std::string english = desk.state().message;
    for (std::size_t language = 1; language < stand.languages.size(); ++language) {
        desk.open(0, language, ui::Hand::Right);
        CHECK(desk.state().message != english);
        CHECK(desk.state().message.starts_with("diary.txt: "));
    }
    CHECK_FALSE(desk.press(ui::gallery_item(GalleryAction::Delete, 0), 1));
    CHECK_FALSE(desk.press(ui::gallery_item(GalleryAction::Shelf, 1), 1));
}
