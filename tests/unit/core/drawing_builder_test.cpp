#include "core/exchange/drawing_builder.hpp"

#include <catch2/catch.hpp>
#include <limits>

using core::DrawingBuilder;

TEST_CASE("times start at 0 and never fall", "[drawing_builder]") {
    DrawingBuilder builder;
    builder.begin_stroke();
    builder.add(0, 0, 5'000.0);
    builder.add(1, 0, 9'000.0);
    builder.add(2, 0, 7'000.0);
    const auto drawing = std::move(builder).finish();
    REQUIRE(drawing);
    const auto& samples = drawing->strokes[0].samples;
    CHECK(samples[0].time_us == 0);
    CHECK(samples[1].time_us == 4'000);
    CHECK(samples[2].time_us == 4'000);
}

TEST_CASE("a stroke whose clock starts again is moved behind the one before", "[drawing_builder]") {
    DrawingBuilder builder;
    builder.begin_stroke();
    builder.add(0, 0, 0.0);
    builder.add(1, 0, 50'000.0);
    builder.begin_stroke();
    builder.add(5, 5, 0.0);
    builder.add(6, 5, 30'000.0);
    const auto drawing = std::move(builder).finish();
    REQUIRE(drawing);
    CHECK(drawing->strokes[1].samples[0].time_us == 50'000 + core::kUntimedPause_us);
    CHECK(drawing->strokes[1].samples[1].time_us == 80'000 + core::kUntimedPause_us);
}

TEST_CASE("without times the pen runs at one diagonal a second", "[drawing_builder]") {
    DrawingBuilder builder;
    builder.begin_stroke();
    builder.add(0, 0);
    builder.add(3, 4);
    builder.begin_stroke();
    builder.add(3, 0);
    builder.add(3, 2.5);
    const auto drawing = std::move(builder).finish();
    REQUIRE(drawing);
    CHECK(drawing->strokes[0].samples[1].time_us == 1'000'000);
    CHECK(drawing->strokes[1].samples[0].time_us == 1'200'000);
    CHECK(drawing->strokes[1].samples[1].time_us == 1'700'000);
}

TEST_CASE("empty strokes are dropped, and no stroke is an empty drawing", "[drawing_builder]") {
    DrawingBuilder builder;
    builder.begin_stroke();
    builder.begin_stroke();
    builder.add(1, 1, 0.0, 7.0);
    builder.begin_stroke();
    const auto drawing = std::move(builder).finish();
    REQUIRE(drawing);
    CHECK(drawing->strokes.size() == 1);
    CHECK(drawing->strokes[0].samples[0].pressure == 1.0);
    CHECK(DrawingBuilder().finish().error().code == core::ErrorCode::EmptyDrawing);
}

TEST_CASE("numbers that are none are refused", "[drawing_builder]") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf, 1.1e7}) {
        DrawingBuilder builder;
        CHECK_FALSE(builder.add(bad, 0));
        CHECK_FALSE(builder.add(0, 0));
        const auto finished = std::move(builder).finish();
        CHECK(finished.error().message == "a coordinate is no finite number within ten million; check the file");
    }
    DrawingBuilder timed;
    CHECK_FALSE(timed.add(0, 0, inf));
    DrawingBuilder pressed;
    CHECK_FALSE(pressed.add(0, 0, 0.0, nan));
}
