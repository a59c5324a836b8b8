#pragma once
// The Find screen: board with cards and tools, sheet with wash and ink. State in, draw list and intents out.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/draw/draw_list.hpp"
#include "ui/screens/card_rail.hpp"
#include "ui/screens/find_layout.hpp"
#include "ui/screens/strings.hpp"

namespace ui {

enum class Tool { Pen, Eraser };

/// One matched part on the sheet.
struct WashPart {
    PictureId coverage{};
    Rect rect;           ///< on the screen
    int colour = 0;      ///< index into palette::parts()
    double opacity = 1;  ///< 0 … 1 of the wash
    friend bool operator==(const WashPart&, const WashPart&) = default;
};

/// The best match under the ink, or one that fades in or out.
struct ShadowPart {
    PictureId coverage{};
    Rect rect;  ///< on the screen; nothing of it is drawn beyond the sheet
    double opacity = 1;
    friend bool operator==(const ShadowPart&, const ShadowPart&) = default;
};

/// What can be touched on the board.
enum class Control {
    Pen,
    Eraser,
    Undo,
    Redo,
    New,
    Language,
    HandSwitch,
    UndoClear,
    Card,  ///< item: its place on the rail
    // of the other screens
    StartDrawing,
    KeepDrawing,
    StartOver,
    Tag,  ///< item: the part's colour; acts while it is held
    Smaller,
    Larger,
    Digit,
    EraseDigit,
    Cancel,
    Station,  ///< item: see station_item
    Mode,     ///< item: 0 Find, 1 Garment
    Garment,  ///< item: see garment_item
    Gallery,  ///< item: see gallery_item
    Wear,     ///< the result that is open, on the figure of Garment
};

/// Everything that Find shows, as values.
struct FindState {
    std::size_t language = 0;  ///< index into the languages
    Tool tool = Tool::Pen;
    bool modes = false;     ///< the switch to Garment is offered
    bool fine_pen = false;  ///< of the two widths of line the finer one
    bool can_undo = false, can_redo = false;
    bool sheet_empty = true;
    bool sheet_cleared = false;  ///< offer to bring back what New took
    std::string board_message;   ///< in the words of the language; shown where no best card stands
    std::array<CardSlot, kCardCount> cards;
    std::vector<ShadowPart> shadows;
    std::vector<WashPart> wash;  ///< in order of size
    PictureId ink{};
    Rect inked;  ///< box of all ink, pixels from the sheet's corner
    std::vector<InkPiece> wet_ink;
    std::vector<InkPiece> ahead_ink;       ///< where the pen will be in the next frame
    std::optional<core::Point> eraser_px;  ///< the ring, while erasing
    std::optional<core::Point> pen_px;     ///< where a pen hovers that lies on a tablet
    std::optional<Control> pressed;
    std::size_t pressed_item = 0;    ///< which language
    std::uint64_t ink_revision = 0;  ///< another number when the ink picture changed
    friend bool operator==(const FindState&, const FindState&) = default;
};

/// What the visitor wants.
struct Intent {
    Control control = Control::Pen;
    std::size_t item = 0;  ///< which language, card …
};

/// Touches on the board. Undo and redo act on the press; everything else on release inside the target.
class BoardTouch {
  public:
    /// A target under the point that takes touches now.
    struct Target {
        Control control;
        std::size_t item;
        Rect rect;
    };
    [[nodiscard]] std::optional<Intent> press(const std::vector<Target>& targets, double x, double y);
    void move(double x, double y);
    [[nodiscard]] std::optional<Intent> release();
    void cancel() { held_.reset(); }
    /// The control that looks pressed: held, with the tip still inside.
    [[nodiscard]] std::optional<Control> pressed() const;
    [[nodiscard]] std::size_t pressed_item() const { return held_ ? held_->item : 0; }
    [[nodiscard]] bool active() const { return held_.has_value(); }

  private:
    std::optional<Target> held_;
    bool inside_ = false;
    bool acted_ = false;
};

class FindScreen {
  public:
    /// Both must outlive the screen.
    FindScreen(const FontSet& fonts, const std::vector<Strings>& languages) : fonts_(&fonts), languages_(&languages) {}

    [[nodiscard]] DrawList draw(const FindState& state, const FindLayout& layout) const;
    /// What can be touched in this state.
    [[nodiscard]] std::vector<BoardTouch::Target> targets(const FindState& state, const FindLayout& layout) const;

  private:
    const FontSet* fonts_;
    const std::vector<Strings>* languages_;
};

/// The footer that Find and the notices share: language switch and hand switch.
void draw_footer(DrawList& list, const FontSet& fonts, const std::vector<Strings>& languages, std::size_t language,
                 const FindLayout& layout, std::optional<Control> pressed, std::size_t pressed_item);
[[nodiscard]] std::vector<BoardTouch::Target> footer_targets(const FindLayout& layout, std::size_t language_count);
void draw_wordmark(DrawList& list, const FontSet& fonts, const FindLayout& layout);

}  // namespace ui
