#include "input/formats/text_lines.hpp"

namespace input {

std::optional<std::int64_t> nanoseconds_of_text(std::string_view s) {
    const std::size_t dot = s.find('.');
    const auto seconds = number_of_text<std::int64_t>(s.substr(0, dot));
    constexpr std::int64_t kLast_s = 4'000'000'000;  // in 2096; so that no difference of two times overflows
    if (!seconds || *seconds < 0 || *seconds > kLast_s) return std::nullopt;
    std::int64_t fraction = 0;
    if (dot != std::string_view::npos) {
        std::string_view digits = s.substr(dot + 1);
        if (digits.empty() || digits.size() > 9) return std::nullopt;
        const auto value = number_of_text<std::uint32_t>(digits);
        if (!value) return std::nullopt;
        fraction = *value;
        for (std::size_t i = digits.size(); i < 9; ++i) fraction *= 10;
    }
    return *seconds * 1'000'000'000 + fraction;
}

bool append_hex_bytes(std::string_view s, std::vector<std::uint8_t>& bytes, std::size_t most) {
    for (std::string_view word = take_word(s); !word.empty(); word = take_word(s)) {
        const auto value = word.size() <= 2 ? number_of_text<std::uint8_t>(word, 16) : std::nullopt;
        if (!value || bytes.size() >= most) return false;
        bytes.push_back(*value);
    }
    return true;
}

}  // namespace input
