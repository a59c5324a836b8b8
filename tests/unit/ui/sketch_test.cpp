#include "ui/screens/sketch.hpp"

#include <catch2/catch.hpp>

namespace {

void draw(ui::Sketch& sketch, double x, double y, double length) {
    sketch.begin({0, x, y, 1});
    sketch.extend({1, x + length / 2, y, 1});
    sketch.extend({2, x + length, y, 1});
    sketch.end();
}

std::vector<double> rows(const ui::Sketch& sketch) {
    std::vector<double> out;
    for (const core::Stroke& s : sketch.drawing().strokes) out.push_back(s.samples.front().y);
    return out;
}

using Rows = std::vector<double>;

}  // namespace

TEST_CASE("undo goes back to the empty sheet and redo forward again, exactly", "[sketch]") {
    ui::Sketch sketch;
    for (const double y : {10.0, 20.0, 30.0}) draw(sketch, 0, y, 50);
    CHECK(rows(sketch) == Rows{10, 20, 30});
    sketch.undo();
    sketch.undo();
    CHECK(rows(sketch) == Rows{10});
    sketch.undo();
    CHECK(sketch.empty());
    CHECK_FALSE(sketch.can_undo());
    for (int i = 0; i < 3; ++i) sketch.redo();
    CHECK(rows(sketch) == Rows{10, 20, 30});
    CHECK_FALSE(sketch.can_redo());
}

TEST_CASE("one sweep of the eraser is one step, and strokes come back in their places", "[sketch]") {
    ui::Sketch sketch;
    for (const double y : {10.0, 20.0, 30.0, 40.0}) draw(sketch, 0, y, 50);
    CHECK(sketch.erase_at({25, 11}, 3));
    CHECK(sketch.erase_at({25, 31}, 3));
    CHECK_FALSE(sketch.erase_at({25, 60}, 3));
    sketch.end_erasing();
    CHECK(rows(sketch) == Rows{20, 40});
    sketch.undo();
    CHECK(rows(sketch) == Rows{10, 20, 30, 40});
    sketch.redo();
    CHECK(rows(sketch) == Rows{20, 40});
    sketch.undo();
    draw(sketch, 0, 50, 50);  // drawing on forgets what was undone
    CHECK_FALSE(sketch.can_redo());
}

TEST_CASE("erasing several strokes at one place brings them back in order", "[sketch]") {
    ui::Sketch sketch;
    for (const double y : {10.0, 11.0, 40.0, 12.0}) draw(sketch, 0, y, 50);
    CHECK(sketch.erase_at({25, 11}, 5));
    sketch.end_erasing();
    CHECK(rows(sketch) == Rows{40});
    sketch.undo();
    CHECK(rows(sketch) == Rows{10, 11, 40, 12});
}

TEST_CASE("a new sheet can be taken back", "[sketch]") {
    ui::Sketch sketch;
    for (const double y : {10.0, 20.0, 30.0}) draw(sketch, 0, y, 50);
    sketch.clear();
    CHECK(sketch.empty());
    sketch.undo();
    CHECK(rows(sketch) == Rows{10, 20, 30});
    sketch.redo();
    CHECK(sketch.empty());
    sketch.clear();  // nothing there: no step
    sketch.undo();
    CHECK(rows(sketch) == Rows{10, 20, 30});
}

TEST_CASE("forgetting leaves nothing to undo", "[sketch]") {
    ui::Sketch sketch;
    draw(sketch, 0, 10, 50);
    const auto epoch = sketch.epoch();
    sketch.forget();
    CHECK(sketch.empty());
    CHECK_FALSE(sketch.can_undo());
    CHECK(sketch.epoch() != epoch);
}

TEST_CASE("appending keeps the epoch, anything else changes it", "[sketch]") {
    ui::Sketch sketch;
    const auto start = sketch.epoch();
    draw(sketch, 0, 10, 50);
    draw(sketch, 0, 20, 50);
    CHECK(sketch.epoch() == start);
    sketch.undo();
    CHECK(sketch.epoch() != start);
}

TEST_CASE("a tip that rests adds no samples", "[sketch]") {
    ui::Sketch sketch;
    sketch.begin({0, 5, 5, 1});
    sketch.extend({1, 5, 5, 1});
    sketch.extend({2, 6, 5, 1});
    sketch.end();
    CHECK(sketch.drawing().strokes[0].samples.size() == 2);
}

TEST_CASE("taking back leaves sheet and history as they were", "[sketch]") {
    ui::Sketch sketch;
    sketch.take_back();
    CHECK(sketch.revision() == 0);
    sketch.begin({0, 1, 1, 1});
    sketch.end();
    const std::uint64_t epoch = sketch.epoch();
    sketch.begin({0, 5, 5, 1});
    sketch.extend({0, 6, 5, 1});
    sketch.take_back();
    CHECK(sketch.drawing().strokes.size() == 1);
    CHECK_FALSE(sketch.open());
    CHECK(sketch.epoch() != epoch);
    CHECK_FALSE(sketch.can_redo());
    CHECK(sketch.erase_at({1, 1}, 1));
    sketch.take_back();
    REQUIRE(sketch.drawing().strokes.size() == 1);
    CHECK(sketch.drawing().strokes[0].samples[0].x == 1);
    sketch.undo();
    CHECK(sketch.empty());
}

TEST_CASE("strokes keep their width through erasing, undo and clearing", "[sketch]") {
    ui::Sketch sketch;
    for (const double width : {1.0, 0.5, 1.0}) {
        sketch.begin({0, 10 * static_cast<double>(sketch.widths().size()), 0, 1}, width);
        sketch.end();
    }
    REQUIRE(sketch.erase_at({10, 0}, 1));
    sketch.end_erasing();
    CHECK(sketch.widths() == std::vector<double>{1, 1});
    sketch.undo();
    CHECK(sketch.widths() == std::vector<double>{1, 0.5, 1});
    sketch.clear();
    CHECK(sketch.widths().empty());
    sketch.undo();
    CHECK(sketch.widths() == std::vector<double>{1, 0.5, 1});
    CHECK(sketch.drawing().strokes[1].samples[0].x == 10);
    sketch.undo();
    sketch.redo();
    CHECK(sketch.widths().size() == sketch.drawing().strokes.size());
    sketch.begin({0, 50, 0, 1}, 0.5);
    sketch.take_back();
    CHECK(sketch.widths() == std::vector<double>{1, 0.5, 1});
}
