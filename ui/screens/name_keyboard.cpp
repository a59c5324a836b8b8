#include "ui/screens/name_keyboard.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "ui/screens/widgets.hpp"

namespace ui {
namespace {

using Kind = KeyboardKey::Kind;
constexpr int kRows = 4;  // of letters; one more with the space bar

bool begins_letter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80;
}

std::size_t letters_in(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_letter));
}

std::vector<std::string> letters_of(const std::string& row) {
    std::istringstream in(row);
    std::vector<std::string> letters;
    for (std::string letter; in >> letter;) letters.push_back(letter);
    return letters;
}

/// Sizes shared by the rows.
struct Metrics {
    double margin, gap, key_height, pitch;
};

Metrics metrics_of(const ScreenScale& s) {
    const double key = s.target(76), gap = std::max(8.0, s.px(10));
    return {s.px(40), gap, key, key + gap};
}

const char* label_of(Kind kind) {
    switch (kind) {
        case Kind::Space:
            return "key_space";
        case Kind::Cancel:
            return "cancel";
        case Kind::Save:
            return "save_name";
        default:
            return "";
    }
}

}  // namespace

std::string capital_of(const std::string& letter) {
    if (letter.size() == 1) {
        const char c = letter[0];
        return c >= 'a' && c <= 'z' ? std::string(1, static_cast<char>(c - 'a' + 'A')) : letter;
    }
    if (letter == "œ") return "Œ";
    if (letter == "ÿ") return "Ÿ";
    const bool latin = letter.size() == 2 && static_cast<unsigned char>(letter[0]) == 0xC3;  // U+00C0 … U+00FF
    const auto second = latin ? static_cast<unsigned char>(letter[1]) : 0U;
    const bool small = second >= 0xA0 && second <= 0xBE && second != 0xB7;  // not the sign of division
    return small ? std::string{letter[0], static_cast<char>(second - 0x20)} : letter;
}

void NameEdit::type(const std::string& letter) {
    if (fresh) text.clear();
    fresh = false;
    if (letters_in(text) < kMostLetters) text += shift ? capital_of(letter) : letter;
    shift = false;
}

void NameEdit::erase() {
    if (fresh) text.clear();
    fresh = false;
    while (!text.empty() && !begins_letter(text.back())) text.pop_back();
    if (!text.empty()) text.pop_back();
}

