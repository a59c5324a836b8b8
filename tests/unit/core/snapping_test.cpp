#include "core/garment/snapping.hpp"

#include <catch2/catch.hpp>

using core::SnapTarget;
using core::Vec3;
using Kind = core::SnapTarget::Kind;

namespace {

const std::vector<core::Landmark> kLandmarks{{"waist_left", {14, 104, 0}}, {"hip_left", {18, 83, 0}}};

core::Network one_line() {
    core::Network network;
    REQUIRE(network.add_line("side", {{15, 104, 1}, {15, 90, 1}, {15, 80, 1}}, false));
    return network;
}

SnapTarget target(Vec3 place, int layer = 0, double reach = 2.0) {
    return core::snap_target(one_line(), layer, kLandmarks, place, reach, true);
}

}  // namespace

TEST_CASE("vertices come before landmarks, these before lines and the middle", "[snapping]") {
    CHECK(target({14.2, 104, 0.1}).kind == Kind::Vertex);
    CHECK(target({14.2, 104, 0.1}).place == Vec3{15, 104, 1});
    const SnapTarget landmark = target({14.2, 104, 0.1}, 1);  // on another layer the vertex is not there
    CHECK(landmark.kind == Kind::Landmark);
    CHECK(landmark.name == "waist_left");
    CHECK(landmark.place == Vec3{14, 104, 0});
    const SnapTarget line = target({16, 95, 1});
    CHECK(line.kind == Kind::Line);
    CHECK(line.name == "side");
    CHECK(line.place.x == Approx(15.0));
    CHECK(target({0.5, 30, 3}).kind == Kind::Middle);
    CHECK(target({0.5, 30, 3}).place == Vec3{0, 30, 3});
    CHECK(target({60, 30, 3}).kind == Kind::None);
    CHECK(target({60, 30, 3}).place == Vec3{60, 30, 3});
    CHECK(target({16, 95, 1}, 0, 0.5).kind == Kind::None);
}
