#pragma once
// Calm full screens for when something is missing: a picture, a title, a sentence and a way out.

#include "ui/screens/find_screen.hpp"

namespace ui {

enum class Notice { None, NoModels, CollectionMissing, CollectionDamaged };

/// Key of the sentence that the board of the sheet shows instead of its hint.
[[nodiscard]] std::string board_key(Notice notice);

class NoticeScreen {
  public:
    /// Both must outlive the screen.
    NoticeScreen(const FontSet& fonts, const std::vector<Strings>& languages)
        : fonts_(&fonts), languages_(&languages) {}

    [[nodiscard]] DrawList draw(Notice notice, std::size_t language, const FindLayout& layout,
                                std::optional<Control> pressed, std::size_t pressed_item) const;
    [[nodiscard]] std::vector<BoardTouch::Target> targets(std::size_t language, const FindLayout& layout) const;

  private:
    [[nodiscard]] Rect button(std::size_t language, const FindLayout& layout) const;
    const FontSet* fonts_;
    const std::vector<Strings>* languages_;
};

}  // namespace ui
