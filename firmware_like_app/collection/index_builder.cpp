#include "firmware_like_app/collection/index_builder.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <unordered_map>

#include "core/exchange/mesh_reader.hpp"
#include "firmware_like_app/collection/likeness_lists.hpp"
#include "firmware_like_app/collection/memory_gate.hpp"
#include "firmware_like_app/collection/ordered_work.hpp"
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

constexpr std::size_t kBatchModels = 16;
constexpr double kBatchMs = 500.0;
constexpr std::size_t kWindow = 96;
constexpr std::uint64_t kBytesAtOnce = 64ULL << 20;

constexpr const char* kGoneStale =
    "described with other settings and kept as it is, for the file is gone; bring it back and build again, or remove "
    "the model";
constexpr const char* kGoneDamaged =
    "damaged in the index, and the file is gone; bring it back and build again, or remove the model";

/// What became of one file.
struct Outcome {
    enum class Kind { Unchanged, Described, Failed, Interrupted };
    Kind kind = Kind::Interrupted;
    db::ModelRecord record;
    std::string class_name;
    std::string why;
};

/// What the index has of one file.
struct Known {
    db::ModelEntry entry;
    bool damaged = false;

    [[nodiscard]] bool is_current(const FileContent& content) const {
        return !damaged && !entry.stale && entry.content_hash == content.hash && entry.file_size == content.size;
    }
};

class Builder {
  public:
    Builder(const IndexBuildOptions& options, db::TwoViewIndex& index, std::stop_token stop)
        : options_(options), index_(index), stop_(std::move(stop)) {
        for (const core::LabelledFile& file : options.classes) class_of_[canonical_path(file.path)] = file.class_name;
    }

    core::Result<IndexBuildReport> build(ModelFiles found, const std::function<void(IndexBuildProgress)>& progress) {
        if (const core::Result<void> known = look_up_known(found.files); !known) return core::unexpected(known.error());
        report_.failed = std::move(found.unreadable);
        const std::vector<std::string>& files = found.files;
        core::Result<void> stored;
        work_in_order(
            files.size(), options_.jobs, kWindow, [&](std::size_t i) { return work(files[i]); },
            [&](std::size_t i, Outcome outcome) {
                if (!take(files[i], std::move(outcome))) return false;
                if (batch_.size() >= kBatchModels || since_stored_.ms() > kBatchMs) stored = store();
                if (progress) progress({.done = i + 1, .total = files.size(), .failed = &report_.failed});
                return stored.has_value();
            });
        if (stored) stored = store();
        if (!stored) return core::unexpected(stored.error());
        return std::move(report_);
    }

  private:
    /// Notes what the index has. Stale and damaged models are worked on too, or kept where their files are gone.
    core::Result<void> look_up_known(std::vector<std::string>& files) {
        core::Result<std::vector<db::ModelEntry>> entries = index_.list();
        if (!entries) return core::unexpected(entries.error());
        const core::Result<std::vector<std::int64_t>> damaged = index_.damaged_models();
        if (!damaged) return core::unexpected(damaged.error());
        const std::size_t asked_for = files.size();
        const auto is_asked_for = [&](const std::string& path) {
            return std::binary_search(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(asked_for), path);
        };
        for (db::ModelEntry& entry : *entries) {
            const bool is_damaged = std::binary_search(damaged->begin(), damaged->end(), entry.id);
            std::error_code missing;
            if ((entry.stale || is_damaged) && !is_asked_for(entry.source_path)) {
                if (fs::exists(entry.source_path, missing)) {
                    files.push_back(entry.source_path);
                } else {
                    report_.kept.push_back({entry.source_path, is_damaged ? kGoneDamaged : kGoneStale});
                }
            }
            std::string path = entry.source_path;
            known_.emplace(std::move(path), Known{std::move(entry), is_damaged});
        }
        std::sort(files.begin(), files.end());
        return {};
    }

    [[nodiscard]] const Known* known(const std::string& path) const {
        const auto it = known_.find(path);
        return it == known_.end() ? nullptr : &it->second;
    }

    [[nodiscard]] std::string class_of(const std::string& path) const {
        if (const auto it = class_of_.find(path); it != class_of_.end()) return it->second;
        const Known* model = known(path);
        return model != nullptr ? model->entry.class_name : std::string();
    }

    /// On a worker's thread: everything but storing.
    Outcome work(const std::string& path) {
        Outcome outcome;
        outcome.class_name = class_of(path);
        if (stop_.stop_requested()) return outcome;
        const core::Result<FileContent> content = content_of(path);
        if (!content) return failed(std::move(outcome), content.error());
        if (const Known* model = known(path); model != nullptr && model->is_current(*content)) {
            outcome.kind = Outcome::Kind::Unchanged;
            return outcome;
        }
        const MemoryGate::Pass pass(gate_, content->size);
        if (stop_.stop_requested()) return outcome;
        core::Result<core::TriangleMesh> mesh = core::read_mesh(path);
        if (!mesh) return failed(std::move(outcome), mesh.error());
        db::ModelRecord& record = outcome.record;
        record.name = model_name(fs::path(path).stem().string(), outcome.class_name);
        record.class_name = outcome.class_name;
        record.source_path = path;
        record.content_hash = content->hash;
        record.file_size = content->size;
        const core::Result<void> described = describe_model(std::move(*mesh), options_.parameters, record, stop_);
        if (!described) return failed(std::move(outcome), described.error());
        outcome.kind = Outcome::Kind::Described;
        return outcome;
    }

