#pragma once
// The words on the screen, one file per language in ui/screens/strings; another language is another file.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace ui {

class Strings {
  public:
    /// UTF-8 JSON: an object of strings, with "code", "short" (as on the switch), "name" and a number "order".
    /// ErrorCode::BadFormat naming `file` otherwise.
    [[nodiscard]] static core::Result<Strings> parse(std::string_view json, std::string file);
    /// Every language built in, and those of the files NAME.json of a folder, by "order"; a file with the code of one
    /// that is there already takes its place. FileMissing naming the folder when it is given and not there.
    [[nodiscard]] static core::Result<std::vector<Strings>> load_all(const std::string& folder = {});

    /// The words for a key; the key itself where the language lacks it, so that a gap is seen and nothing fails.
    [[nodiscard]] const std::string& operator[](const std::string& key) const;
    [[nodiscard]] std::vector<std::string> keys() const;
    [[nodiscard]] const std::string& code() const { return words_.at("code"); }
    [[nodiscard]] int order() const { return order_; }

  private:
    std::map<std::string, std::string> words_;
    int order_ = 0;
};

}  // namespace ui
