#pragma once
// Which model files an index is built from, and what identifies the content of each.

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace app {

/// A file or folder that was passed over, and why.
struct PassedOver {
    std::string file;
    std::string why;
};

struct ModelFiles {
    std::vector<std::string> files;      ///< full paths, sorted, each once
    std::vector<PassedOver> unreadable;  ///< paths that are not there, folders without models or without permission
};

/// The one spelling of a path by which an index knows it: absolute, without links and dots.
[[nodiscard]] std::string canonical_path(const std::string& path);

/// Files as they are named, folders searched recursively for the extensions of core::mesh_extensions(); links to
/// folders are not followed.
[[nodiscard]] ModelFiles find_model_files(const std::vector<std::string>& paths);

struct FileContent {
    std::uint64_t hash = 0;  ///< FNV-1a
    std::uint64_t size = 0;  ///< bytes
};

/// Reads the file block by block; one that is larger than what is read as a model is refused before a byte is read.
/// Errors of core::check_plain_file, and FileUnreadable.
[[nodiscard]] core::Result<FileContent> content_of(const std::string& path);

}  // namespace app
