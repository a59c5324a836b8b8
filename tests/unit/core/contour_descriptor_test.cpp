#include "core/contour/contour_descriptor.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "core/geometry/polygon.hpp"
#include "core/silhouette/contour.hpp"
#include "support/random_contour.hpp"
#include "support/shapes.hpp"

using core::ContourDescriptor;
using core::Polygon;

namespace {

ContourDescriptor described(const Polygon& ring) {
    const core::Result<ContourDescriptor> d = core::describe_contour(ring);
    REQUIRE(d);
    return *d;
}

std::vector<Polygon> outlines() {
    std::vector<Polygon> all{support::horse(), support::hand(), support::star(5, 40, 17), support::l_shape(30, 9),
                             support::comb(6, 9)};
    for (Polygon& ring : all) ring = core::resample_ring(support::scaled(ring, 8), 300);
    for (Polygon& ring : all) {  // on a grid, as pixels are, so that moving them is exact
        for (core::Point& p : ring) p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2};
    }
    return all;
}

core::GrayImage picture_of_an_f(std::uint8_t ink, std::uint8_t paper) {
    core::GrayImage image(60, 80, paper);
    const auto fill = [&](int left, int top, int right, int bottom) {
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) image.at(x, y) = ink;
        }
    };
    fill(10, 8, 18, 70);
    fill(10, 8, 48, 17);
    fill(10, 34, 38, 43);
    return image;
}

void check_within_bounds(const ContourDescriptor& d) {
    for (std::size_t k = 0; k < core::kFrameChannels; ++k) {
        const int greatest = k < core::kFrameStretches ? core::kGreatestHeight : core::kGreatestAhead;
        for (const std::int8_t value : d.frames[k]) CHECK(std::abs(value) <= greatest);
    }
    CHECK(d.complexity >= 0.0F);
    CHECK(d.complexity <= 1.0F);
}

}  // namespace

TEST_CASE("another first point changes nothing", "[contour_descriptor]") {
    for (const Polygon& ring : outlines()) {
        const ContourDescriptor d = described(ring);
        for (const int first : {1, 50, 299}) CHECK(described(support::started_at(ring, first)) == d);
    }
}

TEST_CASE("moving by whole units changes nothing", "[contour_descriptor]") {
    for (const Polygon& ring : outlines()) {
        CHECK(described(support::moved(ring, {37, -12})) == described(ring));
        CHECK(described(support::moved(ring, {-5000, 4096})) == described(ring));
    }
}

TEST_CASE("black on white is white on black", "[contour_descriptor]") {
    const auto of = [](const core::GrayImage& image) {
        return described(*core::largest_contour(core::object_mask(image)));
    };
    CHECK(of(picture_of_an_f(0, 255)) == of(picture_of_an_f(255, 0)));
}

TEST_CASE("a mirrored outline has the mirrored descriptor to the last bit", "[contour_descriptor]") {
    for (const Polygon& ring : outlines()) {
        CHECK(described(support::mirrored(ring)) == core::mirrored(described(ring)));
    }
    std::mt19937_64 random(5);
    for (int i = 0; i < 50; ++i) {
        const ContourDescriptor d = support::random_contour(random);
        CHECK(core::mirrored(core::mirrored(d)) == d);
        CHECK(core::mirrored(d) != d);
    }
}

TEST_CASE("a disc is plain and a horse is not", "[contour_descriptor]") {
    CHECK(described(support::disc(200, 50)).complexity < 0.05F);
    CHECK(described(outlines().front()).complexity > 0.25F);
}

TEST_CASE("a disc covers its own rings and nothing beyond", "[contour_descriptor]") {
    const ContourDescriptor disc = described(support::disc(400, 50));
    for (std::size_t k = 0; k < core::kPolarRings; ++k) {
        const double edge = static_cast<double>(core::kPolarRings) / 2.5;  // in ring widths: a disc has a radius of 1
        const double covered = std::clamp(edge - static_cast<double>(k), 0.0, 1.0);
        const double whole = 255.0 * (2.0 * static_cast<double>(k) + 1) / (2.0 * core::kPolarRings - 1);
        for (const std::uint8_t cell : disc.cover[k]) CHECK(std::abs(cell - covered * whole) <= 1.0 + 0.02 * whole);
    }
}

TEST_CASE("what has no inside has no descriptor", "[contour_descriptor]") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    Polygon clockwise = support::hand();
    std::reverse(clockwise.begin(), clockwise.end());
    const std::vector<Polygon> nothing{{},
                                       {{1, 1}},
                                       {{1, 1}, {2, 3}},
                                       {{0, 0}, {1, 0}, {2, 0}},
                                       {{3, 3}, {3, 3}, {3, 3}, {3, 3}},
                                       {{0, 0}, {nan, 0}, {0, 1}},
                                       {{0, 0}, {inf, 0}, {0, 1}},
                                       clockwise};
    for (const Polygon& ring : nothing) {
        const core::Result<ContourDescriptor> d = core::describe_contour(ring);
        REQUIRE_FALSE(d);
        CHECK(d.error().code == core::ErrorCode::BadOutline);
    }
}

TEST_CASE("odd outlines have a descriptor within its bounds, or none", "[contour_descriptor]") {
    std::vector<Polygon> odd{
        support::rectangle(1, 1),
        support::rectangle(1e5, 0.5),
        support::rectangle(1e-170, 1e-170),
        support::scaled(support::hand(), 1e150),
        support::scaled(support::hand(), 1e-150),
        support::comb(200, 30),
        {{0, 0}, {4, 0}, {0, 3}},
        {{0, 0}, {0, 0}, {4, 0}, {4, 0}, {0, 3}, {0, 3}},
        {{0, 0}, {10, 10}, {10, 0}, {0, 9}},  // a bow tie with one side larger
    };
    std::mt19937_64 random(77);
    for (int i = 0; i < 150; ++i) {
        Polygon ring;
        const int corners = support::random_in(random, 3, 40);
        for (int k = 0; k < corners; ++k) {
            ring.push_back({support::random_in(random, 0, 12) * 1.0, support::random_in(random, 0, 12) * 1.0});
        }
        odd.push_back(ring);
    }
    int sound = 0;
    for (const Polygon& ring : odd) {
        const core::Result<ContourDescriptor> d = core::describe_contour(ring);
        if (!d) continue;
        ++sound;
        check_within_bounds(*d);
    }
    CHECK(sound > 50);
}
