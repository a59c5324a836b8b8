#include "core/exchange/quickdraw_reader.hpp"

#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"

TEST_CASE("a raw line gives strokes with times in microseconds", "[quickdraw_reader]") {
    const auto drawing =
        core::parse_quickdraw_line(R"({"word":"line","drawing":[[[1,2.5],[3,4],[10,26.5]],[[7],[8],[100]]]})");
    REQUIRE(drawing);
    REQUIRE(drawing->strokes.size() == 2);
    const core::PenSample& second = drawing->strokes[0].samples[1];
    CHECK(second.x == 2.5);
    CHECK(second.y == 4.0);
    CHECK(second.time_us == 16'500);
    CHECK(second.pressure == 1.0);
    CHECK(drawing->strokes[1].samples[0].time_us == 90'000);
}

TEST_CASE("a simplified line gives strokes at a constant speed", "[quickdraw_reader]") {
    const auto drawing = core::parse_quickdraw_line(R"({"drawing":[[[0,30],[0,40]]]})");
    REQUIRE(drawing);
    CHECK(drawing->strokes[0].samples[1].time_us == 1'000'000);
}

TEST_CASE("a path may name a line of the file", "[quickdraw_reader]") {
    CHECK(core::split_line_path("a.ndjson:12").line == 12);
    CHECK(core::split_line_path("a.ndjson:12").file == "a.ndjson");
    CHECK(core::split_line_path("a.ndjson").file == "a.ndjson");
    CHECK(core::split_line_path("c:thing").file == "c:thing");
    CHECK(core::split_line_path("a:").file == "a:");
    CHECK(core::split_line_path("a:99999999999999999999999").line == 0);

    const support::TemporaryFolder folder;
    const std::string path =
        folder.write("two.ndjson", "{\"drawing\":[[[1,2],[1,2]]]}\n{\"drawing\":[[[5,6],[5,6]]]}\n");
    CHECK(core::read_quickdraw(path)->strokes[0].samples[0].x == 1.0);
    CHECK(core::read_quickdraw(path + ":1")->strokes[0].samples[0].x == 5.0);
    for (const char* beyond : {":2", ":3", ":1000000"}) {
        const auto none = core::read_quickdraw(path + beyond);
        REQUIRE_FALSE(none);
        CHECK(none.error().message.starts_with("the file has 2 lines, so there is no line "));
    }
    const std::string open_end = folder.write("one.ndjson", "{\"drawing\":[[[1,2],[1,2]]]}");
    CHECK(core::read_quickdraw(open_end + ":0"));
    CHECK(core::read_quickdraw(open_end + ":1").error().message.starts_with("the file has 1 line,"));
    CHECK(core::read_quickdraw(folder.path("none.ndjson:1")).error().code == core::ErrorCode::FileMissing);
}

TEST_CASE("lines that are no drawings are refused with a sentence", "[quickdraw_reader]") {
    const auto refusal = [](std::string_view line) { return core::parse_quickdraw_line(line).error().message; };
    CHECK(refusal("") == "the line is no JSON object; give a line of a Quick, Draw! file");
    CHECK(refusal("[1,2]") == refusal(""));
    CHECK(refusal("{\"drawing\":[[[1],[1]]") == refusal(""));
    CHECK(refusal("{\"word\":\"cat\"}") == "the line has no \"drawing\" list; give a line of a Quick, Draw! file");
    const std::string shape = "a stroke of the drawing is not [[x, …], [y, …]] with an optional [t, …] of equal length";
    for (const char* drawing : {"[5]", "[[]]", "[[[1,2]]]", "[[[1,2],[1]]]", "[[[1],[\"a\"]]]", "[[[1],[1],[null]]]"}) {
        CHECK(refusal("{\"drawing\":" + std::string(drawing) + "}") == shape);
    }
    CHECK(refusal("{\"drawing\":[[[1e99],[1]]]}") ==
          "a coordinate is no finite number within ten million; check the file");
    CHECK(refusal("{\"drawing\":[[[1e999],[1]]]}") == refusal(""));
    CHECK(core::parse_quickdraw_line("{\"drawing\":[]}").error().code == core::ErrorCode::EmptyDrawing);
    CHECK(core::parse_quickdraw_line("{\"drawing\":[[[],[]]]}").error().code == core::ErrorCode::EmptyDrawing);
    CHECK_FALSE(core::parse_quickdraw_line(std::string(100'000, '[')));
    CHECK_FALSE(core::parse_quickdraw_line("{\"drawing\":" + std::string(1'000'000, '[')));
}
