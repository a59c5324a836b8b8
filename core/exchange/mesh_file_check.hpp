#pragma once
// Looks at a model file before a third-party reader does, so that no lie in it costs memory or time.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace core {

/// The extension of a path in lower case, without the dot; empty when there is none.
[[nodiscard]] std::string lower_extension(const std::filesystem::path& path);

/// That `path` is an ordinary file, not empty and of at most `most_bytes`. Errors: FileMissing, FileUnreadable,
/// BadFormat.
[[nodiscard]] Result<void> check_plain_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// The whole file. Errors as check_plain_file, and FileUnreadable when it cannot be opened or read to its end.
[[nodiscard]] Result<std::string> read_plain_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// That the first bytes of a file fit its extension and that the numbers of elements they promise fit its size.
/// `head` is the beginning of the file, of a megabyte or all of it. Refused are archives under another name
/// (UnknownFormat), text formats with zero bytes, PLY and binary STL files shorter than their own counts, and glTF with
/// counts beyond `most_elements` (BadFormat). Formats it knows nothing about pass.
[[nodiscard]] Result<void> check_mesh_head(std::string_view extension, std::string_view head, std::uintmax_t file_bytes,
                                           std::size_t most_elements);

}  // namespace core
