#include "firmware_like_app/commands/eval_lists.hpp"

#include <cstdio>
#include <mutex>

#include "firmware_like_app/collection/sketch_description.hpp"
#include "firmware_like_app/commands/progress_bar.hpp"

namespace app {

core::Result<core::LabelledList> read_list(const EvalOptions& options) {
    std::optional<std::string> files;
    if (!options.files.empty()) files = options.files;
    core::Result<core::LabelledList> list = core::read_list_file(options.list, files);
    if (!list) return core::unexpected(list.error());
    if (list->files.empty()) {
        return core::unexpected(
            core::ErrorCode::FileMissing,
            list->missing.empty() ? "the list names no file; give one path<TAB>class a line"
                                  : "none of the files that it names is there; check the paths, which are relative to "
                                    "the list, or --files",
            options.list);
    }
    for (const core::LabelledFile& missing : list->missing) {
        if (list->missing.size() > 20) break;
        std::fprintf(stderr, "croquis: %s: listed but not there; it is left out\n", missing.path.c_str());
    }
    if (list->missing.size() > 20)
        std::fprintf(stderr, "croquis: %zu listed files are not there; they are left out\n", list->missing.size());
    return list;
}

namespace {

/// What `describe` makes of the files, in their order; what it cannot describe goes to `failures` and standard error.
template <typename Described, typename Describe>
std::vector<Described> describe_all(const std::vector<core::LabelledFile>& files, int jobs, const Describe& describe,
                                    std::vector<std::string>& classes, std::vector<std::string>& failures) {
    std::vector<std::optional<core::Result<Described>>> found(files.size());
    {
        ProgressBar bar("described");
        std::mutex bar_mutex;
        std::size_t done = 0;
        core::parallel_for(files.size(), jobs, [&](std::size_t i, int) {
            found[i].emplace(describe(files[i].path));
            const std::lock_guard lock(bar_mutex);
            bar.show(++done, files.size());
        });
    }
    std::vector<Described> out;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!*found[i]) {
            failures.push_back(found[i]->error().sentence());
            std::fprintf(stderr, "croquis: %s\n", failures.back().c_str());
            continue;
        }
        classes.push_back(files[i].class_name);
        out.push_back(std::move(**found[i]));
    }
    return out;
}

core::Result<core::ComparableShape> shape_of(const std::string& path) {
    const core::Result<SketchDescription> d = describe_file(path);
    if (!d) return core::unexpected(d.error());
    return core::comparable(d->shape.descriptor, d->contour);
}

core::Result<std::vector<core::ComparableShape>> readings_of(const std::string& path) {
    const core::Result<std::vector<SketchDescription>> readings = describe_file_readings(path);
    if (!readings) return core::unexpected(readings.error());
    return comparable(*readings);
}

}  // namespace

DescribedList describe_list(const std::vector<core::LabelledFile>& files, int jobs) {
    DescribedList out;
    out.shapes = describe_all<core::ComparableShape>(files, jobs, shape_of, out.classes, out.failures);
    return out;
}

DescribedSketches describe_sketches(const std::vector<core::LabelledFile>& files, int jobs) {
    DescribedSketches out;
    out.sketches =
        describe_all<std::vector<core::ComparableShape>>(files, jobs, readings_of, out.classes, out.failures);
    return out;
}

core::Result<Collection> load_for_eval(const std::string& database) {
    core::Result<Collection> collection = Collection::load(database);
    if (!collection) return collection;
    for (const std::string& warning : collection->warnings()) {
        std::fprintf(stderr, "croquis: %s: %s\n", database.c_str(), warning.c_str());
    }
    if (collection->models().empty()) {
        return core::unexpected(core::ErrorCode::FileMissing,
                                "the index has no models; add some with croquis index build", database);
    }
    return collection;
}

nlohmann::ordered_json to_json(const core::RetrievalMetrics& m) {
    return {{"NN", m.nn},
            {"FT", m.ft},
            {"ST", m.st},
            {"E", m.e},
            {"DCG", m.dcg},
            {"AP", m.ap},
            {"first_5", m.first_5},
            {"first_10", m.first_10},
            {"precision_recall", m.precision}};
}

void print_metrics(const std::string& name, const core::RetrievalMetrics& m) {
    std::printf("%-28s NN %.3f  FT %.3f  ST %.3f  E %.3f  DCG %.3f  AP %.3f  in first 5 %.3f, 10 %.3f\n", name.c_str(),
                m.nn, m.ft, m.st, m.e, m.dcg, m.ap, m.first_5, m.first_10);
}

}  // namespace app
