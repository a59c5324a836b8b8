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
inline constexpr Colour kClay = Colour::hex(0xD8CFBF);
inline constexpr Colour kEdge = Colour::hex(0x3C3022, 0.07F);   ///< elevation 1
inline constexpr Colour kShade = Colour::hex(0x3C3022, 0.10F);  ///< elevation 2
inline constexpr Colour kNone = {0, 0, 0, 0};

inline constexpr int kPartCount = 8;
/// In order of the part's size; further parts stay clay.
inline constexpr std::array<Colour, kPartCount> kParts{
    Colour::hex(0x75C4F1), Colour::hex(0x8E872C), Colour::hex(0x7B77CF), Colour::hex(0xC6908A),
    Colour::hex(0x734541), Colour::hex(0x127C7D), Colour::hex(0x334A81), Colour::hex(0x9DCD36)};
/// The colour of the number on the part's tag.
inline constexpr std::array<Colour, kPartCount> kTagText{
    kInk, kInk, kInk, kInk, Colour::hex(0xFFFFFF), Colour::hex(0xFFFFFF), Colour::hex(0xFFFFFF), kInk};
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
