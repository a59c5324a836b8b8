#include "firmware_like_app/collection/kept_collection.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "firmware_like_app/collection/index_builder.hpp"
#include "firmware_like_app/collection/sketch_searcher.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"

namespace app {
namespace {

constexpr std::size_t kReloadModels = 100;  // results grow in such steps while an empty collection is read
constexpr std::size_t kMostProblems = 200;
constexpr double kTellAfter_ms = 3'000;  // a rest is not guessed sooner

std::optional<std::int64_t> changed_s(const std::string& database) {
    std::error_code error;
    const auto when = std::filesystem::last_write_time(database, error);
    if (error) return std::nullopt;
    const auto system = std::chrono::file_clock::to_sys(when);
    return std::chrono::duration_cast<std::chrono::seconds>(system.time_since_epoch()).count();
}

/// Whether all that is there was described with other parameters than this program's.
bool all_stale(const std::string& database) {
    const core::Result<db::TwoViewIndex> index =
        db::TwoViewIndex::open(database, db::OpenMode::ReadOnly, {.parameters = parameters_text(ViewParameters{})});
    if (!index) return false;
    const core::Result<db::IndexInfo> info = index->info();
    return info && info->models > 0 && info->stale_models == info->models;
}

std::vector<std::string> sources_of(const std::string& database) {
    std::vector<std::string> paths;
    const core::Result<db::TwoViewIndex> index = db::TwoViewIndex::open(database, db::OpenMode::ReadOnly);
    if (!index) return paths;
    const core::Result<std::vector<db::ModelEntry>> entries = index->list();
    if (!entries) return paths;
    for (const db::ModelEntry& entry : *entries) paths.push_back(entry.source_path);
    return paths;
}

}  // namespace

KeptCollection::KeptCollection(Options options) : options_(std::move(options)) {
    status_.can_add = !options_.database.empty();
    reload(true);
    if (status_.can_add && !options_.models.empty()) {
        {
            const std::lock_guard lock(mutex_);
            const bool nothing = status_.state == CollectionState::Missing || status_.state == CollectionState::Empty;
            if (nothing) status_.state = CollectionState::Building;
        }
        begin({options_.models});
    }
}

KeptCollection::~KeptCollection() {
    thread_.request_stop();
}

/// Opens the index as it is now, beside the searches.
void KeptCollection::reload(bool all_is_read) {
    CollectionState state = CollectionState::Empty;
    std::shared_ptr<SketchSearcher> opened;
    std::vector<std::string> problems;
    if (!options_.database.empty()) {
        core::Result<std::unique_ptr<SketchSearcher>> searcher =
            SketchSearcher::open(options_.database, options_.jobs, options_.best_count);
        if (!searcher) {
            problems.push_back(searcher.error().sentence());
            const bool missing = searcher.error().code == core::ErrorCode::FileMissing;
            state = missing ? CollectionState::Missing : CollectionState::Damaged;
        } else {
            opened = std::move(*searcher);
            for (const std::string& warning : opened->collection().warnings()) {
                if (problems.size() < kMostProblems) problems.push_back(options_.database + ": " + warning);
            }
            if (!opened->collection().models().empty()) state = CollectionState::Ready;
            if (state == CollectionState::Ready && all_stale(options_.database)) {
                state = CollectionState::Stale;
                opened.reset();
            }
        }
    }
    const std::int64_t models = opened ? static_cast<std::int64_t>(opened->collection().models().size()) : 0;
    if (state == CollectionState::Ready) searcher_.replace(opened);
    if (state != CollectionState::Ready) searcher_.replace(nullptr);
    const std::lock_guard lock(mutex_);
    const bool still_read = !all_is_read && status_.importing && status_.state == CollectionState::Building;
    status_.state = still_read ? CollectionState::Building : state;
    status_.models = models;
    status_.views = 2 * models;
    status_.changed_s = changed_s(options_.database);
    status_.problems = std::move(problems);
}

CollectionStatus KeptCollection::status() const {
    const std::lock_guard lock(mutex_);
    CollectionStatus status = status_;
    status.median_search_ms = searcher_.median_ms();
    return status;
}

void KeptCollection::add(const std::string& folder) {
    begin({folder});
}

void KeptCollection::update() {
    begin(sources_of(options_.database));
}

void KeptCollection::stop() {
    thread_.request_stop();
}

void KeptCollection::begin(std::vector<std::string> paths) {
    {
        const std::lock_guard lock(mutex_);
        if (status_.importing || !status_.can_add) return;
        status_.importing = true;
        status_.done = status_.total = status_.unreadable = 0;
        status_.minutes_left.reset();
        status_.ended.reset();
    }
    thread_ = std::jthread([this, paths = std::move(paths)](const std::stop_token& stop) { import(paths, stop); });
}

void KeptCollection::import(const std::vector<std::string>& paths, const std::stop_token& stop) {
    IndexBuildOptions build;
    build.paths = paths;
    build.database = options_.database;
    build.jobs = 1;  // the other cores are the visitors'
    const Stopwatch watch;
    std::size_t next_reload = kReloadModels;
    const core::Result<IndexBuildReport> report = build_index(build, stop, [&](IndexBuildProgress progress) {
        bool reading = false;
        {
            const std::lock_guard lock(mutex_);
            status_.done = static_cast<std::int64_t>(progress.done);
            status_.total = static_cast<std::int64_t>(progress.total);
            if (progress.failed != nullptr) {  // said at once; all of them again when it is over
                for (auto i = static_cast<std::size_t>(status_.unreadable); i < progress.failed->size(); ++i) {
                    const PassedOver& file = (*progress.failed)[i];
                    if (status_.problems.size() < kMostProblems)
                        status_.problems.push_back(file.file + ": " + file.why);
                }
                status_.unreadable = static_cast<std::int64_t>(progress.failed->size());
            }
            if (progress.done > 0 && watch.ms() > kTellAfter_ms) {
                const double left_ms = watch.ms() / static_cast<double>(progress.done) *
                                       static_cast<double>(progress.total - progress.done);
                status_.minutes_left = std::max(1, static_cast<int>(std::ceil(left_ms / 60'000)));
            }
            reading = status_.state == CollectionState::Building;
        }
        if (!reading || progress.done < next_reload) return;
        next_reload = progress.done + kReloadModels;
        reload(false);
    });
    CollectionStatus::Ended ended;
    if (report) {
        ended = {report->added, report->skipped, static_cast<std::int64_t>(report->failed.size()), ""};
    } else {
        ended.failure = report.error().sentence();
    }
    reload(true);
    const std::lock_guard lock(mutex_);
    if (report) {
        for (const PassedOver& file : report->failed) {
            if (status_.problems.size() < kMostProblems) status_.problems.push_back(file.file + ": " + file.why);
        }
    }
    status_.importing = false;
    status_.ended = std::move(ended);
}

}  // namespace app
