#include "firmware_like_app/kiosk/kiosk.hpp"

#include <sys/resource.h>
#include <unistd.h>
#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <mutex>

#include "firmware_like_app/kiosk/drawing_recorder.hpp"
#include "input/formats/any_ink.hpp"
#include "tests/support/figures.hpp"

namespace {

/// A folder that goes away with the test.
struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("croquis-kiosk-" + std::to_string(getpid()) + "-" + std::to_string(next()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    static int next() {
        static int n = 0;
        return n++;
    }
};

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

app::KioskOptions headless(const std::filesystem::path& shots) {
    app::KioskOptions options;
    options.headless = true;
    options.size = ui::SizePx{1280, 800};
    options.shots = shots;
    return options;
}

std::vector<app::NamedDrawing> two_drawings() {
    core::Drawing half = test::make_horse_drawing();
    half.strokes.pop_back();
    return {{"a horse", test::make_horse_drawing()}, {"half/horse", half}};
}

/// Keeps every drawing it is asked for.
class NotingSearcher : public test::FigureSearcher {
  public:
    NotingSearcher() : FigureSearcher(test::make_animals()) {}
    app::SearchAnswer search(const core::Drawing& drawing, std::stop_token stop) override {
        drawings.push_back(drawing);
        return FigureSearcher::search(drawing, stop);
    }
    std::vector<core::Drawing> drawings;
};

}  // namespace

TEST_CASE("two replays give the same pictures, byte for byte", "[kiosk]") {
    const Folder first, second;
    for (const Folder* folder : {&first, &second}) {
        test::FigureSearcher searcher(test::make_animals());
        const auto report = app::run_kiosk(headless(folder->path), &searcher, two_drawings());
        if (!report) FAIL(report.error().sentence());
        REQUIRE(report->replays.size() == 2);
        CHECK(report->replays[0].name == "a horse");
        CHECK(report->replays[0].shots.size() == 4);
        CHECK(report->replays[0].names.at(0) == "horse");
        CHECK(report->replays[0].ids.size() == 9);
    }
    int compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(first.path)) {
        CHECK(bytes_of(entry.path()) == bytes_of(second.path / entry.path().filename()));
        ++compared;
    }
    CHECK(compared == 8);
    CHECK(std::filesystem::exists(first.path / "0001-a-horse-025.png"));
    CHECK(std::filesystem::exists(first.path / "0008-half-horse-100.png"));
}

TEST_CASE("the searcher gets the drawing's own numbers, whatever the size of the screen", "[kiosk]") {
    NotingSearcher searcher;
    const Folder folder;
    REQUIRE(app::run_kiosk(headless({}), &searcher, {{"horse", test::make_horse_drawing()}}));
    REQUIRE_FALSE(searcher.drawings.empty());
    const core::Drawing& last = searcher.drawings.back();
    const core::Drawing given = test::make_horse_drawing();
    REQUIRE(last.strokes.size() == given.strokes.size());
    for (std::size_t i = 0; i < given.strokes.size(); ++i) {
        REQUIRE(last.strokes[i].samples.size() == given.strokes[i].samples.size());
        for (std::size_t k = 0; k < given.strokes[i].samples.size(); ++k) {
            CHECK(last.strokes[i].samples[k].x == given.strokes[i].samples[k].x);
            CHECK(last.strokes[i].samples[k].y == given.strokes[i].samples[k].y);
        }
    }
    CHECK(searcher.drawings.size() == given.strokes.size());  // once after each stroke
}

TEST_CASE("odd drawings pass through the replay: nothing, a dot, no times", "[kiosk]") {
    test::FigureSearcher searcher(test::make_animals());
    core::Drawing dot, untimed;
    dot.strokes.push_back({{{0, 5, 5, 1}}});
    untimed.strokes.push_back({{{0, 0, 0, 1}, {0, 100, 0, 1}, {0, 100, 50, 1}, {0, 0, 50, 1}}});
    const Folder folder;
    const auto report =
        app::run_kiosk(headless(folder.path), &searcher, {{"nothing", {}}, {"dot", dot}, {"untimed", untimed}});
    if (!report) FAIL(report.error().sentence());
    CHECK(report->replays[0].ids.empty());
    CHECK(report->replays[1].ids.empty());
    CHECK(report->replays[1].message_key == "too_little");
    CHECK(report->replays[2].ids.size() == 9);
    for (const app::ReplayReport& replay : report->replays) CHECK(replay.shots.size() == 4);
}

TEST_CASE("without a searcher the sheet still works, and notices are drawn", "[kiosk]") {
    const Folder folder;
    REQUIRE(app::run_kiosk(headless(folder.path), nullptr, {{"horse", test::make_horse_drawing()}}));
    app::KioskOptions options = headless(folder.path);
    options.collection = app::CollectionState::Damaged;
    const auto report = app::run_kiosk(options, nullptr, {});
    REQUIRE(report);
    CHECK(report->replays[0].shots.size() == 1);
}

