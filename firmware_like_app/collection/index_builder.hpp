#pragma once
// Folders of model files into the index: only what is new or changed, several workers, whole models only.

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/exchange/list_file.hpp"
#include "firmware_like_app/collection/model_views.hpp"

namespace app {

struct IndexBuildOptions {
    std::vector<std::string> paths;           ///< files, and folders to search recursively
    std::vector<core::LabelledFile> classes;  ///< class names by file
    std::string database;
    int jobs = 1;
    ViewParameters parameters;
};

struct IndexBuildFailure {
    std::string file;
    std::string why;
};

struct IndexBuildReport {
    int added = 0;
    int skipped = 0;  ///< unchanged
    std::vector<IndexBuildFailure> failed;
    bool interrupted = false;
    double ms = 0.0;
};

struct IndexBuildProgress {
    std::size_t done = 0;
    std::size_t total = 0;
};

/// Adds in the order of paths, so that ids do not depend on the number of jobs. A bad file is reported and passed over.
/// Looks at `stop` after every few models; what was added stays. FileMissing for a path that is not there; the index's
/// own errors.
[[nodiscard]] core::Result<IndexBuildReport> build_index(const IndexBuildOptions& options, std::stop_token stop,
                                                         const std::function<void(IndexBuildProgress)>& progress);

/// What people read: "chair-rocking-chair" of class "chair" is a "Rocking chair".
[[nodiscard]] std::string model_name(const std::string& file_stem, const std::string& class_name);

}  // namespace app
