#include "core/garment/network.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/garment/cloth.hpp"

using core::Network;
using core::SpaceLine;
using core::Vec3;

namespace {

/// Two squares of 20 cm beside each other, from x = 10 on, in the plane z = 0.
Network two_squares() {
    Network net;
    REQUIRE(net.add_line("bottom", {{10, 0, 0}, {30, 0, 0}}));
    REQUIRE(net.add_line("middle", {{30, 0, 0}, {30, 20, 0}}));
    REQUIRE(net.add_line("top", {{30, 20, 0}, {10, 20, 0}}));
    REQUIRE(net.add_line("left", {{10, 20, 0}, {10, 0, 0}}));
    REQUIRE(net.add_line("bottom2", {{30, 0, 0}, {50, 0, 0}}));
    REQUIRE(net.add_line("right", {{50, 0, 0}, {50, 20, 0}}));
    REQUIRE(net.add_line("top2", {{50, 20, 0}, {30, 20, 0}}));
    REQUIRE(net.add_region("one", {"bottom", "middle", "top", "left"}, nullptr));
    REQUIRE(net.add_region("two", {"bottom2", "right", "top2", "middle"}, nullptr));
    return net;
}

SpaceLine ring(double x, double y, double radius) {
    SpaceLine line;
    for (int k = 0; k <= 40; ++k) {
        const double a = 2.0 * std::numbers::pi * k / 40;
        line.push_back({x + radius * std::cos(a), y + radius * std::sin(a), 0});
    }
    return line;
}

double area(const core::QuadMesh& mesh) {
    double sum = 0.0;
    for (const core::Quad& q : mesh.quads) {
        const auto& v = mesh.vertices;
        sum += 0.5 * core::cross(v[q[2]] - v[q[0]], v[q[3]] - v[q[1]]).z;
    }
    return sum;
}

/// Every region can be filled, every line has an even number of edges, everything hangs together.
void check_sound(const Network& net, std::size_t pieces) {
    CHECK(net.inconsistency().empty());
    for (const core::NetworkLine& line : net.lines()) CHECK(net.edge_count(line) % 2 == 0);
    const core::BuiltCloth built = core::build_cloth(net, 0);
    for (const core::ClothFault& fault : built.faults) FAIL(fault.region + ": " + fault.error.message);
    CHECK(built.cloth.pieces.size() == pieces);
}

}  // namespace

TEST_CASE("regions share the points of their common lines", "[network]") {
    const Network net = two_squares();
    check_sound(net, 2);
    const core::Cloth cloth = core::build_cloth(net, 0).cloth;
    CHECK(cloth.mesh.quads.size() == 128);
    CHECK(cloth.mesh.vertices.size() == 9 * 17);
    CHECK(area(cloth.mesh) == Approx(800.0));
    const core::ClothEdges edges = core::edges_of(cloth);
    CHECK(edges.seams.size() == 8);
    CHECK(edges.hems.size() == 48);
}

TEST_CASE("ends near a vertex are welded, ends near a line split it", "[network]") {
    Network net = two_squares();
    REQUIRE(net.add_line("inner", {{11, 1, 0.5}, {20, 11, 0}, {29, 10, 0}}));
    CHECK(net.inconsistency().empty());
    const core::NetworkLine& line = net.lines().back();
    CHECK(line.shape.front() == Vec3{10, 0, 0});
    CHECK(line.shape.back().x == Approx(30.0));
    check_sound(net, 2);  // both regions now pass two pieces of the middle line
    CHECK(net.find_region("two")->ring.size() == 5);
}

TEST_CASE("a cut parts a region in two that fill what it filled", "[network]") {
    Network net = two_squares();
    REQUIRE(net.cut("two", {{50, 11, 0}, {40, 12, 0}, {30, 9, 0}}, "upper"));
    check_sound(net, 3);
    CHECK(area(core::build_cloth(net, 0).cloth.mesh) == Approx(800.0));
    REQUIRE(net.cut("upper", {{40, 12, 0}, {40, 20, 0}}, "corner"));
    check_sound(net, 4);
    CHECK_FALSE(net.cut("three", {{0, 0, 0}, {1, 0, 0}}, "x"));
    CHECK_FALSE(net.cut("two", {{30, 9, 0}, {40, 0, 0}}, "upper"));
    CHECK_FALSE(net.cut("two", {{30.1, 0.2, 0}, {29.9, 0, 0}}, "x"));
    check_sound(net, 4);
}

