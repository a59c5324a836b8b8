#pragma once
// Lists of files with their classes: our own, one "path<TAB>class" a line, and the .cla files of the Princeton
// benchmark.

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace core {

struct LabelledFile {
    std::string path;  ///< as a reader takes it: for a .ndjson it may end in ":N"
    std::string class_name;

    friend bool operator==(const LabelledFile&, const LabelledFile&) = default;
};

struct LabelledList {
    std::vector<LabelledFile> files;    ///< what exists, in the list's order
    std::vector<LabelledFile> missing;  ///< what does not: the path looked for, or a .cla's bare number
};

/// Reads a list, whose first word "PSB" tells a .cla file from our own.
/// Own lists: paths are relative to the list's folder, empty lines are passed over, `files_dir` is not used.
/// .cla: number N stands for the file named N or mN with any extension that models, pictures or drawings have, in
/// `files_dir` (the list's folder without it) or one folder below it, one named as the class before all others. Class
/// names are kept; one that comes again below another parent becomes "parent/name". Classes without files are no fault.
/// FileMissing or FileUnreadable for the list or the folder; BadFormat, with the line, for a line without tab, path or
/// class, and for a .cla that ends early or counts wrongly. n log n in files and folder entries.
[[nodiscard]] Result<LabelledList> read_list_file(const std::string& path,
                                                  const std::optional<std::string>& files_dir = {});

}  // namespace core
