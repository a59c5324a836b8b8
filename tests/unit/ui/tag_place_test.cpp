#include "ui/draw/tag_place.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using core::Point;

namespace {

double least_distance(const std::vector<Point>& places) {
    double least = 1e9;
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, std::hypot(places[i].x - places[j].x, places[i].y - places[j].y));
    }
    return least;
}

}  // namespace

TEST_CASE("a number stands inside its part, also where the middle of its points does not", "[tag place]") {
    const Point square = ui::tag_place({{10, 10}, {30, 10}, {30, 20}, {10, 20}});
    CHECK((square.x > 10 && square.x < 30 && square.y > 10 && square.y < 20));
    // two legs with nothing between them
    const Point legs = ui::tag_place({{0, 0}, {60, 0}, {60, 90}, {50, 90}, {50, 10}, {10, 10}, {10, 90}, {0, 90}});
    CHECK((legs.y < 10 || legs.x < 10 || legs.x > 50));
}

TEST_CASE("numbers that would cover each other move apart, and no others move", "[tag place]") {
    std::vector<Point> places{{100, 100}, {108, 103}, {300, 100}, {106, 96}, {300, 100}};
    ui::spread_tags(places, 30);
    CHECK(least_distance(places) >= 29.9);
    for (const Point& p : places) CHECK(std::abs(p.y - 100) < 40);
    std::vector<Point> far{{0, 0}, {50, 0}, {0, 50}};
    const std::vector<Point> before = far;
    ui::spread_tags(far, 30);
    for (std::size_t i = 0; i < far.size(); ++i) CHECK((far[i].x == before[i].x && far[i].y == before[i].y));
    std::vector<Point> none;
    ui::spread_tags(none, 30);
    CHECK(none.empty());
}