TEST_CASE("wrong calls are named", "[kiosk]") {
    app::KioskOptions options = headless({});
    CHECK(app::run_kiosk(options, nullptr, {}).error().code == core::ErrorCode::BadArgument);
    options.language = "xx";
    options.shots = std::filesystem::temp_directory_path();
    CHECK(app::run_kiosk(options, nullptr, {}).error().message.find("xx") != std::string::npos);
    options.language = "en";
    options.shots = "/proc/none/here";
    CHECK(app::run_kiosk(options, nullptr, {}).error().code == core::ErrorCode::WriteFailed);
}

TEST_CASE("without a screen the window says so in one sentence", "[kiosk]") {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) unsetenv(name);
    setenv("SDL_VIDEODRIVER", "x11", 1);
    const auto report = app::run_kiosk({}, nullptr, {});
    REQUIRE_FALSE(report);
    CHECK(report.error().code == core::ErrorCode::NoDisplay);
    CHECK(report.error().message.find("--headless") != std::string::npos);
}

TEST_CASE("kept drawings never overwrite each other", "[kiosk]") {
    const Folder folder;
    for (int i = 0; i < 2; ++i) {
        app::DrawingRecorder recorder(folder.path);
        REQUIRE(recorder.keep(test::make_horse_drawing()));
        REQUIRE(recorder.keep({}));
    }
    CHECK(bytes_of(folder.path / "drawing-0001.trace") == bytes_of(folder.path / "drawing-0002.trace"));
    CHECK_FALSE(std::filesystem::exists(folder.path / "drawing-0003.trace"));
}

TEST_CASE("a drawing for which there is no room leaves no part of itself", "[kiosk]") {
    const Folder folder;
    rlimit before{};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{200, before.rlim_max};  // stands for a full disk
    REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
    const auto kept = app::DrawingRecorder(folder.path).keep(test::make_horse_drawing());
    REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
    std::signal(SIGXFSZ, handler);
    REQUIRE_FALSE(kept);
    CHECK(kept.error().code == core::ErrorCode::WriteFailed);
    CHECK(std::filesystem::is_empty(folder.path));
}

TEST_CASE("a free name is found among many, and behind those that are there", "[kiosk]") {
    const Folder folder;
    const auto touch = [&](int number) {
        std::array<char, 32> name{};
        std::snprintf(name.data(), name.size(), "drawing-%04d.trace", number);
        std::ofstream(folder.path / name.data());
    };
    CHECK(app::next_free(folder.path, "drawing") == folder.path / "drawing-0001.trace");
    for (int number = 1; number <= 300; ++number) {
        touch(number);
        std::array<char, 32> next{};
        std::snprintf(next.data(), next.size(), "drawing-%04d.trace", number + 1);
        REQUIRE(app::next_free(folder.path, "drawing") == folder.path / next.data());
    }
    for (const int gone : {1, 2, 64, 150, 299}) {
        std::array<char, 32> name{};
        std::snprintf(name.data(), name.size(), "drawing-%04d.trace", gone);
        std::filesystem::remove(folder.path / name.data());
        CHECK_FALSE(std::filesystem::exists(app::next_free(folder.path, "drawing")));
    }
}

TEST_CASE("a kept drawing reads back to the bit", "[kiosk]") {
    const Folder folder;
    const core::Drawing drawn = test::make_horse_drawing();
    REQUIRE(app::DrawingRecorder(folder.path).keep(drawn));
    const auto read = input::read_drawing_of_ink((folder.path / "drawing-0001.trace").string());
    if (!read) FAIL(read.error().sentence());
    REQUIRE(read->strokes.size() == drawn.strokes.size());
    for (std::size_t i = 0; i < drawn.strokes.size(); ++i) {
        REQUIRE(read->strokes[i].samples.size() == drawn.strokes[i].samples.size());
        for (std::size_t k = 0; k < drawn.strokes[i].samples.size(); ++k) {
            const core::PenSample &a = read->strokes[i].samples[k], &b = drawn.strokes[i].samples[k];
            CHECK((a.x == b.x && a.y == b.y && a.pressure == b.pressure));
        }
    }
}

TEST_CASE("long replays are not wiped as if nobody were there", "[kiosk]") {
    test::FigureSearcher searcher(test::make_animals());
    std::vector<app::NamedDrawing> many(45, {"horse", test::make_horse_drawing()});  // above two minutes
    const auto report = app::run_kiosk(headless({}), &searcher, many);
    REQUIRE(report);
    for (const app::ReplayReport& replay : report->replays) {
        CHECK(replay.ids == report->replays[0].ids);
        CHECK(replay.searches == report->replays[0].searches);
    }
}
