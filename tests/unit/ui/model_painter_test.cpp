#include "ui/draw/model_painter.hpp"

#include "tests/unit/ui/gl_fixture.hpp"
#include "ui/draw/palette.hpp"

namespace {

/// A flat-sided box round the origin, soup on purpose: every face has its own vertices and windings differ.
core::TriangleMesh make_box(double x, double y, double z) {
    core::TriangleMesh mesh;
    const auto face = [&](core::Vec3 centre, core::Vec3 u, core::Vec3 v, bool turned) {
        const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {centre - u - v, centre + u - v, centre + u + v, centre - u + v});
        if (turned) {
            mesh.triangles.insert(mesh.triangles.end(), {{base, base + 2, base + 1}, {base, base + 3, base + 2}});
        } else {
            mesh.triangles.insert(mesh.triangles.end(), {{base, base + 1, base + 2}, {base, base + 2, base + 3}});
        }
    };
    face({0, 0, z}, {x, 0, 0}, {0, y, 0}, false);
    face({0, 0, -z}, {x, 0, 0}, {0, y, 0}, true);
    face({x, 0, 0}, {0, y, 0}, {0, 0, z}, false);
    face({-x, 0, 0}, {0, y, 0}, {0, 0, z}, true);
    face({0, y, 0}, {x, 0, 0}, {0, 0, z}, true);
    face({0, -y, 0}, {x, 0, 0}, {0, 0, z}, false);
    return mesh;
}

ui::CardModel make_card(bool mirrored, const std::vector<ui::PartRegion>& parts) {
    const auto geometry = std::make_shared<const ui::ModelGeometry>(ui::make_model_geometry(make_box(0.8, 0.4, 0.3)));
    return ui::make_card_model(geometry, core::Camera{}, mirrored, parts);
}

/// The left half of the box is part 1 (blue), the right half part 8 (green).
std::vector<ui::PartRegion> halves() {
    return {{0, {{-0.8, -0.4}, {0, -0.4}, {0, 0.4}, {-0.8, 0.4}}}, {7, {{0, -0.4}, {0.8, -0.4}, {0.8, 0.4}, {0, 0.4}}}};
}

core::RgbaImage paint(const ui::CardModel& card, bool own_colours = false) {
    core::Result<ui::ModelPainter> painter = ui::ModelPainter::create();
    REQUIRE(painter);
    return painter->paint_image(card, {{200, 135}, 0.05, 0.08, own_colours});
}

bool bluish(test::Pixel p) {
    return p.b > p.r + 30;
}
bool greenish(test::Pixel p) {
    return p.g > p.b + 60;
}

}  // namespace

TEST_CASE("a model fills its picture and leaves the rest clear", "[model]") {
    const auto context = test::gl();
    const core::RgbaImage image = paint(make_card(false, {}));
    REQUIRE(image.width == 400);
    CHECK(test::pixel(image, 200, 135).a == 255);
    CHECK(test::pixel(image, 30, 135).a == 255);  // wide models reach to the margin
    CHECK(test::pixel(image, 5, 135).a == 0);
    CHECK(test::pixel(image, 200, 5).a == 0);
}

TEST_CASE("a leaning model moves right as far as there is room, and no further", "[model]") {
    const auto context = test::gl();
    core::Result<ui::ModelPainter> painter = ui::ModelPainter::create();
    REQUIRE(painter);
    const auto left_edge = [&](ui::SizePx size, double lean) {
        const core::RgbaImage image = painter->paint_image(make_card(false, {}), {size, 0.05, 0.08, false, lean});
        int x = 0;
        while (x < image.width - 1 && test::pixel(image, x, image.height / 2).a < 255) ++x;
        return x;
    };
    const ui::SizePx roomy{300, 100}, tight{200, 135};  // painted at twice the size
    CHECK(left_edge(roomy, 0.1) == left_edge(roomy, 0) + 60);
    CHECK(left_edge(roomy, 0.5) < 2 * left_edge(roomy, 0));
    CHECK(left_edge(tight, 0.1) == left_edge(tight, 0));
}

