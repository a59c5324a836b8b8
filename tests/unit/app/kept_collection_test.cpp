#include "firmware_like_app/collection/kept_collection.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "firmware_like_app/collection/index_builder.hpp"
#include "tests/support/block_models.hpp"
#include "tests/support/figures.hpp"
#include "tests/support/temporary_folder.hpp"

using app::CollectionState;
using app::KeptCollection;
using support::TemporaryFolder;
using namespace std::chrono_literals;

namespace {

void write_models(const TemporaryFolder& folder, const std::string& where, int first, int count) {
    for (int n = first; n < first + count; ++n) {
        (void)folder.write(where + "/block-" + std::to_string(n) + ".off", support::off_text(support::block_model(n)));
    }
}

/// Waits for the end of an import, at most a minute.
app::CollectionStatus ended(const KeptCollection& collection) {
    for (int i = 0; i < 6000; ++i) {
        app::CollectionStatus status = collection.status();
        if (!status.importing && status.ended) return status;
        std::this_thread::sleep_for(10ms);
    }
    return collection.status();
}

std::size_t found(KeptCollection& collection) {
    return collection.searcher().search(test::make_horse_drawing(), {}).best.size();
}

}  // namespace

TEST_CASE("what is missing of a collection is said: no name, no file, no index, no models", "[kept collection]") {
    const TemporaryFolder folder;
    KeptCollection none({.database = "", .models = "", .jobs = 1});
    CHECK(none.status().state == CollectionState::Empty);
    CHECK_FALSE(none.status().can_add);
    none.add(folder.path(""));
    CHECK_FALSE(none.status().importing);
    CHECK(found(none) == 0);

    const KeptCollection missing({.database = folder.path("a.db"), .models = "", .jobs = 1});
    CHECK(missing.status().state == CollectionState::Missing);
    REQUIRE(missing.status().problems.size() == 1);

    const KeptCollection damaged({.database = folder.write("b.db", std::string(5000, 'x')), .models = "", .jobs = 1});
    CHECK(damaged.status().state == CollectionState::Damaged);
}

TEST_CASE("models of a folder are read at the start, and others are added while it is searched", "[kept collection]") {
    const TemporaryFolder folder;
    write_models(folder, "first", 0, 3);
    (void)folder.write("first/broken.off", "OFF\n1 1 0\n");
    KeptCollection collection({.database = folder.path("a.db"), .models = folder.path("first"), .jobs = 1});
    CHECK(collection.status().state == CollectionState::Building);
    const app::CollectionStatus first = ended(collection);
    CHECK(first.state == CollectionState::Ready);
    CHECK(first.models == 3);
    CHECK(first.ended->added == 3);
    CHECK(first.ended->unreadable == 1);
    REQUIRE(first.problems.size() == 1);
    CHECK(first.problems[0].find("broken.off") != std::string::npos);
    CHECK(found(collection) == 3);
    CHECK(collection.status().median_search_ms > 0);

    write_models(folder, "second", 10, 2);
    collection.add(folder.path("second"));
    CHECK(collection.status().state == CollectionState::Ready);  // visitors go on
    const app::CollectionStatus second = ended(collection);
    CHECK(second.ended->added == 2);
    CHECK(second.models == 5);
    CHECK(found(collection) == 5);

    collection.add(folder.path("nowhere"));
    CHECK_FALSE(ended(collection).ended->failure.empty());
    CHECK(collection.status().state == CollectionState::Ready);
}

TEST_CASE("an index of other settings is not searched until it is updated", "[kept collection]") {
    const TemporaryFolder folder;
    write_models(folder, "models", 0, 2);
    app::IndexBuildOptions build;
    build.paths = {folder.path("models")};
    build.database = folder.path("a.db");
    build.parameters.silhouette_px = 64;
    build.parameters.thumbnail = {32, 24};
    REQUIRE(app::build_index(build, {}, {}));
    KeptCollection collection({.database = folder.path("a.db"), .models = "", .jobs = 1});
    CHECK(collection.status().state == CollectionState::Stale);
    CHECK(found(collection) == 0);
    collection.update();
    const app::CollectionStatus status = ended(collection);
    CHECK(status.state == CollectionState::Ready);
    CHECK(status.models == 2);
    CHECK(found(collection) == 2);
}

TEST_CASE("an import is stopped, keeps what it has, and never outlives its collection", "[kept collection]") {
    const TemporaryFolder folder;
    write_models(folder, "models", 0, 12);
    {
        KeptCollection collection({.database = folder.path("a.db"), .models = folder.path("models"), .jobs = 1});
        collection.stop();
        const app::CollectionStatus status = ended(collection);
        CHECK(status.ended->added < 12);
        CHECK((status.state == CollectionState::Ready || status.state == CollectionState::Empty));
    }
    const auto start = std::chrono::steady_clock::now();
    { const KeptCollection collection({.database = folder.path("b.db"), .models = folder.path("models"), .jobs = 1}); }
    CHECK(std::chrono::steady_clock::now() - start < 20s);
}
