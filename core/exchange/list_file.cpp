#include "core/exchange/list_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/exchange/file_bytes.hpp"
#include "core/exchange/quickdraw_reader.hpp"

namespace core {
namespace {

namespace fs = std::filesystem;

/// In the order of preference where a folder has the same name with several of them.
constexpr std::array<std::string_view, 16> kExtensions{"off", "obj", "ply",  "stl", "glb", "gltf",  "dae",    "3ds",
                                                       "png", "bmp", "jpeg", "jpg", "svg", "inkml", "ndjson", "json"};
constexpr std::size_t kMaxListBytes = std::size_t{64} << 20;

std::string folder_of(const std::string& path) {
    return fs::path(path).parent_path().string();
}

bool exists(const std::string& path) {
    std::error_code failure;
    return fs::exists(path, failure) || fs::exists(split_line_path(path).file, failure);
}

Result<LabelledList> read_own_list(std::string_view text, const std::string& path) {
    LabelledList list;
    std::size_t line_number = 0;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        ++line_number;
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
        const std::size_t tab = line.find('\t');
        if (tab == std::string_view::npos || tab == 0 || tab + 1 == line.size()) {
            return unexpected(ErrorCode::BadFormat, "this line is not \"path<TAB>class\"; separate the two by one tab",
                              path + ":" + std::to_string(line_number));
        }
        const fs::path item = fs::path(folder_of(path)) / std::string(line.substr(0, tab));
        LabelledFile file{item.lexically_normal().string(), std::string(line.substr(tab + 1))};
        (exists(file.path) ? list.files : list.missing).push_back(std::move(file));
    }
    return list;
}

/// Files of a folder and of the folders in it, by folder name ("" for the folder itself) and name without extension.
class FolderIndex {
  public:
    static Result<FolderIndex> of(const std::string& folder) {
        FolderIndex index;
        std::error_code failure;
        const fs::path root = folder.empty() ? fs::path(".") : fs::path(folder);
        if (!fs::is_directory(root, failure)) {
            return unexpected(ErrorCode::FileMissing,
                              "there is no such folder; name the folder that holds the listed files", folder);
        }
        index.add(root, "");
        for (fs::directory_iterator it(root, failure), end; !failure && it != end; it.increment(failure)) {
            std::error_code ignored;
            if (it->is_directory(ignored)) index.add(it->path(), it->path().filename().string());
        }
        return index;
    }

    /// The file that a .cla's number stands for, or nothing.
    [[nodiscard]] std::optional<std::string> find(const std::string& number, const std::string& class_name) const {
        for (const std::string& stem : {number, "m" + number}) {
            const auto places = by_stem_.find(stem);
            if (places == by_stem_.end()) continue;
            for (const std::string& folder : {class_name, std::string()}) {
                if (const auto found = places->second.find(folder); found != places->second.end()) {
                    return found->second.second;
                }
            }
            return places->second.begin()->second.second;
        }
        return std::nullopt;
    }

  private:
    void add(const fs::path& folder, const std::string& name) {
        std::error_code failure;
        for (fs::directory_iterator it(folder, failure), end; !failure && it != end; it.increment(failure)) {
            const auto known = std::find(kExtensions.begin(), kExtensions.end(), lower_extension(it->path().string()));
            if (known == kExtensions.end()) continue;
            const std::pair entry(known - kExtensions.begin(), it->path().string());
            auto [place, is_new] = by_stem_[it->path().stem().string()].try_emplace(name, entry);
            if (!is_new) place->second = std::min(place->second, entry);
        }
    }

    /// stem -> folder -> (rank of the extension, path)
    std::map<std::string, std::map<std::string, std::pair<std::ptrdiff_t, std::string>>> by_stem_;
};

/// Words of a .cla with the line they stand on.
class Words {
  public:
    explicit Words(std::string_view text) : text_(text) {}
    std::string next() {
        while (at_ < text_.size() && is_space(text_[at_])) line_ += text_[at_++] == '\n' ? 1 : 0;
        const std::size_t start = at_;
        while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
        return std::string(text_.substr(start, at_ - start));
    }
    std::optional<std::size_t> next_number() {
        const std::string word = next();
        std::size_t value = 0;
        const auto [rest, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (failure != std::errc() || rest != word.data() + word.size()) return std::nullopt;
        return value;
    }
    [[nodiscard]] std::size_t line() const { return line_; }

  private:
    static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

Result<LabelledList> read_cla(std::string_view text, const std::string& path, const std::string& folder) {
    const Result<FolderIndex> index = FolderIndex::of(folder);
    if (!index) return unexpected(index.error());
    Words words(text);
    const auto damaged = [&](const char* what) {
        return unexpected(ErrorCode::BadFormat, std::string("a ") + what + " is expected here; get the .cla file again",
                          path + ":" + std::to_string(words.line()));
    };
    words.next();  // PSB
    words.next();  // version of the format
    const std::optional<std::size_t> classes = words.next_number();
    const std::optional<std::size_t> total = words.next_number();
    if (!classes || !total) return damaged("number of classes and of files");

    LabelledList list;
    std::map<std::string, std::string> parent_of;
    for (std::size_t c = 0; c < *classes; ++c) {
        std::string name = words.next();
        const std::string parent = words.next();
        const std::optional<std::size_t> count = words.next_number();
        if (name.empty() || !count) return damaged("class with its parent and count");
        const auto [known, is_new] = parent_of.try_emplace(name, parent);
        if (!is_new && known->second != parent) name.insert(0, parent + "/");
        for (std::size_t i = 0; i < *count; ++i) {
            const std::optional<std::size_t> number = words.next_number();
            if (!number) return damaged("file number");
            const std::string stem = std::to_string(*number);
            if (std::optional<std::string> found = index->find(stem, known->first)) {
                list.files.push_back({std::move(*found), name});
            } else {
                list.missing.push_back({stem, name});
            }
        }
    }
    if (!words.next().empty()) return damaged("end of the file after the last class");
    if (list.files.size() + list.missing.size() != *total) return damaged("total that agrees with the classes' counts");
    return list;
}

}  // namespace

Result<LabelledList> read_list_file(const std::string& path, const std::optional<std::string>& files_dir) {
    const Result<std::string> bytes = read_file_bytes(path, kMaxListBytes);
    if (!bytes) return unexpected(bytes.error());
    std::string_view text = *bytes;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (text.starts_with("PSB ")) return read_cla(text, path, files_dir.value_or(folder_of(path)));
    return read_own_list(text, path);
}

}  // namespace core
