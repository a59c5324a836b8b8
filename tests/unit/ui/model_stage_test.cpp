#include "ui/draw/model_stage.hpp"

#include <cmath>
#include <numbers>

#include "tests/unit/ui/gl_fixture.hpp"

namespace {

constexpr ui::SizePx kSize{240, 200};

/// A ball of 2 * 24 * 24 triangles, one half of it red and the other blue.
ui::ModelGeometry make_ball() {
    constexpr int kSides = 24;
    ui::ModelGeometry ball;
    const auto corner = [&](int i, int k) {
        const double a = 2 * std::numbers::pi * i / kSides, b = std::numbers::pi * k / kSides;
        const core::Vec3 p{std::sin(b) * std::cos(a), std::cos(b), std::sin(b) * std::sin(a)};
        const float red = i < kSides / 2 ? 1 : 0;
        for (const double v : {p.x, p.y, p.z, p.x, p.y, p.z}) ball.corners.push_back(static_cast<float>(v));
        ball.corners.insert(ball.corners.end(), {red, 0.2F, 1 - red});
    };
    for (int i = 0; i < kSides; ++i) {
        for (int k = 0; k < kSides; ++k) {
            for (const auto& [di, dk] : {std::pair{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}})
                corner(i + di, k + dk);
        }
    }
    return ball;
}

ui::StageView seen(double azimuth, core::Point centre = {120, 100}) {
    ui::StageView view;
    view.camera = ui::orbited({}, azimuth, 0.3);
    view.scale_px = 70;
    view.centre_px = centre;
    view.own_colours = true;
    return view;
}

ui::ModelStage make_stage() {
    core::Result<ui::ModelStage> stage = ui::ModelStage::create();
    REQUIRE(stage);
    const ui::ModelGeometry ball = make_ball();
    stage->set_model(ball, ui::find_ground_contacts(ball, {0, 1, 0}));
    return std::move(*stage);
}

bool same(const core::RgbaImage& a, const core::RgbaImage& b) {
    return a.width == b.width && a.height == b.height && a.pixels == b.pixels;
}

}  // namespace

TEST_CASE("a model drawn in pieces is the one drawn in one go, and is not shown before its last piece", "[model]") {
    const auto context = test::gl();
    ui::ModelStage at_once = make_stage(), in_pieces = make_stage();
    at_once.draw(seen(0), kSize);
    in_pieces.draw(seen(0), kSize);
    const core::RgbaImage before = at_once.read_back();
    REQUIRE(test::pixel(before, 120, 100).a == 255);
    at_once.draw(seen(2), kSize);

    in_pieces.begin(seen(2), kSize);
    const ui::Texture* shown = &in_pieces.texture();
    int pieces = 1;
    for (; !in_pieces.draw_piece(200); ++pieces) CHECK(&in_pieces.texture() == shown);
    CHECK(pieces == 6);
    const core::RgbaImage after = in_pieces.read_back();
    const bool equal = same(after, at_once.read_back()), another = !same(after, before);
    CHECK(equal);
    CHECK(another);
    CHECK(in_pieces.changed().width == at_once.changed().width);
}

TEST_CASE("pieces that were left for a draft or another view leave nothing behind", "[model]") {
    const auto context = test::gl();
    ui::ModelStage left = make_stage(), fresh = make_stage();
    left.draw(seen(0), kSize);
    left.begin(seen(1, {60, 60}), kSize);
    CHECK_FALSE(left.draw_piece(500));
    left.draw_draft(seen(1.5, {60, 60}), kSize, 0.5);
    const core::RgbaImage draft = left.read_back();
    CHECK(draft.width == kSize.width / 2);
    CHECK(draft.height == kSize.height / 2);
    CHECK(test::pixel(draft, 30, 30).a == 255);
    CHECK(left.changed().width == 0);  // another texture

    left.begin(seen(3, {180, 140}), kSize);
    while (!left.draw_piece(500)) CHECK(left.read_back().width == kSize.width / 2);
    fresh.draw(seen(3, {180, 140}), kSize);
    CHECK(left.changed().width == 0);
    const bool equal = same(left.read_back(), fresh.read_back());
    CHECK(equal);
}
