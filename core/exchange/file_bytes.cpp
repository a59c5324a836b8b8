#include "core/exchange/file_bytes.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace core {
namespace {

Unexpected unreadable(const std::string& path, const std::string& why) {
    return unexpected(ErrorCode::FileUnreadable, why, path);
}

}  // namespace

Result<void> check_ordinary_file(const std::string& path) {
    std::error_code failure;
    const std::filesystem::file_status status = std::filesystem::status(path, failure);
    if (status.type() == std::filesystem::file_type::not_found) {
        return unexpected(ErrorCode::FileMissing, "there is no such file; check the name", path);
    }
    if (failure)
        return unreadable(path,
                          "the file cannot be reached (" + failure.message() + "); check the folder's permissions");
    if (std::filesystem::is_directory(status)) return unreadable(path, "this is a folder; name a file in it");
    if (!std::filesystem::is_regular_file(status)) {
        return unreadable(path, "this is a device or a pipe; name an ordinary file");
    }
    if (access(path.c_str(), R_OK) != 0) {
        return unreadable(path, "the file cannot be opened; check its permissions");
    }
    return {};
}

Result<std::string> read_file_bytes(const std::string& path, std::size_t max_bytes) {
    if (Result<void> ordinary = check_ordinary_file(path); !ordinary) return unexpected(ordinary.error());
    std::ifstream in(path, std::ios::binary);
    if (!in) return unreadable(path, "the file cannot be opened; check its permissions");
    std::string bytes;
    std::string block(1u << 16, '\0');
    while (in) {
        in.read(block.data(), static_cast<std::streamsize>(block.size()));
        const auto got = static_cast<std::size_t>(in.gcount());
        if (got > max_bytes - bytes.size()) {
            return unreadable(path,
                              "the file is larger than " + std::to_string(max_bytes >> 20) + " MB; give a smaller one");
        }
        bytes.append(block, 0, got);
    }
    if (in.bad()) return unreadable(path, "the file could not be read to its end; check the disk");
    return bytes;
}

std::string lower_extension(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
    });
    return extension;
}

}  // namespace core
