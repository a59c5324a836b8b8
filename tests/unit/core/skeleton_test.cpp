#include "core/skeleton/skeleton.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/geometry/polygon.hpp"
#include "core/silhouette/contour.hpp"
#include "support/raster.hpp"
#include "support/shapes.hpp"

using core::PieceKind;
using core::Polygon;
using core::Skeleton;

namespace {

Skeleton skeleton_of(const Polygon& outline) {
    const auto s = core::skeletonise(outline, {});
    REQUIRE(s);
    return *s;
}

int count_of(const Skeleton& s, PieceKind kind) {
    return static_cast<int>(std::count_if(s.graph.nodes.begin(), s.graph.nodes.end(),
                                          [&](const core::CatNode& node) { return node.kind == kind; }));
}

std::vector<std::pair<const char*, Polygon>> figures() {
    return {{"horse", support::horse()},       {"hand", support::hand()},      {"star", support::star(5, 10, 4)},
            {"airplane", support::airplane()}, {"bug", support::bug()},        {"centaur", support::centaur()},
            {"comb", support::comb(6, 5)},     {"cross", support::cross(9, 3)}};
}

}  // namespace

TEST_CASE("the worked figures have the terminals that a person counts", "[skeleton]") {
    CHECK(count_of(skeleton_of(support::star(5, 10, 4)), PieceKind::Terminal) == 5);
    CHECK(count_of(skeleton_of(support::cross(9, 3)), PieceKind::Terminal) == 4);
    CHECK(count_of(skeleton_of(support::hand()), PieceKind::Terminal) >= 5);  // fingers and thumb; the wrist may be one
    CHECK(count_of(skeleton_of(support::hand()), PieceKind::Terminal) <= 7);
    CHECK(count_of(skeleton_of(support::airplane()), PieceKind::Terminal) == 5);  // nose, wings, fins
    CHECK(count_of(skeleton_of(support::bug()), PieceKind::Terminal) >= 8);       // six legs, two feelers
}

TEST_CASE("the middle of a star is one junction, an airplane has several", "[skeleton]") {
    const Skeleton star = skeleton_of(support::star(5, 10, 4));
    CHECK(count_of(star, PieceKind::Junction) == 1);
    // Figure 5.8: the blocks of an airplane keep the main body, the wings and the tail apart.
    const Skeleton airplane = skeleton_of(support::airplane());
    CHECK(count_of(airplane, PieceKind::Junction) >= 2);
}

TEST_CASE("every stage hands on what the next one reads", "[skeleton]") {
    for (const auto& [name, outline] : figures()) {
        INFO(name);
        const Skeleton s = skeleton_of(outline);
        const core::ShapeParameters p;
        CHECK(s.contour.size() == static_cast<std::size_t>(p.contour_points));
        CHECK(s.cornerity.size() == s.contour.size());
        CHECK(std::is_sorted(s.corners.begin(), s.corners.end()));
        CHECK(s.samples.size() <= static_cast<std::size_t>(p.sample_size));
        CHECK(s.arcs.perimeter() == Approx(core::perimeter(s.samples)));
        CHECK(s.triangulation.triangles.size() == s.samples.size() - 2);
        CHECK(s.csp_pieces.cuts == s.profile.cuts());
        // Insignificant terminals go, nothing is added.
        for (std::size_t c = 0; c < s.csp_pieces.cuts.size(); ++c) {
            CHECK(s.significant_pieces.cuts[c] <= s.csp_pieces.cuts[c]);
        }
        CHECK(s.merged_pieces.pieces.size() <= s.significant_pieces.pieces.size());
        CHECK(s.graph.nodes.size() == s.pieces.pieces.size());
    }
}

TEST_CASE("no two sleeves are neighbours in what the descriptor stands on", "[skeleton]") {
    for (const auto& [name, outline] : figures()) {
        INFO(name);
        const Skeleton s = skeleton_of(outline);
        for (const core::CatNode& node : s.graph.nodes) {
            if (node.kind != PieceKind::Sleeve) continue;
            for (const int other : node.neighbours) {
                CHECK(s.graph.nodes[static_cast<std::size_t>(other)].kind != PieceKind::Sleeve);
            }
        }
    }
}

TEST_CASE("the skeleton lies inside the shape's box and hangs together", "[skeleton]") {
    for (const auto& [name, outline] : figures()) {
        INFO(name);
        const Skeleton s = skeleton_of(outline);
        std::size_t edges = 0;
        for (const core::CatNode& node : s.graph.nodes) edges += node.neighbours.size();
        CHECK(edges == 2 * (s.graph.nodes.size() - 1));
        // Each end of a segment that is no centroid is the middle of a chord, shared with the next node.
        for (const core::SkeletalSegment& segment : s.graph.skeleton) {
            const bool shared =
                std::any_of(s.graph.skeleton.begin(), s.graph.skeleton.end(), [&](const core::SkeletalSegment& other) {
                    return other.node != segment.node && (other.from == segment.from || other.to == segment.from);
                });
            CHECK(shared);
        }
    }
}

TEST_CASE("a bar's skeleton is nearly as long as the bar, and grows with it", "[skeleton]") {
    const double once = skeleton_of(support::rectangle(100, 6)).skeletal_length;
    CHECK(once > 85);
    CHECK(once < 101);
    CHECK(skeleton_of(support::rectangle(300, 18)).skeletal_length == Approx(3 * once).epsilon(0.01));
}

TEST_CASE("long limbs make a long skeleton: what views are chosen by", "[skeleton]") {
    const double stubby = skeleton_of(support::star(5, 10, 7)).skeletal_length,
                 slender = skeleton_of(support::star(5, 10, 2)).skeletal_length;
    CHECK(slender > stubby);
    CHECK(skeleton_of(support::comb(6, 9)).skeletal_length > skeleton_of(support::comb(6, 3)).skeletal_length);
}

TEST_CASE("an outline that encloses nothing has no skeleton", "[skeleton]") {
    const std::vector<Polygon> nothing{{},
                                       {{1, 1}},
                                       {{0, 0}, {5, 5}},
                                       {{0, 0}, {5, 5}, {10, 10}},
                                       {{0, 0}, {0, 5}, {5, 5}, {5, 0}},  // clockwise
                                       Polygon(50, core::Point{3, 3})};
    for (const Polygon& outline : nothing) {
        const auto s = core::skeletonise(outline, {});
        REQUIRE_FALSE(s);
        CHECK(s.error().code == core::ErrorCode::BadOutline);
    }
}
