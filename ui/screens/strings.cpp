#include "ui/screens/strings.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/exchange/file_bytes.hpp"
#include "ui/gl/embedded.hpp"

namespace ui {

core::Result<Strings> Strings::parse(std::string_view json, std::string file) {
    const nlohmann::json object = nlohmann::json::parse(json, nullptr, false);
    if (!object.is_object()) {
        return core::unexpected(
            core::ErrorCode::BadFormat,
            "a language file must be one JSON object; take ui/screens/strings/en.json as the pattern", std::move(file));
    }
    Strings strings;
    for (const auto& [key, value] : object.items()) {
        if (value.is_string()) {
            strings.words_[key] = value.get<std::string>();
        } else if (key == "order" && value.is_number_integer()) {
            strings.order_ = value.get<int>();
        } else {
            return core::unexpected(core::ErrorCode::BadFormat, "the value of \"" + key + "\" must be a string",
                                    std::move(file));
        }
    }
    for (const char* needed : {"code", "short", "name"}) {
        if (strings.words_.count(needed) == 0) {
            return core::unexpected(core::ErrorCode::BadFormat, std::string("\"") + needed + "\" is missing",
                                    std::move(file));
        }
    }
    return strings;
}

namespace {

constexpr std::size_t kMostStringsBytes = std::size_t{4} << 20;

/// The JSON files of a folder with their contents, by name.
core::Result<std::map<std::string, std::string>> files_of(const std::string& folder) {
    std::map<std::string, std::string> files;
    if (folder.empty()) return files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.path().extension() != ".json") continue;
        core::Result<std::string> text = core::read_file_bytes(entry.path().string(), kMostStringsBytes);
        if (!text) return core::unexpected(text.error());
        files[entry.path().string()] = std::move(*text);
    }
    if (!error) return files;
    return core::unexpected(core::ErrorCode::FileMissing, "the folder of language files cannot be read", folder);
}

}  // namespace

core::Result<std::vector<Strings>> Strings::load_all(const std::string& folder) {
    std::vector<Strings> all;
    const auto add = [&all](std::string_view json, std::string file) -> core::Result<void> {
        core::Result<Strings> strings = parse(json, std::move(file));
        if (!strings) return core::unexpected(strings.error());
        std::erase_if(all, [&](const Strings& s) { return s.code() == strings->code(); });
        all.push_back(std::move(*strings));
        return {};
    };
    for (const EmbeddedFile& file : string_files()) {
        if (const core::Result<void> added = add(file.content, std::string(file.name)); !added)
            return core::unexpected(added.error());
    }
    const core::Result<std::map<std::string, std::string>> files = files_of(folder);
    if (!files) return core::unexpected(files.error());
    for (const auto& [file, json] : *files) {
        if (const core::Result<void> added = add(json, file); !added) return core::unexpected(added.error());
    }
    std::stable_sort(all.begin(), all.end(), [](const Strings& a, const Strings& b) { return a.order_ < b.order_; });
    return all;
}

const std::string& Strings::operator[](const std::string& key) const {
    const auto found = words_.find(key);
    return found != words_.end() ? found->second : key;
}

std::vector<std::string> Strings::keys() const {
    std::vector<std::string> all;
    for (const auto& [key, words] : words_) all.push_back(key);
    return all;
}

}  // namespace ui
