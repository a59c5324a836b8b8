#pragma once
// What nobody touches: a line draws itself and becomes the form that was found for it (design picture 01).

#include <vector>

#include "ui/screens/find_screen.hpp"
#include "ui/screens/widgets.hpp"

namespace ui {

/// Where the composition stands; pixels of the screen.
struct AttractLayout {
    ScreenScale scale;
    Rect stage;                                                  ///< where lines are drawn and forms stand
    Rect language;                                               ///< the switch
    double text_x = 0, wordmark_y = 0, title_y = 0, lead_y = 0;  ///< baselines
    double text_width = 0;
};
[[nodiscard]] AttractLayout attract_layout(SizePx screen, std::size_t language_count);

struct AttractState {
    std::size_t language = 0;
    PictureId ink{}, form{};
    Rect inked;                     ///< box of the ink, from the stage's corner
    Rect form_box;                  ///< of the form, whose picture fills the stage; from the stage's corner
    std::vector<InkPiece> wet_ink;  ///< from the stage's corner
    /// How far the form has come over the line, 0 … 1, from the right.
    double form_share = 0;
    double opacity = 1;  ///< of line and form
    core::Point drift;   ///< moves everything but the switch a little, against burn-in
    std::optional<std::size_t> pressed_language;
    std::uint64_t ink_revision = 0;
    friend bool operator==(const AttractState&, const AttractState&) = default;
};

class AttractScreen {
  public:
    /// Both must outlive the screen.
    AttractScreen(const FontSet& fonts, const std::vector<Strings>& languages)
        : fonts_(&fonts), languages_(&languages) {}
    [[nodiscard]] DrawList draw(const AttractState& state, SizePx screen) const;
    [[nodiscard]] std::vector<BoardTouch::Target> targets(SizePx screen) const;

  private:
    const FontSet* fonts_;
    const std::vector<Strings>* languages_;
};

}  // namespace ui
