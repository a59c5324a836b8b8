#include "ui/draw/figure_camera.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/mannequin/dress_form.hpp"
#include "tests/unit/ui/gl_fixture.hpp"
#include "ui/draw/depth_map.hpp"
#include "ui/draw/figure_stage.hpp"

namespace {

using core::Vec3;
const ui::Rect kBox{100, 50, 1100, 980};

std::vector<ui::FigureCamera> cameras() {
    std::vector<ui::FigureCamera> all;
    for (const char* name : {"front", "back", "left", "right", "top"}) {
        all.push_back(ui::framed(*core::named_view(name), kBox, 170));
    }
    for (const double azimuth : {-2.0, 0.5, 3.0})
        all.push_back(ui::framed(ui::solid_view(azimuth, 0.2, 170), kBox, 170));
    return all;
}

/// Four triangles: a diamond about a place, facing +z.
core::TriangleMesh diamond(Vec3 at, double size) {
    core::TriangleMesh mesh;
    mesh.vertices = {at + Vec3{-size, 0, 0}, at + Vec3{0, -size, 0}, at + Vec3{size, 0, 0}, at + Vec3{0, size, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

}  // namespace

TEST_CASE("the pen's ray passes through what is drawn under the pen, in every view", "[figure camera]") {
    for (const ui::FigureCamera& camera : cameras()) {
        for (const Vec3 place : {Vec3{0, 0, 0}, Vec3{12, 140, 9}, Vec3{-30, 80, -14}, Vec3{5, 168, 3}}) {
            const core::Point px = camera.to_px(place);
            const core::DrawingView::Ray ray = camera.view.ray(camera.to_drawing(px));
            const Vec3 from = place - ray.origin;
            const double off = core::length(from - ray.direction * core::dot(from, ray.direction));
            CHECK(off < 1e-9);
            CHECK(core::dot(from, ray.direction) > 0);
        }
    }
}

TEST_CASE("a framed figure stands inside its box", "[figure camera]") {
    for (const ui::FigureCamera& camera : cameras()) {
        const bool solid = camera.view.eye_distance > 0;
        const double wide = solid ? 25 : 60, deep = solid ? 12 : 40;
        for (const Vec3 place : {Vec3{wide, 0, 0}, Vec3{-wide, 0, 0}, Vec3{0, 170, 0}, Vec3{0, 0, deep}}) {
            const core::Point px = camera.to_px(place);
            CHECK(px.x >= kBox.x - 1e-6);
            CHECK(px.x <= kBox.right() + 1e-6);
            CHECK(px.y >= kBox.y - 1e-6);
            CHECK(px.y <= kBox.bottom() + 1e-6);
        }
    }
}

TEST_CASE("the picture shows a place where the camera says", "[figure camera]") {
    const auto context = test::gl();
    core::Result<ui::FigureStage> stage = ui::FigureStage::create();
    REQUIRE(stage);
    ui::Target target = ui::FigureStage::make_target({600, 500});
    for (const ui::FigureCamera& wide : cameras()) {
        if (std::abs(wide.view.toward.z) < 0.4) continue;  // the diamond would be seen from its edge
        const ui::FigureCamera camera = ui::framed(wide.view, {0, 0, 600, 500}, 170);
        const Vec3 place{20, 120, 10};
        stage->set_body(ui::corners_of_body(diamond(place, 4)));
        ui::FigureStage::Look look;
        look.shadow = false;
        stage->draw(camera, look, target);
        const core::RgbaImage image = target.read_back();
        double x = 0, y = 0, count = 0;
        for (int v = 0; v < 500; ++v) {
            for (int u = 0; u < 600; ++u) {
                const double a = test::pixel(image, u, v).a / 255.0;
                x += a * (u + 0.5);
                y += a * (v + 0.5);
                count += a;
            }
        }
        REQUIRE(count > 20);
        const core::Point px = camera.to_px(place);
        CHECK(x / count == Approx(px.x).margin(0.35));
        CHECK(y / count == Approx(px.y).margin(0.35));
    }
}

TEST_CASE("what lies behind the figure is hidden, what lies before it is not", "[depth map]") {
    const core::TriangleMesh wall = diamond({0, 100, 0}, 30);
    for (const ui::FigureCamera& camera : cameras()) {
        const double faces = camera.view.toward.z;
        if (std::abs(faces) < 0.4) continue;
        ui::DepthMap map;
        map.clear(camera, {1300, 1080});
        map.add(wall.vertices, wall.triangles);
        const double sign = faces > 0 ? 1 : -1;
        CHECK(map.hides({0, 100, -6 * sign}));
        CHECK_FALSE(map.hides({0, 100, 6 * sign}));
        CHECK_FALSE(map.hides({0, 100, 0}));
        CHECK_FALSE(map.hides({0, 150, -6 * sign}));
        CHECK_FALSE(map.hides({9000, 100, -6}));
    }
}

TEST_CASE("cloth is drawn in its fabric, with its quads on request", "[figure stage]") {
    const auto context = test::gl();
    core::Result<ui::FigureStage> stage = ui::FigureStage::create();
    REQUIRE(stage);
    core::Cloth cloth;
    cloth.mesh.vertices = {{-20, 80, 5}, {0, 80, 5}, {20, 80, 5}, {-20, 120, 5}, {0, 120, 5}, {20, 120, 5}};
    cloth.mesh.quads = {{0, 1, 4, 3}, {1, 2, 5, 4}};
    core::ClothPiece left, right;
    left.count = 1;
    right.first = right.count = 1;
    cloth.pieces = {left, right};
    const ui::FabricLook red{ui::Fabric::Plain, ui::Colour::hex(0xC03020), ""};
    const ui::FabricLook blue{ui::Fabric::Plain, ui::Colour::hex(0x2040C0), ""};
    const ui::ClothCorners corners = ui::corners_of_cloth(cloth, {red, blue});
    REQUIRE(corners.runs.size() == 2);
    REQUIRE(corners.corners.count() == 12);
    stage->set_layer(0, corners);
    const ui::FigureCamera camera = ui::framed(*core::named_view("front"), {0, 0, 600, 500}, 170);
    ui::Target target = ui::FigureStage::make_target({600, 500});
    ui::FigureStage::Look look;
    stage->draw(camera, look, target);
    core::RgbaImage image = target.read_back();
    const auto at = [&](Vec3 place) {
        const core::Point px = camera.to_px(place);
        return test::pixel(image, static_cast<int>(px.x), static_cast<int>(px.y));
    };
    CHECK(at({-10, 100, 5}).r > at({-10, 100, 5}).b + 60);
    CHECK(at({10, 100, 5}).b > at({10, 100, 5}).r + 60);
    const int before = at({0, 100, 5}).r + at({0, 100, 5}).b;
    look.quads = true;
    stage->draw(camera, look, target);
    image = target.read_back();
    CHECK(at({0, 100, 5}).r + at({0, 100, 5}).b < before - 20);
    look.shown = {false};
    stage->draw(camera, look, target);
    image = target.read_back();
    CHECK(at({10, 100, 5}).a == 0);
}

TEST_CASE("every fabric repeats without a seam and is made the same again", "[fabric]") {
    for (int i = 0; i < ui::kFabricCount; ++i) {
        const auto fabric = static_cast<ui::Fabric>(i);
        const core::RgbaImage a = ui::weave(fabric, ui::Colour::hex(0xB4BFC9)),
                              b = ui::weave(fabric, ui::Colour::hex(0xB4BFC9));
        CHECK(a.pixels == b.pixels);
        CHECK(ui::fabric_of(ui::fabric_name(fabric)) == fabric);
        // the step over the edge is no larger than the largest step inside
        int inside = 0, over = 0;
        for (int y = 0; y < ui::kFabricTile_px; ++y) {
            for (int x = 0; x + 1 < ui::kFabricTile_px; ++x) {
                inside = std::max(inside, std::abs(test::pixel(a, x, y).g - test::pixel(a, x + 1, y).g));
                inside = std::max(inside, std::abs(test::pixel(a, y, x).g - test::pixel(a, y, x + 1).g));
            }
            over = std::max(over, std::abs(test::pixel(a, ui::kFabricTile_px - 1, y).g - test::pixel(a, 0, y).g));
            over = std::max(over, std::abs(test::pixel(a, y, ui::kFabricTile_px - 1).g - test::pixel(a, y, 0).g));
        }
        CHECK(over <= inside + 6);
    }
    CHECK(ui::colour_of("#b4bfc9", ui::palette::kInk) == ui::Colour::hex(0xB4BFC9));
    CHECK(ui::colour_of("blue", ui::palette::kInk) == ui::palette::kInk);
    CHECK(ui::hex_of(ui::Colour::hex(0x0A1B2C)) == "#0a1b2c");
}
