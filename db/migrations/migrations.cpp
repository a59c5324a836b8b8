#include "db/migrations/migrations.hpp"

#include <string>

#include "db/sqlite/transaction.hpp"

namespace db {

namespace {

/// One kind of our databases.
struct Schema {
    std::uint32_t application_id;
    std::span<const Migration> steps;
    int page_size;
    const char* how_to_update;  ///< of an older one, opened read-only
    DatabaseWords words;
};

Schema collection_schema() {
    // A view's row is about 2 kB: pages of 4 kB would be half empty.
    return {kApplicationId,
            migrations(),
            kPageSize,
            "an older version of Croquis made it; add a model to it once with `croquis index build` to bring it up to "
            "date",
            {}};
}

Schema designs_schema() {
    return {kDesignsApplicationId,
            design_migrations(),
            kDesignsPageSize,
            "an older version of Croquis made it; open a design of it once at the kiosk to bring it up to date",
            {.thing = "file of designs",
             .make = "it is made when a garment is first drawn at the kiosk",
             .mend = "restore a copy, or move it away to begin without designs",
             .renew = "name another file"}};
}

core::Result<void> apply(const Database& database, const Schema& schema, std::size_t from) {
    for (std::size_t i = from; i < schema.steps.size(); ++i) {
        if (core::Result<void> done = database.execute(schema.steps[i].sql); !done) return done;
    }
    // Both numbers are in the header page, so they change with the tables or not at all.
    return database.execute("PRAGMA application_id = " + std::to_string(schema.application_id) +
                            "; PRAGMA user_version = " + std::to_string(schema.steps.size()));
}

/// Looks at the version again under the write lock, so that two programs opening at once migrate once.
core::Result<void> migrate(const Database& database, const Schema& schema) {
    // Counts for a new file only.
    if (core::Result<void> sized = database.execute("PRAGMA page_size = " + std::to_string(schema.page_size)); !sized) {
        return sized;
    }
    core::Result<Transaction> transaction = Transaction::begin(database, Transaction::Kind::Write);
    if (!transaction) return core::unexpected(transaction.error());
    const core::Result<std::int64_t> version = database.integer("PRAGMA user_version");
    if (!version) return core::unexpected(version.error());
    if (*version < static_cast<std::int64_t>(schema.steps.size())) {
        if (core::Result<void> done = apply(database, schema, static_cast<std::size_t>(*version)); !done) return done;
    }
    return transaction->commit();
}

core::Result<Database> open_up_to_date(const std::filesystem::path& path, OpenMode mode, const Schema& schema,
                                       const CollectionOptions& options) {
    core::Result<Database> database = Database::open(path, mode,
                                                     {.application_id = schema.application_id,
                                                      .newest_version = static_cast<int>(schema.steps.size()),
                                                      .busy_timeout_ms = options.busy_timeout_ms,
                                                      .max_pages = options.max_pages,
                                                      .words = schema.words});
    if (!database) return database;
    const core::Result<std::int64_t> version = database->integer("PRAGMA user_version");
    if (!version) return core::unexpected(version.error());
    if (*version < static_cast<std::int64_t>(schema.steps.size())) {
        if (mode == OpenMode::ReadOnly) {
            return core::unexpected(core::ErrorCode::DatabaseFailed, schema.how_to_update, path.string());
        }
        if (const core::Result<void> done = migrate(*database, schema); !done) return core::unexpected(done.error());
    }
    if (mode != OpenMode::ReadOnly) {
        if (const core::Result<void> done = database->use_write_ahead_log(options.busy_timeout_ms); !done) {
            return core::unexpected(done.error());
        }
    }
    return database;
}

}  // namespace

int newest_version() {
    return static_cast<int>(migrations().size());
}

core::Result<Database> open_collection(const std::filesystem::path& path, OpenMode mode,
                                       const CollectionOptions& options) {
    return open_up_to_date(path, mode, collection_schema(), options);
}

core::Result<Database> open_designs(const std::filesystem::path& path, OpenMode mode,
                                    const CollectionOptions& options) {
    return open_up_to_date(path, mode, designs_schema(), options);
}

}  // namespace db
