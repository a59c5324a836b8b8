#include "firmware_like_app/collection/likeness_lists.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "core/contour/contour_match.hpp"
#include "tests/support/random_contour.hpp"
#include "tests/support/temporary_folder.hpp"

using db::NeighbourList;
using db::TwoViewIndex;
using support::TemporaryFolder;

namespace {

/// Models with contours made up and nothing else; the same number gives the same model.
db::ModelRecord model(int number, int variant = 0) {
    std::mt19937_64 random(static_cast<std::uint64_t>(number + 1000 * variant));
    db::ModelRecord out;
    out.source_path = "m" + std::to_string(number) + ".off";
    out.name = out.source_path;
    for (db::ModelView& view : out.views) {
        view.camera = {{0, 0, 1}, {0, 1, 0}};
        view.contour = support::random_contour(random, 0.2);
    }
    out.display_mesh.vertices = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}};
    out.display_mesh.triangles = {{0, 1, 2}};
    return out;
}

TwoViewIndex open(const TemporaryFolder& folder, const std::string& name) {
    auto index = TwoViewIndex::open(folder.path(name), db::OpenMode::Create, {.parameters = "p"});
    if (!index) FAIL(index.error().sentence());
    return std::move(*index);
}

void add(TwoViewIndex& index, int from, int to) {
    for (int n = from; n < to; ++n) {
        const auto added = index.add(model(n));
        if (!added) FAIL(added.error().sentence());
    }
}

int update(TwoViewIndex& index, int jobs = 1) {
    const auto report = app::update_likeness(index, jobs, {});
    if (!report) FAIL(report.error().sentence());
    return report->measured;
}

std::vector<NeighbourList> lists(const TwoViewIndex& index) {
    auto stored = index.neighbour_lists();
    REQUIRE(stored);
    return std::move(*stored);
}

/// All distances, nothing spared.
std::vector<NeighbourList> exhaustive(const TwoViewIndex& index) {
    const auto loaded = index.load_views();
    REQUIRE(loaded);
    core::ContourMatcher matcher;
    std::vector<NeighbourList> out;
    for (const db::ModelRecord& a : loaded->models) {
        out.push_back({a.id, {}});
        for (const db::ModelRecord& b : loaded->models) {
            if (a.id == b.id) continue;
            double least = 1e9;
            for (const db::ModelView& v : a.views) {
                for (const db::ModelView& w : b.views) {
                    least = std::min(least, matcher.distance(core::matchable(v.contour), core::matchable(w.contour)));
                }
            }
            out.back().nearest.push_back({b.id, static_cast<float>(least)});
        }
        auto& nearest = out.back().nearest;
        std::sort(nearest.begin(), nearest.end(), [](const auto& p, const auto& q) {
            return p.distance != q.distance ? p.distance < q.distance : p.id < q.id;
        });
        nearest.resize(std::min(nearest.size(), core::kNearestCount));
    }
    return out;
}

}  // namespace

TEST_CASE("the nearest others of every model are found, whatever the number of threads", "[likeness]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder, "a.db"), other = open(folder, "b.db");
    add(index, 0, 45);
    add(other, 0, 45);
    CHECK(update(index) == 45);
    CHECK(lists(index) == exhaustive(index));
    CHECK(update(index) == 0);
    CHECK(update(other, 3) == 45);
    CHECK(lists(other) == lists(index));
    CHECK(index.check()->empty());
}

TEST_CASE("added, changed and removed models change the lists as measuring all again would", "[likeness]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder, "a.db");
    add(index, 0, 8);
    CHECK(update(index) == 8);
    add(index, 8, 24);
    CHECK(update(index) == 24);  // eight lists of seven were short
    CHECK(lists(index) == exhaustive(index));
    add(index, 24, 27);
    CHECK(update(index, 2) == 3);
    CHECK(lists(index) == exhaustive(index));
    REQUIRE(index.add(model(5, 1)));
    REQUIRE(index.remove(11));
    CHECK(update(index) > 1);
    CHECK(lists(index) == exhaustive(index));
    CHECK(update(index) == 0);
}

TEST_CASE("lists measured in memory are those that an index would store", "[likeness]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder, "a.db");
    add(index, 0, 40);
    CHECK(update(index) == 40);
    const auto loaded = index.load_views();
    REQUIRE(loaded);
    std::vector<app::CollectionModel> models;
    std::vector<std::int64_t> ids;
    for (const db::ModelRecord& record : loaded->models) {
        ids.push_back(record.id);
        models.push_back({record, {}});
        for (std::size_t v = 0; v < 2; ++v) {
            models.back().views[v].contour = core::matchable(record.views[v].contour);
        }
    }
    std::size_t done = 0;
    const core::NearestLists measured =
        app::measured_likeness(models, 2, [&](std::size_t models_done, std::size_t) { done = models_done; });
    CHECK(measured == app::lists_by_place(lists(index), ids));
    CHECK(done == 40);
    CHECK(app::measured_likeness({}, 2).empty());
    CHECK(app::measured_likeness(std::span(models).first(1), 1) == core::NearestLists(1));
}

TEST_CASE("stopped at any moment, measuring goes on to the same lists", "[likeness]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder, "a.db");
    add(index, 0, 40);
    for (int round = 0; round < 3; ++round) {
        std::stop_source stop;
        const auto report = app::update_likeness(index, 2, stop.get_token(), [&](std::size_t done, std::size_t total) {
            CHECK(done <= total);
            stop.request_stop();
        });
        REQUIRE(report);
        CHECK(report->measured <= 32);
        CHECK(index.check()->empty());
    }
    CHECK(update(index) == 0);
    CHECK(lists(index) == exhaustive(index));
}

TEST_CASE("one model has no others", "[likeness]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder, "a.db");
    CHECK(update(index) == 0);
    add(index, 0, 1);
    CHECK(update(index) == 0);
    CHECK(lists(index).empty());
}

TEST_CASE("lists of another distance are measured again", "[likeness]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder, "a.db");
    add(index, 0, 12);
    REQUIRE(index.keep_likeness("of old"));
    REQUIRE(index.store_neighbours(std::vector<NeighbourList>{{1, {{2, 5.0F}}}}));
    CHECK(update(index) == 12);
    CHECK(lists(index) == exhaustive(index));
}

TEST_CASE("stored lists are read by place, without models that are not there", "[likeness]") {
    const std::vector<NeighbourList> stored{{4, {{9, 0.1F}, {7, 0.2F}}}, {5, {{4, 0.3F}}}, {9, {{4, 0.1F}}}};
    const core::NearestLists lists = app::lists_by_place(stored, {4, 8, 9});
    REQUIRE(lists.size() == 3);
    CHECK(lists[0] == std::vector<core::Neighbour>{{2, 0.1F}});
    CHECK(lists[1].empty());
    CHECK(lists[2] == std::vector<core::Neighbour>{{0, 0.1F}});
}
