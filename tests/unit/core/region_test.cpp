#include "core/garment/region.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
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

TEST_CASE("a grid whose sides arch high is the discrete Coons patch all the same", "[region]") {
    constexpr int kAcross = 7, kUp = 5;
    const auto point = [](int i, int j) {
        const double u = static_cast<double>(i) / kAcross, v = static_cast<double>(j) / kUp;
        return Vec3{u * 10, v * 10, 6 * std::sin(3.1 * u) + 5 * std::sin(3.1 * v) + 3 * u * v};
    };
    RegionOutline outline{{{}, {}, {}, {}}};
    for (int i = 0; i <= kAcross; ++i) {
        outline.sides[0].push_back(point(i, 0));
        outline.sides[2].push_back(point(kAcross - i, kUp));
    }
    for (int j = 0; j <= kUp; ++j) {
        outline.sides[1].push_back(point(kAcross, j));
        outline.sides[3].push_back(point(0, kUp - j));
    }
    const auto filled = core::fill_region(outline, core::kCoonsAlpha);
    REQUIRE(filled);
    CHECK(filled->alpha == core::kCoonsAlpha);
    const auto coons = [&](int i, int j) {
        const double u = static_cast<double>(i) / kAcross, v = static_cast<double>(j) / kUp;
        const Vec3 across = point(0, j) * (1 - u) + point(kAcross, j) * u;
        const Vec3 up = point(i, 0) * (1 - v) + point(i, kUp) * v;
        const Vec3 corners = (point(0, 0) * (1 - v) + point(0, kUp) * v) * (1 - u) +
                             (point(kAcross, 0) * (1 - v) + point(kAcross, kUp) * v) * u;
        return across + up - corners;
    };
    double highest = 0.0;
    for (int i = 1; i < kAcross; ++i)
        for (int j = 1; j < kUp; ++j) {
            const Vec3 wanted = coons(i, j);
            double nearest = 1e9;
            for (const Vec3& v : filled->mesh.vertices) nearest = std::min(nearest, core::length(v - wanted));
            CAPTURE(i, j);
            CHECK(nearest < 1e-10);
            highest = std::max(highest, wanted.z);
        }
    CHECK(highest > 9);  // well above all sides
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