std::string NameEdit::name() const {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

KeyboardLayout keyboard_layout(const NameEdit& edit, const Strings& words, SizePx screen) {
    const ScreenScale s = ScreenScale::of(screen);
    const Metrics m = metrics_of(s);
    const double field = s.target(80), height = m.gap + field + m.gap + (kRows + 1) * m.pitch + s.px(24);
    KeyboardLayout layout;
    layout.panel = {0, s.height() - height, s.width(), height};
    const double widest = std::min(s.width() - 2 * m.margin, std::round(12 * s.px(128)));
    const double left = std::round((s.width() - widest) / 2);
    layout.field = {left, layout.panel.y + m.gap * 1.5, widest, field};
    double y = layout.field.bottom() + m.gap;
    const double side = std::round(widest * 0.11);  // of the wide keys at the ends of the last rows
    for (int row = 1; row <= kRows; ++row, y += m.pitch) {
        const std::vector<std::string> letters = letters_of(words["keys_" + std::to_string(row)]);
        const bool last = row == kRows;
        const double from = last ? left + side + m.gap : left, room = widest - (last ? 2 * (side + m.gap) : 0.0);
        const auto count = static_cast<double>(std::max<std::size_t>(letters.size(), 1));
        const double pitch = std::min((room + m.gap) / count, m.key_height * 1.9 + m.gap);
        const double start = from + (room + m.gap - pitch * count) / 2;
        if (last) layout.keys.push_back({Kind::Shift, {}, {left, y, side, m.key_height}});
        for (std::size_t i = 0; i < letters.size(); ++i)
            layout.keys.push_back({Kind::Letter,
                                   edit.shift ? capital_of(letters[i]) : letters[i],
                                   {start + pitch * static_cast<double>(i), y, pitch - m.gap, m.key_height}});
        if (last) layout.keys.push_back({Kind::Erase, {}, {left + widest - side, y, side, m.key_height}});
    }
    const double wide = std::round(widest * 0.2);
    layout.keys.push_back({Kind::Cancel, {}, {left, y, wide, m.key_height}});
    layout.keys.push_back({Kind::Space, {}, {left + wide + m.gap, y, widest - 2 * (wide + m.gap), m.key_height}});
    layout.keys.push_back({Kind::Save, {}, {left + widest - wide, y, wide, m.key_height}});
    return layout;
}

void draw_keyboard(DrawList& list, const FontSet& fonts, const Strings& words, const NameEdit& edit,
                   const KeyboardLayout& layout, SizePx screen, int pressed) {
    const ScreenScale s = ScreenScale::of(screen);
    const double line = std::max(1.5, s.px(2));
    list.box({0, 0, s.width(), s.height()}, 0, palette::kInk.faded(0.28F));
    list.box(layout.panel, 0, palette::kBoard);
    const Rect& field = layout.field;
    list.box(field, s.px(16), palette::kSheet, palette::kSanguine, line * 1.5);
    const TextStyle name = s.text(Face::Medium, 32);
    const std::string shown = fonts.cut(edit.text, name, field.width - s.px(80));
    const double x = field.x + s.px(28), base = field.centre_y() + cap_drop(name);
    const double end = x + fonts.width_px(shown, name);
    if (edit.fresh && !shown.empty())  // as a text that is selected: the next letter takes its place
        list.box({x - s.px(6), field.y + s.px(14), end - x + s.px(12), field.height - s.px(28)}, s.px(8),
                 palette::kWell);
    list.text(fonts, shown, name, palette::kInk, x, base);
    list.box({end + s.px(3), field.y + s.px(16), line, field.height - s.px(32)}, 0, palette::kSanguine);
    const TextStyle letter = s.text(Face::Medium, 28), label = s.text(Face::SemiBold, 20);
    for (std::size_t i = 0; i < layout.keys.size(); ++i) {
        const KeyboardKey& key = layout.keys[i];
        const bool down = static_cast<int>(i) == pressed;
        if (key.kind == Kind::Save || key.kind == Kind::Cancel) {
            draw_button(list, fonts, key.rect, words[label_of(key.kind)], label,
                        key.kind == Kind::Save ? ButtonKind::Primary : ButtonKind::Quiet, down, line,
                        key.kind == Kind::Cancel || !edit.name().empty());
            continue;
        }
        const Rect r = down ? scaled(key.rect, 0.97) : key.rect;
        const bool chosen = key.kind == Kind::Shift && edit.shift;
        list.box(r, s.px(16), chosen ? palette::kInk : (down ? palette::kWell : palette::kSheet), palette::kLine,
                 std::max(1.0, s.px(1)));
        const double size = s.px(34);
        if (key.kind == Kind::Shift)
            list.icon(Icon::Up, r.centre_x(), r.centre_y(), size, size / 32 * 2.2,
                      chosen ? palette::kSheet : palette::kInk);
        else if (key.kind == Kind::Erase)
            list.icon(Icon::Back, r.centre_x(), r.centre_y(), size, size / 32 * 2.2, palette::kInk);
        else if (key.kind == Kind::Space)
            draw_fitted(list, fonts, words[label_of(key.kind)], s.text(Face::Medium, 18), palette::kMuted, r.centre_x(),
                        r.centre_y() + s.px(6), r.width - s.px(24), Align::Centre);
        else
            list.text(fonts, key.letter, letter, palette::kInk, r.centre_x(), r.centre_y() + cap_drop(letter),
                      Align::Centre);
    }
}

}  // namespace ui
