#pragma once
// "Still there?": lies over what the visitor left, and counts down to its end (design picture 10).

#include "ui/screens/find_screen.hpp"

namespace ui {

struct StillThereState {
    std::size_t language = 0;
    int seconds = 0;   ///< left, rounded up
    double share = 0;  ///< left, 1 … 0
    std::optional<Control> pressed;
    friend bool operator==(const StillThereState&, const StillThereState&) = default;
};

class StillThereScreen {
  public:
    /// Both must outlive the screen.
    StillThereScreen(const FontSet& fonts, const std::vector<Strings>& languages)
        : fonts_(&fonts), languages_(&languages) {}
    /// To be drawn over the frame of what lies below.
    [[nodiscard]] DrawList draw(const StillThereState& state, SizePx screen) const;
    [[nodiscard]] std::vector<BoardTouch::Target> targets(const StillThereState& state, SizePx screen) const;

  private:
    const FontSet* fonts_;
    const std::vector<Strings>* languages_;
};

}  // namespace ui
