#pragma once
// The designs that are kept: cards with pictures, to open, copy, rename and delete; and the bin they are taken out of
// again. Fills the screen.

#include <optional>
#include <string>
#include <vector>

#include "ui/screens/find_screen.hpp"
#include "ui/screens/name_keyboard.hpp"

namespace ui {

/// What a touch wants; `item` of Control::Gallery is one of these, with the number of the card (or key, or shelf)
/// added in hundreds.
enum class GalleryAction : std::size_t {
    Close,
    New,
    Shelf,  ///< index: 0 designs, 1 bin
    Open,   ///< index: card, as below
    Duplicate,
    Rename,
    Delete,
    Restore,
    UndoDelete,
    Key,  ///< index: of the keyboard's keys
};
[[nodiscard]] constexpr std::size_t gallery_item(GalleryAction action, std::size_t index = 0) {
    return static_cast<std::size_t>(action) + 100 * index;
}
[[nodiscard]] constexpr GalleryAction gallery_action(std::size_t item) {
    return static_cast<GalleryAction>(item % 100);
}
[[nodiscard]] constexpr std::size_t gallery_index(std::size_t item) {
    return item / 100;
}

struct GalleryCard {
    std::string name, date;
    std::optional<PictureId> picture;  ///< 3 wide to 4 high; none: the card shows a sign
    bool open = false;                 ///< it is the design on the sheet, which cannot be deleted
    friend bool operator==(const GalleryCard&, const GalleryCard&) = default;
};

struct GalleryState {
    std::size_t language = 0;
    Hand hand = Hand::Right;
    bool bin = false;                    ///< which shelf
    std::vector<GalleryCard> cards;      ///< of the shelf, in order
    int bin_days = 30;                   ///< how long the bin keeps them
    std::string deleted;                 ///< name of the design just deleted: offers to undo it; empty: none
    std::string message;                 ///< what went wrong, in words; empty: nothing
    std::optional<NameEdit> rename;      ///< the keyboard is open
    double scroll = 0;                   ///< pixels, 0 or more
    std::optional<std::size_t> pressed;  ///< item of Control::Gallery
    friend bool operator==(const GalleryState&, const GalleryState&) = default;
};

/// The page as it is drawn, and where it can be touched.
struct GalleryPage {
    DrawList list;
    std::vector<BoardTouch::Target> targets;
    double most_scroll = 0;         ///< pixels
    std::vector<std::size_t> seen;  ///< cards that are on the screen, in order
};

class GalleryScreen {
  public:
    /// Both must outlive the screen.
    GalleryScreen(const FontSet& fonts, const std::vector<Strings>& languages)
        : fonts_(&fonts), languages_(&languages) {}
    [[nodiscard]] GalleryPage build(const GalleryState& state, SizePx screen) const;

  private:
    const FontSet* fonts_;
    const std::vector<Strings>* languages_;
};

}  // namespace ui
