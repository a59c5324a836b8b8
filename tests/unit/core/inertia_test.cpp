#include "core/skeleton/inertia.hpp"

#include <catch2/catch.hpp>

#include "core/geometry/polygon.hpp"
#include "support/shapes.hpp"

using core::axis_of_least_inertia;
using core::InertiaAxis;
using core::Point;

TEST_CASE("the axis of a bar runs along it, through its middle", "[inertia]") {
    for (const double angle : {0.0, 0.3, 1.2, 2.9}) {
        const InertiaAxis axis = axis_of_least_inertia(support::turned(support::rectangle(9, 2), angle));
        const Point along{std::cos(angle), std::sin(angle)};
        CHECK(std::abs(dot(axis.direction, along)) == Approx(1.0));
        CHECK(distance(axis.centre, support::turned({{4.5, 1}}, angle)[0]) == Approx(0.0).margin(1e-12));
    }
}

TEST_CASE("it is the area that counts, not how densely the outline is sampled", "[inertia]") {
    const InertiaAxis axis = axis_of_least_inertia({{0, 0}, {9, 0}, {9, 0.5}, {9, 1}, {9, 1.5}, {9, 2}, {0, 2}});
    CHECK(axis.centre.x == Approx(4.5));
    CHECK(std::abs(axis.direction.x) == Approx(1.0));
}

TEST_CASE("where the axis is undefined it is the x axis", "[inertia]") {
    for (const core::Polygon& ring : {support::disc(100, 5), support::rectangle(3, 3), support::cross(5, 2)}) {
        CHECK(axis_of_least_inertia(ring).direction == Point{1, 0});
    }
    CHECK(axis_of_least_inertia({{0, 0}, {1, 1}, {2, 2}}).direction == Point{1, 0});
    CHECK(axis_of_least_inertia({}).direction == Point{1, 0});
}

TEST_CASE("stretching lengthens along the axis only, about the centre", "[inertia]") {
    const core::Polygon bar = support::turned(support::rectangle(8, 2), 0.7);
    const InertiaAxis axis = axis_of_least_inertia(bar);
    const core::Polygon longer = core::stretched_along(bar, axis, 1.125);
    CHECK(distance(longer[0], longer[1]) == Approx(9.0));
    CHECK(distance(longer[1], longer[2]) == Approx(2.0));
    CHECK(distance(axis_of_least_inertia(longer).centre, axis.centre) == Approx(0.0).margin(1e-12));
    CHECK(distance(core::stretched_along(bar, axis, 1.0)[2], bar[2]) == Approx(0.0).margin(1e-12));
}
