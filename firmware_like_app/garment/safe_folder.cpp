#include "firmware_like_app/garment/safe_folder.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <utility>

namespace app {
namespace {

namespace fs = std::filesystem;
using Kind = ExportFault::Kind;

constexpr std::string_view kUnfinished = ".croquis-unfinished-";
constexpr std::size_t kMostName = 60;
constexpr std::size_t kAtOnce = std::size_t{1} << 18;  // bytes between two looks at the stop token
constexpr int kMostCopies = 10000;

ExportFault fault(Kind kind, core::ErrorCode code, std::string message, const fs::path& where) {
    return {kind, {code, std::move(message), where.string()}};
}

/// What a failed call means.
ExportFault fault_of(int error, const fs::path& where) {
    using core::ErrorCode;
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            return fault(Kind::Full, ErrorCode::WriteFailed,
                         "there is no room left; free some space or use another stick (nothing was saved)", where);
        case EROFS:
        case EACCES:
        case EPERM:
            return fault(Kind::ReadOnly, ErrorCode::WriteFailed,
                         "it cannot be written; unlock the stick or use another one", where);
        case ENOENT:
        case ENODEV:
        case ENXIO:
        case EIO:
            return fault(Kind::Gone, ErrorCode::WriteFailed,
                         "it was pulled out or cannot be read; plug it in and export again", where);
        default:
            return fault(Kind::Failed, ErrorCode::WriteFailed,
                         std::string("writing failed (") + std::strerror(error) + "); use another stick", where);
    }
}

/// An open file or folder.
class Handle {
  public:
    Handle(const fs::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (number_ >= 0) ::close(number_);
    }
    [[nodiscard]] int number() const { return number_; }
    /// 0, or errno: some file systems tell only now that the disk is full.
    [[nodiscard]] int close() { return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno; }

