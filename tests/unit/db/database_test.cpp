#include "db/sqlite/database.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "db_fixtures.hpp"

using core::ErrorCode;
using db::Database;
using db::OpenMode;
using fixture::Bytes;
using fixture::TemporaryFolder;

namespace {

constexpr db::DatabaseOptions kOurs{.application_id = 0x1234, .newest_version = 3, .busy_timeout_ms = 20};

/// A file with one table, marked as ours.
void make_database(const std::filesystem::path& path, const std::string& more = {}) {
    const Database database = fixture::value(Database::open(path, OpenMode::Create, kOurs));
    fixture::ok(
        database.execute("PRAGMA application_id = 0x1234; PRAGMA user_version = 3;"
                         "CREATE TABLE t (n INTEGER, x REAL, s TEXT, b BLOB);" +
                         more));
}

ErrorCode refusal(const std::filesystem::path& path, OpenMode mode) {
    const core::Result<Database> opened = Database::open(path, mode, kOurs);
    REQUIRE_FALSE(opened);
    CHECK(opened.error().where == path.string());
    CHECK_FALSE(opened.error().message.empty());
    return opened.error().code;
}

/// Permissions mean nothing to root, so the body runs in a child as nobody. True when it returned true there.
bool as_nobody(const std::function<bool()>& body) {
    const pid_t child = fork();
    if (child == 0) {
        const bool changed = geteuid() != 0 || (setegid(65534) == 0 && seteuid(65534) == 0);
        _exit(changed && body() ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

TEST_CASE("values come back from a table as they were bound", "[database]") {
    const TemporaryFolder folder;
    make_database(folder / "a.db");
    const Database database = fixture::value(Database::open(folder / "a.db", OpenMode::ReadWrite, kOurs));
    db::Statement insert = fixture::value(database.prepare("INSERT INTO t VALUES (?, ?, ?, ?)"));
    const std::vector<std::byte> blob{std::byte{0}, std::byte{255}};
    fixture::ok(
        insert.bind(0xfedcba9876543210ULL).bind(0.1).bind("a\"'b").bind(std::span<const std::byte>(blob)).run());
    fixture::ok(insert.bind(-1).bind(0.0).bind("").bind(std::span<const std::byte>()).run());
    db::Statement select = fixture::value(database.prepare("SELECT n, x, s, b FROM t ORDER BY rowid"));
    REQUIRE(fixture::value(select.step()));
    CHECK(static_cast<std::uint64_t>(select.integer(0)) == 0xfedcba9876543210ULL);
    CHECK(select.real(1) == 0.1);
    CHECK(select.text(2) == "a\"'b");
    CHECK(std::vector<std::byte>(select.blob(3).begin(), select.blob(3).end()) == blob);
    REQUIRE(fixture::value(select.step()));
    CHECK(select.integer(0) == -1);
    CHECK(select.blob(3).empty());
    CHECK_FALSE(fixture::value(select.step()));
    CHECK(fixture::value(database.integer("SELECT count(*) FROM t WHERE s IS NULL OR b IS NULL")) == 0);
}

TEST_CASE("binding too much is told at the step, and the statement works again", "[database]") {
    const TemporaryFolder folder;
    make_database(folder / "a.db");
    const Database database = fixture::value(Database::open(folder / "a.db", OpenMode::ReadWrite, kOurs));
    db::Statement insert = fixture::value(database.prepare("INSERT INTO t (n) VALUES (?)"));
    CHECK_FALSE(insert.bind(1).bind(2).run());
    fixture::ok(insert.bind(3).run());
    CHECK(fixture::value(database.integer("SELECT sum(n) FROM t")) == 3);
    CHECK_FALSE(database.prepare("SELECT nothing FROM nowhere"));
}

TEST_CASE("a statement keeps its connection alive", "[database]") {
    const TemporaryFolder folder;
    make_database(folder / "a.db");
    std::optional<Database> database = fixture::value(Database::open(folder / "a.db", OpenMode::ReadOnly, kOurs));
    db::Statement count = fixture::value(database->prepare("SELECT count(*) FROM t"));
    database.reset();
    CHECK(fixture::value(count.step()));
}

TEST_CASE("what must exist and does not is missing", "[database]") {
    const TemporaryFolder folder;
    CHECK(refusal(folder / "none.db", OpenMode::ReadOnly) == ErrorCode::FileMissing);
    CHECK(refusal(folder / "none.db", OpenMode::ReadWrite) == ErrorCode::FileMissing);
    CHECK(refusal(folder.path() / "nowhere" / "a.db", OpenMode::Create) == ErrorCode::FileMissing);
    CHECK(refusal(folder.path(), OpenMode::Create) == ErrorCode::FileUnreadable);
    CHECK(refusal("/dev/null", OpenMode::Create) == ErrorCode::FileUnreadable);
    CHECK_FALSE(Database::open("", OpenMode::Create, kOurs));
    CHECK(fixture::snapshot(folder.path()).empty());
}

TEST_CASE("an empty file becomes a database only when one may be created", "[database]") {
    const TemporaryFolder folder;
    fixture::write_bytes(folder / "a.db", {});
    CHECK(refusal(folder / "a.db", OpenMode::ReadOnly) == ErrorCode::NotAnIndex);
    CHECK(refusal(folder / "a.db", OpenMode::ReadWrite) == ErrorCode::NotAnIndex);
    CHECK(Database::open(folder / "a.db", OpenMode::Create, kOurs));
}

TEST_CASE("a file that is not ours is refused and not altered by a byte", "[database]") {
    const TemporaryFolder folder;
    const OpenMode mode = GENERATE(OpenMode::ReadOnly, OpenMode::ReadWrite, OpenMode::Create);
    const std::filesystem::path path = folder / "other";
    const std::string text = "Dear diary, today I drew a horse.\n" + std::string(5000, 'x');
    SECTION("a text") {
        fixture::write_bytes(path, Bytes(text.begin(), text.end()));
    }
    SECTION("a short text") {
        fixture::write_bytes(path, Bytes(text.begin(), text.begin() + 4));
    }
    SECTION("another program's database, with its log beside it") {
        // Copied while open, so that the log is as after a crash: SQLite would fold it in on opening.
        const TemporaryFolder workshop;
        const db::DatabaseOptions theirs{.application_id = 77};
        const Database made = fixture::value(Database::open(workshop / "other", OpenMode::Create, theirs));
        fixture::ok(made.execute("PRAGMA application_id = 77; CREATE TABLE diary (line TEXT)"));
        fixture::ok(made.use_write_ahead_log(100));
        fixture::ok(made.execute("INSERT INTO diary VALUES ('I drew a horse')"));
        for (const char* name : {"other", "other-wal"})
            fixture::write_bytes(folder / name, fixture::read_bytes(workshop / name));
        REQUIRE_FALSE(fixture::read_bytes(folder / "other-wal").empty());
    }
    const auto before = fixture::snapshot(folder.path());
    CHECK(refusal(path, mode) == ErrorCode::NotAnIndex);
    CHECK(fixture::snapshot(folder.path()) == before);
}

TEST_CASE("a database of a newer version is refused and not altered by a byte", "[database]") {
    const TemporaryFolder folder;
    make_database(folder / "a.db", "PRAGMA user_version = 4");
    const auto before = fixture::snapshot(folder.path());
    const OpenMode mode = GENERATE(OpenMode::ReadOnly, OpenMode::ReadWrite, OpenMode::Create);
    CHECK(refusal(folder / "a.db", mode) == ErrorCode::NewerVersion);
    CHECK(fixture::snapshot(folder.path()) == before);
}

TEST_CASE("a newer version that stands only in the log is refused too", "[database]") {
    const TemporaryFolder folder;
    make_database(folder / "a.db");
    const Database writer = fixture::value(Database::open(folder / "a.db", OpenMode::ReadWrite, kOurs));
    fixture::ok(writer.use_write_ahead_log(100));
    fixture::ok(writer.execute("PRAGMA user_version = 4"));
    CHECK(refusal(folder / "a.db", OpenMode::ReadOnly) == ErrorCode::NewerVersion);
}

TEST_CASE("a database cut off in its first page is damaged", "[database]") {
    const TemporaryFolder folder;
    make_database(folder / "a.db");
    Bytes bytes = fixture::read_bytes(folder / "a.db");
    bytes.resize(GENERATE(64, 1000));
    fixture::write_bytes(folder / "a.db", bytes);
    const ErrorCode code = refusal(folder / "a.db", OpenMode::ReadOnly);
    CHECK((code == ErrorCode::Damaged || code == ErrorCode::NotAnIndex));
}

TEST_CASE("a read-only folder is searched, and refused for writing", "[database]") {
    const TemporaryFolder folder;
    make_database(folder / "a #1?%.db", "INSERT INTO t (n) VALUES (42)");
    {
        fixture::ok(
            fixture::value(Database::open(folder / "a #1?%.db", OpenMode::ReadWrite, kOurs)).use_write_ahead_log(100));
    }
    std::filesystem::permissions(folder / "a #1?%.db", std::filesystem::perms(0444));
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
    CHECK(as_nobody([&] {
        const core::Result<Database> database = Database::open(folder / "a #1?%.db", OpenMode::ReadOnly, kOurs);
        return database && *database->integer("SELECT n FROM t") == 42;
    }));
    CHECK(as_nobody([&] {
        const core::Result<Database> database = Database::open(folder / "a #1?%.db", OpenMode::ReadWrite, kOurs);
        return !database && database.error().code == ErrorCode::WriteFailed;
    }));
    CHECK(as_nobody([&] {
        const core::Result<Database> database = Database::open(folder / "new.db", OpenMode::Create, kOurs);
        return !database && database.error().code == ErrorCode::WriteFailed &&
               database.error().message.find("read-only") != std::string::npos;
    }));
}

TEST_CASE("a log left over in a read-only folder is not passed over in silence", "[database]") {
    const TemporaryFolder workshop;
    make_database(workshop / "a.db");
    const Database writer = fixture::value(Database::open(workshop / "a.db", OpenMode::ReadWrite, kOurs));
    fixture::ok(writer.use_write_ahead_log(100));
    fixture::ok(writer.execute("INSERT INTO t (n) VALUES (42)"));
    const TemporaryFolder folder;
    for (const char* name : {"a.db", "a.db-wal"}) {
        fixture::write_bytes(folder / name, fixture::read_bytes(workshop / name));
    }
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
    CHECK(as_nobody([&] {
        const core::Result<Database> database = Database::open(folder / "a.db", OpenMode::ReadOnly, kOurs);
        return !database && database.error().message.find("did not end in order") != std::string::npos;
    }));
}

TEST_CASE("what a killed writer left half done is undone, also for reading", "[database]") {
    const TemporaryFolder workshop, folder;
    make_database(workshop / "a.db", "INSERT INTO t (n) VALUES (42)");
    const Database writer = fixture::value(Database::open(workshop / "a.db", OpenMode::ReadWrite, kOurs));
    // More than the cache holds, so that it is on the disk before the transaction has ended.
    fixture::ok(
        writer.execute("PRAGMA cache_size = 4; BEGIN; UPDATE t SET n = 7;"
                       "WITH RECURSIVE k(i) AS (VALUES(1) UNION ALL SELECT i + 1 FROM k WHERE i < 100)"
                       "INSERT INTO t (n, b) SELECT 7, zeroblob(4000) FROM k;"));
    for (const char* name : {"a.db", "a.db-journal"}) {
        fixture::write_bytes(folder / name, fixture::read_bytes(workshop / name));
    }
    const Database reader = fixture::value(Database::open(folder / "a.db", OpenMode::ReadOnly, kOurs));
    CHECK(fixture::value(reader.integer("SELECT count(*) FROM t")) == 1);
    CHECK(fixture::value(reader.integer("SELECT n FROM t")) == 42);
    CHECK_FALSE(std::filesystem::exists(folder / "a.db-journal"));
}

TEST_CASE("a pipe is no database and is not waited for", "[database]") {
    const TemporaryFolder folder;
    REQUIRE(mkfifo((folder / "a.db").c_str(), 0600) == 0);
    for (const OpenMode mode : {OpenMode::ReadOnly, OpenMode::ReadWrite, OpenMode::Create}) {
        CHECK(refusal(folder / "a.db", mode) == ErrorCode::FileUnreadable);
    }
}

TEST_CASE("a file nobody may read is named", "[database]") {
    const TemporaryFolder folder;
    make_database(folder / "a.db");
    std::filesystem::permissions(folder / "a.db", std::filesystem::perms::none);
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
    CHECK(as_nobody([&] {
        const core::Result<Database> database = Database::open(folder / "a.db", OpenMode::ReadOnly, kOurs);
        return !database && database.error().code == ErrorCode::FileUnreadable;
    }));
}
