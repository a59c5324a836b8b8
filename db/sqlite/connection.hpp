#pragma once
// One SQLite connection, shared by the Database, its statements and its transactions so that it closes after the last.
// Of use inside db/sqlite only.

#include <string>

#include "core/base/result.hpp"
#include "db/sqlite/database.hpp"

struct sqlite3;

namespace db {

struct Connection {
    sqlite3* handle = nullptr;
    std::string where;  ///< the path as the caller spelt it, for messages
    DatabaseWords words;

    Connection(sqlite3* opened, std::string path, const DatabaseWords& called);
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection();

    /// The connection's last failure as an Error: what a person can do for the usual ones, SQLite's words for the rest.
    [[nodiscard]] core::Unexpected failure() const;
    /// True after SQLite gave up a transaction by itself, or when none was begun.
    [[nodiscard]] bool outside_transaction() const;
};

/// The Error for an extended SQLite result code; `detail` are SQLite's own words.
[[nodiscard]] core::Error describe_failure(int extended_code, const std::string& detail, const std::string& where,
                                           const DatabaseWords& words);

}  // namespace db
