#pragma once
// Pieces of the Garment screen that are files of their own: type, the list of layers and history, folds, drawers.

#include <string>
#include <vector>

#include "ui/screens/garment_screen.hpp"

namespace ui {

/// Type of the arrangements: what is for reading keeps at least 16 px on small screens.
struct GarmentType {
    TextStyle wordmark, view, where, tool, tile, caption, number, head, row, button, switched, note, title, value;
};
[[nodiscard]] GarmentType garment_type(const GarmentLayout& layout);

/// The number as it is shown, with its unit.
[[nodiscard]] std::string stepper_number(const Strings& words, const Stepper& stepper);
void draw_garment_stepper(DrawList& list, const FontSet& fonts, const Strings& words, const GarmentState& state,
                          const GarmentLayout& layout);
void add_stepper_targets(std::vector<BoardTouch::Target>& all, const GarmentLayout& layout);
/// The plane that is drawn in, over the small views.
void draw_plane_traces(DrawList& list, const GarmentState& state, const GarmentLayout& layout);

/// Layers or history, with their heads.
void draw_garment_list(DrawList& list, const FontSet& fonts, const Strings& words, const GarmentState& state,
                       const GarmentLayout& layout);
/// Label, word and slider; or, after New, the way back.
void draw_garment_folds(DrawList& list, const FontSet& fonts, const Strings& words, const GarmentState& state,
                        const GarmentLayout& layout);
/// Of list and folds.
void add_list_targets(std::vector<BoardTouch::Target>& all, const GarmentState& state, const GarmentLayout& layout);

/// What covers the board: body, fabrics, export, and on upright screens layers.
void draw_garment_drawer(DrawList& list, const FontSet& fonts, const std::vector<Strings>& languages,
                         const GarmentState& state, const GarmentLayout& layout);
void add_drawer_targets(std::vector<BoardTouch::Target>& all, const GarmentState& state, const GarmentLayout& layout,
                        std::size_t language_count);

/// The line of a slider with its knob at a share of it.
void draw_slider(DrawList& list, const Rect& rect, double share, bool held, bool on, bool grips, double scale);

/// Fabrics in two columns, and swatches below them.
struct FabricPlaces {
    std::vector<Rect> fabrics, colours;
};
[[nodiscard]] FabricPlaces fabric_places(const GarmentLayout& layout, std::size_t fabrics);

}  // namespace ui
