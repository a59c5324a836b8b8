#include "core/garment/drawing.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "support/simple_body.hpp"

using core::Point;
using core::StrokePart;
using core::Vec3;
using Kind = core::DrawingTool::Kind;

namespace {

const core::Obstacle& body() {
    static const core::Obstacle obstacle = *core::Obstacle::of_body(support::post(10.0, 60.0));
    return obstacle;
}

StrokePart part(const char* view, Kind kind, double offset, std::vector<Point> points) {
    return {*core::named_view(view), {kind, offset}, std::move(points)};
}

std::vector<Vec3> lifted(const core::SketchStroke& stroke) {
    const auto line = core::lift_stroke(stroke, body());
    REQUIRE(line);
    return *line;
}

void check_near(Vec3 a, Vec3 b, double margin) {
    CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
    CHECK(core::length(a - b) < margin);
}

}  // namespace

TEST_CASE("a stroke on the body keeps its offset, from every view", "[drawing]") {
    for (const char* view : {"front", "back", "left", "right"})
        for (const Vec3& p : lifted({part(view, Kind::Body, 1.5, {{0, 25}, {4, 30}, {-6, 35}})}))
            CHECK(std::hypot(p.x, p.z) == Approx(11.5).margin(0.15));
    check_near(lifted({part("front", Kind::Body, 0, {{3, 30}, {0, 30}})})[1], {0, 30, 10}, 0.15);
    check_near(lifted({part("back", Kind::Body, 0, {{3, 30}, {0, 30}})})[0], {-3, 30, -9.54}, 0.15);
    check_near(lifted({part("left", Kind::Body, 0, {{3, 30}, {0, 30}})})[1], {10, 30, 0}, 0.15);
    check_near(lifted({part("top", Kind::Body, 1, {{0, 0}, {3, 0}})})[0], {0, 61, 0}, 0.3);
}

TEST_CASE("beside the body the stroke lies where the view passes it nearest", "[drawing]") {
    check_near(lifted({part("front", Kind::Body, 1, {{14, 30}, {15, 31}})})[0], {14, 30, 0}, 0.6);
    const auto far = core::lift_stroke({part("front", Kind::Body, 1, {{12, 30}, {60, 30}})}, body());
    REQUIRE_FALSE(far);
    CHECK(far.error().message.find("Point 2") != std::string::npos);
}

TEST_CASE("strokes in system planes", "[drawing]") {
    check_near(lifted({part("front", Kind::PlaneXY, -2, {{5, 7}, {6, 8}})})[0], {5, 7, -2}, 1e-9);
    check_near(lifted({part("left", Kind::PlaneYZ, 3, {{5, 7}, {6, 8}})})[0], {3, 7, -5}, 1e-9);
    check_near(lifted({part("top", Kind::PlaneXZ, 20, {{5, 7}, {6, 8}})})[0], {5, 20, -7}, 1e-9);
    const auto edge_on = core::lift_stroke({part("top", Kind::PlaneXY, 0, {{5, 7}, {6, 8}})}, body());
    REQUIRE_FALSE(edge_on);
    CHECK(edge_on.error().message.find("edge-on") != std::string::npos);
}

TEST_CASE("a perspective view draws through its eye", "[drawing]") {
    const auto view = core::perspective_view({0, 30, 100}, {0, 30, 0});
    REQUIRE(view);
    const StrokePart through{*view, {Kind::PlaneXY, 50.0}, {{4, 6}, {5, 6}}};
    check_near(lifted({through})[0], {2, 33, 50}, 1e-9);
    CHECK_FALSE(core::perspective_view({1, 2, 3}, {1, 2, 3}));
    CHECK(core::perspective_view({0, 90, 0}, {0, 0, 0}));
}

TEST_CASE("the temporary plane turns the drawing into the view, through the last point", "[drawing]") {
    const auto line = lifted({part("front", Kind::PlaneXY, 2, {{10, 40}, {12, 20}}),
                              part("front", Kind::Temporary, 0, {{12, 20}, {11, 17}, {8, 14}})});
    REQUIRE(line.size() == 4);
    check_near(line[1], {12, 20, 2}, 1e-9);
    check_near(line[2], {11, 20, 5}, 1e-9);  // 3 down in the drawing: 3 towards the viewer
    check_near(line[3], {8, 20, 8}, 1e-9);
    CHECK_FALSE(core::lift_stroke({part("front", Kind::Temporary, 0, {{1, 2}, {3, 4}})}, body()));
}

TEST_CASE("another view in the middle of a stroke lifts what follows", "[drawing]") {
    const auto line =
        lifted({part("front", Kind::Body, 0, {{0, 40}, {6, 40}}), part("left", Kind::Body, 0, {{-4, 40}, {4, 40}}),
                part("back", Kind::Body, 0, {{-6, 40}, {0, 40}})});
    REQUIRE(line.size() == 6);
    check_near(line[0], {0, 40, 10}, 0.2);
    check_near(line[2], {9.17, 40, 4}, 0.2);
    check_near(line[5], {0, 40, -10}, 0.2);
}

TEST_CASE("faulty strokes and views", "[drawing]") {
    CHECK_FALSE(core::lift_stroke({}, body()));
    CHECK_FALSE(core::lift_stroke({part("front", Kind::Body, 0, {{1, 30}, {1, 30}})}, body()));
    CHECK_FALSE(core::lift_stroke(
        {part("front", Kind::Body, 0, {{1, 30}, {std::numeric_limits<double>::quiet_NaN(), 30}})}, body()));
    CHECK(core::named_view("below").error().message.find("front, back") != std::string::npos);
    CHECK_FALSE(core::Obstacle::of_body(core::TriangleMesh{}));
}
