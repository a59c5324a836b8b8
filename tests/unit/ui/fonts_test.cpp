#include "ui/draw/fonts.hpp"

#include <catch2/catch.hpp>

#include "ui/screens/strings.hpp"

namespace {

ui::FontSet fonts() {
    core::Result<ui::FontSet> set = ui::FontSet::load();
    if (!set) FAIL(set.error().sentence());
    return std::move(*set);
}

const ui::TextStyle kBody{ui::Face::Regular, 20, 0};

}  // namespace

TEST_CASE("text is as wide as its letters, larger when larger", "[text]") {
    const ui::FontSet set = fonts();
    CHECK(set.width_px("", kBody) == 0);
    const double word = set.width_px("Croquis", kBody);
    CHECK(word > 60);
    CHECK(word < 85);
    CHECK(set.width_px("Croquis", {ui::Face::Regular, 40, 0}) == Approx(2 * word).epsilon(0.01));
    CHECK(set.width_px("Croquis", {ui::Face::SemiBold, 20, 0}) > word);
    CHECK(set.width_px("Croquis", {ui::Face::Regular, 20, -0.03}) == Approx(word - 6 * 0.6));
}

TEST_CASE("figures are tabular", "[text]") {
    const ui::FontSet set = fonts();
    CHECK(set.width_px("111", kBody) == Approx(set.width_px("888", kBody)));
}

TEST_CASE("long names end in an ellipsis that still fits", "[text]") {
    const ui::FontSet set = fonts();
    CHECK(set.cut("Horse", kBody, 200) == "Horse");
    const std::string cut = set.cut("Grandfather clock", kBody, 90);
    CHECK(cut.find("…") != std::string::npos);
    CHECK(set.width_px(cut, kBody) <= 90);
    const std::string accents = set.cut("ééééééééééééééééé", kBody, 60);  // never half a letter
    CHECK(accents.size() % 2 == std::string("…").size() % 2);
}

TEST_CASE("sentences break between words", "[text]") {
    const ui::FontSet set = fonts();
    const std::vector<std::string> lines = set.wrap("The closest pieces appear here while you draw.", kBody, 300);
    CHECK(lines.size() == 2);
    for (const std::string& line : lines) CHECK(set.width_px(line, kBody) <= 300);
}

TEST_CASE("letters outside Inter come from Noto Sans", "[text]") {
    const ui::FontSet set = fonts();
    REQUIRE(set.has_inter());
    const ui::ShapedText& hindi = set.shape("क", kBody);  // neither font of the set need have it, but nothing fails
    CHECK_FALSE(hindi.glyphs.empty());
    const ui::GlyphImage letter = set.rasterise(0, set.shape("H", kBody).glyphs[0].glyph, 20, 0);
    CHECK(letter.coverage.height >= 13);
    CHECK(letter.coverage.height <= 17);
}

TEST_CASE("missing fonts are named with the package to install", "[text]") {
    const core::Result<ui::FontSet> none = ui::FontSet::load({"/nonexistent"});
    REQUIRE_FALSE(none);
    CHECK(none.error().code == core::ErrorCode::FileMissing);
    CHECK(none.error().message.find("fonts-inter") != std::string::npos);
    CHECK(ui::FontSet::load({"/usr/share/fonts/truetype/noto"}));  // Noto alone does
}

TEST_CASE("every language has the same keys and its own words", "[text]") {
    const core::Result<std::vector<ui::Strings>> all = ui::Strings::load_all();
    REQUIRE(all);
    REQUIRE(all->size() >= 3);
    CHECK((*all)[0].code() == "en");
    for (const ui::Strings& language : *all) {
        CHECK(language.keys() == (*all)[0].keys());
        for (const std::string& key : language.keys()) CHECK_FALSE(language[key].empty());
    }
    CHECK((*all)[1]["tool_pen"] == "Stylet");
    CHECK((*all)[0]["no such key"] == "no such key");
}

TEST_CASE("a damaged language file is refused with its name", "[text]") {
    CHECK(ui::Strings::parse("{", "x.json").error().where == "x.json");
    CHECK_FALSE(ui::Strings::parse(R"({"code": "xx"})", "x.json"));
    CHECK_FALSE(ui::Strings::parse(R"({"code": ["xx"], "short": "X", "name": "X"})", "x.json"));
}