    static Outcome failed(Outcome outcome, const core::Error& error) {
        // A reader that Ctrl-C has ended says nothing about the file.
        if (error.code == core::ErrorCode::Cancelled) return outcome;
        outcome.kind = Outcome::Kind::Failed;
        outcome.why = error.message;
        return outcome;
    }

    /// False when the build was interrupted at this file. What others have described beyond it is dropped, so that a
    /// later build gives the same ids as one in one go.
    bool take(const std::string& path, Outcome outcome) {
        switch (outcome.kind) {
            case Outcome::Kind::Interrupted:
                report_.interrupted = true;
                return false;
            case Outcome::Kind::Unchanged:
                ++report_.skipped;
                relabel_if_needed(known(path)->entry, outcome.class_name);
                return true;
            case Outcome::Kind::Failed:
                report_.failed.push_back({path, std::move(outcome.why)});
                return true;
            case Outcome::Kind::Described:
                batch_.push_back(std::move(outcome.record));
                return true;
        }
        return true;
    }

    /// An unchanged file may still have got another class.
    void relabel_if_needed(const db::ModelEntry& entry, const std::string& class_name) {
        if (entry.class_name == class_name) return;
        const std::string name = model_name(fs::path(entry.source_path).stem().string(), class_name);
        if (const auto done = index_.relabel(entry.id, name, class_name); !done) {
            report_.failed.push_back({entry.source_path, done.error().message});
        }
    }

    /// Stores the batch in one transaction; if that is refused, one by one, so that one bad model spoils no other.
    core::Result<void> store() {
        std::vector<db::ModelRecord> batch;
        batch.swap(batch_);
        since_stored_ = Stopwatch();
        if (batch.empty()) return {};
        const auto ids = index_.add_all(batch);
        if (ids) {
            report_.added += static_cast<int>(batch.size());
            return {};
        }
        using core::ErrorCode;
        const ErrorCode code = ids.error().code;
        const bool of_a_model =
            code == ErrorCode::BadArgument || code == ErrorCode::BadOutline || code == ErrorCode::BadMesh;
        if (!of_a_model) return core::unexpected(ids.error());
        for (const db::ModelRecord& record : batch) {
            const auto id = index_.add(record);
            if (id) {
                ++report_.added;
            } else {
                report_.failed.push_back({record.source_path, id.error().message});
            }
        }
        return {};
    }

    const IndexBuildOptions& options_;
    db::TwoViewIndex& index_;
    std::stop_token stop_;
    std::map<std::string, std::string> class_of_;
    std::unordered_map<std::string, Known> known_;
    MemoryGate gate_{kBytesAtOnce};
    std::vector<db::ModelRecord> batch_;
    Stopwatch since_stored_;
    IndexBuildReport report_;
};

/// Brings the neighbour lists up to date, where the index is to have them.
core::Result<void> measure_likeness(const IndexBuildOptions& options, db::TwoViewIndex& index,
                                    const std::stop_token& stop,
                                    const std::function<void(IndexBuildProgress)>& progress, IndexBuildReport& report) {
    const core::Result<std::optional<std::string>> measure = index.likeness_measure();
    if (!measure) return core::unexpected(measure.error());
    if ((!options.likeness && !*measure) || report.interrupted) return {};
    const core::Result<LikenessReport> done =
        update_likeness(index, options.jobs, stop, [&progress](std::size_t models, std::size_t total) {
            if (progress) progress({.done = models, .total = total, .measuring = true});
        });
    if (!done) return core::unexpected(done.error());
    report.measured = done->measured;
    report.interrupted = done->interrupted;
    return {};
}

}  // namespace

core::Result<IndexBuildReport> build_index(const IndexBuildOptions& options, const std::stop_token& stop,
                                           const std::function<void(IndexBuildProgress)>& progress) {
    const Stopwatch watch;
    ModelFiles found = find_model_files(options.paths);
    if (found.files.empty()) {
        const PassedOver first =
            found.unreadable.empty() ? PassedOver{"", "there is no path; name a folder"} : found.unreadable.front();
        return core::unexpected(core::ErrorCode::FileMissing, first.why, first.file);
    }
    core::Result<db::TwoViewIndex> index = db::TwoViewIndex::open(options.database, db::OpenMode::Create,
                                                                  {.parameters = parameters_text(options.parameters)});
    if (!index) return core::unexpected(index.error());
    core::Result<IndexBuildReport> report = Builder(options, *index, stop).build(std::move(found), progress);
    if (!report) return report;
    const core::Result<void> measured = measure_likeness(options, *index, stop, progress, *report);
    if (!measured) return core::unexpected(measured.error());
    std::error_code unknown;
    if (!fs::exists(options.database, unknown)) {
        return core::unexpected(core::ErrorCode::WriteFailed,
                                "the index was moved or removed while it was built; build it again", options.database);
    }
    report->ms = watch.ms();
    return report;
}

}  // namespace app
