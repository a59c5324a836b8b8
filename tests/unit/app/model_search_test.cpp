#include "firmware_like_app/collection/model_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/shapes.hpp"

using app::CollectionModel;
using app::ModelSearch;
using app::RankBy;
using app::RankedModel;

namespace {

/// Stars of three to seven uneven tips; twice the same number is twice the same shape.
core::ComparableShape star(unsigned number) {
    std::mt19937 random(number);
    core::Polygon ring = support::star(3 + static_cast<int>(number % 5), 30, 12);
    for (core::Point& p : ring) p = p * (0.7 + 0.6 * static_cast<double>(random() % 1000) / 1000.0);
    const auto readings = core::read_outline(ring);
    REQUIRE(readings);
    return core::comparable(*readings);
}

/// Some of the models are equal, so that there are ties.
std::vector<CollectionModel> collection(unsigned count) {
    std::vector<CollectionModel> models(count);
    for (unsigned i = 0; i < count; ++i) models[i].views = {star(i % 17), star(100 + i % 13)};
    return models;
}

bool same(const std::vector<RankedModel>& a, const std::vector<RankedModel>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const RankedModel& p, const RankedModel& q) {
        return p.model == q.model && p.view == q.view && p.distance == q.distance && p.reading == q.reading;
    });
}

std::vector<RankedModel> first_of(std::vector<RankedModel> ranked, std::size_t count) {
    ranked.resize(std::min(count, ranked.size()));
    return ranked;
}

}  // namespace

TEST_CASE("the nearest models are the first of all ranked ones, whatever the number of threads", "[search]") {
    const std::vector<CollectionModel> models = collection(40);
    for (const unsigned number : {3U, 200U, 201U, 202U}) {
        const std::vector<core::ComparableShape> drawn{star(number)};
        const std::vector<RankedModel> all = app::rank_models(models, {.readings = drawn}, RankBy::Fused);
        REQUIRE(all.size() == models.size());
        for (const std::size_t count : {0U, 1U, 5U, 10U, 39U, 40U, 60U}) {
            for (const int jobs : {1, 2, 5}) {
                const ModelSearch search{.readings = drawn, .jobs = jobs};
                CHECK(same(app::nearest_models(models, search, count), first_of(all, count)));
                CHECK(same(app::rank_models(models, search, RankBy::Fused), all));
            }
        }
    }
}

TEST_CASE("ranked both ways at once, models lie as far as ranked one way after the other", "[search]") {
    const std::vector<CollectionModel> models = collection(40);
    const auto equal = [](const std::vector<RankedModel>& a, const std::vector<RankedModel>& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const RankedModel& p, const RankedModel& q) {
            return p.model == q.model && p.distance == q.distance;
        });
    };
    for (const unsigned number : {3U, 200U, 201U}) {
        const std::vector<core::ComparableShape> drawn{star(number), star(number + 50)};
        for (const int jobs : {1, 3}) {
            const ModelSearch search{.readings = drawn, .except = 5, .jobs = jobs};
            const app::BothRankings both = app::rank_models_both_ways(models, search);
            REQUIRE(both.fused.size() == models.size() - 1);
            CHECK(equal(both.by_parts, app::rank_models(models, search, RankBy::Parts)));
            CHECK(equal(both.fused, app::rank_models(models, search, RankBy::Fused)));
        }
    }
}

TEST_CASE("models that are thought to be near change no answer, right or wrong", "[search]") {
    const std::vector<CollectionModel> models = collection(40);
    const std::vector<core::ComparableShape> drawn{star(200)};
    const std::vector<RankedModel> all = app::rank_models(models, {.readings = drawn}, RankBy::Fused);
    const std::vector<std::size_t> nearest{all[0].model, all[1].model, all[2].model, all[3].model, all[4].model};
    const std::vector<std::size_t> farthest{all[39].model, all[38].model, all[37].model, all[36].model, all[35].model};
    const std::vector<std::size_t> nonsense{7, 7, 4000, 7, 7};
    for (const std::vector<std::size_t>& likely : {nearest, farthest, nonsense}) {
        for (const std::size_t count : {1U, 5U, 12U}) {
            const ModelSearch search{.readings = drawn, .likely = likely, .jobs = 2};
            CHECK(same(app::nearest_models(models, search, count), first_of(all, count)));
        }
    }
    const ModelSearch without{.readings = drawn, .except = nearest[0], .likely = nearest};
    for (const RankedModel& r : app::nearest_models(models, without, 5)) CHECK(r.model != nearest[0]);
}

TEST_CASE("of several readings the best counts, and is named", "[search]") {
    const std::vector<CollectionModel> models = collection(20);
    const std::vector<core::ComparableShape> drawn{star(300), star(7), star(301)};
    std::vector<double> least(models.size(), std::numeric_limits<double>::infinity());
    for (const core::ComparableShape& reading : drawn) {
        for (const RankedModel& r : app::rank_models(models, {.readings = {&reading, 1}}, RankBy::Fused)) {
            least[r.model] = std::min(least[r.model], r.distance);
        }
    }
    const ModelSearch search{.readings = drawn, .jobs = 2};
    const std::vector<RankedModel> all = app::rank_models(models, search, RankBy::Fused);
    for (const RankedModel& r : all) CHECK(r.distance == least[r.model]);
    CHECK(all.front().model == 7);
    CHECK(all.front().reading == 1);
    CHECK(same(app::nearest_models(models, search, 6), first_of(all, 6)));
}

TEST_CASE("a model that is passed over is in no ranking", "[search]") {
    const std::vector<CollectionModel> models = collection(20);
    const ModelSearch search{.readings = models[3].views, .except = 3};
    for (const RankBy by : {RankBy::Parts, RankBy::Fused}) {
        const std::vector<RankedModel> all = app::rank_models(models, search, by);
        CHECK(all.size() == models.size() - 1);
        for (const RankedModel& r : all) CHECK(r.model != 3);
    }
    const std::vector<RankedModel> nearest = app::nearest_models(models, search, 8);
    CHECK(same(nearest, first_of(app::rank_models(models, search, RankBy::Fused), 8)));
}

TEST_CASE("an empty collection has no nearest models", "[search]") {
    const core::ComparableShape drawn = star(1);
    CHECK(app::nearest_models({}, {.readings = {&drawn, 1}, .jobs = 2}, 10).empty());
    CHECK(app::rank_models({}, {.readings = {&drawn, 1}}, RankBy::Fused).empty());
}

TEST_CASE("a search that is stopped ends", "[search]") {
    const std::vector<CollectionModel> models = collection(20);
    const core::ComparableShape drawn = star(1);
    std::stop_source stop;
    stop.request_stop();
    CHECK(app::nearest_models(models, {.readings = {&drawn, 1}, .stop = stop.get_token()}, 5).empty());
}
