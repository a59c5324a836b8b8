#include "core/geometry/turn.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <random>

using core::Vec3;

namespace {

constexpr double kPi = std::numbers::pi;

bool close(Vec3 a, Vec3 b) {
    return core::length(a - b) < 1e-9;
}

bool same_turn(Vec3 a, Vec3 b) {
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        if (!close(core::turned(axis, a), core::turned(axis, b))) return false;
    return true;
}

}  // namespace

TEST_CASE("a turn goes about x, then y, then z", "[turn]") {
    CHECK(close(core::turned({0, 1, 0}, {kPi / 2, 0, 0}), {0, 0, 1}));
    CHECK(close(core::turned({0, 0, 1}, {0, kPi / 2, 0}), {1, 0, 0}));
    CHECK(close(core::turned({1, 0, 0}, {0, 0, kPi / 2}), {0, 1, 0}));
    CHECK(close(core::turned({0, 1, 0}, {kPi / 2, kPi / 2, 0}), {1, 0, 0}));
}

TEST_CASE("a turn is found again from where it takes the axes", "[turn]") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(-kPi, kPi);
    for (int k = 0; k < 200; ++k) {
        Vec3 turn{angle(random), angle(random), angle(random)};
        if (k % 5 == 0) turn.y = kPi / 2;
        if (k % 5 == 1) turn.y = -kPi / 2;
        const Vec3 found = core::turn_of_axes(core::turned({1, 0, 0}, turn), core::turned({0, 1, 0}, turn),
                                              core::turned({0, 0, 1}, turn));
        CHECK(same_turn(found, turn));
    }
}

TEST_CASE("turning further is turning twice", "[turn]") {
    const Vec3 turn{0.3, -0.8, 1.1};
    const Vec3 more = core::turned_further(turn, {0, 0, 1}, 0.5);
    CHECK(same_turn(more, {0.3, -0.8, 1.6}));
    const Vec3 tipped = core::turned_further(turn, {1, 0, 0}, kPi / 2);
    CHECK(close(core::turned({0, 1, 0}, tipped), core::turned(core::turned({0, 1, 0}, turn), {kPi / 2, 0, 0})));
    CHECK(same_turn(core::turned_further(tipped, {1, 0, 0}, -kPi / 2), turn));
}
