#pragma once
// Files on a stick, all of them or none, never over others, and on the stick before anybody says so.

#include <functional>
#include <span>
#include <stop_token>
#include <string>

#include "core/base/result.hpp"
#include "firmware_like_app/garment/export_files.hpp"
#include "firmware_like_app/garment/stick_finder.hpp"

namespace app {

/// What went wrong, for the screen's words, and in a sentence.
struct ExportFault {
    enum class Kind { Nothing, NoPlace, Full, Gone, ReadOnly, Cancelled, Failed };
    Kind kind = Kind::Failed;
    core::Error error;
};

/// `name` as every file system takes it: without / \ : * ? " < > | and control characters, 60 bytes at most, never
/// empty.
[[nodiscard]] std::string safe_name(std::string name);

struct FolderReport {
    std::filesystem::path folder;  ///< place/name, place/name-2 …
    std::optional<ExportFault> fault;
};

/// Writes the files into a new folder of the place: under another name first, each flushed to the disk, then renamed in
/// one go. After a fault nothing of it is left, as far as the place is still there; what a pulled stick kept goes with
/// the next call. `progress`: share of the bytes, 0 … 1.
[[nodiscard]] FolderReport write_new_folder(const ExportPlace& place, const std::string& name,
                                            std::span<const NamedBytes> files,
                                            const std::function<void(double)>& progress = {},
                                            const std::stop_token& stop = {});

}  // namespace app
