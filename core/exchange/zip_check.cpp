#include "core/exchange/zip_check.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace core {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kEndBytes = 22, kEntryBytes = 46, kLongestComment = 65535;
constexpr std::uint64_t kMostDirectoryBytes = 16ULL << 20;
constexpr std::uint64_t kInZip64 = 0xffffffffULL;  // the real number is elsewhere, for it is larger

std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

Unexpected no_directory() {
    return unexpected(ErrorCode::BadFormat,
                      "the archive inside has no directory; it is cut short or damaged, copy it again");
}

Unexpected too_much(std::uintmax_t most_bytes) {
    return unexpected(ErrorCode::BadMesh, "the archive inside unpacks to more than the " +
                                              std::to_string(most_bytes >> 20) +
                                              " MiB that are read; simplify the "
                                              "model first");
}

std::string read_part(std::ifstream& file, std::uint64_t from, std::uint64_t size) {
    std::string bytes(static_cast<std::size_t>(size), '\0');
    file.clear();
    file.seekg(static_cast<std::streamoff>(from));
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return bytes;
}

/// Sums up what the members unpack to.
Result<void> check_directory(std::string_view directory, std::uintmax_t most_bytes) {
    std::uint64_t sum = 0;
    while (directory.size() >= kEntryBytes && directory.starts_with("PK\x01\x02"sv)) {
        const std::uint64_t unpacked = number_at(directory, 24, 4);
        sum += unpacked;
        if (unpacked == kInZip64 || sum > most_bytes) return too_much(most_bytes);
        const std::uint64_t names =
            number_at(directory, 28, 2) + number_at(directory, 30, 2) + number_at(directory, 32, 2);
        if (kEntryBytes + names > directory.size()) return no_directory();
        directory.remove_prefix(kEntryBytes + static_cast<std::size_t>(names));
    }
    return directory.empty() ? Result<void>() : no_directory();
}

}  // namespace

Result<void> check_zip(const std::filesystem::path& path, std::uintmax_t most_bytes) {
    std::error_code fault;
    const std::uintmax_t size = std::filesystem::file_size(path, fault);
    std::ifstream file(path, std::ios::binary);
    if (fault || !file) return unexpected(ErrorCode::FileUnreadable, "the file cannot be read; check its rights");
    const std::uint64_t tail_bytes = std::min<std::uint64_t>(size, kEndBytes + kLongestComment);
    const std::string tail = read_part(file, size - tail_bytes, tail_bytes);
    const std::size_t end = tail.rfind("PK\x05\x06"sv);
    if (end == std::string::npos || tail.size() - end < kEndBytes) return no_directory();
    const std::uint64_t bytes = number_at(tail, end + 12, 4), from = number_at(tail, end + 16, 4);
    if (bytes == kInZip64 || from == kInZip64 || bytes > kMostDirectoryBytes) return too_much(most_bytes);
    if (from > size || bytes > size - from) return no_directory();
    const std::string directory = read_part(file, from, bytes);
    if (directory.size() != bytes) return no_directory();
    return check_directory(directory, most_bytes);
}

}  // namespace core
