#include "core/garment/fill_topology.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>
#include <vector>

#include "core/garment/fill_plan.hpp"

using core::ErrorCode;
using core::fill_topology;

namespace {

int irregular(const std::vector<int>& sides) {
    return fill_topology(sides)->counts.irregular();
}

/// Calls `use` for `count` even inputs of n sides up to `longest`.
template <typename Use>
void for_random_sides(int n, int longest, int count, const Use& use) {
    std::mt19937 generator(static_cast<unsigned>(100 * n + longest));
    for (int k = 0; k < count;) {
        std::vector<int> sides;
        for (int i = 0; i < n; ++i) sides.push_back(1 + static_cast<int>(generator() % static_cast<unsigned>(longest)));
        const int total = std::accumulate(sides.begin(), sides.end(), 0);
        if (total % 2 != 0 || total < 4) continue;
        use(sides);
        ++k;
    }
}

}  // namespace

TEST_CASE("regions that one star fills have one irregular vertex", "[fill_topology]") {
    const auto pentagon = fill_topology(std::array{6, 4, 3, 5, 4});
    REQUIRE(pentagon);
    CHECK(pentagon->boundary == 22);
    CHECK(pentagon->counts.irregular_interior == 1);
    CHECK(pentagon->counts.irregular_boundary == 0);
    CHECK(pentagon->counts.interior_by_valence[5] == 1);
    CHECK(irregular({6, 6, 6}) == 1);
    CHECK(irregular({7, 4, 3}) == 1);
}

TEST_CASE("a grid needs none; four other sides need two", "[fill_topology]") {
    const auto grid = fill_topology(std::array{5, 3, 5, 3});
    CHECK(grid->counts.irregular() == 0);
    CHECK(grid->quads.size() == 15);
    CHECK(grid->vertices == 24);
    CHECK(irregular({10, 14, 8, 12}) == 2);
    CHECK(irregular({10, 14, 10, 12}) == 2);
}

TEST_CASE("where the distances of a star are negative, two more do", "[fill_topology]") {
    CHECK(irregular({20, 6, 6}) == 3);
    CHECK(irregular({10, 2, 2}) == 3);
    CHECK(irregular({30, 4, 4, 4}) == 4);
    CHECK(irregular({9, 9, 2, 2, 2}) == 3);
}

TEST_CASE("the smallest regions: one quad with as many corners as there are", "[fill_topology]") {
    CHECK(fill_topology(std::array{1, 1, 1, 1})->quads.size() == 1);
    CHECK(fill_topology(std::array{2, 2})->quads.size() == 1);
    CHECK(fill_topology(std::array{1, 3})->quads.size() == 1);
    CHECK(fill_topology(std::array{1, 1, 2})->quads.size() == 1);
    CHECK(fill_topology(std::array{1, 1, 1, 1, 1, 1, 1, 1})->counts.irregular() <= 4);
}

TEST_CASE("every even input is filled; inner valences are 3 to 5, the boundary is the input", "[fill_topology]") {
    // build_fill has checked each result with count_quad_disc; here the promises are checked once more from outside
    for (int n = 2; n <= 8; ++n)
        for (const int longest : {3, 8, 40}) {
            int failed = 0, wrong = 0;
            for_random_sides(n, longest, 40, [&](const std::vector<int>& sides) {
                const auto topology = fill_topology(sides);
                if (!topology) {
                    ++failed;
                    return;
                }
                const auto total = static_cast<std::uint32_t>(std::accumulate(sides.begin(), sides.end(), 0));
                wrong += topology->boundary != total || topology->is_corner.size() != total;
                const auto counts = core::count_quad_disc(topology->quads, topology->vertices, topology->is_corner);
                wrong += !counts || counts->irregular() != topology->counts.irregular();
            });
            CAPTURE(n, longest);
            CHECK(failed == 0);
            CHECK(wrong == 0);
        }
}

TEST_CASE("rows of irregular vertices stay below those of pattern-based filling", "[fill_topology]") {
    struct Limit {
        int n, longest, most;
        double per_cent;  // of regions may have more than `most`
    };
    for (const Limit& limit : {Limit{3, 12, 1, 33.0}, Limit{3, 12, 3, 0.0}, Limit{4, 10, 2, 6.4}, Limit{4, 10, 4, 0.0},
                               Limit{5, 7, 1, 54.6}, Limit{5, 7, 3, 12.7}, Limit{6, 5, 2, 36.9}, Limit{6, 5, 4, 7.1}}) {
        int above = 0;
        constexpr int kCases = 400;
        for_random_sides(limit.n, limit.longest, kCases,
                         [&](const std::vector<int>& sides) { above += irregular(sides) > limit.most; });
        CAPTURE(limit.n, limit.longest, limit.most, above);
        CHECK(100.0 * above / kCases <= limit.per_cent + 6.0 * (limit.per_cent > 0.0));  // the share of a sample
    }
}

TEST_CASE("the same input gives the same quads", "[fill_topology]") {
    const auto first = fill_topology(std::array{11, 5, 9, 3, 8, 4}),
               second = fill_topology(std::array{11, 5, 9, 3, 8, 4});
    CHECK(first->quads == second->quads);
}

TEST_CASE("what cannot be filled is refused in one sentence", "[fill_topology]") {
    CHECK(fill_topology(std::array{3, 4, 4}).error().message.find("11 edges, an odd number") != std::string::npos);
    CHECK(fill_topology(std::array{3, 0, 5}).error().message.find("Side 2") != std::string::npos);
    CHECK(fill_topology(std::array{4}).error().code == ErrorCode::BadArgument);
    CHECK(fill_topology(std::array{1, 1}).error().code == ErrorCode::BadArgument);
    CHECK(fill_topology(std::vector<int>(9, 2)).error().code == ErrorCode::BadArgument);
    CHECK(fill_topology(std::array{4, 100000, 4}).error().code == ErrorCode::BadArgument);
}

TEST_CASE("a plan's cuts leave the sides that its last piece fills", "[fill_plan]") {
    for_random_sides(4, 20, 50, [](const std::vector<int>& counts) {
        core::SideCounts sides;
        for (const int count : counts) sides.push_back(count);
        for (const core::FillPlan& plan : core::fill_plans(sides, 2, core::FillSearch::Quick)) {
            core::SideCounts rest = sides;
            for (std::size_t i = 0; i + 1 < plan.steps.size(); ++i) {
                const int total = rest.total();
                rest = core::sides_after(rest, plan.steps[i]);
                if (plan.steps[i].kind == core::FillStep::Kind::CornerRectangle) CHECK(rest.total() == total);
            }
            REQUIRE(plan.steps.back().kind == core::FillStep::Kind::Star);
            const auto d = core::star_distances(rest);
            REQUIRE(d);
            for (int i = 0; i < rest.n; ++i) CHECK((*d)[i - 1] + (*d)[i + 1] == rest[i]);
        }
    });
}
