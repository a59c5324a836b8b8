#pragma once
// A pad of digits in a drawer, for a measure that is written rather than slid.

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "ui/draw/draw_list.hpp"
#include "ui/screens/strings.hpp"

namespace ui {

/// A number that is being written: up to three digits, and one after the point.
struct NumberEdit {
    std::string text;   ///< digits and at most one '.', as "92.5"
    bool fresh = true;  ///< nothing was typed: the first digit takes the place of the old number
    friend bool operator==(const NumberEdit&, const NumberEdit&) = default;

    void type(char digit);
    void point();  ///< the decimal sign; a second one does nothing
    void erase();  ///< the last sign
    /// Nothing where no digit is written.
    [[nodiscard]] std::optional<double> value() const;
};

/// Keys by number: 0 … 9 the digits, then the decimal sign and the one that erases.
inline constexpr std::size_t kPadKeys = 12, kPadPoint = 10, kPadErase = 11;

struct NumberPadLayout {
    double name_baseline = 0, range_baseline = 0;
    Rect field;
    std::array<Rect, kPadKeys> keys;
};
/// In four rows of three within `area`, below the field. Keys are at least 64 high where the area has that height.
[[nodiscard]] NumberPadLayout number_pad_layout(const Rect& area, double scale);

/// `name` stands above the field, `range` below it, in sanguine while `wrong`. `pressed`: number of a key, or none.
void draw_number_pad(DrawList& list, const FontSet& fonts, const Strings& words, const NumberEdit& edit,
                     const std::string& name, const std::string& range, bool wrong, const NumberPadLayout& layout,
                     double scale, std::optional<std::size_t> pressed);

}  // namespace ui
