#include "core/contour/contour_match.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "core/geometry/polygon.hpp"
#include "core/silhouette/contour.hpp"
#include "support/random_contour.hpp"
#include "support/shapes.hpp"

using core::ContourDescriptor;
using core::ContourMatcher;
using core::MatchableContour;
using core::Polygon;

namespace {

struct Named {
    const char* name;
    MatchableContour contour;
};

MatchableContour contour_of(const Polygon& ring) {
    const core::Result<ContourDescriptor> d = core::describe_contour(ring);
    REQUIRE(d);
    return core::matchable(*d);
}

/// A band round a growing circle.
Polygon spiral(double turns) {
    Polygon outer, inner;
    for (double t = 0.0; t <= turns * 6.28; t += 0.1) {
        const core::Point along{std::cos(t), std::sin(t)};
        outer.push_back(along * (3.0 + 1.6 * t));
        inner.push_back(along * (1.0 + 1.6 * t));
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return outer;
}

std::vector<Named> shapes() {
    core::BinaryImage line(90, 9);
    for (int x = 5; x < 80; ++x) line.at(x, 4) = 1;
    return {{"horse", contour_of(support::horse())},
            {"hand", contour_of(support::hand())},
            {"star", contour_of(support::star(5, 9, 4))},
            {"cross", contour_of(support::cross(8, 3))},
            {"disc", contour_of(support::disc(90, 7))},
            {"square", contour_of(support::rectangle(5, 5))},
            {"needle", contour_of(support::rectangle(400, 1))},
            {"one pixel wide", contour_of(*core::largest_contour(line))},
            {"comb", contour_of(support::comb(200, 30))},
            {"spiral", contour_of(spiral(5))}};
}

/// The header's definition with plain loops over every turn, and nothing cut short.
class PlainMatch {
  public:
    static double distance(const MatchableContour& a, const MatchableContour& b) {
        const MatchableContour turned = core::matchable(core::mirrored(b.descriptor));
        const double complexity = static_cast<double>(a.descriptor.complexity) + b.descriptor.complexity;
        const double alignment = std::min(align(a, b), align(a, turned));
        const double cover = std::min(cover_difference(a, b), cover_difference(a, turned));
        return 5.34 * alignment / (80.0 * 16 * core::kGreatestHeight) / (0.5 + complexity) +
               2.67 * cover / (255.0 * core::kPolarRings * core::kPolarSectors);
    }

  private:
    static constexpr int kN = static_cast<int>(core::kFramePoints);
    static constexpr int kLeftOut = 85, kStray = 7;

    static int gap(const MatchableContour& a, int i, const MatchableContour& b, int j) {
        int sum = 0;
        for (std::size_t k = 0; k < core::kFrameChannels; ++k) {
            const auto x = static_cast<std::size_t>(i), y = static_cast<std::size_t>(j);
            sum += std::max({0, a.low[k][x] - b.high[k][y], b.low[k][y] - a.high[k][x]});
        }
        return sum;
    }

    static double align(const MatchableContour& a, const MatchableContour& b) {
        std::vector<int> gaps(kN * kN);
        for (int i = 0; i < kN; ++i) {
            for (int j = 0; j < kN; ++j) gaps[static_cast<std::size_t>(i * kN + j)] = gap(a, i, b, j);
        }
        int least = 1 << 30;
        for (int turn = 0; turn < kN; ++turn) least = std::min(least, align_turned(gaps, turn));
        return least;
    }

    /// cost(i, j): of the first i points of A and the first j of B from `turn` on.
    static int align_turned(const std::vector<int>& gaps, int turn) {
        std::vector<std::vector<int>> cost(kN + 1, std::vector<int>(kN + kStray + 1, 1 << 29));
        for (int i = 0; i <= kN; ++i) {
            for (int j = std::max(0, i - kStray); j <= std::min(kN + kStray, i + kStray); ++j) {
                int& c = cost[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
                if (i == 0 && j == 0) c = 0;
                const auto before = [&](int di, int dj) {
                    return cost[static_cast<std::size_t>(i - di)][static_cast<std::size_t>(j - dj)];
                };
                if (i > 0) c = std::min(c, before(1, 0) + kLeftOut);
                if (j > 0) c = std::min(c, before(0, 1) + kLeftOut);
                if (i > 0 && j > 0) {
                    c = std::min(c, before(1, 1) + gaps[static_cast<std::size_t>((i - 1) * kN + (j - 1 + turn) % kN)]);
                }
            }
        }
        return cost[kN][kN];
    }

    static double cover_difference(const MatchableContour& a, const MatchableContour& b) {
        int least = 1 << 30;
        for (std::size_t turn = 0; turn < core::kPolarSectors; ++turn) {
            int sum = 0;
            for (std::size_t r = 0; r < core::kPolarRings; ++r) {
                for (std::size_t s = 0; s < core::kPolarSectors; ++s) {
                    sum += std::abs(a.descriptor.cover[r][s] - b.descriptor.cover[r][(s + turn) % core::kPolarSectors]);
                }
            }
            least = std::min(least, sum);
        }
        return least;
    }
};

}  // namespace

TEST_CASE("the distance is what its definition says", "[contour_match]") {
    ContourMatcher matcher;
    const std::vector<Named> all = shapes();
    for (std::size_t i = 0; i < all.size(); i += 4) {
        for (std::size_t j = 1; j < all.size(); j += 5) {
            INFO(all[i].name << " and " << all[j].name);
            // The band lies about the point of A where the rings are cut, and which is A is for the matcher to say.
            const double one = PlainMatch::distance(all[i].contour, all[j].contour);
            const double other = PlainMatch::distance(all[j].contour, all[i].contour);
            const double d = matcher.distance(all[i].contour, all[j].contour);
            CHECK((d == Approx(one).epsilon(1e-12) || d == Approx(other).epsilon(1e-12)));
        }
    }
    std::mt19937_64 random(21);
    for (int round = 0; round < 2; ++round) {
        const MatchableContour a = core::matchable(support::random_contour(random, 0.1));
        const MatchableContour b = core::matchable(support::random_contour(random, 0.1));
        const double one = PlainMatch::distance(a, b), other = PlainMatch::distance(b, a), d = matcher.distance(a, b);
        CHECK((d == Approx(one).epsilon(1e-12) || d == Approx(other).epsilon(1e-12)));
    }
}

TEST_CASE("a contour is at no distance from itself and from its mirror image", "[contour_match]") {
    ContourMatcher matcher;
    for (const Named& shape : shapes()) {
        INFO(shape.name);
        CHECK(matcher.distance(shape.contour, shape.contour) == 0.0);
        CHECK(matcher.distance(shape.contour, core::matchable(core::mirrored(shape.contour.descriptor))) == 0.0);
    }
}

TEST_CASE("the distance is symmetric, and the mirror image has it too, to the last bit", "[contour_match]") {
    ContourMatcher matcher;
    std::mt19937_64 random(22);
    std::vector<Named> all = shapes();
    for (int i = 0; i < 3; ++i) all.push_back({"random", core::matchable(support::random_contour(random, 0.3))});
    for (const Named& a : all) {
        const MatchableContour turned = core::matchable(core::mirrored(a.contour.descriptor));
        for (const Named& b : all) {
            INFO(a.name << " and " << b.name);
            const double d = matcher.distance(a.contour, b.contour);
            CHECK(matcher.distance(b.contour, a.contour) == d);
            CHECK(matcher.distance(turned, b.contour) == d);
            CHECK(matcher.distance(b.contour, turned) == d);
            CHECK(core::lower_bound(a.contour, b.contour) == core::lower_bound(b.contour, a.contour));
        }
    }
}

TEST_CASE("every two shapes have a finite distance, 0 for the same alone", "[contour_match]") {
    ContourMatcher matcher;
    const std::vector<Named> all = shapes();
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < all.size(); ++j) {
            INFO(all[i].name << " and " << all[j].name);
            const double d = matcher.distance(all[i].contour, all[j].contour);
            CHECK(std::isfinite(d));
            CHECK(d <= 6.4);
            if (i == j) continue;
            CHECK(d > 0.0);
        }
    }
}

