#include "db/sqlite/transaction.hpp"

#include "db_fixtures.hpp"

using db::Database;
using db::OpenMode;
using db::Transaction;
using fixture::TemporaryFolder;
using State = db::Transaction::State;

namespace {

constexpr db::DatabaseOptions kOptions{.application_id = 0, .newest_version = 0, .busy_timeout_ms = 20};

Database open_table(const TemporaryFolder& folder, const db::DatabaseOptions& options = kOptions) {
    Database database = fixture::value(Database::open(folder / "a.db", OpenMode::Create, options));
    fixture::ok(database.execute("CREATE TABLE IF NOT EXISTS t (n INTEGER)"));
    fixture::ok(database.use_write_ahead_log(100));
    return database;
}

std::int64_t rows(const Database& database) {
    return fixture::value(database.integer("SELECT count(*) FROM t"));
}

Transaction write(const Database& database) {
    return fixture::value(Transaction::begin(database, Transaction::Kind::Write));
}

}  // namespace

TEST_CASE("what is committed stays, what is not does not", "[transaction]") {
    const TemporaryFolder folder;
    const Database database = open_table(folder);
    {
        Transaction kept = write(database);
        fixture::ok(database.execute("INSERT INTO t VALUES (1)"));
        CHECK(kept.state() == State::Open);
        fixture::ok(kept.commit());
        CHECK(kept.state() == State::Committed);
        kept.rollback();
        CHECK(kept.state() == State::Committed);
        CHECK_FALSE(kept.commit());
    }
    {
        const Transaction left = write(database);
        fixture::ok(database.execute("INSERT INTO t VALUES (2)"));
    }
    Transaction undone = write(database);
    fixture::ok(database.execute("INSERT INTO t VALUES (3)"));
    undone.rollback();
    CHECK(undone.state() == State::RolledBack);
    CHECK_FALSE(undone.commit());
    CHECK(rows(database) == 1);
}

TEST_CASE("a moved transaction is ended once, by its new owner", "[transaction]") {
    const TemporaryFolder folder;
    const Database database = open_table(folder);
    Transaction first = write(database);
    fixture::ok(database.execute("INSERT INTO t VALUES (1)"));
    {
        Transaction second(std::move(first));
        fixture::ok(second.commit());
    }
    CHECK(rows(database) == 1);
}

TEST_CASE("transactions do not nest", "[transaction]") {
    const TemporaryFolder folder;
    const Database database = open_table(folder);
    const Transaction outer = write(database);
    CHECK_FALSE(Transaction::begin(database, Transaction::Kind::Write));
    CHECK(outer.state() == State::Open);
}

TEST_CASE("a full disk ends the transaction, and it knows", "[transaction]") {
    const TemporaryFolder folder;
    db::DatabaseOptions small = kOptions;
    small.max_pages = 10;
    const Database database = open_table(folder, small);
    fixture::ok(database.execute("INSERT INTO t VALUES (1)"));
    Transaction transaction = write(database);
    const core::Result<void> full = database.execute(
        "WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM r WHERE i < 100000) "
        "INSERT INTO t SELECT i FROM r");
    CHECK(fixture::sentence(full).find("the disk is full; free some space") != std::string::npos);
    CHECK(full.error().code == core::ErrorCode::WriteFailed);
    transaction.rollback();
    CHECK(transaction.state() == State::RolledBack);
    CHECK(rows(database) == 1);
}

TEST_CASE("a second writer is told to wait, a reader is not", "[transaction]") {
    const TemporaryFolder folder;
    const Database one = open_table(folder);
    const Database two = open_table(folder);
    Transaction holding = write(one);
    fixture::ok(one.execute("INSERT INTO t VALUES (1)"));
    const core::Result<Transaction> refused = Transaction::begin(two, Transaction::Kind::Write);
    CHECK(fixture::sentence(refused).find("another program is using it; wait") != std::string::npos);
    CHECK(rows(two) == 0);
    fixture::ok(holding.commit());
    CHECK(rows(two) == 1);
}

TEST_CASE("a reading transaction sees one moment", "[transaction]") {
    const TemporaryFolder folder;
    const Database one = open_table(folder);
    const Database two = open_table(folder);
    Transaction moment = fixture::value(Transaction::begin(two, Transaction::Kind::Read));
    CHECK(rows(two) == 0);
    fixture::ok(one.execute("INSERT INTO t VALUES (1)"));
    CHECK(rows(two) == 0);
    moment.rollback();
    CHECK(rows(two) == 1);
}
