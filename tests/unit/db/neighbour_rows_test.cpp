// The neighbour lists of an index: stored, kept right when models go, and looked over by check.

#include <limits>

#include "db/migrations/migrations.hpp"
#include "db/stores/two_view_index.hpp"
#include "db_fixtures.hpp"

using db::NeighbourList;
using db::OpenMode;
using db::TwoViewIndex;
using fixture::TemporaryFolder;

namespace {

TwoViewIndex with_models(const TemporaryFolder& folder, int count) {
    TwoViewIndex index = fixture::value(TwoViewIndex::open(folder / "a.db", OpenMode::Create, {.parameters = "p"}));
    for (int n = 0; n < count; ++n) fixture::value(index.add(fixture::random_model(n)));
    return index;
}

/// Every model beside every other.
std::vector<NeighbourList> some_lists() {
    return {{1, {{2, 0.125F}, {3, 0.3F}}}, {2, {{1, 0.125F}, {3, 0.5F}}}, {3, {{1, 0.3F}, {2, 0.5F}}}};
}

}  // namespace

TEST_CASE("neighbour lists come back as they were stored, and are replaced one by one", "[neighbours]") {
    const TemporaryFolder folder;
    TwoViewIndex index = with_models(folder, 3);
    CHECK(fixture::value(index.neighbour_lists()).empty());
    fixture::ok(index.store_neighbours(some_lists()));
    CHECK(fixture::value(index.neighbour_lists()) == some_lists());
    std::vector<NeighbourList> changed = some_lists();
    changed[1].nearest = {{3, 0.01F}};
    fixture::ok(index.store_neighbours(std::span(changed).subspan(1, 1)));
    CHECK(fixture::value(index.neighbour_lists()) == changed);
    CHECK(fixture::value(index.check()).empty());
}

TEST_CASE("a model that is removed or described again leaves every list", "[neighbours]") {
    const TemporaryFolder folder;
    TwoViewIndex index = with_models(folder, 3);
    fixture::ok(index.store_neighbours(some_lists()));
    SECTION("removed") {
        fixture::ok(index.remove(2));
    }
    SECTION("described again") {
        fixture::value(index.add(fixture::random_model(1)));
    }
    CHECK(fixture::value(index.neighbour_lists()) == std::vector<NeighbourList>{{1, {{3, 0.3F}}}, {3, {{1, 0.3F}}}});
    CHECK(fixture::value(index.check()).empty());
}

TEST_CASE("another name or class leaves the lists as they are", "[neighbours]") {
    const TemporaryFolder folder;
    TwoViewIndex index = with_models(folder, 3);
    fixture::ok(index.store_neighbours(some_lists()));
    fixture::ok(index.relabel(2, "mare", "horse"));
    CHECK(fixture::value(index.neighbour_lists()) == some_lists());
}

TEST_CASE("lists name the distance they were measured by, and another one throws them away", "[neighbours]") {
    const TemporaryFolder folder;
    TwoViewIndex index = with_models(folder, 3);
    CHECK_FALSE(fixture::value(index.likeness_measure()));
    fixture::ok(index.keep_likeness("one"));
    fixture::ok(index.store_neighbours(some_lists()));
    fixture::ok(index.keep_likeness("one"));
    CHECK(fixture::value(index.likeness_measure()).value() == "one");
    CHECK(fixture::value(index.neighbour_lists()) == some_lists());
    fixture::ok(index.keep_likeness("other"));
    CHECK(fixture::value(index.likeness_measure()).value() == "other");
    CHECK(fixture::value(index.neighbour_lists()).empty());
}

TEST_CASE("what names a model that is gone is passed over", "[neighbours]") {
    const TemporaryFolder folder;
    TwoViewIndex index = with_models(folder, 2);
    fixture::ok(index.store_neighbours(some_lists()));
    CHECK(fixture::value(index.neighbour_lists()) ==
          std::vector<NeighbourList>{{1, {{2, 0.125F}}}, {2, {{1, 0.125F}}}});
    CHECK(fixture::value(index.check()).empty());
}

TEST_CASE("lists that are not sound are refused, and nothing of them is stored", "[neighbours]") {
    const TemporaryFolder folder;
    TwoViewIndex index = with_models(folder, 3);
    std::vector<NeighbourList> lists = some_lists();
    SECTION("its own model") {
        lists[2].nearest[0].id = 3;
    }
    SECTION("not ascending") {
        std::swap(lists[2].nearest[0], lists[2].nearest[1]);
    }
    SECTION("below 0") {
        lists[2].nearest[0].distance = -1.0F;
    }
    SECTION("not finite") {
        lists[2].nearest[1].distance = std::numeric_limits<float>::infinity();
    }
    const auto refused = index.store_neighbours(lists);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == core::ErrorCode::BadArgument);
    CHECK(fixture::value(index.neighbour_lists()).empty());
}

TEST_CASE("a damaged row is left out of its list and named by check", "[neighbours]") {
    const TemporaryFolder folder;
    TwoViewIndex index = with_models(folder, 3);
    fixture::ok(index.store_neighbours(some_lists()));
    const std::string sql = GENERATE("UPDATE neighbour SET distance = 0.25 WHERE model_id = 2 AND place = 0",
                                     "UPDATE neighbour SET other_id = 3 WHERE model_id = 2 AND place = 0",
                                     "UPDATE neighbour SET place = 7 WHERE model_id = 2 AND place = 0");
    {
        const db::Database database = fixture::value(db::open_collection(folder / "a.db", OpenMode::ReadWrite));
        fixture::ok(database.execute(sql));
    }
    std::vector<NeighbourList> expected = some_lists();
    expected[1].nearest.erase(expected[1].nearest.begin());
    CHECK(fixture::value(index.neighbour_lists()) == expected);
    const std::vector<db::Damage> damaged = fixture::value(index.check());
    REQUIRE(damaged.size() == 1);
    CHECK(damaged[0].sentence() == "model 2, neighbours: they are damaged; build the index again");
    CHECK(fixture::value(index.damaged_models()).empty());
}
