#include "firmware_like_app/collection/index_builder.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "core/base/checksum.hpp"
#include "core/base/parallel.hpp"
#include "core/exchange/mesh_reader.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"

namespace app {

namespace fs = std::filesystem;

std::string model_name(const std::string& file_stem, const std::string& class_name) {
    std::string name = file_stem;
    if (name.size() > class_name.size() + 1 && !class_name.empty()) {
        std::string prefix = class_name + "-";
        std::replace(prefix.begin(), prefix.end(), ' ', '-');
        if (name.starts_with(prefix)) name = name.substr(prefix.size());
    }
    std::replace(name.begin(), name.end(), '-', ' ');
    std::replace(name.begin(), name.end(), '_', ' ');
    if (!name.empty() && static_cast<unsigned char>(name[0]) < 128 &&
        name.find_first_of("0123456789") == std::string::npos) {
        name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    }
    return name;
}

namespace {

std::string canonical_text(const fs::path& path) {
    std::error_code error;
    const fs::path full = fs::weakly_canonical(path, error);
    return (error ? path : full).string();
}

core::Result<std::vector<std::string>> files_of(const std::vector<std::string>& paths) {
    std::set<std::string> files;
    for (const std::string& path : paths) {
        std::error_code error;
        if (fs::is_directory(path, error)) {
            for (fs::recursive_directory_iterator it(path, fs::directory_options::skip_permission_denied, error), end;
                 !error && it != end; it.increment(error)) {
                std::error_code ignored;
                if (it->is_regular_file(ignored) && core::has_mesh_extension(it->path())) {
                    files.insert(canonical_text(it->path()));
                }
            }
            if (error) {
                return core::unexpected(core::ErrorCode::FileUnreadable,
                                        "the folder cannot be read; check its permissions", path);
            }
        } else if (fs::exists(path, error)) {
            files.insert(canonical_text(path));
        } else {
            return core::unexpected(core::ErrorCode::FileMissing, "there is no such file or folder; check the path",
                                    path);
        }
    }
    return std::vector<std::string>(files.begin(), files.end());
}

/// What identifies the file's content.
struct Content {
    std::uint64_t hash = 0;
    std::uint64_t size = 0;
};

core::Result<Content> content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return core::unexpected(core::ErrorCode::FileUnreadable, "the file cannot be read; check its permissions",
                                path);
    Content content;
    content.hash = core::fnv1a64({});
    std::vector<char> buffer(1 << 16);
    while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), file.gcount() > 0) {
        const std::span<const char> read(buffer.data(), static_cast<std::size_t>(file.gcount()));
        content.hash = core::fnv1a64(std::as_bytes(read), content.hash);
        content.size += read.size();
    }
    return content;
}

/// One file on its way through a worker.
struct Job {
    std::string path;
    std::string class_name;
    std::optional<db::ModelRecord> record;
    bool unchanged = false;
    std::string why;
};

void describe_job(Job& job, const Content& content, const ViewParameters& parameters) {
    const core::Result<core::TriangleMesh> mesh = core::read_mesh(job.path);
    if (!mesh) {
        job.why = mesh.error().message;
        return;
    }
    db::ModelRecord record;
    record.name = model_name(fs::path(job.path).stem().string(), job.class_name);
    record.class_name = job.class_name;
    record.source_path = job.path;
    record.content_hash = content.hash;
    record.file_size = content.size;
    const core::Result<void> described = describe_model(*mesh, parameters, record);
    if (described) {
        job.record = std::move(record);
    } else {
        job.why = described.error().message;
    }
}

/// Adds what the jobs made, one transaction for all; if that is refused, one by one, so that one bad model spoils no
/// other.
core::Result<void> store(std::vector<Job>& jobs, db::TwoViewIndex& index, IndexBuildReport& report) {
    std::vector<db::ModelRecord> records;
    for (Job& job : jobs) {
        report.skipped += job.unchanged ? 1 : 0;
        if (!job.why.empty()) report.failed.push_back({job.path, job.why});
        if (job.record) records.push_back(std::move(*job.record));
    }
    if (records.empty()) return {};
    const auto ids = index.add_all(records);
    if (ids) {
        report.added += static_cast<int>(records.size());
        return {};
    }
    if (ids.error().code == core::ErrorCode::WriteFailed || ids.error().code == core::ErrorCode::DatabaseFailed) {
        return core::unexpected(ids.error());
    }
    for (const db::ModelRecord& record : records) {
        const auto id = index.add(record);
        if (id) {
            ++report.added;
        } else {
            report.failed.push_back({record.source_path, id.error().message});
        }
    }
    return {};
}

/// An unchanged file may still have got another class.
void relabel_if_needed(db::TwoViewIndex& index, const Job& job) {
    const auto entry = index.find(job.path);
    if (!entry || !*entry || (*entry)->class_name == job.class_name || job.class_name.empty()) return;
    (void)index.relabel((*entry)->id, model_name(fs::path(job.path).stem().string(), job.class_name), job.class_name);
}

}  // namespace

core::Result<IndexBuildReport> build_index(const IndexBuildOptions& options, std::stop_token stop,
                                           const std::function<void(IndexBuildProgress)>& progress) {
    const Stopwatch watch;
    const core::Result<std::vector<std::string>> files = files_of(options.paths);
    if (!files) return core::unexpected(files.error());
    if (files->empty()) {
        return core::unexpected(core::ErrorCode::FileMissing,
                                "there is no 3D model in it; give a folder with OFF, OBJ, STL, PLY, "
                                "glTF, DAE or 3DS files",
                                options.paths.empty() ? "" : options.paths.front());
    }
    core::Result<db::TwoViewIndex> index = db::TwoViewIndex::open(options.database, db::OpenMode::Create,
                                                                  {.parameters = parameters_text(options.parameters)});
    if (!index) return core::unexpected(index.error());
    std::map<std::string, std::string> class_of;
    for (const core::LabelledFile& file : options.classes) class_of[canonical_text(file.path)] = file.class_name;

    constexpr std::size_t kBatch = 32;
    IndexBuildReport report;
    for (std::size_t first = 0; first < files->size() && !report.interrupted; first += kBatch) {
        std::vector<Job> jobs;
        std::vector<Content> contents;
        for (std::size_t i = first; i < std::min(files->size(), first + kBatch); ++i) {
            Job job{(*files)[i], {}, {}, false, {}};
            if (const auto it = class_of.find(job.path); it != class_of.end()) job.class_name = it->second;
            const core::Result<Content> content = content_of(job.path);
            if (!content) {
                job.why = content.error().message;
            } else {
                const core::Result<bool> unchanged = index->is_unchanged(job.path, content->hash, content->size);
                if (!unchanged) return core::unexpected(unchanged.error());
                job.unchanged = *unchanged;
                if (job.unchanged) relabel_if_needed(*index, job);
            }
            contents.push_back(content ? *content : Content{});
            jobs.push_back(std::move(job));
        }
        core::parallel_for(jobs.size(), options.jobs, [&](std::size_t i, int) {
            if (!jobs[i].unchanged && jobs[i].why.empty() && !stop.stop_requested()) {
                describe_job(jobs[i], contents[i], options.parameters);
            }
        });
        const core::Result<void> stored = store(jobs, *index, report);
        if (!stored) return core::unexpected(stored.error());
        report.interrupted = stop.stop_requested();
        if (progress) progress({std::min(files->size(), first + kBatch), files->size()});
    }
    report.ms = watch.ms();
    return report;
}

}  // namespace app
