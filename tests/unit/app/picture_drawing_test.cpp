#include "firmware_like_app/collection/picture_drawing.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace {

/// White, with a black upright ring around (60, 50).
core::GrayImage ring(double inner, double outer) {
    core::GrayImage image(120, 100, 255);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double r = std::hypot(x - 60.0, (y - 50.0) / 1.5);
            if (r >= inner && r <= outer) image.at(x, y) = 0;
        }
    return image;
}

}  // namespace

TEST_CASE("a pen goes once around what a picture shows", "[picture_drawing]") {
    for (const double inner : {0.0, 25.0}) {  // a solid shape, and the same as a line
        CAPTURE(inner);
        const auto drawing = app::drawing_of_picture(ring(inner, 28));
        REQUIRE(drawing);
        REQUIRE(drawing->strokes.size() == 1);
        const std::vector<core::PenSample>& samples = drawing->strokes[0].samples;
        REQUIRE(samples.size() > 50);
        CHECK(samples.size() <= 801);
        CHECK(samples.front().x == samples.back().x);
        CHECK(samples.front().y == samples.back().y);
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const double r = std::hypot(samples[k].x - 60.0, (samples[k].y - 50.0) / 1.5);
            CHECK(r == Approx(28).margin(2.5));
            if (k > 0) CHECK(samples[k].time_us > samples[k - 1].time_us);
            left = std::min(left, samples[k].x);
            right = std::max(right, samples[k].x);
            top = std::min(top, samples[k].y);
            bottom = std::max(bottom, samples[k].y);
        }
        CHECK(samples.back().time_us == 4000000);
        CHECK(right - left == Approx(56).margin(4));
        CHECK(bottom - top == Approx(84).margin(4));
    }
}

TEST_CASE("a picture of nothing is no drawing", "[picture_drawing]") {
    const auto drawing = app::drawing_of_picture(core::GrayImage(50, 50, 255));
    REQUIRE_FALSE(drawing);
    CHECK(drawing.error().code == core::ErrorCode::EmptyDrawing);
}