TEST_CASE("without parts a model is clay", "[model]") {
    const auto context = test::gl();
    const test::Pixel p = test::pixel(paint(make_card(false, {})), 200, 135);
    CHECK(p.r > p.g);  // clay is warm and light
    CHECK(p.g > p.b);
    CHECK(p.b > 100);
}

TEST_CASE("each part has its colour, and the mirrored picture has them the other way round", "[model]") {
    const auto context = test::gl();
    const core::RgbaImage image = paint(make_card(false, halves())), mirrored = paint(make_card(true, halves()));
    CHECK(bluish(test::pixel(image, 60, 135)));
    CHECK(greenish(test::pixel(image, 340, 135)));
    CHECK(greenish(test::pixel(mirrored, 60, 135)));
    CHECK(bluish(test::pixel(mirrored, 340, 135)));
    CHECK(bluish(test::pixel(image, 22, 135)));  // no clay along the edge of the silhouette
}

TEST_CASE("colours blend where parts meet and an unmatched part stays clay", "[model]") {
    std::vector<ui::PartRegion> parts = halves();
    parts[1].colour = -1;
    const core::RgbaImage map = ui::bake_part_map(parts, 200, 0.02);
    const auto weight = [&](double plane_x) { return test::pixel(map, static_cast<int>((plane_x + 1) * 100), 100).a; };
    CHECK(weight(-0.4) == 255);
    CHECK(weight(0.4) == 0);
    CHECK(weight(0.0) > 60);
    CHECK(weight(0.0) < 200);
}

TEST_CASE("the colour on a model is 76 per cent part and 24 per cent clay", "[model]") {
    const auto context = test::gl();
    const test::Pixel clay = test::pixel(paint(make_card(false, {})), 100, 135);
    const test::Pixel part = test::pixel(paint(make_card(false, halves())), 100, 135);
    const ui::Colour c = ui::palette::kClay, p = ui::palette::parts()[0];
    const double expected = (0.76 * p.r + 0.24 * c.r) / c.r;  // the light is the same
    CHECK(static_cast<double>(part.r) / clay.r == Approx(expected).margin(0.04));
}

TEST_CASE("normals are smooth over a ball and sharp over a box, whatever the windings", "[model]") {
    const ui::ModelGeometry box = ui::make_model_geometry(make_box(1, 1, 1));
    REQUIRE(box.corner_count() == 36);
    for (std::size_t i = 0; i < box.corners.size(); i += 9) {
        const double largest =
            std::max({std::abs(box.corners[i + 3]), std::abs(box.corners[i + 4]), std::abs(box.corners[i + 5])});
        CHECK(largest == Approx(1.0));
    }
    core::TriangleMesh roof;  // two faces that meet at 20 degrees, wound against each other
    roof.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0.176, 0}, {-1, 0.176, 0}};
    roof.triangles = {{0, 1, 2}, {0, 1, 3}};
    const ui::ModelGeometry smooth = ui::make_model_geometry(roof);
    CHECK(std::abs(smooth.corners[4]) == Approx(1.0).margin(0.01));  // at the ridge: straight up
}

TEST_CASE("a model stands where its lowest parts are", "[model]") {
    const ui::CardModel card = make_card(false, {});
    REQUIRE(card.contacts.size() == 1);
    CHECK(card.contacts[0].x == Approx(-0.8));
    CHECK(card.contacts[0].y == Approx(0.8));
}

TEST_CASE("a mesh without area gives an empty picture and no failure", "[model]") {
    const auto context = test::gl();
    core::TriangleMesh flat;
    flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}};
    flat.triangles = {{0, 1, 2}};
    const auto geometry = std::make_shared<const ui::ModelGeometry>(ui::make_model_geometry(flat));
    CHECK(geometry->corner_count() == 0);
    const core::RgbaImage image = paint(ui::make_card_model(geometry, {}, false, {}));
    CHECK(test::pixel(image, 200, 135).a == 0);
}
