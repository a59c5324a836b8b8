#include "db/sqlite/database.hpp"

#include <sqlite3.h>

#include <utility>

#include "db/sqlite/connection.hpp"
#include "db/sqlite/database_file.hpp"

namespace db {

namespace {

namespace fs = std::filesystem;

core::Result<std::shared_ptr<const Connection>> connect(const std::string& name, int flags, const std::string& where,
                                                        const DatabaseWords& words) {
    sqlite3* handle = nullptr;
    const int code = sqlite3_open_v2(name.c_str(), &handle, flags | SQLITE_OPEN_EXRESCODE, nullptr);
    auto connection =
        std::make_shared<const Connection>(handle, where, words);  // also closes a handle that failed to open
    if (code != SQLITE_OK) return core::unexpected(describe_failure(code, sqlite3_errstr(code), where, words));
    return connection;
}

int flags_for(OpenMode mode) {
    switch (mode) {
        case OpenMode::ReadOnly:
            return SQLITE_OPEN_READONLY;
        case OpenMode::ReadWrite:
            return SQLITE_OPEN_READWRITE;
        case OpenMode::Create:
            return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    }
    return SQLITE_OPEN_READONLY;
}

/// Settings that live with the connection. A file may come from anybody: nothing in its schema is trusted to run code.
core::Result<void> set_up(const Database& database, sqlite3* handle, const DatabaseOptions& options) {
    sqlite3_busy_timeout(handle, options.busy_timeout_ms);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    std::string pragmas = "PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL; PRAGMA cell_size_check = ON;";
    if (options.max_pages > 0) pragmas += "PRAGMA max_page_count = " + std::to_string(options.max_pages);
    return database.execute(pragmas);
}

/// The log beside the file may hold a later first page than the one that examine_file saw.
core::Result<void> confirm_identity(const Database& database, OpenMode mode, const DatabaseOptions& options) {
    const core::Result<std::int64_t> pages = database.integer("PRAGMA page_count");
    if (!pages) return core::unexpected(pages.error());
    if (*pages == 0) {
        if (mode == OpenMode::Create) return {};
        return core::unexpected(core::ErrorCode::NotAnIndex, std::string("the file is empty; ") + options.words.make,
                                database.where());
    }
    const core::Result<std::int64_t> id = database.integer("PRAGMA application_id");
    if (!id) return core::unexpected(id.error());
    if (static_cast<std::uint32_t>(*id) != options.application_id)
        return core::unexpected(not_ours(database.where(), options.words));
    const core::Result<std::int64_t> version = database.integer("PRAGMA user_version");
    if (!version) return core::unexpected(version.error());
    if (*version < 0 || *version > options.newest_version) {
        return core::unexpected(newer_version(*version, options, database.where()));
    }
    return {};
}

}  // namespace

Database::Database(std::shared_ptr<const Connection> connection) : connection_(std::move(connection)) {}

core::Result<Database> Database::open(const fs::path& path, OpenMode mode, const DatabaseOptions& options) {
    const core::Result<FileState> state = examine_file(path, mode, options);
    if (!state) return core::unexpected(state.error());
    const auto open_as = [&](const std::string& name, int flags) -> core::Result<Database> {
        core::Result<std::shared_ptr<const Connection>> connection = connect(name, flags, path.string(), options.words);
        if (!connection) return core::unexpected(connection.error());
        Database database(*connection);
        core::Result<void> ready = set_up(database, (*connection)->handle, options);
        if (ready) ready = confirm_identity(database, mode, options);
        if (!ready) return core::unexpected(ready.error());
        return database;
    };
    core::Result<Database> database = open_as(fs::absolute(path).string(), flags_for(mode));
    // In a read-only folder SQLite cannot make the files that it keeps beside a database with a write-ahead log.
    const bool shut_out = !database && (database.error().code == core::ErrorCode::FileUnreadable ||
                                        database.error().code == core::ErrorCode::WriteFailed);
    if (!shut_out || mode != OpenMode::ReadOnly) return database;
    if (is_complete_by_itself(path)) return open_as(immutable_uri(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    // What a program that was killed left undone cannot be undone for reading only; where we may write, once is enough.
    if (open_as(fs::absolute(path).string(), flags_for(OpenMode::ReadWrite))) {
        return open_as(fs::absolute(path).string(), flags_for(mode));
    }
    return core::unexpected(core::ErrorCode::WriteFailed,
                            "the last program that wrote to it did not end in order, and its folder is read-only; open "
                            "it once with the folder writable",
                            path.string());
}

core::Result<void> Database::use_write_ahead_log(int busy_timeout_ms) const {
    // SQLite does not wait for another program's lock here.
    constexpr int kPause_ms = 5;
    for (int waited_ms = 0;; waited_ms += kPause_ms) {
        const int code = sqlite3_exec(connection_->handle, "PRAGMA journal_mode = WAL", nullptr, nullptr, nullptr);
        if (code == SQLITE_OK) return {};
        if ((code & 0xff) != SQLITE_BUSY || waited_ms >= busy_timeout_ms) return connection_->failure();
        sqlite3_sleep(kPause_ms);
    }
}

core::Result<void> Database::execute(const std::string& sql) const {
    if (sqlite3_exec(connection_->handle, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
        return connection_->failure();
    }
    return {};
}

core::Result<std::int64_t> Database::integer(const std::string& sql) const {
    core::Result<Statement> statement = prepare(sql);
    if (!statement) return core::unexpected(statement.error());
    const core::Result<bool> row = statement->step();
    if (!row) return core::unexpected(row.error());
    return *row ? statement->integer(0) : 0;
}

core::Result<Statement> Database::prepare(std::string_view sql) const {
    sqlite3_stmt* statement = nullptr;
    const int code =
        sqlite3_prepare_v2(connection_->handle, sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    if (code != SQLITE_OK) return connection_->failure();
    return Statement(connection_, statement);
}

std::int64_t Database::last_insert_id() const {
    return sqlite3_last_insert_rowid(connection_->handle);
}

const std::string& Database::where() const {
    return connection_->where;
}

}  // namespace db
