#include "db/sqlite/database_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <fstream>

namespace db {

namespace {

namespace fs = std::filesystem;
using core::ErrorCode;

constexpr std::size_t kHeaderSize = 100;      // of a SQLite file, https://www.sqlite.org/fileformat2.html section 1.3
constexpr std::size_t kUserVersionAt = 60;    // big-endian
constexpr std::size_t kApplicationIdAt = 68;  // big-endian
constexpr char kMagic[] = "SQLite format 3";  // 16 bytes with its final zero

std::uint32_t big_endian(const std::array<char, kHeaderSize>& header, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(header[at + i]);
    return value;
}

bool may(const fs::path& path, int what) {
    return faccessat(AT_FDCWD, path.c_str(), what, AT_EACCESS) == 0;
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

core::Result<void> examine_folder(const fs::path& path, OpenMode mode) {
    const fs::path folder = folder_of(path);
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) {
        return core::unexpected(ErrorCode::FileMissing,
                                "the folder " + folder.string() + " does not exist; make it first", path.string());
    }
    // SQLite keeps its log beside the file, so that writing needs the folder too.
    if (mode != OpenMode::ReadOnly && !may(folder, W_OK | X_OK)) {
        return core::unexpected(
            ErrorCode::WriteFailed,
            "the folder " + folder.string() + " is read-only; allow writing to it or choose another place",
            path.string());
    }
    return {};
}

core::Result<FileState> examine_header(const fs::path& path, const DatabaseOptions& options) {
    std::array<char, kHeaderSize> header{};
    std::ifstream file(path, std::ios::binary);
    file.read(header.data(), header.size());
    const std::streamsize got = file.gcount();
    if (got == 0 && file.eof()) return FileState::Absent;
    if (file.bad())
        return core::unexpected(ErrorCode::FileUnreadable, "it cannot be read; check the disk", path.string());
    const bool sqlite =
        got >= static_cast<std::streamsize>(sizeof kMagic) && std::memcmp(header.data(), kMagic, sizeof kMagic) == 0;
    if (!sqlite) return core::unexpected(not_ours(path.string(), options.words));
    if (got < static_cast<std::streamsize>(kHeaderSize)) {
        return core::unexpected(ErrorCode::Damaged, std::string("it is cut off; ") + options.words.mend, path.string());
    }
    if (big_endian(header, kApplicationIdAt) != options.application_id)
        return core::unexpected(not_ours(path.string(), options.words));
    const std::uint32_t version = big_endian(header, kUserVersionAt);
    if (version > static_cast<std::uint32_t>(options.newest_version)) {
        return core::unexpected(newer_version(version, options, path.string()));
    }
    return FileState::Ours;
}

bool holds_bytes(const fs::path& path) {
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(path, missing);
    return !missing && size > 0;
}

}  // namespace

core::Result<FileState> examine_file(const fs::path& path, OpenMode mode, const DatabaseOptions& options) {
    if (path.empty())
        return core::unexpected(ErrorCode::BadArgument,
                                "the " + std::string(options.words.thing) + " has no file name; name a file");
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (status.type() == fs::file_type::not_found) {
        if (const core::Result<void> folder = examine_folder(path, mode); !folder) {
            return core::unexpected(folder.error());
        }
        if (mode == OpenMode::Create) return FileState::Absent;
        return core::unexpected(ErrorCode::FileMissing, std::string("there is no such file; ") + options.words.make,
                                path.string());
    }
    if (fs::is_directory(status)) {
        return core::unexpected(ErrorCode::FileUnreadable, "it is a folder; name a file in it", path.string());
    }
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        return core::unexpected(ErrorCode::FileUnreadable, "it is a device or a pipe; name an ordinary file",
                                path.string());
    }
    if (!fs::is_regular_file(status) || !may(path, R_OK)) {
        return core::unexpected(ErrorCode::FileUnreadable, "it cannot be read; check its permissions", path.string());
    }
    core::Result<FileState> state = examine_header(path, options);
    if (!state) return state;
    if (*state == FileState::Absent && mode != OpenMode::Create) {
        return core::unexpected(ErrorCode::NotAnIndex, std::string("the file is empty; ") + options.words.make,
                                path.string());
    }
    if (mode != OpenMode::ReadOnly && !may(path, W_OK)) {
        return core::unexpected(ErrorCode::WriteFailed,
                                "the file is read-only; allow writing to it or choose another place", path.string());
    }
    if (const core::Result<void> folder = examine_folder(path, mode); !folder) return core::unexpected(folder.error());
    return state;
}

bool is_complete_by_itself(const fs::path& path) {
    return !holds_bytes(path.string() + "-wal") && !holds_bytes(path.string() + "-journal");
}

std::string immutable_uri(const fs::path& path) {
    constexpr char kDigits[] = "0123456789ABCDEF";
    std::string uri = "file:";
    for (const char c : fs::absolute(path).string()) {
        if (c == '?' || c == '#' || c == '%') {
            const auto byte = static_cast<unsigned char>(c);
            uri += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
        } else {
            uri += c;
        }
    }
    return uri + "?immutable=1";
}

core::Error not_ours(const std::string& where, const DatabaseWords& words) {
    return {ErrorCode::NotAnIndex,
            "it is no Croquis " + std::string(words.thing) + " and was left as it is; name another file", where};
}

core::Error newer_version(std::int64_t version, const DatabaseOptions& options, const std::string& where) {
    return {ErrorCode::NewerVersion,
            "a newer Croquis made it (version " + std::to_string(version) + ", this program knows " +
                std::to_string(options.newest_version) + ") and it was left as it is; use that Croquis, or " +
                options.words.renew,
            where};
}

}  // namespace db
