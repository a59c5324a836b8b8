#include "core/exchange/stroke_list_reader.hpp"

#include <catch2/catch.hpp>

TEST_CASE("a stroke list gives points with time and pressure where it has them", "[stroke_list_reader]") {
    const auto drawing = core::parse_stroke_list(
        R"({"strokes":[{"points":[[0,0,0,0.25],[3,4,20,0.5]]},{"points":[[1,1,100]]}],"unit":"mm"})");
    REQUIRE(drawing);
    REQUIRE(drawing->strokes.size() == 2);
    CHECK(drawing->strokes[0].samples[1].time_us == 20'000);
    CHECK(drawing->strokes[0].samples[1].pressure == 0.5);
    CHECK(drawing->strokes[1].samples[0].pressure == 1.0);
}

TEST_CASE("a stroke list without times runs at a constant speed and may still have pressure", "[stroke_list_reader]") {
    const auto drawing = core::parse_stroke_list(R"({"strokes":[{"points":[[0,0,null,0.5],[3,4]]}]})");
    REQUIRE(drawing);
    CHECK(drawing->strokes[0].samples[0].pressure == 0.5);
    CHECK(drawing->strokes[0].samples[1].time_us == 1'000'000);
}

TEST_CASE("texts that are no stroke lists are refused with a sentence", "[stroke_list_reader]") {
    const auto refusal = [](const char* text) { return core::parse_stroke_list(text).error().message; };
    CHECK(refusal("{\"strokes\":") == "the text is no JSON; check it for a missing bracket or comma");
    CHECK(refusal("[]") == "the JSON has no \"strokes\" list; give {\"strokes\": [{\"points\": [[x, y], …]}, …]}");
    CHECK(refusal("{\"strokes\":3}") == refusal("[]"));
    CHECK(refusal("{\"strokes\":[7]}") == "a stroke has no \"points\" list; give {\"points\": [[x, y], …]}");
    for (const char* point : {"1", "[1]", "[1,null]", "[1,2,3,4,5]", "[1,\"2\"]", "{}"}) {
        const std::string text = std::string("{\"strokes\":[{\"points\":[") + point + "]}]}";
        CHECK(refusal(text.c_str()) == "a point is not [x, y], [x, y, t_ms] or [x, y, t_ms, pressure]");
    }
    CHECK(core::parse_stroke_list("{\"strokes\":[]}").error().code == core::ErrorCode::EmptyDrawing);
}
