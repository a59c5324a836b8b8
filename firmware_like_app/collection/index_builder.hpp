#pragma once
// Folders of model files into the index: only what is new or changed, several workers, whole models only.

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/exchange/list_file.hpp"
#include "firmware_like_app/collection/model_files.hpp"
#include "firmware_like_app/collection/model_views.hpp"

namespace app {

struct IndexBuildOptions {
    std::vector<std::string> paths;           ///< files, and folders to search recursively
    std::vector<core::LabelledFile> classes;  ///< class names by file
    std::string database;
    int jobs = 1;
    bool likeness = false;  ///< measure which models are near to which; an index that has this keeps it up to date
    ViewParameters parameters;
};

struct IndexBuildReport {
    int added = 0;    ///< new, changed, or stale and described again
    int skipped = 0;  ///< unchanged
    std::vector<PassedOver> failed;
    int measured = 0;              ///< models whose nearest others were looked for
    std::vector<PassedOver> kept;  ///< stale or damaged, but their files are gone: left as they are
    bool interrupted = false;
    double ms = 0.0;
};

struct IndexBuildProgress {
    std::size_t done = 0;  ///< files, or models
    std::size_t total = 0;
    const std::vector<PassedOver>* failed = nullptr;  ///< so far; only while it is told
    bool measuring = false;  ///< models are described; who is near to whom is being measured (likeness_lists.hpp)
};

/// Adds in the order of paths, so that ids do not depend on the number of jobs, nor on whether a build was interrupted,
/// or killed, and called again. A bad file or folder is reported and passed over; a model keeps its class where
/// `classes` names none. Models in the index that were described with other parameters are described again, wherever
/// their files are. What is added is durable after 16 models or half a second; `stop` is looked at before
/// each file, and what was described until then is kept. Files of together more than 64 MB are not read at the same
/// time. FileMissing when there is nothing to read at all; the index's own errors (NotAnIndex, NewerVersion,
/// WriteFailed …), with what was added before still in it.
[[nodiscard]] core::Result<IndexBuildReport> build_index(const IndexBuildOptions& options, const std::stop_token& stop,
                                                         const std::function<void(IndexBuildProgress)>& progress);

/// What people read: "chair-rocking-chair" of class "chair" is a "Rocking chair".
[[nodiscard]] std::string model_name(const std::string& file_stem, const std::string& class_name);

}  // namespace app
