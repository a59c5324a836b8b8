#include "core/parts/describe.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/match/match.hpp"
#include "core/silhouette/contour.hpp"
#include "support/raster.hpp"
#include "support/shapes.hpp"
#include "support/text_shape.hpp"

using core::BinaryImage;
using core::Polygon;
using core::ShapeDescriptor;

namespace {

ShapeDescriptor described(const BinaryImage& image) {
    const auto outline = core::largest_contour(image);
    REQUIRE(outline);
    const auto descriptor = core::describe(*outline);
    REQUIRE(descriptor);
    return *descriptor;
}

/// Shapes that the method has trouble to say anything about.
std::vector<std::pair<std::string, BinaryImage>> degenerate() {
    std::vector<std::pair<std::string, BinaryImage>> all{
        {"disc", support::silhouette_of(support::disc(90, 1), 120)},
        {"square", support::silhouette_of(support::rectangle(1, 1), 120)},
        {"blob", support::silhouette_of({{0, 2}, {2, 0}, {6, 0.5}, {9, 3}, {8, 6}, {4, 7}, {1, 5}}, 120)},
        {"long bar", support::silhouette_of(support::rectangle(40, 1), 160)},
        {"spiral", support::silhouette_of(support::spiral(4, 5), 200)},
        {"spiral whose sides cross once they are sampled", support::silhouette_of(support::spiral(8, 4), 260)},
        {"coastline", support::silhouette_of(support::coastline(9), 240)},
        {"comb of 200 teeth", support::silhouette_of(support::comb(200, 30), 1200)},
        {"one pixel wide, across",
         support::text_shape({"......................", ".####################.", "......................"})},
        {"three by three pixels", support::text_shape({".....", ".###.", ".###.", ".###.", "....."})},
    };
    BinaryImage slanted(60, 60), touching = support::rastered({{{-5, -5}, {40, -5}, {25, 64}, {-5, 64}}}, 60, 60);
    for (int i = 4; i < 56; ++i) slanted.at(i, i) = 1;
    all.emplace_back("one pixel wide, aslant", slanted);
    all.emplace_back("touching the border", touching);
    BinaryImage full(40, 30);
    std::fill(full.pixels.begin(), full.pixels.end(), 1);
    all.emplace_back("all of the page", full);
    all.emplace_back(
        "two objects",
        support::rastered({{{5, 5}, {55, 5}, {55, 30}, {30, 55}}, {{70, 60}, {90, 60}, {80, 90}}}, 100, 100));
    return all;
}

std::vector<std::pair<std::string, BinaryImage>> ordinary() {
    return {{"horse", support::silhouette_of(support::horse(), 140)},
            {"hand", support::silhouette_of(support::hand(), 140)},
            {"airplane", support::silhouette_of(support::airplane(), 140)},
            {"star", support::silhouette_of(support::star(5, 10, 4), 140)}};
}

void check_numbers(const ShapeDescriptor& d) {
    CHECK(std::isfinite(d.skeletal_length));
    CHECK(d.skeletal_length >= 0.0);
    const auto check = [](const core::Part& part) {
        for (const float f : part.features) CHECK(std::isfinite(f));
        for (const float r : part.signature) CHECK(std::isfinite(r));
    };
    for (const core::Part& part : d.parts) check(part);
    check(d.whole);
    CHECK(d.terminal_count >= 1);
    CHECK(d.parts.size() >= static_cast<std::size_t>(d.terminal_count));
    REQUIRE_FALSE(d.stop_points.empty());
    for (const int t : d.stop_points) CHECK((t >= 0 && t < d.terminal_count));
}

}  // namespace

TEST_CASE("every degenerate shape has a descriptor of finite numbers", "[describe]") {
    for (const auto& [name, image] : degenerate()) {
        INFO(name);
        check_numbers(described(image));
    }
}

TEST_CASE("every degenerate shape has a finite distance to everything, none to itself, symmetric", "[describe]") {
    std::vector<std::pair<std::string, core::MatchableShape>> shapes;
    for (const auto& [name, image] : degenerate()) shapes.emplace_back(name, core::matchable(described(image)));
    for (const auto& [name, image] : ordinary()) shapes.emplace_back(name, core::matchable(described(image)));
    core::Matcher matcher;
    for (const auto& [name_a, a] : shapes) {
        for (const auto& [name_b, b] : shapes) {
            INFO(name_a << " and " << name_b);
            const double d = matcher.distance(a, b);
            CHECK(std::isfinite(d));
            CHECK(d >= 0.0);
            CHECK(d == matcher.distance(b, a));
            if (name_a == name_b) CHECK(d == Approx(0.0).margin(1e-3));
        }
    }
}

TEST_CASE("a shape of fewer than two parts has the whole outline as its only one", "[describe]") {
    // Where every terminal is insignificant, nothing is cut at all.
    core::ShapeParameters nothing_counts;
    nothing_counts.thresh_any_clr = 0.0;
    nothing_counts.sharp_turn_deg = 180.0;
    for (const auto& [name, image] : degenerate()) {
        INFO(name);
        const auto outline = core::largest_contour(image);
        REQUIRE(outline);
        const auto shape = core::describe_in_steps(*outline, nothing_counts);
        REQUIRE(shape);
        REQUIRE(shape->skeleton.pieces.pieces.size() == 1);
        CHECK(shape->tree.root == -1);
        const ShapeDescriptor& d = shape->descriptor;
        REQUIRE(d.parts.size() == 1);
        CHECK(d.terminal_count == 1);
        CHECK(d.parts[0] == d.whole);
        CHECK(d.parts[0].start_sample == d.parts[0].end_sample);
        CHECK(d.parts[0].features[0] == 100.0F);
        CHECK(d.stop_points == std::vector<int>{0});
        CHECK(d.skeletal_length == 0.0);
        check_numbers(d);
        core::Matcher matcher;
        const core::MatchableShape plain = core::matchable(d);
        CHECK(matcher.distance(plain, plain) == Approx(0.0).margin(1e-3));
        CHECK(std::isfinite(matcher.distance(plain, core::matchable(described(ordinary()[0].second)))));
    }
}