TEST_CASE("a turned, scaled or differently sampled shape is much nearer than another", "[contour_match]") {
    ContourMatcher matcher;
    const MatchableContour horse = contour_of(support::horse()), hand = contour_of(support::hand());
    const double apart = matcher.distance(horse, hand);
    for (const double angle : {0.3, 1.0, 2.2, 3.14, 5.0}) {
        CHECK(matcher.distance(horse, contour_of(support::turned(support::horse(), angle))) < 0.02 * apart);
    }
    for (const double factor : {0.01, 0.5, 3.0, 1000.0}) {
        CHECK(matcher.distance(horse, contour_of(support::scaled(support::horse(), factor))) < 0.02 * apart);
    }
    CHECK(matcher.distance(horse, contour_of(core::resample_ring(support::horse(), 500))) < 0.05 * apart);
}

TEST_CASE("the lower bound is never above the distance, and tells something", "[contour_match][bound]") {
    ContourMatcher matcher;
    std::mt19937_64 random(23);
    std::vector<Named> all = shapes();
    for (int i = 0; i < 12; ++i) {
        all.push_back({"random", core::matchable(support::random_contour(random, i % 2 == 0 ? 1.0 : 0.05))});
    }
    double share = 0.0;
    for (const Named& a : all) {
        for (const Named& b : all) {
            INFO(a.name << " and " << b.name);
            const double bound = core::lower_bound(a.contour, b.contour), d = matcher.distance(a.contour, b.contour);
            CHECK(bound >= 0.0);
            CHECK(bound <= d);
            if (d > 0.0) share += bound / d / static_cast<double>(all.size() * all.size());
        }
    }
    CHECK(share > 0.05);
}

