#include "firmware_like_app/kiosk/garment_body_files.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/exchange/mesh_reader.hpp"
#include "firmware_like_app/garment/design_sources.hpp"
#include "firmware_like_app/kiosk/background.hpp"

namespace app {
namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargest_bytes = 64U << 20;  // of a body: larger files are collections, or mistakes
constexpr std::size_t kMostListed = 2000;
constexpr std::size_t kMostKept = 4;  // bodies in memory

bool by_name(const fs::path& a, const fs::path& b) {
    return a.filename().string() < b.filename().string();
}

}  // namespace

/// One file on its way.
struct GarmentBodyFiles::Reading {
    std::string file;
    bool wanted = true;  // by the screen's thread alone
    std::mutex mutex;
    bool done = false;
    std::string problem;
};

core::Result<core::DressForm> GarmentBodyFiles::Shelf::form(const std::string& file) {
    {
        const std::scoped_lock lock(mutex);
        if (const auto known = forms.find(file); known != forms.end()) return *known->second;
    }
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(file, error);
    if (!error && bytes > kLargest_bytes) {
        return core::unexpected(core::ErrorCode::BadArgument, "the file is too large for a body", file);
    }
    core::Result<core::DressForm> read = bodies_by_file()(file);
    if (!read) return read;
    const std::scoped_lock lock(mutex);
    if (forms.size() >= kMostKept) forms.clear();
    forms[file] = std::make_shared<const core::DressForm>(*read);
    return read;
}

GarmentBodyFiles::GarmentBodyFiles(fs::path root, bool own_thread)
    : root_(std::move(root)), folder_(root_), own_thread_(own_thread) {}

GarmentBodyFiles::~GarmentBodyFiles() = default;

void GarmentBodyFiles::open() {
    list(root_);
}

void GarmentBodyFiles::list(const fs::path& folder) {
    folder_ = folder;
    entries_.clear();
    first_ = 0;
    problem_.clear();
    std::vector<fs::path> folders, files;
    std::error_code error;
    for (auto it = fs::directory_iterator(folder_, fs::directory_options::skip_permission_denied, error);
         !error && it != fs::directory_iterator() && folders.size() + files.size() < kMostListed; it.increment(error)) {
        std::error_code not_there;
        const std::string name = it->path().filename().string();
        if (name.empty() || name[0] == '.') continue;
        if (it->is_directory(not_there)) {
            folders.push_back(it->path());
        } else if (core::has_mesh_extension(it->path())) {
            files.push_back(it->path());
        }
    }
    std::sort(folders.begin(), folders.end(), by_name);
    std::sort(files.begin(), files.end(), by_name);
    folders_ = folders.size();
    entries_ = std::move(folders);
    entries_.insert(entries_.end(), files.begin(), files.end());
    if (error) problem_ = folder_.string() + ": " + error.message();
}

void GarmentBodyFiles::up() {
    if (folder_ != root_) list(folder_.parent_path());
}

void GarmentBodyFiles::earlier() {
    first_ -= std::min(first_, ui::BodyFiles::kRows);
}

void GarmentBodyFiles::later() {
    if (first_ + ui::BodyFiles::kRows < entries_.size()) first_ += ui::BodyFiles::kRows;
}

void GarmentBodyFiles::choose(std::size_t row) {
    const std::size_t at = first_ + row;
    if (row >= ui::BodyFiles::kRows || at >= entries_.size() || reading_) return;
    if (at < folders_) return list(fs::path(entries_[at]));
    read(entries_[at].string());
}

void GarmentBodyFiles::read(const std::string& file) {
    problem_.clear();
    reading_ = std::make_shared<Reading>();
    reading_->file = file;
    const auto work = [reading = reading_, shelf = shelf_] {
        std::string problem;
        try {
            const core::Result<core::DressForm> form = shelf->form(reading->file);
            if (!form) problem = form.error().message;
        } catch (const std::exception& error) {  // out of memory
            problem = std::string("it cannot be read (") + error.what() + ")";
        }
        const std::scoped_lock lock(reading->mutex);
        // as it is listed: the folder is the studio's business
        if (!problem.empty()) reading->problem = fs::path(reading->file).filename().string() + ": " + problem;
        reading->done = true;
    };
    if (!own_thread_) return work();
    thread_ = std::jthread([work] {
        yield_to_the_pen();
        work();
    });
}

std::optional<std::string> GarmentBodyFiles::take() {
    if (!reading_) return std::nullopt;
    {
        const std::scoped_lock lock(reading_->mutex);
        if (!reading_->done) return std::nullopt;
    }
    const std::shared_ptr<Reading> done = std::exchange(reading_, nullptr);
    if (!done->wanted) return std::nullopt;
    problem_ = done->problem;
    return problem_.empty() ? std::optional<std::string>(done->file) : std::nullopt;
}

void GarmentBodyFiles::forget() {
    problem_.clear();
    if (reading_) reading_->wanted = false;  // it is read to its end, and then nobody asks for it
}

ui::BodyFiles GarmentBodyFiles::state() const {
    ui::BodyFiles out;
    // visitors read it: the folder's own name alone
    out.title = (folder_.has_filename() ? folder_ : folder_.parent_path()).filename().string();
    out.up = folder_ != root_;
    out.first = first_;
    out.all = entries_.size();
    out.reading = reading_ != nullptr;
    out.problem = problem_;
    for (std::size_t i = first_; i < std::min(entries_.size(), first_ + ui::BodyFiles::kRows); ++i) {
        out.rows.push_back({entries_[i].filename().string(), i < folders_});
    }
    return out;
}

core::FormSource GarmentBodyFiles::source() const {
    return [shelf = shelf_](const std::string& file) { return shelf->form(file); };
}

}  // namespace app