TEST_CASE("a hole is left open", "[network]") {
    Network net = two_squares();
    REQUIRE(net.cut_hole("one", ring(20, 11, 4), "other half"));
    check_sound(net, 3);
    CHECK(area(core::build_cloth(net, 0).cloth.mesh) == Approx(800.0 - 3.1416 * 16.0).margin(4.0));
    SpaceLine turned = ring(40, 9, 4);
    std::reverse(turned.begin(), turned.end());
    REQUIRE(net.cut_hole("two", turned, "last"));
    check_sound(net, 4);
    CHECK_FALSE(net.cut_hole("two", ring(40, 9, 0.2), "x"));
}

TEST_CASE("regions are removed with the lines that only they had", "[network]") {
    Network net = two_squares();
    REQUIRE(net.remove_region("one"));
    check_sound(net, 1);
    int alive = 0;
    for (const core::NetworkLine& line : net.lines()) alive += line.alive;
    CHECK(alive == 4);
    CHECK_FALSE(net.remove_region("one"));
    REQUIRE(net.add_line("new", {{30, 20, 0}, {20, 10, 0}, {30, 0, 0}}));
    REQUIRE(net.add_region("one", {"new", "middle"}, nullptr));  // the name is free again
    check_sound(net, 2);
}

TEST_CASE("moving a vertex takes its neighbourhood along; welding joins", "[network]") {
    Network net = two_squares();
    REQUIRE(net.move({30, 20, 0}, {30, 26, 3}, 8.0));
    check_sound(net, 2);
    CHECK(area(core::build_cloth(net, 0).cloth.mesh) > 805.0);
    CHECK_FALSE(net.move({0, 90, 0}, {0, 0, 0}, 5.0));
    Network apart;
    REQUIRE(apart.add_line("a", {{10, 0, 0}, {30, 0, 0}}));
    REQUIRE(apart.add_line("b", {{30, 5, 0}, {20, 20, 0}}));
    REQUIRE(apart.add_line("c", {{20, 20, 0}, {10, 0, 0}}));
    CHECK(apart.add_region("r", {"a", "b", "c"}, nullptr).error().message.find("not closed") != std::string::npos);
    REQUIRE(apart.weld({30, 0, 0}, {30, 5, 0}));
    REQUIRE(apart.add_region("r", {"a", "b", "c"}, nullptr));
    check_sound(apart, 1);
    CHECK_FALSE(apart.weld({10, 0, 0}, {30, 0, 0}));
}

TEST_CASE("corners are found where the outline turns, and can be corrected", "[network]") {
    Network net = two_squares();
    CHECK(net.find_region("one")->corners.size() == 4);
    REQUIRE(net.set_corner("one", {20, 0, 0}, true));
    CHECK(net.find_region("one")->corners.size() == 5);
    REQUIRE(net.set_corner("one", {10, 0, 0}, false));
    CHECK(net.find_region("one")->corners.size() == 4);
    check_sound(net, 2);
    REQUIRE(net.set_corner("one", {10, 20, 0}, false));
    REQUIRE(net.set_corner("one", {30, 20, 0}, false));
    CHECK_FALSE(net.set_corner("one", {30, 0, 0}, false));  // two must stay
    check_sound(net, 2);
}

TEST_CASE("a single closed stroke is a region", "[network]") {
    Network round;
    REQUIRE(round.add_line("pocket", ring(30, 30, 8)));
    REQUIRE(round.add_region("pocket", {"pocket"}, nullptr));
    check_sound(round, 1);
    Network square;
    REQUIRE(square.add_line("s", {{10, 10, 0}, {20, 10, 0}, {20, 20, 0}, {10, 20, 0}, {10, 10, 0}}));
    REQUIRE(square.add_region("s", {"s"}, nullptr));
    CHECK(square.find_region("s")->corners.size() >= 3);
    check_sound(square, 1);
}