TEST_CASE("giving up never turns a farther shape into a nearer one", "[contour_match]") {
    ContourMatcher matcher;
    std::mt19937_64 random(24);
    std::vector<Named> all = shapes();
    for (int i = 0; i < 2; ++i) all.push_back({"random", core::matchable(support::random_contour(random, 0.2))});
    for (const Named& a : all) {
        for (const Named& b : all) {
            INFO(a.name << " and " << b.name);
            const double d = matcher.distance(a.contour, b.contour);
            for (const double share : {0.0, 0.1, 0.4, 0.8, 0.999, 1.0}) {
                CHECK(matcher.distance(a.contour, b.contour, share * d) >= share * d);
            }
            CHECK(matcher.distance(a.contour, b.contour, 1.001 * d + 1e-9) == d);
        }
    }
}

TEST_CASE("a contour matcher keeps nothing of one pair that shows in the next", "[contour_match]") {
    ContourMatcher used, fresh;
    const std::vector<Named> all = shapes();
    (void)used.distance(all[0].contour, all[1].contour);
    (void)used.distance(all[2].contour, all[0].contour, 0.01);
    CHECK(used.distance(all[3].contour, all[1].contour) == fresh.distance(all[3].contour, all[1].contour));
}

TEST_CASE("giving up early never changes a distance that is good enough", "[contour_match]") {
    ContourMatcher matcher;
    const std::vector<Named> all = shapes();
    for (const Named& a : all) {
        for (const Named& b : all) {
            INFO(a.name << " and " << b.name);
            const double d = matcher.distance(a.contour, b.contour);
            for (const double share : {0.01, 0.3, 0.7, 0.9, 0.99, 1.0}) {
                CHECK(matcher.distance(a.contour, b.contour, share * d) >= share * d);
                CHECK(matcher.distance(a.contour, b.contour, share * d) <= d);
            }
            const double just_above = std::nextafter(d, 10.0);
            for (const double limit : {just_above, 1.01 * d + 1e-9, 2.0 * d + 1e-9}) {
                CHECK(matcher.distance(a.contour, b.contour, limit) == d);
            }
        }
    }
}
