#include "firmware_like_app/config/config.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "firmware_like_app/config/options.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

std::string sentence_of(const std::string& text) {
    const auto config = app::parse_config(text, "croquis.toml");
    REQUIRE_FALSE(config);
    CHECK(config.error().where == "croquis.toml");
    return config.error().message;
}

bool says(const std::string& sentence, const std::string& words) {
    return sentence.find(words) != std::string::npos;
}

std::string content(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("the default file reads as the defaults, and names every option", "[config]") {
    const std::string text = app::default_config_text();
    const auto config = app::parse_config(text, "");
    if (!config) FAIL(config.error().sentence());
    CHECK(config->idle.ask_s == 60);
    CHECK(config->visitors.language == "en");
    CHECK(config->visitors.attract);
    CHECK(config->tablet.area.empty());
    CHECK(config->station.pin == "000000");
    for (const app::Option& option : app::all_options()) CHECK(says(text, "\n" + option.name + " = "));
    CHECK(app::parse_config("", "").has_value());
}

TEST_CASE("every kind of value is read", "[config]") {
    const auto config = app::parse_config(
        "[visitors]\nlanguage = \"de\"\nhand = 'left'\nattract = false\n"
        "[idle]\nask_s = 90\ncountdown_s = 12.5\n[collection]\nsearch_threads = 3\n[tablet]\narea = [0, 0.1, 1, 0.9]\n",
        "");
    REQUIRE(config);
    CHECK(config->visitors.language == "de");
    CHECK(config->visitors.hand == "left");
    CHECK_FALSE(config->visitors.attract);
    CHECK(config->idle.ask_s == 90);
    CHECK(config->idle.countdown_s == 12.5);
    CHECK(config->collection.search_threads == 3);
    CHECK(config->tablet.area == std::vector<double>{0, 0.1, 1, 0.9});
}

TEST_CASE("what is wrong is said with line and key, and names that are near are offered", "[config]") {
    const std::string typo = sentence_of("# a comment\n[idle]\nask_sec = 90\n");
    CHECK(says(typo, "line 3"));
    CHECK(says(typo, "idle.ask_sec"));
    CHECK(says(typo, "did you mean idle.ask_s?"));
    const std::string section = sentence_of("\n[visitor]\n");
    CHECK(says(section, "line 2"));
    CHECK(says(section, "did you mean visitors?"));
    CHECK_FALSE(says(sentence_of("[nothing_like_it_at_all]\n"), "did you mean"));
    CHECK(says(sentence_of("ask_s = 4\n"), "line 1"));

    const std::string type = sentence_of("[visitors]\nattract = \"yes\"\n");
    CHECK(says(type, "line 2"));
    CHECK(says(type, "visitors.attract"));
    CHECK(says(type, "true or false"));
    CHECK(says(sentence_of("[idle]\nask_s = 5\n"), "from 10 to 3600"));
    CHECK(says(sentence_of("[idle]\nask_s = true\n"), "a number"));
    CHECK(says(sentence_of("[idle]\nask_s = nan\n"), "a number"));
    CHECK(says(sentence_of("[collection]\nsearch_threads = 1.5\n"), "whole number"));
    CHECK(says(sentence_of("[visitors]\nhand = \"both\"\n"), "\"right\", \"left\""));
    CHECK(says(sentence_of("[station]\npin = \"12a4\"\n"), "four to eight digits"));
    CHECK(says(sentence_of("[station]\npin = 1234\n"), "quotes"));
    CHECK(says(sentence_of("[tablet]\narea = [0, 0, 0, 1]\n"), "left < right"));
    CHECK(says(sentence_of("[tablet]\narea = [0, 0, \"1\", 1]\n"), "numbers in brackets"));
    CHECK(says(sentence_of("[screen]\nsize = \"20x20\"\n"), "320x240"));
    const std::string syntax = sentence_of("[idle]\nask_s = = 3\n");
    CHECK(says(syntax, "line 2"));
    CHECK(says(syntax, "TOML"));
    CHECK(says(sentence_of("[idle]\nask_s = 60\nask_s = 70\n"), "line 3"));
}

TEST_CASE("a file that is not there or is a folder is named", "[config]") {
    const auto missing = app::read_config("/nowhere/croquis.toml");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().code == core::ErrorCode::FileMissing);
    CHECK(missing.error().where == "/nowhere/croquis.toml");
    CHECK(app::read_config("/").error().code == core::ErrorCode::FileUnreadable);
}

