#include "ui/screens/garment_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace ui {
namespace {

using Known = std::pair<const char*, const char*>;

// as core/garment/desk/region_names and middle_line write them, and the keys of their words
constexpr std::array<Known, 11> kNames{{{"sleeve back", "piece_sleeve_back"},
                                        {"leg back", "piece_leg_back"},
                                        {"sleeve", "piece_sleeve"},
                                        {"leg", "piece_leg"},
                                        {"collar", "piece_collar"},
                                        {"front", "piece_front"},
                                        {"back", "piece_back"},
                                        {"side", "piece_side"},
                                        {"piece", "step_piece"},
                                        {"line", "step_line"},
                                        {"middle", "line_middle"}}};

/// Whether only numbers follow: of pieces that were parted, and of a line's pieces.
bool is_number_tail(const std::string& tail) {
    return std::all_of(tail.begin(), tail.end(),
                       [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == ' ' || c == '/'; });
}

}  // namespace

std::string shown_name(const Strings& words, std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');  // as names in files may be written
    for (const auto& [known, key] : kNames) {
        const std::string base = known;
        if (name.rfind(base, 0) != 0) continue;
        const std::string tail = name.substr(base.size());
        if (tail.empty() || ((tail[0] == ' ' || tail[0] == '/') && is_number_tail(tail))) return words[key] + tail;
    }
    return name;
}

}  // namespace ui
