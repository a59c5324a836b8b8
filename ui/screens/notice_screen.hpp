#pragma once
// Calm full screens for when something is missing: a picture, a title, a sentence and a way out.

#include "ui/screens/find_screen.hpp"

namespace ui {

enum class Notice {
    None,
    NoModels,
    CollectionMissing,
    CollectionDamaged,
    CollectionStale,
    Building,
    NoTablet,
    NoInput
};

/// Key of the sentence that the board of the sheet shows instead of its hint.
[[nodiscard]] std::string board_key(Notice notice);

struct NoticeState {
    Notice notice = Notice::None;
    std::size_t language = 0;
    bool garment = false;                  ///< the other mode is there, and needs no collection
    std::int64_t done = 0, total = 0;      ///< models, of Building
    std::string code = {};                 ///< of NoInput, for whoever is called
    std::optional<int> minutes_left = {};  ///< of Building; nothing while that cannot be told
    std::optional<Control> pressed = {};
    std::size_t pressed_item = 0;
    friend bool operator==(const NoticeState&, const NoticeState&) = default;
};

class NoticeScreen {
  public:
    /// Both must outlive the screen.
    NoticeScreen(const FontSet& fonts, const std::vector<Strings>& languages)
        : fonts_(&fonts), languages_(&languages) {}

    /// The layout gives wordmark and footer their place.
    [[nodiscard]] DrawList draw(const NoticeState& state, const FindLayout& layout) const;
    [[nodiscard]] std::vector<BoardTouch::Target> targets(const NoticeState& state, const FindLayout& layout) const;

  private:
    [[nodiscard]] Rect button(const NoticeState& state, const FindLayout& layout) const;
    const FontSet* fonts_;
    const std::vector<Strings>* languages_;
};

}  // namespace ui
