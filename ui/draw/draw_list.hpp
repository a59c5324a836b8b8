#pragma once
// What a screen wants drawn, in order, as plain values: screens make lists, the painter draws them.

#include <string>
#include <variant>
#include <vector>

#include "ui/draw/fonts.hpp"
#include "ui/draw/icons.hpp"
#include "ui/draw/ink_curve.hpp"
#include "ui/draw/palette.hpp"

namespace ui {

/// Names a texture that the painter is told about separately.
enum class PictureId : int {};

struct BoxCommand {
    Rect rect;
    double radius = 0;
    Colour fill;
    Colour border = palette::kNone;
    double border_px = 0;
    double softness = 0;  ///< > 0: a shadow whose edge fades over this many pixels to either side
    friend bool operator==(const BoxCommand&, const BoxCommand&) = default;
};

/// One line; x, y is the start of its baseline.
struct TextCommand {
    std::string text;
    TextStyle style;
    Colour colour;
    double x = 0, y = 0;
    friend bool operator==(const TextCommand&, const TextCommand&) = default;
};

struct IconCommand {
    Icon icon = Icon::Pen;
    double centre_x = 0, centre_y = 0;
    double size_px = 36, line_px = 2.5;
    Colour colour;
    friend bool operator==(const IconCommand&, const IconCommand&) = default;
};

struct PictureCommand {
    enum class Mode { Picture, Tint, Wash };  ///< as it is; coverage in a colour; coverage multiplied as a wash
    PictureId picture{};
    Rect rect;
    Mode mode = Mode::Picture;
    Colour tint;
    double opacity = 1;
    Rect source{0, 0, 1, 1};  ///< part of the picture that is shown, 0 … 1
    /// Opacity comes in from left to right, or goes where `to` is the smaller: 0 at `from`, 1 at `to`, both in widths
    /// of the rect. Equal: no ramp.
    struct Ramp {
        double from = 0, to = 0;
        friend bool operator==(const Ramp&, const Ramp&) = default;
    };
    Ramp ramp;
    /// Where the picture is not empty, in pixels of the screen, so that nothing need be drawn elsewhere; without size:
    /// everywhere. It says nothing new of the pixels, so two commands that differ in it alone are the same.
    Rect within;
    friend bool operator==(const PictureCommand& a, const PictureCommand& b) {
        return a.picture == b.picture && a.rect == b.rect && a.mode == b.mode && a.tint == b.tint &&
               a.opacity == b.opacity && a.source == b.source && a.ramp == b.ramp;
    }
};

/// Ink drawn straight to the screen: the wet end.
struct InkCommand {
    std::vector<InkPiece> pieces;
    Colour colour;
    Rect clip;
    friend bool operator==(const InkCommand&, const InkCommand&) = default;
};

using DrawCommand = std::variant<BoxCommand, TextCommand, IconCommand, PictureCommand, InkCommand>;

enum class Align { Left, Centre, Right };

class DrawList {
  public:
    void box(const Rect& rect, double radius, Colour fill, Colour border = palette::kNone, double border_px = 0) {
        commands.emplace_back(BoxCommand{rect, radius, fill, border, border_px, 0});
    }
    /// A soft shadow of the rounded rectangle, moved down by `down`.
    void shadow(const Rect& rect, double radius, double down, double softness, Colour colour) {
        commands.emplace_back(
            BoxCommand{{rect.x, rect.y + down, rect.width, rect.height}, radius, colour, {}, 0, softness});
    }
    /// `x` is the left end, middle or right end; `y` the baseline.
    void text(const FontSet& fonts, const std::string& text, const TextStyle& style, Colour colour, double x, double y,
              Align align = Align::Left);
    void icon(Icon icon, double centre_x, double centre_y, double size_px, double line_px, Colour colour) {
        commands.emplace_back(IconCommand{icon, centre_x, centre_y, size_px, line_px, colour});
    }
    void picture(PictureId id, const Rect& rect, double opacity = 1) {
        commands.emplace_back(
            PictureCommand{id, rect, PictureCommand::Mode::Picture, {}, opacity, {0, 0, 1, 1}, {}, {}});
    }
    /// Coverage in a colour; see PictureCommand::within.
    void tinted(PictureId id, const Rect& rect, Colour tint, const Rect& within = {}) {
        commands.emplace_back(PictureCommand{id, rect, PictureCommand::Mode::Tint, tint, 1, {0, 0, 1, 1}, {}, within});
    }
    void wash(PictureId id, const Rect& rect, Colour tint, double opacity) {
        commands.emplace_back(
            PictureCommand{id, rect, PictureCommand::Mode::Wash, tint, opacity, {0, 0, 1, 1}, {}, {}});
    }
    void ink(std::vector<InkPiece> pieces, Colour colour, const Rect& clip) {
        commands.emplace_back(InkCommand{std::move(pieces), colour, clip});
    }

    std::vector<DrawCommand> commands;
};

}  // namespace ui