TEST_CASE("what is drawn on another layer is not welded", "[network]") {
    Network net = two_squares();
    net.begin_layer(1);
    REQUIRE(net.add_line("patch", {{12, 2, 0}, {28, 2, 0}, {28, 18, 0}, {12, 18, 0}, {12, 2, 0}}));
    REQUIRE(net.add_region("patch", {"patch"}, nullptr));
    check_sound(net, 2);
    CHECK(core::build_cloth(net, 1).cloth.pieces.size() == 1);
    CHECK(net.find_region("one")->ring.size() == 4);
}

TEST_CASE("faulty lines and regions are named", "[network]") {
    Network net = two_squares();
    const auto says = [](const core::Result<void>& done, const char* words) {
        return !done && done.error().message.find(words) != std::string::npos;
    };
    CHECK(says(net.add_line("", {{0, 0, 0}, {9, 0, 0}}), "name"));
    CHECK(says(net.add_line("x", {{0, 0, 0}}), "\"x\" is too short"));
    CHECK(says(net.add_line("x", {{0, 0, 0}, {NAN, 0, 0}}), "finite"));
    CHECK(says(net.add_region("three", {"bottom", "nothing"}, nullptr), "\"nothing\", which does not exist"));
    CHECK(says(net.add_region("three", {"bottom", "middle", "top"}, nullptr), "not closed"));
    CHECK(says(net.add_region("three", {"bottom", "middle", "top", "left", "bottom2", "right", "top2"}, nullptr),
               "simple ring"));
    CHECK(says(net.add_region("one", {"bottom", "middle", "top", "left"}, nullptr), "no other has"));
    CHECK(says(net.set_alpha("one", -0.3), "alpha"));
    CHECK(says(net.set_alpha("nine", -0.1), "no region"));
    check_sound(net, 2);
}

TEST_CASE("every edit can be undone and done again", "[network]") {
    core::NetworkHistory history(two_squares());
    const auto edit = [&](const auto& change) {
        Network next = history.now();
        REQUIRE(change(next));
        history.push(std::move(next));
    };
    edit([](Network& n) { return n.cut("one", {{10, 10, 0}, {30, 10, 0}}, "a"); });
    edit([](Network& n) { return n.remove_region("two"); });
    check_sound(history.now(), 2);
    CHECK(history.undo());
    check_sound(history.now(), 3);
    CHECK(history.undo());
    check_sound(history.now(), 2);
    CHECK_FALSE(history.undo());
    CHECK(history.redo());
    check_sound(history.now(), 3);
    edit([](Network& n) { return n.remove_region("a"); });
    CHECK_FALSE(history.redo());
    check_sound(history.now(), 2);
}

TEST_CASE("mirrored halves are joined on the plane", "[cloth]") {
    Network net;
    REQUIRE(net.add_line("a", {{0.4, 0, 0}, {20, 0, 0}}));
    REQUIRE(net.add_line("b", {{20, 0, 0}, {20, 20, 0}}));
    REQUIRE(net.add_line("c", {{20, 20, 0}, {0.2, 20, 0}}));
    REQUIRE(net.add_line("d", {{0.2, 20, 0}, {0.4, 0, 0}}));
    REQUIRE(net.add_region("half", {"a", "b", "c", "d"}, nullptr));
    const core::Cloth half = core::build_cloth(net, 0).cloth, whole = core::mirrored_and_joined(half);
    CHECK(whole.pieces.size() == 2);
    CHECK(whole.pieces[1].name == "half_mirrored");
    CHECK(whole.mesh.quads.size() == 2 * half.mesh.quads.size());
    CHECK(whole.mesh.vertices.size() == 9 * 17);
    CHECK(area(whole.mesh) == Approx(800.0));
    CHECK(core::edges_of(whole).seams.size() == 8);
    CHECK(core::edges_of(whole).hems.size() == 48);
}
