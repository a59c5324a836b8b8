#pragma once
// The shapes of our databases, as numbered SQL files that are applied in order and counted by user_version: the
// collection of models (this folder) and the garment designs (designs/).
// A file NNNN_name.sql is compiled into the library; what was once released is never edited again.

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/base/result.hpp"
#include "db/sqlite/database.hpp"

namespace db {

/// "CRQS" and "CRQG": the application_ids that mark a SQLite file as our collection, and as our designs.
inline constexpr std::uint32_t kApplicationId = 0x43525153;
inline constexpr std::uint32_t kDesignsApplicationId = 0x43525147;

/// Bytes a page of a new database.
inline constexpr int kPageSize = 16384;
inline constexpr int kDesignsPageSize = 4096;

struct Migration {
    const char* name;  ///< "0001_two_view_index"
    const char* sql;
};

/// All of them, in order; the n-th brings a database from user_version n-1 to n.
[[nodiscard]] std::span<const Migration> migrations();
[[nodiscard]] std::span<const Migration> design_migrations();

/// The user_version of a collection that this program reads and writes.
[[nodiscard]] int newest_version();

struct CollectionOptions {
    int busy_timeout_ms = 5000;  ///< how long to wait for another program's lock
    std::int64_t max_pages = 0;  ///< largest size in pages; 0: as much as the disk holds
};

/// Opens a database of ours and brings it to the newest version (all pending migrations in one transaction), unless it
/// is opened read-only, where an older version is refused. Errors of Database::open, and DatabaseFailed for that.
[[nodiscard]] core::Result<Database> open_collection(const std::filesystem::path& path, OpenMode mode,
                                                     const CollectionOptions& options = {});
[[nodiscard]] core::Result<Database> open_designs(const std::filesystem::path& path, OpenMode mode,
                                                  const CollectionOptions& options = {});

}  // namespace db
