#include "ui/draw/lifted_parts.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

const core::Camera kFront{{0, 0, 1}, {0, 1, 0}};

/// A box of twelve large triangles.
core::TriangleMesh box(core::Vec3 low, core::Vec3 high) {
    core::TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

core::Polygon rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// Mean weight of a colour over the vertices of which the place passes.
template <typename Passes>
double mean_weight(const ui::LiftedModel& model, std::size_t colour, const Passes& passes) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < model.vertex_of.size(); ++i) {
        const float* f = model.geometry.corners.data() + i * 9;
        if (!passes(core::Vec3{f[0], f[1], f[2]})) continue;
        sum += model.weights[model.vertex_of[i]][colour] / 255.0;
        ++count;
    }
    REQUIRE(count > 0);
    return sum / count;
}

}  // namespace

TEST_CASE("both halves of a coarse box take their part, to the back too, and blend between", "[lifted parts]") {
    const auto geometry = ui::make_model_geometry(box({-0.7, -0.4, -0.3}, {0.7, 0.4, 0.3}));
    const std::vector<ui::PartRegion> parts{{0, rectangle(-0.7, -0.4, 0, 0.4)}, {3, rectangle(0, -0.4, 0.7, 0.4)}};
    const ui::LiftedModel model = ui::lift_parts(geometry, kFront, parts);
    CHECK(model.geometry.corner_count() / 3 > 1000);  // fine enough for a border
    CHECK(mean_weight(model, 0, [](core::Vec3 p) { return p.x < -0.2 && p.z > 0.2; }) > 0.99);
    CHECK(mean_weight(model, 3, [](core::Vec3 p) { return p.x > 0.2 && p.z > 0.2; }) > 0.99);
    CHECK(mean_weight(model, 0, [](core::Vec3 p) { return p.x < -0.2 && p.z < -0.29; }) > 0.95);
    CHECK(mean_weight(model, 3, [](core::Vec3 p) { return p.x > 0.2 && p.z < -0.29; }) > 0.95);
    const double between = mean_weight(model, 0, [](core::Vec3 p) { return std::abs(p.x) < 0.03 && p.z > 0.29; });
    CHECK(between > 0.1);
    CHECK(between < 0.9);
}

TEST_CASE("what is seen between the parts stays clay, to the back too, as on the card", "[lifted parts]") {
    const auto geometry = ui::make_model_geometry(box({-0.7, -0.4, -0.3}, {0.7, 0.4, 0.3}));
    const std::vector<ui::PartRegion> parts{{0, rectangle(-0.7, -0.4, -0.4, 0.4)}, {3, rectangle(0.4, -0.4, 0.7, 0.4)}};
    const ui::LiftedModel model = ui::lift_parts(geometry, kFront, parts);
    for (const bool back : {false, true}) {
        const auto middle = [&](core::Vec3 p) { return std::abs(p.x) < 0.2 && (back ? p.z < -0.29 : p.z > 0.29); };
        CHECK(mean_weight(model, 0, middle) + mean_weight(model, 3, middle) < 0.02);
    }
    CHECK(mean_weight(model, 0, [](core::Vec3 p) { return p.x < -0.55 && p.z > 0.2; }) > 0.95);
    CHECK(mean_weight(model, 3, [](core::Vec3 p) { return p.x > 0.55 && p.z > 0.2; }) > 0.95);
}

TEST_CASE("what stands behind another part takes its own neighbours' colour, not the part before it",
          "[lifted parts]") {
    core::TriangleMesh mesh = box({-0.3, -0.3, 0.3}, {0.3, 0.3, 0.6});  // in front
    const core::TriangleMesh behind = box({-0.8, -0.3, -0.6}, {0.8, 0.3, -0.4});
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), behind.vertices.begin(), behind.vertices.end());
    for (const auto& t : behind.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const std::vector<ui::PartRegion> parts{{1, rectangle(-0.8, -0.3, 0.8, 0.3)}, {2, rectangle(-0.3, -0.3, 0.3, 0.3)}};
    const ui::LiftedModel model = ui::lift_parts(ui::make_model_geometry(mesh), kFront, parts);
    CHECK(mean_weight(model, 2, [](core::Vec3 p) { return p.z > 0.2; }) > 0.9);
    CHECK(mean_weight(model, 1, [](core::Vec3 p) { return p.z < -0.3 && std::abs(p.x) < 0.1; }) > 0.9);
}

TEST_CASE("anchors lie on their part, seen from the camera", "[lifted parts]") {
    const auto geometry = ui::make_model_geometry(box({-0.7, -0.4, -0.3}, {0.7, 0.4, 0.3}));
    const std::vector<ui::PartRegion> parts{
        {4, rectangle(0, -0.4, 0.7, 0.4)}, {0, rectangle(-0.7, -0.4, 0, 0.4)}, {-1, rectangle(-0.1, -0.1, 0.1, 0.1)}};
    const ui::LiftedModel model = ui::lift_parts(geometry, kFront, parts);
    REQUIRE(model.anchors.size() == 2);
    CHECK(model.anchors[0].colour == 0);
    CHECK(model.anchors[1].colour == 4);
    for (const ui::LiftedAnchor& anchor : model.anchors) {
        CHECK(std::abs(anchor.place.x - (anchor.colour == 0 ? -0.35 : 0.35)) < 0.06);
        CHECK(std::abs(anchor.place.z - 0.3) < 1e-6);
        CHECK(core::dot(anchor.normal, kFront.direction) > 0.5);
    }
}

TEST_CASE("without parts all is clay, uncut; nothing is nothing", "[lifted parts]") {
    const auto geometry = ui::make_model_geometry(box({-0.7, -0.4, -0.3}, {0.7, 0.4, 0.3}));
    const ui::LiftedModel model = ui::lift_parts(geometry, kFront, {});
    CHECK(model.geometry.corner_count() == geometry.corner_count());
    CHECK(model.anchors.empty());
    CHECK(model.geometry.corners[6] == Approx(ui::palette::kClay.r));
    CHECK(ui::lift_parts({}, kFront, {}).geometry.corner_count() == 0);
    CHECK(ui::lift_parts({}, kFront, {{0, rectangle(0, 0, 1, 1)}}).anchors.empty());
}

TEST_CASE("a held number leaves the other parts a quarter of their colour, and all comes back", "[lifted parts]") {
    const auto geometry = ui::make_model_geometry(box({-0.7, -0.4, -0.3}, {0.7, 0.4, 0.3}));
    const std::vector<ui::PartRegion> parts{{0, rectangle(-0.7, -0.4, 0, 0.4)}, {3, rectangle(0, -0.4, 0.7, 0.4)}};
    ui::LiftedModel model = ui::lift_parts(geometry, kFront, parts);
    const std::vector<float> before = model.geometry.corners;
    ui::recolour(model, 3);
    const bool changed = model.geometry.corners != before;
    CHECK(changed);
    ui::recolour(model, std::nullopt);
    const bool back = model.geometry.corners == before;
    CHECK(back);
}
