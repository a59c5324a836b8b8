#pragma once
// Looks at what a ZIP archive says it unpacks to, before anything unpacks it.

#include <cstdint>
#include <filesystem>

#include "core/base/result.hpp"

namespace core {

/// That the archive's directory is whole and that its members unpack to at most `most_bytes` together. Readers set
/// memory aside by these numbers, so a member that is larger than it says is cut off and harms nobody. BadFormat for a
/// file without a directory, BadMesh for too much (also in members of 4 GB or more), FileUnreadable. Reads the end of
/// the file and the directory, 16 MB of it at most. After PKWARE's APPNOTE, sections 4.3.12 and 4.3.16.
[[nodiscard]] Result<void> check_zip(const std::filesystem::path& path, std::uintmax_t most_bytes);

}  // namespace core
