#pragma once
// The table of all options: name, what it is, its bounds, where it goes. Of use inside config only.

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "firmware_like_app/config/config.hpp"

namespace app {

struct Option {
    /// Where the value goes.
    using Place = std::variant<std::function<std::string&(Config&)>, std::function<bool&(Config&)>,
                               std::function<double&(Config&)>, std::function<std::int64_t&(Config&)>,
                               std::function<std::vector<double>&(Config&)>>;
    std::string section, name;
    std::string comment;  ///< for the default file; a line break begins another comment line
    Place place;
    double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
    std::vector<std::string> choices = {};                      ///< of a text; empty: any
    std::function<std::string(const Config&)> check = nullptr;  ///< what is wrong with it, or nothing

    [[nodiscard]] Option within(double low, double high) && {
        least = low;
        most = high;
        return std::move(*this);
    }
    [[nodiscard]] Option one_of(std::vector<std::string> words) && {
        choices = std::move(words);
        return std::move(*this);
    }
    [[nodiscard]] Option checked_by(std::function<std::string(const Config&)> what) && {
        check = std::move(what);
        return std::move(*this);
    }

    [[nodiscard]] std::string key() const { return section + "." + name; }
};

[[nodiscard]] const std::vector<Option>& all_options();
/// What each section is about.
[[nodiscard]] std::string section_comment(const std::string& section);

}  // namespace app
