#include "db/codec/points_codec.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "db_fixtures.hpp"
#include "hostile_blob.hpp"

using core::Polygon;
using fixture::Random;

namespace {

Polygon round_trip(const Polygon& ring) {
    return fixture::value(db::decode_polygon(fixture::value(db::encode_polygon(ring))));
}

double box_side(const Polygon& ring) {
    const auto [left, right] = std::minmax_element(ring.begin(), ring.end(), [](auto a, auto b) { return a.x < b.x; });
    const auto [low, high] = std::minmax_element(ring.begin(), ring.end(), [](auto a, auto b) { return a.y < b.y; });
    return std::max(right->x - left->x, high->y - low->y);
}

}  // namespace

TEST_CASE("pixel and half-pixel outlines come back exactly", "[points]") {
    const Polygon pixels{{0, 0}, {1023, 0.5}, {1023.5, 767}, {-0.5, 766.5}};
    CHECK(round_trip(pixels) == pixels);
}

TEST_CASE("points move by less than 1/65534 of the box, and only once", "[points]") {
    Random random(7);
    for (int i = 0; i < 300; ++i) {
        const double radius = std::ldexp(1.0, fixture::whole(random, -20, 20)) * fixture::real(random, 0.5, 1.0);
        Polygon ring = fixture::random_outline(random, fixture::whole(random, 1, 120), radius);
        const core::Point away{fixture::real(random, -8, 8) * radius, fixture::real(random, -8, 8) * radius};
        for (core::Point& p : ring) p = p + away;
        const Polygon once = round_trip(ring);
        REQUIRE(once.size() == ring.size());
        double moved = 0.0;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            moved = std::max({moved, std::abs(once[k].x - ring[k].x), std::abs(once[k].y - ring[k].y)});
        }
        CHECK(moved <= std::max(box_side(ring) / 65534.0, 10.0 * radius * 0x1.0p-40));
        CHECK(round_trip(once) == once);
    }
}

TEST_CASE("a tiny outline far away stays near its place", "[points]") {
    const Polygon far{{1e9, 1e9}, {1e9 + 1e-6, 1e9}, {1e9, 1e9 + 1e-6}};
    const Polygon once = round_trip(far);
    CHECK(core::distance(once[1], far[1]) <= 1e9 * 0x1.0p-38);
    CHECK(round_trip(once) == once);
}

TEST_CASE("no points, one point and equal points are polygons too", "[points]") {
    CHECK(round_trip({}).empty());
    CHECK(round_trip({{0, 0}}) == Polygon{{0, 0}});
    CHECK(round_trip({{0.1, -3}, {0.1, -3}})[0].x == Approx(0.1).margin(1e-11));
}

TEST_CASE("100 points take about 4 bytes each", "[points]") {
    Random random(1);
    CHECK(fixture::value(db::encode_polygon(fixture::random_outline(random, 100, 1.0))).size() <= 450);
}

TEST_CASE("points that are not finite or out of reach are not stored", "[points]") {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {infinity, -infinity, nan, 1e10}) {
        const core::Result<db::Blob> refused = db::encode_polygon({{0, 0}, {1, bad}});
        REQUIRE_FALSE(refused);
        CHECK(refused.error().code == core::ErrorCode::BadOutline);
    }
}

TEST_CASE("a polygon blob cut off or changed gives an error or a sound polygon", "[points][hostile]") {
    Random random(3);
    fixture::try_every_cut_and_flip<Polygon>(
        fixture::value(db::encode_polygon(fixture::random_outline(random, 40, 1.0))), db::decode_polygon,
        db::encode_polygon, std::equal_to<>());
}
