#pragma once
// One model, large, beside the drawing it was found for: matched parts in the same colours and numbers on both, other
// close models below (design picture 04).

#include <optional>
#include <string>
#include <vector>

#include "ui/screens/find_screen.hpp"
#include "ui/screens/widgets.hpp"

namespace ui {

inline constexpr std::size_t kSimilarCount = 6;

/// Pixels of the screen.
struct DetailLayout {
    ScreenScale scale;
    Hand hand = Hand::Right;
    Rect board, sheet, back, drawing;
    Rect wear;  ///< beside the button that goes back
    std::array<Rect, kSimilarCount> similar;
    double your_drawing_y = 0, also_close_y = 0;  ///< baselines
    double name_x = 0, name_y = 0, caption_y = 0, text_width = 0;
    Rect stage;        ///< the picture of the model
    Rect model;        ///< the part of it that the model fills at first
    core::Point ring;  ///< centre of the turning ring
    double ring_radius = 0;
    double hint_y = 0;     ///< baseline of "Drag to turn"
    Rect smaller, larger;  ///< the zoom's buttons
};
[[nodiscard]] DetailLayout detail_layout(SizePx screen, Hand hand);

struct DetailTag {
    int colour = 0;
    core::Point anchor, place;  ///< on the screen
    bool hidden = false;        ///< its part is at the back now
    friend bool operator==(const DetailTag&, const DetailTag&) = default;
};

struct SimilarCard {
    std::string name;
    PictureId picture{};
    bool to_come = false;  ///< the picture is on its way: the name stands where it will stand then
    friend bool operator==(const SimilarCard&, const SimilarCard&) = default;
};

struct DetailState {
    std::size_t language = 0;
    std::string name, caption;
    PictureId model{};  ///< fills the stage; none: not yet
    PictureId still{};  ///< the model as on its card, over the other
    Rect still_rect;    ///< on the screen: while opening it grows out of its card
    double still_opacity = 0;
    double opened = 1;  ///< 0 … 1 of the opening
    PictureId ink{};
    Rect inked;                  ///< from the drawing box's corner
    std::vector<WashPart> wash;  ///< on the screen
    std::vector<DetailTag> drawing_tags, model_tags;
    std::vector<SimilarCard> similar;
    double azimuth = 0, elevation = 0;  ///< of the view, radians
    std::uint64_t view = 0;             ///< another number when the model's picture changed
    bool touched = false;               ///< the hint is not needed any more
    bool wear = false;                  ///< the model can be put on the figure of Garment
    std::optional<int> focus;           ///< the part whose number is held
    std::optional<Control> pressed;
    std::size_t pressed_item = 0;
    friend bool operator==(const DetailState&, const DetailState&) = default;
};

class DetailScreen {
  public:
    /// Both must outlive the screen.
    DetailScreen(const FontSet& fonts, const std::vector<Strings>& languages)
        : fonts_(&fonts), languages_(&languages) {}
    [[nodiscard]] DrawList draw(const DetailState& state, const DetailLayout& layout) const;
    [[nodiscard]] std::vector<BoardTouch::Target> targets(const DetailState& state, const DetailLayout& layout) const;

  private:
    const FontSet* fonts_;
    const std::vector<Strings>* languages_;
};

}  // namespace ui
