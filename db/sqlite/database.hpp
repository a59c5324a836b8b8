#pragma once
// A SQLite file that is ours, opened. Nothing is written to a file that is not: its first bytes are read before SQLite
// sees it, because SQLite may fold a left-over log into a file that it opens, and closes, for reading.
//
// Use one Database per thread. Readers and one writer, in one process or several, do not wait for each other.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.hpp"
#include "db/sqlite/statement.hpp"

namespace db {

enum class OpenMode {
    ReadOnly,   ///< the file must exist; works in a read-only folder too, if the last writer ended in order
    ReadWrite,  ///< the file must exist
    Create,     ///< as ReadWrite; a missing or empty file becomes a new database
};

/// How sentences about a file call it, and what they advise.
struct DatabaseWords {
    const char* thing = "index";  ///< "it is no Croquis …"
    const char* make = "make the index with `croquis index build`";
    const char* mend = "restore a copy, or move it away and build the index again";
    const char* renew = "build a new index";
};

struct DatabaseOptions {
    std::uint32_t application_id = 0;  ///< a file with another one is refused
    int newest_version = 0;            ///< a file with a larger user_version is refused
    int busy_timeout_ms = 5000;        ///< how long to wait for another program's lock
    std::int64_t max_pages = 0;        ///< largest size in pages; 0: as much as the disk holds
    DatabaseWords words = {};
};

class Database {
  public:
    /// Foreign keys on, synchronous FULL. The schema is not touched, so a created database is empty.
    /// FileMissing, FileUnreadable (a folder, no permission), NotAnIndex (no SQLite file, or one of another program),
    /// NewerVersion, Damaged, WriteFailed (read-only file or folder, opened for writing), DatabaseFailed.
    [[nodiscard]] static core::Result<Database> open(const std::filesystem::path& path, OpenMode mode,
                                                     const DatabaseOptions& options);

    /// Changes over to the write-ahead log, for good; waits so long for another program's lock. Where the file system
    /// has no shared memory, nothing changes.
    [[nodiscard]] core::Result<void> use_write_ahead_log(int busy_timeout_ms) const;

    /// Runs statements that give no rows, several if separated by semicolons; stops at the first failure.
    [[nodiscard]] core::Result<void> execute(const std::string& sql) const;
    /// The first column of the first row; 0 where there is none.
    [[nodiscard]] core::Result<std::int64_t> integer(const std::string& sql) const;
    [[nodiscard]] core::Result<Statement> prepare(std::string_view sql) const;

    /// The id that the last INSERT of this connection gave.
    [[nodiscard]] std::int64_t last_insert_id() const;
    /// The path as it was given to open, for messages.
    [[nodiscard]] const std::string& where() const;

    /// For Transaction.
    [[nodiscard]] const std::shared_ptr<const Connection>& connection() const { return connection_; }

  private:
    explicit Database(std::shared_ptr<const Connection> connection);
    std::shared_ptr<const Connection> connection_;
};

}  // namespace db
