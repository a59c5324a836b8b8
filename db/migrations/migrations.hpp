#pragma once
// The shape of the database, as numbered SQL files that are applied in order and counted by user_version.
// A file NNNN_name.sql of this folder is compiled into the library; what was once released is never edited again.

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/base/result.hpp"
#include "db/sqlite/database.hpp"

namespace db {

/// "CRQS": the application_id that marks a SQLite file as ours.
inline constexpr std::uint32_t kApplicationId = 0x43525153;

/// Bytes a page of a new database.
inline constexpr int kPageSize = 16384;

struct Migration {
    const char* name;  ///< "0001_two_view_index"
    const char* sql;
};

/// All of them, in order; the n-th brings a database from user_version n-1 to n.
[[nodiscard]] std::span<const Migration> migrations();

/// The user_version that this program reads and writes.
[[nodiscard]] int newest_version();

struct CollectionOptions {
    int busy_timeout_ms = 5000;  ///< how long to wait for another program's lock
    std::int64_t max_pages = 0;  ///< largest size in pages (kPageSize); 0: as much as the disk holds
};

/// Opens a database of ours and brings it to the newest version (all pending migrations in one transaction), unless it
/// is opened read-only, where an older version is refused. Errors of Database::open, and DatabaseFailed for that.
[[nodiscard]] core::Result<Database> open_collection(const std::filesystem::path& path, OpenMode mode,
                                                     const CollectionOptions& options = {});

}  // namespace db
