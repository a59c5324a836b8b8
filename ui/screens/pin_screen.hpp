#pragma once
// The operator's PIN: ten large keys, dots for the digits, never a digit (design picture 08). And the page on which the
// screen is cleaned.

#include "ui/screens/find_screen.hpp"

namespace ui {

struct PinState {
    std::size_t language = 0;
    int length = 6, entered = 0;
    bool wrong = false;
    std::int64_t wait_s = 0;
    std::optional<Control> pressed = {};
    std::size_t pressed_item = 0;
    friend bool operator==(const PinState&, const PinState&) = default;
};

class PinScreen {
  public:
    /// Both must outlive the screen.
    PinScreen(const FontSet& fonts, const std::vector<Strings>& languages) : fonts_(&fonts), languages_(&languages) {}
    [[nodiscard]] DrawList draw(const PinState& state, SizePx screen) const;
    /// Digits are items 0 … 9 of Control::Digit.
    [[nodiscard]] std::vector<BoardTouch::Target> targets(const PinState& state, SizePx screen) const;
    /// Nothing can be touched; `share` of the time is left.
    [[nodiscard]] DrawList draw_cleaning(std::size_t language, double share, int seconds, SizePx screen) const;

  private:
    const FontSet* fonts_;
    const std::vector<Strings>* languages_;
};

}  // namespace ui
