#pragma once
// What a file is, from its first bytes and its permissions, before SQLite is let near it. Of use inside db/sqlite only.

#include <filesystem>

#include "core/base/result.hpp"
#include "db/sqlite/database.hpp"

namespace db {

enum class FileState {
    Absent,  ///< no such file, or an empty one
    Ours,    ///< a SQLite file with our application_id and a version we know, as far as its first page tells
};

/// Refuses, with the errors of Database::open, whatever must not be opened in this mode. Only reads.
[[nodiscard]] core::Result<FileState> examine_file(const std::filesystem::path& path, OpenMode mode,
                                                   const DatabaseOptions& options);

/// True where no log or journal lies beside the file, so that the file alone is the whole database.
[[nodiscard]] bool is_complete_by_itself(const std::filesystem::path& path);

/// A `file:` URI by which SQLite reads the file without locks and without files beside it.
[[nodiscard]] std::string immutable_uri(const std::filesystem::path& path);

[[nodiscard]] core::Error not_ours(const std::string& where, const DatabaseWords& words);
[[nodiscard]] core::Error newer_version(std::int64_t version, const DatabaseOptions& options, const std::string& where);

}  // namespace db
