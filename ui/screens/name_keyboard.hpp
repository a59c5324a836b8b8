#pragma once
// A keyboard on the screen, for names. Its keys are those of the language (`keys_1` … `keys_4` of its file, letters
// parted by spaces), so that another language brings its own.

#include <cstddef>
#include <string>
#include <vector>

#include "ui/draw/draw_list.hpp"
#include "ui/gl/context.hpp"
#include "ui/screens/strings.hpp"

namespace ui {

/// A name that is being written. Letters are whole UTF-8 letters of Latin scripts.
struct NameEdit {
    static constexpr std::size_t kMostLetters = 40;
    std::string text;
    bool fresh = true;  ///< nothing was typed: the first letter takes the place of the old name
    bool shift = false;
    friend bool operator==(const NameEdit&, const NameEdit&) = default;

    /// A letter, a capital while shift is on; beyond kMostLetters nothing happens.
    void type(const std::string& letter);
    void erase();  ///< the last letter
    /// Without spaces at its ends; empty: there is nothing to save.
    [[nodiscard]] std::string name() const;
};

/// The capital of a letter of a Latin script; others as they are.
[[nodiscard]] std::string capital_of(const std::string& letter);

struct KeyboardKey {
    enum class Kind { Letter, Shift, Erase, Space, Cancel, Save };
    Kind kind = Kind::Letter;
    std::string letter;  ///< Letter: as the key shows it
    Rect rect;
};

/// Along the bottom of the screen, the field above it.
struct KeyboardLayout {
    Rect panel, field;
    std::vector<KeyboardKey> keys;  ///< a key's number is its place here
};
[[nodiscard]] KeyboardLayout keyboard_layout(const NameEdit& edit, const Strings& words, SizePx screen);

/// `pressed`: number of the key under the tip, or none below 0.
void draw_keyboard(DrawList& list, const FontSet& fonts, const Strings& words, const NameEdit& edit,
                   const KeyboardLayout& layout, SizePx screen, int pressed);

}  // namespace ui
