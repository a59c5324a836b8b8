#pragma once
// The small change of readers of line formats: lines, words, numbers, bytes in hexadecimal.

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace input {

/// Walks over the lines of a text, without their ends.
class TextLines {
  public:
    explicit TextLines(std::string_view text) : rest_(text) {}

    bool next(std::string_view& line) {
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        line = rest_.substr(0, end);
        rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        ++number_;
        return true;
    }
    /// Of the line that next() gave last, from 1.
    [[nodiscard]] std::size_t number() const { return number_; }

  private:
    std::string_view rest_;
    std::size_t number_ = 0;
};

[[nodiscard]] inline std::string_view trimmed(std::string_view s) {
    const std::size_t first = s.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return s.substr(first, s.find_last_not_of(" \t") - first + 1);
}

/// Takes the next word (to the next blank) off the front; empty at the end.
[[nodiscard]] inline std::string_view take_word(std::string_view& s) {
    s = s.substr(std::min(s.find_first_not_of(" \t"), s.size()));
    const std::string_view word = s.substr(0, s.find_first_of(" \t"));
    s.remove_prefix(word.size());
    return word;
}

/// The whole of `s` as a number, nothing else.
template <typename T>
[[nodiscard]] std::optional<T> number_of_text(std::string_view s, int base = 10) {
    T value{};
    const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), value, base);
    if (error != std::errc{} || end != s.data() + s.size() || s.empty()) return std::nullopt;
    return value;
}

/// "1300039392.959569" in nanoseconds, exactly; nothing when it is no time or does not fit.
[[nodiscard]] std::optional<std::int64_t> nanoseconds_of_text(std::string_view s);

/// "08 80 FA" appended to `bytes`; false when a word is no byte or `most` would be exceeded.
[[nodiscard]] bool append_hex_bytes(std::string_view s, std::vector<std::uint8_t>& bytes, std::size_t most);

}  // namespace input
