#pragma once
// The colours of the design, and rectangles on the screen.

#include <array>
#include <cstddef>
#include <cstdint>

namespace ui {

/// Red, green, blue and opacity, 0 … 1, not premultiplied.
struct Colour {
    float r = 0, g = 0, b = 0, a = 1;

    [[nodiscard]] static constexpr Colour hex(std::uint32_t rgb, float alpha = 1.0F) {
        return {static_cast<float>(rgb >> 16 & 255) / 255.0F, static_cast<float>(rgb >> 8 & 255) / 255.0F,
                static_cast<float>(rgb & 255) / 255.0F, alpha};
    }
    [[nodiscard]] constexpr Colour faded(float by) const { return {r, g, b, a * by}; }
    friend bool operator==(const Colour&, const Colour&) = default;
};

namespace palette {
inline constexpr Colour kInk = Colour::hex(0x1E1B18);
inline constexpr Colour kInkAhead = Colour::hex(0x787572);  ///< ink over sheet at 60 %, without seams
inline constexpr Colour kMuted = Colour::hex(0x6A6259);
inline constexpr Colour kSanguine = Colour::hex(0xA8371C);
inline constexpr Colour kOk = Colour::hex(0x1F6B4F);  ///< the operator's ticks only
inline constexpr Colour kSheet = Colour::hex(0xFFFDF8);
inline constexpr Colour kBoard = Colour::hex(0xF4F0E7);
inline constexpr Colour kWell = Colour::hex(0xEAE4D8);
inline constexpr Colour kLine = Colour::hex(0xDDD5C6);
inline constexpr Colour kShadow = Colour::hex(0xECE6DA);  ///< best match under the ink
inline constexpr Colour kClay = Colour::hex(0xD8CFBF);
inline constexpr Colour kEdge = Colour::hex(0x3C3022, 0.07F);   ///< elevation 1
inline constexpr Colour kShade = Colour::hex(0x3C3022, 0.10F);  ///< elevation 2
inline constexpr Colour kNone = {0, 0, 0, 0};

inline constexpr int kPartCount = 8;
/// Colours of parts, in order of the part's size; further parts stay clay. And of the number on each part's tag.
struct PartColours {
    std::array<Colour, kPartCount> parts;
    std::array<Colour, kPartCount> tag_text;
};
/// Soft: the design's. Strong: for screens and projectors that show soft colours pale. In both any two differ by 20 and
/// more after CIEDE2000, by 15 and more without red, green or blue cones, and none is near sanguine.
enum class PartPalette { Soft, Strong };
[[nodiscard]] const PartColours& part_colours(PartPalette palette);

/// The one in use, from any thread. What was drawn in others before is drawn anew by whoever chooses.
void choose_parts(PartPalette palette);
[[nodiscard]] PartPalette chosen_parts();
[[nodiscard]] inline const std::array<Colour, kPartCount>& parts() {
    return part_colours(chosen_parts()).parts;
}
[[nodiscard]] inline const std::array<Colour, kPartCount>& tag_text() {
    return part_colours(chosen_parts()).tag_text;
}

inline constexpr float kWashShare = 0.42F;  ///< part colour on the sketch
inline constexpr float kPartShare = 0.76F;  ///< part colour on a model; the rest is clay
inline constexpr float kOffShare = 0.34F;   ///< a control that takes no touch
}  // namespace palette

/// In pixels of the screen, y down.
struct Rect {
    double x = 0, y = 0, width = 0, height = 0;

    [[nodiscard]] double right() const { return x + width; }
    [[nodiscard]] double bottom() const { return y + height; }
    [[nodiscard]] double centre_x() const { return x + width * 0.5; }
    [[nodiscard]] double centre_y() const { return y + height * 0.5; }
    /// The left and top edge belong to it, the right and bottom edge do not.
    [[nodiscard]] bool contains(double px, double py) const {
        return px >= x && px < right() && py >= y && py < bottom();
    }
    [[nodiscard]] Rect shrunk(double by) const { return {x + by, y + by, width - 2 * by, height - 2 * by}; }
    friend bool operator==(const Rect&, const Rect&) = default;
};

}  // namespace ui
