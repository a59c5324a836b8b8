#include "core/match/outline_profile.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/geometry/polygon.hpp"
#include "support/shapes.hpp"

using core::outline_difference;
using core::outline_profile;
using core::OutlineAnchor;
using core::OutlineProfile;

namespace {

const std::vector<OutlineAnchor> kAsTheyAre{{0, 0}};

core::Polygon turned(const core::Polygon& shape, double angle, double scale) {
    core::Polygon out;
    for (const core::Point p : shape) {
        out.push_back({scale * (p.x * std::cos(angle) - p.y * std::sin(angle)) + 7.0,
                       scale * (p.x * std::sin(angle) + p.y * std::cos(angle)) - 3.0});
    }
    return out;
}

/// The mirror image in anti-clockwise order, from the same first point.
core::Polygon mirror_image(const core::Polygon& shape) {
    core::Polygon out{{-shape.front().x, shape.front().y}};
    for (std::size_t i = shape.size(); i-- > 1;) out.push_back({-shape[i].x, shape[i].y});
    return out;
}

}  // namespace

TEST_CASE("an outline does not differ from itself, turned, moved or at another size", "[outline]") {
    const core::Polygon horse = support::horse();
    const OutlineProfile profile = outline_profile(horse);
    CHECK(outline_difference(profile, profile, kAsTheyAre) == 0.0F);
    for (const double angle : {0.4, 1.9, 3.1, 5.0}) {
        const OutlineProfile other = outline_profile(turned(horse, angle, 2.5));
        CHECK(outline_difference(profile, other, kAsTheyAre) < 0.005F);
    }
}

TEST_CASE("a shape read backwards is its mirror image", "[outline]") {
    const OutlineProfile profile = outline_profile(support::horse());
    const OutlineProfile image = outline_profile(mirror_image(support::horse()));
    CHECK(outline_difference(mirrored(profile), image, kAsTheyAre) < 0.005F);
    CHECK(outline_difference(profile, image, kAsTheyAre) > 0.1F);
    CHECK(mirrored(mirrored(profile)) == profile);
}

TEST_CASE("heights are those of the rest of the outline over the tangent", "[outline]") {
    // A square from its lower left corner: seen from the middle of the lower side, the upper side stands highest.
    const core::Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    const OutlineProfile profile = outline_profile(square);
    const auto& from_below = profile.heights[32];  // an eighth of the way round
    CHECK(from_below[0] == 128);                   // along the lower side itself
    CHECK(from_below[7] > from_below[3]);
    for (std::size_t bin = 0; bin < core::kHeightBins; ++bin) {
        CHECK(from_below[bin] >= 128);  // nothing lies below a side of a convex shape
    }
}

TEST_CASE("anchors say what is compared with what", "[outline]") {
    // The same shape from another first point, a quarter of the way round.
    const core::Polygon star = support::star(5, 9, 4);
    core::Polygon even = core::resample_ring(star, 256), later(even.begin() + 64, even.end());
    later.insert(later.end(), even.begin(), even.begin() + 64);
    const OutlineProfile a = outline_profile(even), b = outline_profile(later);
    const std::vector<OutlineAnchor> shifted{{64U << 8U, 0}};
    CHECK(outline_difference(a, b, shifted) < 0.01F);
    CHECK(outline_difference(a, b, kAsTheyAre) > 0.2F);
    // Anchors that agree with each other change nothing.
    const std::vector<OutlineAnchor> more{{64U << 8U, 0}, {100U << 8U, 36U << 8U}, {200U << 8U, 136U << 8U}};
    CHECK(outline_difference(a, b, more) < 0.01F);
}

TEST_CASE("swapping two outlines changes nothing", "[outline]") {
    const OutlineProfile a = outline_profile(support::horse()), b = outline_profile(support::hand());
    const std::vector<OutlineAnchor> there{{100, 40000}, {9000, 52000}, {30000, 900}, {41000, 22000}};
    std::vector<OutlineAnchor> back;
    for (const OutlineAnchor& anchor : there) back.push_back({anchor.b, anchor.a});
    CHECK(outline_difference(a, b, there) == outline_difference(b, a, back));
}

TEST_CASE("giving up returns the limit", "[outline]") {
    const OutlineProfile a = outline_profile(support::horse()), b = outline_profile(support::hand());
    const float difference = outline_difference(a, b, kAsTheyAre);
    CHECK(outline_difference(a, b, kAsTheyAre, difference / 3) == difference / 3);
    CHECK(outline_difference(a, b, kAsTheyAre, difference * 1.1F) == difference);
}

TEST_CASE("outlines without height and alignments without anchor have finite differences", "[outline]") {
    const OutlineProfile line = outline_profile({{0, 0}, {5, 0}, {9, 0}});
    const OutlineProfile horse = outline_profile(support::horse());
    CHECK(line.complexity == 0.0F);
    CHECK(outline_difference(line, line, kAsTheyAre) == 0.0F);
    CHECK(std::isfinite(outline_difference(line, horse, kAsTheyAre)));
    CHECK(outline_difference(horse, horse, {}) == core::kUnaligned);
    // A part that is the whole outline starts where it ends.
    const std::vector<OutlineAnchor> whole{{500, 500}, {500, 500}};
    CHECK(outline_difference(horse, horse, whole) == 0.0F);
}
