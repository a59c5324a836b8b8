#include "core/garment/region.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "support/outlines.hpp"

using core::RegionOutline;
using core::Vec3;

namespace {

std::string fault(const RegionOutline& outline) {
    const auto filled = core::fill_region(outline, core::kCoonsAlpha);
    return filled ? "" : filled.error().message;
}

bool says(const RegionOutline& outline, const char* words) {
    INFO(fault(outline));
    return fault(outline).find(words) != std::string::npos;
}

RegionOutline square() {
    return {{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
             {{2, 0, 0}, {2, 1, 0}, {2, 2, 0}},
             {{2, 2, 0}, {1, 2, 0}, {0, 2, 0}},
             {{0, 2, 0}, {0, 1, 0}, {0, 0, 0}}}};
}

}  // namespace

TEST_CASE("a filled region keeps its points, in order, bit for bit", "[region]") {
    const RegionOutline outline = support::circle_outline({7, 4, 5, 6, 8});
    const auto filled = core::fill_region(outline, -0.2);
    REQUIRE(filled);
    std::size_t at = 0;
    for (const auto& side : outline.sides)
        for (std::size_t k = 0; k + 1 < side.size(); ++k) CHECK(filled->mesh.vertices[at++] == side[k]);
    CHECK(at == filled->topology.boundary);
    CHECK(filled->mesh.quads == filled->topology.quads);
}

TEST_CASE("no quad folds on a circle, whatever alpha", "[region]") {
    for (const std::vector<int>& sides :
         {std::vector{20, 6, 6}, {40, 3, 5}, {9, 7, 8, 6, 10, 8}, {6, 6}, {31, 2, 3, 4}, {8, 8, 8, 8, 8, 8, 8, 8}})
        for (const double alpha : {0.0, -0.1, -0.25}) {
            CAPTURE(sides, alpha);
            const auto filled = core::fill_region(support::circle_outline(sides), alpha);
            REQUIRE(filled);
            CHECK(support::folded_quad(filled->mesh) == -1);
            CHECK(filled->alpha >= alpha);
        }
}

TEST_CASE("faulty outlines are refused in one sentence that names the place", "[region]") {
    CHECK(fault(square()).empty());
    RegionOutline open = square();
    open.sides[1].back().x = 2.5;
    CHECK(says(open, "side 2 does not end where side 3 starts"));
    RegionOutline not_finite = square();
    not_finite.sides[2][1].y = std::numeric_limits<double>::quiet_NaN();
    CHECK(says(not_finite, "Side 3 has a coordinate that is no finite number"));
    RegionOutline doubled = square();
    doubled.sides[0].insert(doubled.sides[0].begin() + 1, {1, 0, 0});
    CHECK(says(doubled, "Side 1 has an edge without length"));
    RegionOutline no_length = square();
    no_length.sides.insert(no_length.sides.begin() + 1, {{2, 0, 0}, {2, 0, 0}});
    CHECK(says(no_length, "Side 2 has an edge without length"));
    RegionOutline point = square();
    point.sides[3] = {{0, 2, 0}};
    CHECK(says(point, "Side 4 has fewer than 2 points"));
    RegionOutline odd = square();
    odd.sides[0] = {{0, 0, 0}, {2, 0, 0}};
    CHECK(says(odd, "odd"));
    CHECK(says({{square().sides[0]}}, "1 sides"));
    CHECK(says({}, "0 sides"));
}

TEST_CASE("an outline that crosses or touches itself is refused", "[region]") {
    const RegionOutline eight{{{{0, 0, 0}, {2, 2, 0}, {3, 3, 0}},
                               {{3, 3, 0}, {3, 0, 0}},
                               {{3, 0, 0}, {0, 3, 0}},
                               {{0, 3, 0}, {0, 1, 0}, {0, 0, 0}}}};
    CHECK(says(eight, "side 1 and side 3 touch or cross"));
    RegionOutline lifted = eight;  // the same from above, but one side passes over the other
    lifted.sides[2] = {{3, 0, 0}, {1.5, 1.5, 1}, {0, 3, 0}};
    lifted.sides[1] = {{3, 3, 0}, {3, 1, 0}, {3, 0, 0}};
    CHECK(fault(lifted).empty());
}
