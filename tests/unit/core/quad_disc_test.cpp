#include "core/mesh/quad_disc.hpp"

#include <catch2/catch.hpp>

using core::count_quad_disc;
using core::Quad;

namespace {

const std::vector<bool> kFourCorners{true, false, true, false, true, false, true, false};
/// 2 x 2 quads: the boundary 0 … 7 from a corner on, 8 in the middle.
std::vector<Quad> two_by_two() {
    return {{0, 1, 8, 7}, {1, 2, 3, 8}, {8, 3, 4, 5}, {7, 8, 5, 6}};
}

}  // namespace

TEST_CASE("a grid is a disc without irregular vertices; other corners make some", "[quad_disc]") {
    const auto counts = count_quad_disc(two_by_two(), 9, kFourCorners);
    REQUIRE(counts);
    CHECK(counts->irregular() == 0);
    CHECK(counts->interior_by_valence[4] == 1);
    std::vector<bool> two_corners(8, false);
    two_corners[0] = two_corners[4] = true;
    CHECK(count_quad_disc(two_by_two(), 9, two_corners)->irregular_boundary == 2);
}

TEST_CASE("what is no disc of quads is told apart", "[quad_disc]") {
    std::vector<Quad> quads = two_by_two();
    std::swap(quads[1][1], quads[1][3]);
    CHECK_FALSE(count_quad_disc(quads, 9, kFourCorners));  // one turned over
    quads = two_by_two();
    quads.pop_back();
    CHECK_FALSE(count_quad_disc(quads, 9, kFourCorners));  // a hole at the border
    quads = two_by_two();
    quads[0][2] = 0;
    CHECK_FALSE(count_quad_disc(quads, 9, kFourCorners));  // a corner twice
    quads = two_by_two();
    quads[0][2] = 77;
    CHECK_FALSE(count_quad_disc(quads, 9, kFourCorners));          // no such vertex
    CHECK_FALSE(count_quad_disc(two_by_two(), 10, kFourCorners));  // a vertex without a quad
    quads = two_by_two();
    quads.push_back(quads[0]);
    CHECK_FALSE(count_quad_disc(quads, 9, kFourCorners));  // a quad twice
}

TEST_CASE("an inner vertex with two quads is refused", "[quad_disc]") {
    const std::vector<Quad> quads{{0, 1, 2, 4}, {4, 2, 3, 0}};
    CHECK_FALSE(count_quad_disc(quads, 5, std::vector<bool>(4, true)));
}