TEST_CASE("a pipe is not waited for, nor a device read without end", "[config]") {
    const support::TemporaryFolder folder;
    const std::string pipe = folder.path("pipe.toml");
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    for (const std::string& path : {pipe, std::string("/dev/zero")}) {
        const auto config = app::read_config(path);
        REQUIRE_FALSE(config);
        CHECK(config.error().code == core::ErrorCode::FileUnreadable);
        CHECK(config.error().where == path);
    }
}

TEST_CASE("the command line sets what the file sets, without quotes", "[config]") {
    app::Config config;
    REQUIRE(app::set_option(config, "visitors.language=fr"));
    REQUIRE(app::set_option(config, "idle.ask_s=120"));
    REQUIRE(app::set_option(config, "visitors.attract=false"));
    REQUIRE(app::set_option(config, "tablet.area=[0, 0, 0.5, 0.5]"));
    CHECK(config.visitors.language == "fr");
    CHECK(config.idle.ask_s == 120);
    CHECK_FALSE(config.visitors.attract);
    CHECK(config.tablet.area.size() == 4);
    CHECK(says(app::set_option(config, "idle.aks_s=1").error().message, "did you mean idle.ask_s?"));
    CHECK(says(app::set_option(config, "idle.ask_s=soon").error().message, "soon"));
    CHECK(says(app::set_option(config, "idle").error().message, "section.name=value"));
    CHECK(app::set_option(config, "idle.ask_s=1").error().code == core::ErrorCode::BadArgument);
}

TEST_CASE("saving changes its own lines only, and makes the file where there is none", "[config]") {
    const support::TemporaryFolder folder;
    const std::string path = folder.path("croquis.toml");
    std::ofstream(path)
        << "# ours\n[idle]\n# patient people\nask_s = 90   # seconds\n\n[visitors]\nlanguage = \"fr\"\n";
    REQUIRE(app::save_options(path, {{"idle.ask_s", "75"}, {"idle.countdown_s", "15"}, {"tablet.pressure", "soft"}}));
    const std::string text = content(path);
    CHECK(says(text,
               "# ours\n[idle]\n# patient people\nask_s = 75\ncountdown_s = 15\n\n[visitors]\nlanguage = \"fr\"\n"));
    CHECK(says(text, "[tablet]\npressure = \"soft\"\n"));
    const auto config = app::read_config(path);
    REQUIRE(config);
    CHECK(config->idle.ask_s == 75);
    CHECK(config->visitors.language == "fr");

    const std::string fresh = folder.path("new.toml");
    REQUIRE(app::save_options(fresh, {{"visitors.hand", "left"}}));
    CHECK(app::read_config(fresh)->visitors.hand == "left");
    CHECK(says(content(fresh), "# Where the station stands"));
    CHECK_FALSE(app::save_options(fresh, {{"idle.ask_s", "1"}}));
    CHECK(app::read_config(fresh)->idle.ask_s == 60);
    CHECK_FALSE(app::save_options("/nowhere/at/all.toml", {{"visitors.hand", "left"}}));

    const std::string blocked = folder.path("blocked.toml");
    std::filesystem::create_directories(blocked + "/inside");
    CHECK_FALSE(app::save_options(blocked, {{"visitors.hand", "left"}}));
    CHECK_FALSE(std::filesystem::exists(blocked + ".new"));
}
