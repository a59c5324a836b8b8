#include "db/migrations/migrations.hpp"

#include <array>
#include <thread>

#include "db_fixtures.hpp"

using db::Database;
using db::OpenMode;
using fixture::TemporaryFolder;

TEST_CASE("migrations are numbered without a gap", "[migrations]") {
    REQUIRE(db::newest_version() >= 1);
    for (std::size_t i = 0; i < db::migrations().size(); ++i) {
        const std::string number = std::to_string(10001 + i).substr(1) + "_";
        CHECK(std::string(db::migrations()[i].name).rfind(number, 0) == 0);
    }
}

TEST_CASE("a new collection is marked, versioned and logged ahead", "[migrations]") {
    const TemporaryFolder folder;
    const Database database = fixture::value(db::open_collection(folder / "a.db", OpenMode::Create));
    CHECK(fixture::value(database.integer("PRAGMA application_id")) == db::kApplicationId);
    CHECK(fixture::value(database.integer("PRAGMA user_version")) == db::newest_version());
    CHECK(fixture::value(database.integer("PRAGMA foreign_keys")) == 1);
    CHECK(fixture::value(database.integer("PRAGMA synchronous")) == 2);
    CHECK(fixture::value(database.integer("SELECT count(*) FROM sqlite_schema WHERE name = 'model'")) == 1);
    CHECK(std::filesystem::exists(folder / "a.db-wal"));
}

TEST_CASE("opening again changes nothing", "[migrations]") {
    const TemporaryFolder folder;
    { fixture::value(db::open_collection(folder / "a.db", OpenMode::Create)); }
    const auto before = fixture::snapshot(folder.path());
    { fixture::value(db::open_collection(folder / "a.db", OpenMode::ReadWrite)); }
    CHECK(fixture::snapshot(folder.path()) == before);
}

TEST_CASE("an older version is brought up to date for writing and refused for reading", "[migrations]") {
    const TemporaryFolder folder;
    {
        const Database old = fixture::value(Database::open(folder / "a.db", OpenMode::Create, {}));
        fixture::ok(old.execute("PRAGMA application_id = " + std::to_string(db::kApplicationId) + "; VACUUM"));
    }
    const core::Result<Database> refused = db::open_collection(folder / "a.db", OpenMode::ReadOnly);
    CHECK(fixture::sentence(refused).find("an older version of Croquis made it") != std::string::npos);
    fixture::value(db::open_collection(folder / "a.db", OpenMode::ReadWrite));
    fixture::value(db::open_collection(folder / "a.db", OpenMode::ReadOnly));
}

TEST_CASE("every step from the first keeps what is stored", "[migrations]") {
    const TemporaryFolder folder;
    {
        const Database old = fixture::value(Database::open(folder / "a.db", OpenMode::Create, {}));
        fixture::ok(old.execute(db::migrations()[0].sql));
        fixture::ok(
            old.execute("INSERT INTO build VALUES (1, 'p', 7, '0.1.0');"
                        "INSERT INTO model VALUES (5, 'm.off', 'mare', 'horse', 1, 2, 1, 3);"
                        "PRAGMA user_version = 1; PRAGMA application_id = " +
                        std::to_string(db::kApplicationId)));
    }
    CHECK_FALSE(db::open_collection(folder / "a.db", OpenMode::ReadOnly));
    const Database database = fixture::value(db::open_collection(folder / "a.db", OpenMode::ReadWrite));
    CHECK(fixture::value(database.integer("PRAGMA user_version")) == db::newest_version());
    CHECK(fixture::value(database.integer("SELECT count(*) FROM model WHERE id = 5 AND name = 'mare'")) == 1);
    CHECK(fixture::value(database.integer("SELECT count(*) FROM neighbour")) == 0);
    CHECK(fixture::value(database.integer("SELECT count(*) FROM sqlite_schema WHERE name = 'likeness'")) == 1);
}

TEST_CASE("programs that create the same collection at once make it once", "[migrations]") {
    for (int round = 0; round < 10; ++round) {
        const TemporaryFolder folder;
        std::array<std::string, 4> failures;
        std::vector<std::thread> programs;
        for (std::string& failure : failures) {
            programs.emplace_back([&] {
                const core::Result<Database> database = db::open_collection(folder / "a.db", OpenMode::Create);
                if (!database) failure = database.error().sentence();
            });
        }
        for (std::thread& program : programs) program.join();
        for (const std::string& failure : failures) CHECK(failure.empty());
    }
}

TEST_CASE("a migration that fails half-way leaves the file as it was", "[migrations]") {
    const TemporaryFolder folder;
    {
        const Database old = fixture::value(Database::open(folder / "a.db", OpenMode::Create, {}));
        // Version 0 of ours, but with a table that migration 1 also makes, after others.
        fixture::ok(old.execute("CREATE TABLE display_mesh (n); PRAGMA application_id = " +
                                std::to_string(db::kApplicationId)));
    }
    const auto before = fixture::snapshot(folder.path());
    CHECK_FALSE(db::open_collection(folder / "a.db", OpenMode::ReadWrite));
    CHECK(fixture::snapshot(folder.path()) == before);
}
