#include "ui/screens/card_text.hpp"

#include <array>
#include <catch2/catch.hpp>

namespace {

const ui::FontSet& fonts() {
    static const ui::FontSet set = std::move(*ui::FontSet::load());
    return set;
}

/// A wall in the image plane: seen as this rectangle.
ui::CardModel wall(double width, double height, bool mirrored = false) {
    const auto x = width / 2, y = height / 2;
    core::TriangleMesh mesh;
    mesh.vertices = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    auto geometry = std::make_shared<const ui::ModelGeometry>(ui::make_model_geometry(mesh));
    return ui::make_card_model(geometry, {{0, 0, 1}, {0, 1, 0}}, mirrored, {});
}

/// Whether a line of text of that width, from there down to there on the card, lies beside the model.
bool is_beside(const ui::FindLayout& l, std::size_t card, const ui::CardPlace& place, const ui::CardModel& model) {
    const ui::CardText text = ui::card_text(l, card);
    const ui::Rect &whole = l.cards[card], &picture = l.card_pictures[card];
    double baseline = whole.y + text.name_baseline - picture.y;
    for (const std::string& line : place.name) {
        const double right = whole.x + text.x - picture.x + fonts().width_px(line, text.name);
        const double free = ui::free_at_left(model, place.picture, baseline - 0.7 * text.name.size_px,
                                             baseline + 0.2 * text.name.size_px);
        if (right > free) return false;
        baseline += ui::kNameLineHeight * text.name.size_px;
    }
    return true;
}

}  // namespace

TEST_CASE("no name lies on its model and none is cut that fits on the card", "[card text]") {
    const std::array<const char*, 5> names{"Cat", "Bar chair", "High backed chair", "Little propeller plane",
                                           "Four petalled flower"};
    for (const ui::SizePx size : {ui::SizePx{1920, 1080}, {1280, 800}, {3840, 2160}, {1080, 1920}}) {
        const ui::FindLayout layout = ui::find_layout(size, ui::Hand::Right);
        for (const bool mirrored : {false, true}) {
            for (const auto& [width, height] : {std::pair{1.8, 0.6}, {1.0, 1.0}, {0.3, 1.8}, {1.8, 1.2}}) {
                const ui::CardModel model = wall(width, height, mirrored);
                for (const std::string name : names) {
                    for (std::size_t card = 0; card < ui::kCardCount; ++card) {
                        const ui::CardPlace place = ui::place_on_card(fonts(), layout, card, name, "Class", model);
                        INFO(name << " " << size.width << " card " << card << " model " << width << " " << height);
                        CHECK(is_beside(layout, card, place, model));
                        std::string whole;
                        for (const std::string& line : place.name) whole += (whole.empty() ? "" : " ") + line;
                        const ui::CardText text = ui::card_text(layout, card);
                        if (fonts().width_px(name, text.name) <= text.most_px) CHECK(whole == name);
                    }
                }
            }
        }
    }
}

TEST_CASE("a short name leaves the model its size and its place; a long one moves it before it makes it small",
          "[card text]") {
    const ui::FindLayout layout = ui::find_layout({1920, 1080}, ui::Hand::Right);
    const ui::CardModel slim = wall(0.5, 1.8);
    const ui::CardPlace beside = ui::place_on_card(fonts(), layout, 3, "Cat", "", slim);
    CHECK(beside.picture.lean == 0);
    CHECK(beside.picture.headroom == 0);
    const ui::CardPlace leaning = ui::place_on_card(fonts(), layout, 3, "Bar chair 2000", "", slim);
    CHECK(leaning.picture.lean > 0);
    CHECK(leaning.picture.headroom == 0);
    const ui::CardPlace below = ui::place_on_card(fonts(), layout, 3, "Incomprehensible", "", wall(1.7, 1.5));
    CHECK(below.picture.headroom > 0.1);
}

TEST_CASE("what is free beside a model depends on the height", "[card text]") {
    core::TriangleMesh mesh;  // a slope: high at the right
    mesh.vertices = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}};
    mesh.triangles = {{0, 1, 2}};
    for (int cut = 0; cut < 4; ++cut) {  // finer, as boxes of triangles count
        core::TriangleMesh finer;
        for (const auto& t : mesh.triangles) {
            const auto n = static_cast<std::uint32_t>(finer.vertices.size());
            const core::Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
            for (const core::Vec3& v : {a, b, c, (a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5})
                finer.vertices.push_back(v);
            for (const auto& s : {std::array<std::uint32_t, 3>{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}})
                finer.triangles.push_back({n + s[0], n + s[1], n + s[2]});
        }
        mesh = std::move(finer);
    }
    const auto geometry = std::make_shared<const ui::ModelGeometry>(ui::make_model_geometry(mesh));
    const ui::ModelPictureOptions options{{200, 200}, 0.0, 0.0};
    const ui::CardModel plain = ui::make_card_model(geometry, {{0, 0, 1}, {0, 1, 0}}, false, {});
    CHECK(ui::free_at_left(plain, options, 0, 10) > 170);
    CHECK(ui::free_at_left(plain, options, 95, 105) == Approx(90).margin(15));
    CHECK(ui::free_at_left(plain, options, 190, 200) < 15);
    const ui::CardModel flipped = ui::make_card_model(geometry, {{0, 0, 1}, {0, 1, 0}}, true, {});
    CHECK(ui::free_at_left(flipped, options, 0, 10) < 15);
    CHECK(ui::free_at_left(plain, options, -50, -20) == 200);
}
