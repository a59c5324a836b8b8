#include "core/mannequin/loft.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using core::Loft;
using core::Vec3;

namespace {

const core::LoftFrame kUpright{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};

Loft cylinder() {
    return {kUpright, {{0, 3, 3, 3, 0, 0}, {10, 3, 3, 3, 0, 0}, {20, 3, 3, 3, 0, 0}}, Loft::Shape::Ellipse};
}

}  // namespace

TEST_CASE("distances to a cylinder with flat ends", "[loft]") {
    const Loft loft = cylinder();
    CHECK(loft.sample({5, 10, 0}).distance == Approx(2.0));
    CHECK(loft.sample({0, 10, -1}).distance == Approx(-2.0));
    CHECK(loft.sample({0, 10, 0}).distance == Approx(-3.0));
    CHECK(loft.sample({0, 24, 0}).distance == Approx(4.0));
    CHECK(loft.sample({0, 19.5, 0}).distance == Approx(-0.5));
    CHECK(loft.sample({6, 24, 0}).distance == Approx(5.0));
    CHECK(loft.sample({0, -2, 0}).gradient.y == Approx(-1.0));
}

TEST_CASE("gradients have length 1 and lead out", "[loft]") {
    const Loft cone(kUpright, {{0, 6, 6, 5, 0, 0}, {10, 4, 4, 3, 1, 0}, {20, 2, 2, 2, 1, 0.5}}, Loft::Shape::Boxy);
    for (int k = 0; k < 40; ++k) {
        const Vec3 p{8 * std::cos(k * 0.7), 2.0 + 0.4 * k, 8 * std::sin(k * 0.7)};
        const core::FieldSample s = cone.sample(p);
        CHECK(core::length(s.gradient) == Approx(1.0));
        CHECK(s.distance > 0.0);
        const double step = 0.3;
        CHECK(cone.sample(p - s.gradient * step).distance == Approx(s.distance - step).margin(0.08));
    }
}

TEST_CASE("sections are met where they are put, without overshoot", "[loft]") {
    const Loft loft(kUpright, {{0, 5, 5, 5, 0, 0}, {10, 5, 5, 5, 0, 0}, {20, 3, 3, 3, 0, 0}, {30, 3, 3, 3, 0, 0}},
                    Loft::Shape::Ellipse);
    for (double y = 0.0; y <= 30.0; y += 0.5) {
        CHECK(loft.at(y).side <= 5.0 + 1e-9);
        CHECK(loft.at(y).side >= 3.0 - 1e-9);
    }
    CHECK(loft.at(5).side == Approx(5.0));
    CHECK(loft.at(15).side == Approx(4.0).margin(0.05));
    CHECK(loft.middle(15).y == Approx(15.0));
}
