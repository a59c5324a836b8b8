#include "core/exchange/region_reader.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using core::parse_region;

TEST_CASE("sides are read in order", "[region_reader]") {
    const auto outline = parse_region(R"({"sides":[[[0,0,0],[1,0.5,0]],[[1,0.5,0],[0,0,null]]]})");
    REQUIRE(outline);
    REQUIRE(outline->sides.size() == 2);
    CHECK(outline->sides[0][1] == core::Vec3{1, 0.5, 0});
    CHECK(std::isnan(outline->sides[1][1].z));
}

TEST_CASE("what is no region is refused in one sentence", "[region_reader]") {
    const auto says = [](const char* text, const char* words) {
        const auto outline = parse_region(text);
        return !outline && outline.error().message.find(words) != std::string::npos;
    };
    CHECK(says("", "no JSON"));
    CHECK(says(R"({"sides":[[[0,0,0],[1,0)", "ends early"));
    CHECK(says("[1,2]", "no \"sides\""));
    CHECK(says(R"({"sides":{}})", "no \"sides\""));
    CHECK(says(R"({"sides":[[[0,0,0]],7]})", "Side 2 is no list"));
    CHECK(says(R"({"sides":[[[0,0,0],[1,1]]]})", "Side 1, point 2"));
    CHECK(says(R"({"sides":[[[0,0,"1"]]]})", "Side 1, point 1"));
    CHECK(core::read_region("/nowhere.json").error().code == core::ErrorCode::FileMissing);
}
