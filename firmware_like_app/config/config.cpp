#include "firmware_like_app/config/config.hpp"

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

#include "core/exchange/file_bytes.hpp"
#include "firmware_like_app/config/options.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostConfigBytes = std::size_t{4} << 20;

core::Unexpected bad(const std::string& where, const toml::source_region& at, const std::string& what) {
    const std::string line = at.begin.line > 0 ? "line " + std::to_string(at.begin.line) + ": " : "";
    return core::unexpected(core::ErrorCode::BadFormat, line + what, where);
}

/// How many letters must be changed, added, left out or swapped with their neighbour (Damerau 1964, Levenshtein 1966).
std::size_t edits_between(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    std::iota(d[0].begin(), d[0].end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t k = 1; k <= b.size(); ++k) {
            d[i][k] = std::min({d[i - 1][k] + 1, d[i][k - 1] + 1, d[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1)});
            const bool swapped = i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1];
            if (swapped) d[i][k] = std::min(d[i][k], d[i - 2][k - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

/// "; did you mean idle.ask_s?", or nothing where no name is near.
std::string meant(const std::string& key, const std::vector<std::string>& names) {
    std::string best;
    std::size_t least = key.size() / 3 + 2;
    for (const std::string& name : names) {
        const std::size_t edits = edits_between(key, name);
        if (edits >= least) continue;
        least = edits;
        best = name;
    }
    return best.empty() ? "" : "; did you mean " + best + "?";
}

std::vector<std::string> all_keys() {
    std::vector<std::string> names;
    for (const Option& option : all_options()) names.push_back(option.key());
    return names;
}

std::vector<std::string> all_sections() {
    std::vector<std::string> names;
    for (const Option& option : all_options()) {
        if (names.empty() || names.back() != option.section) names.push_back(option.section);
    }
    return names;
}

const Option* find_option(const std::string& key) {
    for (const Option& option : all_options()) {
        if (option.key() == key) return &option;
    }
    return nullptr;
}

/// A number as short as it can be said.
std::string number_text(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

std::string out_of_bounds(const Option& option, double value) {
    if (value >= option.least && value <= option.most) return "";
    return "it must be from " + number_text(option.least) + " to " + number_text(option.most);
}

/// What is wrong with the value, or nothing. Puts it into the config.
std::string put(const Option& option, const toml::node& node, Config& config) {
    if (const auto* text = std::get_if<0>(&option.place)) {
        const auto value = node.value_exact<std::string>();
        if (!value) return "it must be a text in quotes";
        (*text)(config) = *value;
        const bool known = option.choices.empty() ||
                           std::find(option.choices.begin(), option.choices.end(), *value) != option.choices.end();
        if (!known) {
            std::string words;
            for (const std::string& choice : option.choices) words += (words.empty() ? "\"" : ", \"") + choice + "\"";
            return "it must be one of " + words;
        }
    } else if (const auto* flag = std::get_if<1>(&option.place)) {
        const auto value = node.value_exact<bool>();
        if (!value) return "it must be true or false";
        (*flag)(config) = *value;
    } else if (const auto* number = std::get_if<2>(&option.place)) {
        const auto value = node.value<double>();
        if (!value || node.is_boolean() || !std::isfinite(*value)) return "it must be a number";
        if (std::string wrong = out_of_bounds(option, *value); !wrong.empty()) return wrong;
        (*number)(config) = *value;
    } else if (const auto* whole = std::get_if<3>(&option.place)) {
        const auto value = node.value_exact<std::int64_t>();
        if (!value) return "it must be a whole number";
        if (std::string wrong = out_of_bounds(option, static_cast<double>(*value)); !wrong.empty()) return wrong;
        (*whole)(config) = *value;
    } else {
        const toml::array* array = node.as_array();
        if (array == nullptr) return "it must be numbers in brackets";
        std::vector<double> values;
        for (const toml::node& entry : *array) {
            const auto value = entry.value<double>();
            if (!value || entry.is_boolean()) return "it must be numbers in brackets";
            values.push_back(*value);
        }
        std::get<4>(option.place)(config) = std::move(values);
    }
    return option.check ? option.check(config) : "";
}

std::string is_wrong(const std::string& key, const std::string& what) {
    return "\"" + key + "\" is wrong: " + what;
}

std::string assignment_of(const std::string& key, const std::string& value) {
    return key + "=" + value;
}

core::Result<void> take_table(const toml::table& root, const std::string& where, Config& config) {
    for (const auto& [section, node] : root) {
        const std::string name(section.str());
        const toml::table* table = node.as_table();
        const std::vector<std::string> sections = all_sections();
        if (table == nullptr || std::find(sections.begin(), sections.end(), name) == sections.end()) {
            return bad(where, section.source(),
                       "\"" + name + "\" is not known" + meant(name, table != nullptr ? sections : all_keys()));
        }
        for (const auto& [key, value] : *table) {
            const std::string whole = name + "." + std::string(key.str());
            const Option* option = find_option(whole);
            if (option == nullptr) {
                return bad(where, key.source(), "\"" + whole + "\" is not known" + meant(whole, all_keys()));
            }
            const std::string wrong = put(*option, value, config);
            if (!wrong.empty()) return bad(where, key.source(), is_wrong(whole, wrong));
        }
    }
    return {};
}

/// A basic string of TOML: backslashes, quotes and control characters are escaped.
std::string in_quotes(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') out += '\\';
        if (code >= 0x20 && code != 0x7F) {
            out += c;
        } else {
            std::array<char, 8> escape{};
            std::snprintf(escape.data(), escape.size(), "\\u%04X", code);
            out += escape.data();
        }
    }
    return out + "\"";
}

/// The value as the file spells it.
std::string value_text(const Option& option, Config config) {
    if (const auto* text = std::get_if<0>(&option.place)) return in_quotes((*text)(config));
    if (const auto* flag = std::get_if<1>(&option.place)) return (*flag)(config) ? "true" : "false";
    if (const auto* number = std::get_if<2>(&option.place)) return number_text((*number)(config));
    if (const auto* whole = std::get_if<3>(&option.place)) return std::to_string((*whole)(config));
    std::string words;
    for (const double value : std::get<4>(option.place)(config))
        words += (words.empty() ? "" : ", ") + number_text(value);
    return "[" + words + "]";
}

core::Result<std::string> text_of(const std::string& path) {
    core::Result<std::string> text = core::read_file_bytes(path, kMostConfigBytes);
    if (!text && text.error().code == core::ErrorCode::FileMissing) {
        return core::unexpected(core::ErrorCode::FileMissing,
                                "there is no such file; \"croquis config\" prints one to begin with", path);
    }
    return text;
}

/// The whole file beside the old one, then in its place: a power cut leaves one of the two.
core::Result<void> replace_file(const std::string& path, const std::string& text) {
    const std::string beside = path + ".new";
    const auto failed = [&](const std::string& why) {
        std::error_code ignored;
        fs::remove(beside, ignored);
        return core::unexpected(core::ErrorCode::WriteFailed, why, path);
    };
    std::ofstream out(beside, std::ios::binary | std::ios::trunc);
    out << text;
    out.close();
    if (!out) return failed("it cannot be written; check that its folder may be written to and has room");
    std::error_code error;
    fs::rename(beside, path, error);
    if (error) return failed("it cannot be replaced (" + error.message() + "); check the permissions of its folder");
    return {};
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// One option into the lines of a file: over its own line, or as a new one at the end of its section.
void set_line(std::vector<std::string>& lines, const Option& option, const std::string& value) {
    std::string section;
    std::optional<std::size_t> end;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string line = trimmed(lines[i]);
        if (!line.empty() && line[0] == '[') {
            section = line.substr(1, line.find(']') - 1);
            if (section == option.section) end = i + 1;
            continue;
        }
        if (section != option.section) continue;
        if (!line.empty()) end = i + 1;
        const std::size_t equals = line.find('=');
        if (equals == std::string::npos || line[0] == '#' || trimmed(line.substr(0, equals)) != option.name) continue;
        lines[i] = option.name + " = " + value;
        return;
    }
    if (!end) {
        lines.insert(lines.end(), {"", "[" + option.section + "]"});
        end = lines.size();
    }
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(*end), option.name + " = " + value);
}

}  // namespace

std::string default_config_text() {
    std::string text = "# Croquis: the settings of this station. Every option stands here with its default.\n";
    std::string section;
    for (const Option& option : all_options()) {
        if (option.section != section) {
            section = option.section;
            text += "\n# " + section_comment(section) + "\n[" + section + "]\n";
        }
        std::string comment = option.comment;
        for (std::size_t at = comment.find('\n'); at != std::string::npos; at = comment.find('\n', at + 3)) {
            comment.replace(at, 1, "\n# ");
        }
        text += "# " + comment;
        if (std::isfinite(option.least))
            text += " " + number_text(option.least) + " to " + number_text(option.most) + ".";
        text += "\n" + option.name + " = " + value_text(option, Config{}) + "\n";
    }
    return text;
}

core::Result<Config> parse_config(std::string_view text, const std::string& where) {
    Config config;
    try {
        const toml::table root = toml::parse(text);
        if (const core::Result<void> taken = take_table(root, where, config); !taken)
            return core::unexpected(taken.error());
    } catch (const toml::parse_error& error) {
        return bad(where, error.source(), "it is no TOML: " + std::string(error.description()));
    }
    return config;
}

core::Result<Config> read_config(const std::string& path) {
    const core::Result<std::string> text = text_of(path);
    if (!text) return core::unexpected(text.error());
    return parse_config(*text, path);
}

core::Result<void> set_option(Config& config, const std::string& assignment) {
    const auto wrong_call = [](const std::string& what) {
        return core::unexpected(core::ErrorCode::BadArgument, what);
    };
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        return wrong_call("\"" + assignment + "\" is no setting; write section.name=value, such as idle.ask_s=90");
    }
    const std::string key = trimmed(assignment.substr(0, equals)), value = assignment.substr(equals + 1);
    const Option* option = find_option(key);
    if (option == nullptr) return wrong_call("\"" + key + "\" is not known" + meant(key, all_keys()));
    const bool is_text = std::holds_alternative<std::function<std::string&(Config&)>>(option->place);
    try {
        const toml::table table = toml::parse("v = " + (is_text ? in_quotes(value) : value));
        const std::string wrong = put(*option, *table.get("v"), config);
        if (wrong.empty()) return {};
        return wrong_call("\"" + key + "\" is wrong: " + wrong);
    } catch (const toml::parse_error&) {
        return wrong_call("\"" + key + "\" is wrong: \"" + value + "\" cannot be read");
    }
}

core::Result<void> save_options(const std::string& path,
                                const std::vector<std::pair<std::string, std::string>>& options) {
    std::error_code missing;
    core::Result<std::string> text = default_config_text();
    if (fs::exists(path, missing)) text = text_of(path);
    if (!text) return core::unexpected(text.error());
    std::vector<std::string> lines;
    std::istringstream in(*text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    Config config;
    for (const auto& [key, value] : options) {
        if (core::Result<void> put_in = set_option(config, assignment_of(key, value)); !put_in) return put_in;
        const Option& option = *find_option(key);
        set_line(lines, option, value_text(option, config));
    }
    std::string out;
    for (const std::string& line : lines) out += line + "\n";
    // what is written can be read again
    if (const core::Result<Config> again = parse_config(out, path); !again) return core::unexpected(again.error());
    return replace_file(path, out);
}

}  // namespace app
