#include "db/migrations/migrations.hpp"

#include <string>

#include "db/sqlite/transaction.hpp"

namespace db {

namespace {

core::Result<void> apply(const Database& database, std::size_t from) {
    for (std::size_t i = from; i < migrations().size(); ++i) {
        if (core::Result<void> done = database.execute(migrations()[i].sql); !done) return done;
    }
    // Both numbers are in the header page, so they change with the tables or not at all.
    return database.execute("PRAGMA application_id = " + std::to_string(kApplicationId) +
                            "; PRAGMA user_version = " + std::to_string(migrations().size()));
}

/// Looks at the version again under the write lock, so that two programs opening at once migrate once.
core::Result<void> migrate(const Database& database) {
    // Counts for a new file only. A view's row is about 2 kB: pages of 4 kB would be half empty.
    if (core::Result<void> sized = database.execute("PRAGMA page_size = " + std::to_string(kPageSize)); !sized) {
        return sized;
    }
    core::Result<Transaction> transaction = Transaction::begin(database, Transaction::Kind::Write);
    if (!transaction) return core::unexpected(transaction.error());
    const core::Result<std::int64_t> version = database.integer("PRAGMA user_version");
    if (!version) return core::unexpected(version.error());
    if (*version < newest_version()) {
        if (core::Result<void> done = apply(database, static_cast<std::size_t>(*version)); !done) return done;
    }
    return transaction->commit();
}

}  // namespace

int newest_version() {
    return static_cast<int>(migrations().size());
}

core::Result<Database> open_collection(const std::filesystem::path& path, OpenMode mode,
                                       const CollectionOptions& options) {
    core::Result<Database> database = Database::open(path, mode,
                                                     {.application_id = kApplicationId,
                                                      .newest_version = newest_version(),
                                                      .busy_timeout_ms = options.busy_timeout_ms,
                                                      .max_pages = options.max_pages});
    if (!database) return database;
    const core::Result<std::int64_t> version = database->integer("PRAGMA user_version");
    if (!version) return core::unexpected(version.error());
    if (*version < newest_version()) {
        if (mode == OpenMode::ReadOnly) {
            return core::unexpected(core::ErrorCode::DatabaseFailed,
                                    "an older version of Croquis made it; add a model to it once with `croquis index "
                                    "build` to bring it up to date",
                                    path.string());
        }
        if (const core::Result<void> done = migrate(*database); !done) return core::unexpected(done.error());
    }
    if (mode != OpenMode::ReadOnly) {
        if (const core::Result<void> done = database->use_write_ahead_log(options.busy_timeout_ms); !done) {
            return core::unexpected(done.error());
        }
    }
    return database;
}

}  // namespace db
