#include "core/exchange/mesh_file_check.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

namespace core {
namespace {

using namespace std::string_view_literals;

constexpr std::array kArchives{"PK\x03\x04"sv,
                               "\x1f\x8b"sv,
                               "7z\xbc\xaf\x27\x1c"sv,
                               "Rar!"sv,
                               "\xfd"
                               "7zXZ"sv,
                               "BZh"sv};
constexpr std::array kTextFormats{"obj"sv, "dae"sv, "gltf"sv, "x3d"sv, "wrl"sv, "ase"sv, "nff"sv, "ac"sv};
constexpr std::array kZippedFormats{"3mf"sv, "zae"sv, "x3db"sv, "q3o"sv};

template <typename List>
bool holds(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

Unexpected too_short() {
    return unexpected(ErrorCode::BadFormat,
                      "the file is shorter than it says; it is cut short or damaged, copy it again");
}

/// Bytes that a value of a PLY type takes in a binary file; 1 for an unknown type, so as never to ask for too much.
std::uintmax_t ply_type_bytes(std::string_view type) {
    if (type == "double" || type == "float64") return 8;
    if (type == "float" || type == "float32" || type == "int" || type == "int32" || type == "uint" ||
        type == "uint32") {
        return 4;
    }
    return type == "short" || type == "ushort" || type == "int16" || type == "uint16" ? 2 : 1;
}

/// The least bytes that the elements of a PLY header can take, against those that are there.
Result<void> check_ply(std::string_view head, std::uintmax_t file_bytes) {
    if (!head.starts_with("ply")) return unexpected(ErrorCode::BadFormat, "the file does not begin as PLY files do");
    std::istringstream lines{std::string(head.substr(0, std::min<std::size_t>(head.size(), 65536)))};
    bool ascii = true;
    double needed = 0.0, count = 0.0;
    std::string line, word, type;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        words >> word;
        if (word == "end_header") break;
        if (word == "format" && words >> type) ascii = type == "ascii";
        if (word == "element" && !(words >> type >> count)) count = 0.0;
        if (word == "property" && words >> type) {
            if (type == "list") words >> type;
            needed += count * (ascii ? 2.0 : static_cast<double>(ply_type_bytes(type)));
        }
    }
    // The last number of a text file needs no break after it.
    if (needed > static_cast<double>(file_bytes) + 1.0) return too_short();
    return {};
}

/// A binary STL is 80 bytes of anything, the count, and 50 bytes a triangle.
Result<void> check_stl(std::string_view head, std::uintmax_t file_bytes) {
    if (head.starts_with("solid")) return {};
    std::uint32_t count = 0;
    if (head.size() < 84) return too_short();
    std::memcpy(&count, head.data() + 80, sizeof count);
    if (84 + 50 * static_cast<std::uintmax_t>(count) > file_bytes) return too_short();
    return {};
}

/// The largest number that follows a key of a JSON text.
double largest_value(std::string_view json, std::string_view key) {
    double largest = 0.0;
    for (std::size_t at = json.find(key); at != json.npos; at = json.find(key, at + key.size())) {
        std::size_t from = at + key.size();
        while (from < json.size() && (std::isspace(static_cast<unsigned char>(json[from])) != 0 || json[from] == ':')) {
            ++from;
        }
        double value = 0.0;
        std::from_chars(json.data() + from, json.data() + json.size(), value);
        largest = std::max(largest, value);
    }
    return largest;
}

Result<void> check_gltf(std::string_view head, std::size_t most_elements) {
    if (largest_value(head, "\"count\"") > 3.0 * static_cast<double>(most_elements) ||
        largest_value(head, "\"byteLength\"") > 32.0 * static_cast<double>(most_elements)) {
        return unexpected(ErrorCode::BadFormat, "the file promises more data than is read; simplify the model");
    }
    return {};
}

}  // namespace

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

Result<void> check_plain_file(const std::filesystem::path& path, std::uintmax_t most_bytes) {
    std::error_code fault;
    const std::filesystem::file_status status = std::filesystem::status(path, fault);
    if (status.type() == std::filesystem::file_type::not_found) {
        return unexpected(ErrorCode::FileMissing, "there is no such file; check the path", path.string());
    }
    if (status.type() != std::filesystem::file_type::regular) {
        return unexpected(ErrorCode::FileUnreadable, "this is not an ordinary file; give the path of a file",
                          path.string());
    }
    const std::uintmax_t bytes = std::filesystem::file_size(path, fault);
    if (fault) return unexpected(ErrorCode::FileUnreadable, "the file cannot be read; check its rights", path.string());
    if (bytes == 0) return unexpected(ErrorCode::BadFormat, "the file is empty; export it again", path.string());
    if (bytes > most_bytes) {
        return unexpected(ErrorCode::FileUnreadable,
                          "the file is larger than the " + std::to_string(most_bytes >> 20) +
                              " MiB that are read; simplify the model first",
                          path.string());
    }
    return {};
}

Result<std::string> read_plain_file(const std::filesystem::path& path, std::uintmax_t most_bytes) {
    if (Result<void> plain = check_plain_file(path, most_bytes); !plain) return unexpected(plain.error());
    std::ifstream file(path, std::ios::binary);
    std::error_code fault;
    std::string bytes(static_cast<std::size_t>(std::filesystem::file_size(path, fault)), '\0');
    if (!file || fault || !file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
        return unexpected(ErrorCode::FileUnreadable, "the file cannot be read; check its rights", path.string());
    }
    return bytes;
}

Result<void> check_mesh_head(std::string_view extension, std::string_view head, std::uintmax_t file_bytes,
                             std::size_t most_elements) {
    if (!holds(kZippedFormats, extension)) {
        for (const std::string_view archive : kArchives) {
            if (!head.starts_with(archive)) continue;
            return unexpected(ErrorCode::UnknownFormat, "this is an archive under another name; unpack it first");
        }
    }
    if (holds(kTextFormats, extension) && head.find('\0') != head.npos) {
        return unexpected(ErrorCode::BadFormat, "this is not the text that its extension promises; export it again");
    }
    if (extension == "ply") return check_ply(head, file_bytes);
    if (extension == "stl") return check_stl(head, file_bytes);
    if (extension == "gltf" || extension == "glb") return check_gltf(head, most_elements);
    return {};
}

}  // namespace core
