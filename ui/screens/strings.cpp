#include "ui/screens/strings.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "ui/gl/embedded.hpp"

namespace ui {

core::Result<Strings> Strings::parse(std::string_view json, std::string file) {
    const nlohmann::json object = nlohmann::json::parse(json, nullptr, false);
    if (!object.is_object()) {
        return core::unexpected(core::ErrorCode::BadFormat, "a language file must be one JSON object", std::move(file));
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

core::Result<std::vector<Strings>> Strings::load_all() {
    std::vector<Strings> all;
    for (const EmbeddedFile& file : string_files()) {
        core::Result<Strings> strings = parse(file.content, std::string(file.name));
        if (!strings) return core::unexpected(strings.error());
        all.push_back(std::move(*strings));
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
