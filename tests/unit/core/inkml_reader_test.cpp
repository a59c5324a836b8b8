#include "core/exchange/inkml_reader.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

namespace {

std::string written(const core::Result<core::Drawing>& drawing) {
    if (!drawing) return drawing.error().message;
    std::string text;
    for (const core::Stroke& stroke : drawing->strokes) {
        if (!text.empty()) text += " |";
        for (const core::PenSample& s : stroke.samples) {
            text +=
                (text.empty() ? "" : " ") + std::to_string(std::lround(s.x)) + "," + std::to_string(std::lround(s.y));
        }
    }
    return text;
}

core::Result<core::Drawing> ink(const std::string& body) {
    return core::parse_inkml("<ink>" + body + "</ink>");
}

const std::string kBad =
    "a trace is no list of points of the trace format's channels, or there are more than a million points";

}  // namespace

TEST_CASE("traces without a format are X and Y", "[inkml_reader]") {
    CHECK(written(ink("<trace>1 2, 3 4,5 6</trace><traceGroup><trace>\n7 8\n</trace></traceGroup>")) ==
          "1,2 3,4 5,6 | 7,8");
    CHECK(written(core::parse_inkml("<i:ink xmlns:i='x'><i:trace>1 2</i:trace></i:ink>")) == "1,2");
    CHECK(written(ink("<trace type='penUp'>9 9</trace><trace>1 2</trace>")) == "1,2");
}

TEST_CASE("the trace format tells the order of the channels and the unit of time", "[inkml_reader]") {
    const auto drawing = ink(
        "<traceFormat><channel name='T' units='s'/><channel name='Y'/><channel name='X'/><channel name='F' max='200'/>"
        "</traceFormat><trace>1.5 20 10 100, 1.75 21 11 50</trace>");
    REQUIRE(drawing);
    const auto& samples = drawing->strokes[0].samples;
    CHECK(samples[1].x == 11.0);
    CHECK(samples[1].y == 21.0);
    CHECK(samples[1].time_us == 250'000);
    CHECK(samples[0].pressure == 0.5);
    CHECK(samples[1].pressure == 0.25);
}

TEST_CASE("force without a maximum is relative to the largest found", "[inkml_reader]") {
    const auto drawing =
        ink("<traceFormat><channel name='X'/><channel name='Y'/><channel name='F'/></traceFormat>"
            "<trace>0 0 300, 1 1 600</trace>");
    REQUIRE(drawing);
    CHECK(drawing->strokes[0].samples[0].pressure == 0.5);
}

TEST_CASE("prefixes make differences until the next prefix", "[inkml_reader]") {
    // The first point explicit, then velocities, then velocities that change.
    CHECK(written(ink("<trace>100 200,'1'2,3 4</trace>")) == "100,200 101,202 104,206");
    CHECK(written(ink("<trace>10 10,'2'3,\"1\"-1,0 0</trace>")) == "10,10 12,13 15,15 18,17");
    CHECK(written(ink("<trace>1 2,'1'1,!7!8,9 9</trace>")) == "1,2 2,3 7,8 9,9");
    CHECK(written(ink("<trace>1-2,* 5</trace>")) == "1,-2 1,5");
}

TEST_CASE("texts that are no ink are refused with a sentence", "[inkml_reader]") {
    CHECK(written(core::parse_inkml("<svg/>")) == "the XML is no InkML; its first element is not <ink>");
    CHECK(ink("").error().code == core::ErrorCode::EmptyDrawing);
    CHECK(ink("<trace> </trace>").error().code == core::ErrorCode::EmptyDrawing);
    for (const char* trace : {"1", "1 2 3", "1 2,", "1 2;3 4", "a b", "nan nan", "1 2,,3 4", "1e999 2", "#A #B"}) {
        INFO(trace);
        const std::string said = written(ink("<trace>" + std::string(trace) + "</trace>"));
        // A comma at the end ends the list; it is the one slip that is forgiven.
        CHECK(said == (std::string(trace) == "1 2," ? "1,2" : kBad));
    }
    CHECK(written(ink("<traceFormat><channel name='X'/></traceFormat><trace>1</trace>")) ==
          "the trace format has no channels X and Y; record it with a position");
    CHECK(written(ink("<trace>1e8 0</trace>")) ==
          "a coordinate is no finite number within ten million; check the file");
}
