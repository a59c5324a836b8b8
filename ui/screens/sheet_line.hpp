#pragma once
// Lines of a garment on the sheet: each kind looks its own way, hidden ones are dimmed (design, "Garment lines").

#include <vector>

#include "ui/draw/draw_list.hpp"

namespace ui {

struct SheetLine {
    enum class Kind { Plane, Body, Temporary, Mirrored, Cut, Tape, Seam };
    Kind kind = Kind::Plane;
    bool selected = false, dimmed = false;
    core::Polyline px;
    friend bool operator==(const SheetLine&, const SheetLine&) = default;
};

/// A region that closed and waits for its cloth.
struct SheetWash {
    PictureId coverage{};
    Rect rect;
    Colour colour;
    friend bool operator==(const SheetWash&, const SheetWash&) = default;
};

/// Into the list, cut to the sheet. `scale`: pixels per pixel of the design. Linear in points and in dashes.
void draw_sheet_line(DrawList& list, const SheetLine& line, double scale, const Rect& clip);
/// A polygon's edge, and its area where it is convex, in one colour.
void draw_convex(DrawList& list, const std::vector<core::Point>& corners, Colour colour, const Rect& clip);
/// A square to grasp.
void draw_handle(DrawList& list, core::Point at, double scale, bool held);
/// A hollow ring: an open end.
void draw_open_end(DrawList& list, core::Point at, double scale, const Rect& clip);

}  // namespace ui