  private:
    int number_;
};

/// 0, or errno.
int flush_folder(const fs::path& folder) {
    const Handle handle(folder, O_RDONLY | O_DIRECTORY);
    if (handle.number() < 0) return errno;
    // not every file system knows how to flush a folder; one that does not has nothing to flush
    return fsync(handle.number()) == 0 || errno == EINVAL ? 0 : errno;
}

bool is_still_there(const ExportPlace& place) {
    struct stat info {};
    if (stat(place.path.c_str(), &info) != 0 || !S_ISDIR(info.st_mode)) return false;
    return place.device == 0 || info.st_dev == place.device;
}

/// Nothing when the files fit, as far as the file system says.
std::optional<ExportFault> look_for_room(const fs::path& folder, std::span<const NamedBytes> files) {
    struct statvfs info {};
    if (statvfs(folder.c_str(), &info) != 0 || info.f_frsize == 0) return std::nullopt;
    std::uint64_t blocks = 4;  // of the folder itself
    for (const NamedBytes& file : files) blocks += file.bytes.size() / info.f_frsize + 1;
    if (blocks <= info.f_bavail) return std::nullopt;
    const auto megabytes = [&](std::uint64_t count) {
        return std::to_string(count * info.f_frsize / 1000000) + "." +
               std::to_string(count * info.f_frsize / 100000 % 10) + " MB";
    };
    return fault(Kind::Full, core::ErrorCode::WriteFailed,
                 "there is no room: it has " + megabytes(info.f_bavail) + " free and " + megabytes(blocks) +
                     " are needed; free some space or use another stick",
                 folder);
}

/// `process`: number of the program that made an unfinished folder.
bool is_written_by_another(const std::string& process) {
    pid_t id = 0;
    const auto [end, failed] = std::from_chars(process.data(), process.data() + process.size(), id);
    if (failed != std::errc() || end != process.data() + process.size() || id <= 0 || id == getpid()) return false;
    return kill(id, 0) == 0 || errno == EPERM;
}

/// What a stick that was pulled out in the middle kept.
void clear_unfinished(const fs::path& place) {
    std::error_code ignored;
    for (fs::directory_iterator it(place, ignored), end; !ignored && it != end; it.increment(ignored)) {
        const std::string name = it->path().filename().string();
        if (name.starts_with(kUnfinished) && !is_written_by_another(name.substr(kUnfinished.size())))
            fs::remove_all(it->path(), ignored);
    }
}

/// 0, or errno. `name`: the destination must not exist; then EEXIST, and nothing happens.
int rename_to_new(const fs::path& from, const fs::path& to) {
    if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
    if (errno != EINVAL && errno != ENOSYS) return errno;
    struct stat info {};  // the file system does not know that call
    if (lstat(to.c_str(), &info) == 0) return EEXIST;
    return rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

/// One call's work, so that its steps share what they know.
class Writer {
  public:
    Writer(const ExportPlace& place, std::span<const NamedBytes> files, const std::function<void(double)>& progress,
           const std::stop_token& stop)
        : place_(place), files_(files), progress_(progress), stop_(stop) {
        for (const NamedBytes& file : files) all_ += file.bytes.size();
    }

    FolderReport write(const std::string& name) {
        if (!is_still_there(place_))
            return {{},
                    place_.device != 0
                        ? fault_of(ENOENT, place_.path)
                        : fault(Kind::NoPlace, core::ErrorCode::FileMissing,
                                "there is no such folder; make it first, or name another one", place_.path)};
        if (place_.read_only) return {{}, fault_of(EROFS, place_.path)};
        clear_unfinished(place_.path);
        if (std::optional<ExportFault> full = look_for_room(place_.path, files_)) return {{}, std::move(full)};
        unfinished_ = place_.path / (std::string(kUnfinished) + std::to_string(getpid()));
        FolderReport report;
        report.fault = fill();
        if (!report.fault) report.fault = give_name(name, report.folder);
        if (report.fault) {
            std::error_code ignored;
            fs::remove_all(unfinished_, ignored);
            if (!is_still_there(place_)) report.fault = fault_of(ENODEV, place_.path);
        }
        return report;
    }

  private:
    std::optional<ExportFault> fill() {
        if (mkdir(unfinished_.c_str(), 0755) != 0) return fault_of(errno, place_.path);
        for (const NamedBytes& file : files_)
            if (std::optional<ExportFault> failed = write_file(file)) return failed;
        if (const int error = flush_folder(unfinished_)) return fault_of(error, place_.path);
        return std::nullopt;
    }

    std::optional<ExportFault> write_file(const NamedBytes& file) {
        const fs::path path = unfinished_ / file.name;
        Handle handle(path, O_WRONLY | O_CREAT | O_EXCL);
        if (handle.number() < 0) return fault_of(errno, path);
        for (std::size_t at = 0; at < file.bytes.size();) {
            if (stop_.stop_requested())
                return fault(Kind::Cancelled, core::ErrorCode::Cancelled, "the export was stopped", place_.path);
            const ssize_t wrote =
                ::write(handle.number(), file.bytes.data() + at, std::min(kAtOnce, file.bytes.size() - at));
            if (wrote < 0 && errno == EINTR) continue;
            if (wrote < 0) return fault_of(errno, place_.path / file.name);
            at += static_cast<std::size_t>(wrote);
            done_ += static_cast<std::size_t>(wrote);
            if (progress_ && all_ > 0) progress_(static_cast<double>(done_) / static_cast<double>(all_));
        }
        if (fsync(handle.number()) != 0) return fault_of(errno, place_.path / file.name);
        if (const int error = handle.close()) return fault_of(error, place_.path / file.name);
        return std::nullopt;
    }

    std::optional<ExportFault> give_name(const std::string& name, fs::path& folder) {
        for (int n = 1; n <= kMostCopies; ++n) {
            const fs::path to = place_.path / (n == 1 ? name : name + "-" + std::to_string(n));
            const int error = rename_to_new(unfinished_, to);
            if (error == EEXIST || error == ENOTEMPTY) continue;
            if (error != 0) return fault_of(error, to);
            unfinished_ = to;  // what goes if it does not reach the disk
            if (const int failed = flush_folder(place_.path)) return fault_of(failed, place_.path);
            if (!is_still_there(place_)) return fault_of(ENODEV, place_.path);
            folder = to;
            return std::nullopt;
        }
        return fault(Kind::Failed, core::ErrorCode::WriteFailed,
                     "there are too many exports of this name; use another stick", place_.path / name);
    }

    const ExportPlace& place_;
    std::span<const NamedBytes> files_;
    const std::function<void(double)>& progress_;
    const std::stop_token& stop_;
    fs::path unfinished_;
    std::size_t all_ = 0, done_ = 0;
};

}  // namespace

std::string safe_name(std::string name) {
    constexpr std::string_view kRefused = "/\\:*?\"<>|";
    for (char& c : name)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || kRefused.find(c) != std::string_view::npos) c = '_';
    if (name.size() > kMostName) {
        std::size_t end = kMostName;
        while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80) --end;  // whole letters
        name.resize(end);
    }
    while (!name.empty() && (name.back() == '.' || name.back() == ' ')) name.pop_back();
    while (!name.empty() && (name.front() == '.' || name.front() == ' ')) name.erase(name.begin());
    return name.empty() ? "design" : name;
}

FolderReport write_new_folder(const ExportPlace& place, const std::string& name, std::span<const NamedBytes> files,
                              const std::function<void(double)>& progress, const std::stop_token& stop) {
    return Writer(place, files, progress, stop).write(safe_name(name));
}

}  // namespace app
