#pragma once
// A whole file as bytes, with a limit, so that no file can fill the memory.

#include <cstddef>
#include <string>

#include "core/base/result.hpp"

namespace core {

/// Largest file that the readers of pictures and drawings take, in bytes.
inline constexpr std::size_t kMaxSketchFileBytes = 256u << 20;

/// That `path` is an ordinary file that may be read; asked before one is opened, for a pipe would be waited for and a
/// device never ends. FileMissing when there is none; FileUnreadable for a folder, a device, a pipe, a file without
/// permission. Errors carry the path in `where`.
[[nodiscard]] Result<void> check_ordinary_file(const std::string& path);

/// The bytes of the file at `path`, as a string because most readers want text.
/// Errors as check_ordinary_file, and FileUnreadable for a file that fails while being read, or one larger than
/// `max_bytes`. Errors carry the path in `where`. Linear time; no more than the file's size in
/// memory.
[[nodiscard]] Result<std::string> read_file_bytes(const std::string& path, std::size_t max_bytes = kMaxSketchFileBytes);

/// The part of a file name after its last dot, in lower case and without the dot; empty when there is none.
[[nodiscard]] std::string lower_extension(const std::string& path);

}  // namespace core
