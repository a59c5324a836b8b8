#include "firmware_like_app/commands/progress_bar.hpp"

#include <catch2/catch.hpp>

using app::progress_line;

TEST_CASE("a progress line has bar, numbers, rate and time left", "[progress]") {
    CHECK(progress_line(0, 90, "models", 0.0) == "[..............................] 0 of 90 models");
    CHECK(progress_line(30, 90, "models", 4.0) ==
          "[##########....................] 30 of 90 models, 4.0 a second, 15 s left");
    CHECK(progress_line(90, 90, "models", 120.4) == "[##############################] 90 of 90 models, 120 a second");
    CHECK(progress_line(0, 0, "models", 0.0) == "[##############################] 0 of 0 models");
}

TEST_CASE("long times are told in minutes and hours", "[progress]") {
    CHECK_THAT(progress_line(0, 1000, "models", 5.0), Catch::EndsWith(", 3 min 20 s left"));
    CHECK_THAT(progress_line(0, 80000, "models", 10.0), Catch::EndsWith(", 2 h 13 min left"));
}