TEST_CASE("terminals of the descriptor are those of the graph", "[describe]") {
    for (const auto& [name, image] : ordinary()) {
        INFO(name);
        const auto shape = core::describe_in_steps(*core::largest_contour(image));
        REQUIRE(shape);
        const auto& nodes = shape->skeleton.graph.nodes;
        CHECK(shape->descriptor.terminal_count ==
              std::count_if(nodes.begin(), nodes.end(),
                            [](const core::CatNode& node) { return node.kind == core::PieceKind::Terminal; }));
        CHECK(shape->descriptor.samples == shape->skeleton.samples);
        CHECK(shape->descriptor.skeletal_length == shape->skeleton.skeletal_length);
    }
}

TEST_CASE("a band whose samples would cross is described by fewer of them", "[describe]") {
    const ShapeDescriptor spiral = described(support::silhouette_of(support::spiral(8, 4), 260));
    CHECK(spiral.samples.size() < 100);
    CHECK(core::triangulate(spiral.samples));
}

TEST_CASE("a comb keeps its teeth as long as there are samples for them", "[describe]") {
    // 100 samples: ten teeth have four corners each; two hundred do not, and what is left is still a shape.
    const ShapeDescriptor ten = described(support::silhouette_of(support::comb(10, 8), 200));
    CHECK(ten.terminal_count >= 10);
    const ShapeDescriptor many = described(support::silhouette_of(support::comb(200, 30), 1200));
    CHECK(many.samples.size() <= 100);
    CHECK(many.terminal_count >= 1);
}

TEST_CASE("of two objects the larger is described", "[describe]") {
    const Polygon large{{5, 5}, {55, 5}, {55, 30}, {30, 55}}, small{{70, 60}, {90, 60}, {80, 90}};
    CHECK(described(support::rastered({large, small}, 100, 100)) == described(support::rastered({large}, 100, 100)));
}

TEST_CASE("a page margin changes nothing, not even its absence", "[describe]") {
    const BinaryImage tight = support::silhouette_of(support::horse(), 140, 0);
    const ShapeDescriptor here = described(tight);
    const ShapeDescriptor there = described(support::with_margin(tight, 13, 5, 7, 9));
    CHECK(here.parts == there.parts);
    CHECK(here.stop_points == there.stop_points);
}

TEST_CASE("an outline twice, four times or half as large has the same parts to the last bit", "[describe]") {
    // Grids have steps of powers of two, so everything scales exactly with them.
    for (const Polygon& outline : {support::horse(), support::hand(), support::bug(), support::coastline(6)}) {
        const auto one = core::describe(outline);
        REQUIRE(one);
        for (const double factor : {0.5, 2.0, 4.0}) {
            const auto other = core::describe(support::scaled(outline, factor));
            REQUIRE(other);
            CHECK(other->parts == one->parts);
            CHECK(other->stop_points == one->stop_points);
            CHECK(other->whole == one->whole);
            CHECK(other->skeletal_length == factor * one->skeletal_length);
        }
    }
}

TEST_CASE("a mirrored outline reads nearly the same backwards", "[describe]") {
    core::Matcher matcher;
    for (const Polygon& outline : {support::horse(), support::horned(), support::centaur(), support::hand()}) {
        const auto one = core::describe(outline), other = core::describe(support::mirrored(outline));
        REQUIRE((one && other));
        const core::Match match = matcher.match(core::matchable(*one), core::matchable(*other));
        CHECK(match.reversed);
        CHECK(match.distance < 0.5 * matcher.asymmetry(core::matchable(*one)));
    }
}

TEST_CASE("a horse is its legs, tail and head; legs of one end and the head make wings", "[describe]") {
    const ShapeDescriptor horse = described(support::silhouette_of(support::horse(), 200));
    CHECK(horse.terminal_count >= 6);
    CHECK(horse.terminal_count <= 9);
    CHECK(horse.parts.size() > static_cast<std::size_t>(horse.terminal_count));
    CHECK(std::is_sorted(horse.stop_points.begin(), horse.stop_points.end()));
    // What the parts cut off never adds up to more than the shape: terminals do not overlap.
    double area = 0.0, perimeter = 0.0;
    for (int t = 0; t < horse.terminal_count; ++t) {
        area += horse.parts[static_cast<std::size_t>(t)].features[0];
        perimeter += horse.parts[static_cast<std::size_t>(t)].features[1];
    }
    CHECK(area < 100.0);
    CHECK(perimeter < 100.0);
}

TEST_CASE("outlines that enclose no area are told apart", "[describe]") {
    CHECK(core::describe({}).error().code == core::ErrorCode::BadOutline);
    CHECK(core::describe({{0, 0}, {1, 0}, {2, 0}}).error().code == core::ErrorCode::BadOutline);
}
